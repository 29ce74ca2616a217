#include "rooms.hpp"
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <utility>
#include "exercise.hpp"
#include "text.hpp"

namespace nutshell::exercises {

namespace {

std::string digits(double value) {
    if (value == 0) return "0";  // no "-0"
    char text[40];
    for (int precision = 6; precision <= 17; ++precision) {  // as many as tell it from its neighbours
        std::snprintf(text, sizeof text, "%.*g", precision, value);
        if (std::abs(std::strtod(text, nullptr) - value) <= 1e-9 * std::abs(value)) break;
    }
    return text;
}
std::vector<Exercise>& entered() {
    static std::vector<Exercise> all;
    return all;
}

}  // namespace

bool enter(Exercise exercise) {
    entered().push_back(std::move(exercise));
    return true;
}

void Paper::begin_input() {
    record_.inputs.push_back({"", {}, level_});
    frame_.clear();
    name_.clear();
}

void Paper::describe(const char* name_or_words) {
    std::string& text = record_.inputs.back().words;
    text += (text.empty() ? "" : name_.empty() ? ", " : " ") + std::string(name_or_words);
    name_ = name_.empty() ? name_or_words : "";
}

void Paper::describe(double value) {
    record_.inputs.back().words += " " + digits(value);
    record_.inputs.back().values.push_back({std::exchange(name_, ""), {value}});
}

void Paper::describe(const std::vector<double>& values, bool matrix) {
    std::string& text = record_.inputs.back().words;
    text += matrix ? " ((" : " (";
    for (std::size_t i = 0; i < values.size() && i < (matrix ? 9 : 6); ++i)  // a matrix by rows
        text += (i == 0                 ? ""
                 : matrix && i % 3 == 0 ? "), ("
                                        : ", ") +
                digits(values[matrix ? i / 3 + 3 * (i % 3) : i]);
    text += matrix ? "))" : values.size() > 6 ? ", ...)" : ")";
    record_.inputs.back().values.push_back({std::exchange(name_, ""), values});
}

void Paper::keep(const char* name, std::vector<double> values, const std::vector<double>& terms,
                 std::vector<double> start, std::vector<double> exact, bool quaternion, bool matrix) {
    double scale = 0;
    for (const double term : terms) scale = std::max(scale, std::abs(term));
    if (record_.inputs.empty()) begin_input();
    record_.outputs.push_back({name, record_.inputs.size() - 1, level_, std::move(values), scale,
                               std::move(start), std::move(exact), quaternion, frame_, matrix});
}

}  // namespace nutshell::exercises

namespace nutshell::judge {

namespace fs = std::filesystem;

const Chapter::Header& Chapter::header_of(Number exercise) const {
    for (const Header& header : headers)
        if (header.reference.body(exercise)) return header;
    throw std::runtime_error("there is no exercise " + exercise.text());
}

std::vector<fs::path> chapter_folders(const Rooms& rooms, int last) {
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(rooms.course / "chapters"))
        if (std::atoi(entry.path().filename().c_str()) <= last && fs::is_directory(entry.path() / "nutshell"))
            folders.push_back(entry.path());
    std::sort(folders.begin(), folders.end());
    return folders;
}

std::vector<Chapter> chapters_of(const Rooms& rooms) {
    std::vector<Chapter> all;
    for (const auto& folder : chapter_folders(rooms, 99)) {
        Chapter chapter{std::atoi(folder.filename().c_str()), folder.filename(), {}, {}};
        std::vector<fs::path> headers;
        for (const auto& entry : fs::directory_iterator(folder / "nutshell"))
            if (entry.path().extension() == ".hpp") headers.push_back(entry.path());
        std::sort(headers.begin(), headers.end());
        for (const auto& header : headers) {
            Marked source = marked(read_text(header));
            if (source.bodies.empty() && source.complaints.empty()) continue;
            if (!source.complaints.empty())
                throw std::runtime_error(header.string() + ": " + source.complaints.begin()->second);
            for (const Body& body : source.bodies) chapter.exercises.push_back(body.number);
            chapter.headers.push_back({"nutshell/" + header.filename().string(), std::move(source)});
        }
        std::sort(chapter.exercises.begin(), chapter.exercises.end());
        if (!chapter.exercises.empty()) all.push_back(std::move(chapter));
    }
    return all;
}

fs::path questions_file(const Rooms& rooms, const Chapter& chapter, Number number) {
    const fs::path folder = rooms.course / "chapters" / chapter.folder / "exercises";
    if (fs::is_directory(folder))
        for (const auto& entry : fs::directory_iterator(folder))
            if (starts_with(entry.path().filename().string(), number.text() + "_") &&
                entry.path().extension() == ".hpp")
                return entry.path();
    throw std::runtime_error("exercise " + number.text() + " is marked in its header, but has no file " +
                             (folder / (number.text() + "_*.hpp")).string());
}

const std::vector<exercises::Exercise>& all_exercises() {
    static const auto sorted = [] {
        auto all = exercises::entered();
        std::sort(all.begin(), all.end(),
                  [](const auto& a, const auto& b) { return number_of(a.id) < number_of(b.id); });
        return all;
    }();
    return sorted;
}

const exercises::Exercise& exercise_of(Number number) {
    for (const auto& exercise : all_exercises())
        if (number_of(exercise.id) == number) return exercise;
    throw std::runtime_error(
        "exercise " + number.text() +
        " has no file in its chapter's folder exercises/, or the judge was built without it");
}

exercises::Record record_of(const exercises::Attempt& attempt, bool beyond) {
    exercises::Paper paper;
    if (!beyond) paper.leave_out_beyond();
    attempt(paper);
    return paper.record();
}

}  // namespace nutshell::judge
