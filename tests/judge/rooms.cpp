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
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value == 0 ? 0 : value);  // no "-0"
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
    record_.inputs.emplace_back();
    described_ = 0;
}

void Paper::describe(const char* name_or_words) {
    std::string& text = record_.inputs.back();
    text += (text.empty() ? "" : described_ % 2 == 0 ? ", " : " ") + std::string(name_or_words);
    ++described_;
}

void Paper::describe(double value) {
    record_.inputs.back() += " " + digits(value);
    ++described_;
}

void Paper::describe(const std::vector<double>& values) {
    std::string& text = record_.inputs.back();
    text += " (";
    for (std::size_t i = 0; i < values.size() && i < 6; ++i) text += (i ? ", " : "") + digits(values[i]);
    text += values.size() > 6 ? ", ...)" : ")";
    ++described_;
}

void Paper::keep(const char* name, std::vector<double> values, const std::vector<double>& terms,
                 std::vector<double> exact) {
    double scale = 0;
    for (const double term : terms) scale = std::max(scale, std::abs(term));
    std::vector<double> start;  // by convention the first term is what the value starts from
    if (terms.size() >= values.size())
        start.assign(terms.begin(), terms.begin() + static_cast<std::ptrdiff_t>(values.size()));
    if (record_.inputs.empty()) begin_input();
    record_.outputs.push_back({name, record_.inputs.size() - 1, level_, std::move(values), scale,
                               std::move(start), std::move(exact)});
}

}  // namespace nutshell::exercises

namespace nutshell::judge {

namespace fs = std::filesystem;

const Chapter::Header& Chapter::header_of(Number exercise) const {
    for (const Header& header : headers)
        if (header.reference.body(exercise)) return header;
    throw std::runtime_error("there is no exercise " + exercise.text());
}

std::vector<Chapter> chapters_of(const Rooms& rooms) {
    std::vector<Chapter> all;
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(rooms.course / "chapters"))
        if (fs::is_directory(entry.path() / "nutshell")) folders.push_back(entry.path());
    std::sort(folders.begin(), folders.end());
    for (const auto& folder : folders) {
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

exercises::Record record_of(const exercises::Attempt& attempt, bool other_states) {
    exercises::Paper paper;
    if (!other_states) paper.leave_out_other_states();
    attempt(paper);
    return paper.record();
}

}  // namespace nutshell::judge
