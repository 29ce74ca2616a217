#include "own_headers.hpp"
#include <algorithm>
#include <map>
#include <stdexcept>
#include "text.hpp"

namespace nutshell::judge {

namespace fs = std::filesystem;

bool among(const std::vector<Number>& numbers, Number number) {
    return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

OwnHeaders::OwnHeaders(const Rooms& in, const Chapter& of) : rooms(in), chapter(of) {
    for (const auto& header : chapter.headers) {
        auto text = own_text(rooms, chapter, header);
        files.push_back({own_path(rooms, chapter, header), text, marked(text.value_or(""))});
    }
}

const OwnHeaders::File& OwnHeaders::file_of(Number number) const {
    for (std::size_t i = 0; i < files.size(); ++i)
        if (chapter.headers[i].reference.body(number)) return files[i];
    throw std::logic_error("no header");
}

std::vector<Number> OwnHeaders::called_by(Number number) const {
    std::vector<Number> called;
    const Body* body = body_of(number);
    if (!body) return called;
    const std::string code = bare_code(body->text);
    for (const Number other : chapter.exercises)
        if (other != number && calls(code, exercise_of(other).function)) called.push_back(other);
    return called;
}

std::string OwnHeaders::changed_line(Number number) const {
    const Marked& reference = chapter.header_of(number).reference;
    const std::string own = bare_code(*file_of(number).text);
    for (std::size_t i = 0; i < reference.lines.size(); ++i) {
        const std::string code = bare_code(reference.lines[i]);
        const bool inside = std::any_of(reference.bodies.begin(), reference.bodies.end(),
                                        [&](const Body& body) { return body.begin <= i && i <= body.end; });
        if (!inside && code.size() > 3 && !contains(own, code)) return code;
    }
    return "";
}

Overlay OwnHeaders::overlay(const std::vector<Number>& broken, bool for_a_grader) const {
    std::vector<Marked> sources;  // what the bodies stand in
    bool all_there = true;
    for (std::size_t i = 0; i < files.size(); ++i) {
        sources.push_back(for_a_grader ? chapter.headers[i].reference : files[i].source);
        all_there = all_there && files[i].text && leads_out(rooms, files[i].path).empty();
    }
    Overlay overlay;
    if (all_there || for_a_grader) overlay.ahead = ahead_of(rooms, chapter, sources);
    if (overlay.ahead) sources = overlay.ahead->skeletons;
    if (!for_a_grader && !overlay.ahead && broken.empty()) return {};
    overlay.only = for_a_grader || overlay.ahead;
    overlay.folder = rooms.work / chapter.folder / (for_a_grader ? "graded" : "own");
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (!for_a_grader && !files[i].text) continue;
        const std::string file = "\"" + files[i].path.string() + "\"\n", name = chapter.headers[i].path;
        std::map<Number, std::string> bodies;
        for (const Body& body : sources[i].bodies) {
            const Body* answer = files[i].source.body(body.number);
            const bool out =
                !answer || among(broken, body.number) || (for_a_grader && !not_a_body(answer->text).empty());
            bodies[body.number] =
                out ? unanswered(body.number) + "\n"
                    : "#line " + std::to_string(answer->begin + 2) + " " + file + answer->text;
            bodies[body.number] += for_a_grader ? "#line 1 \"" + name + "\"\n"
                                   : answer     ? "#line " + std::to_string(answer->end + 1) + " " + file
                                                : "";
        }
        write_if_changed(overlay.folder / name,
                         (for_a_grader ? "#include <nutshell/unanswered.hpp>\n" : "#line 1 " + file) +
                             with_bodies(sources[i], bodies));
    }
    return overlay;
}

bool OwnHeaders::reference_among(const std::vector<fs::path>& sources, Number number) const {
    const fs::path reference = rooms.course / "chapters" / chapter.folder / chapter.header_of(number).path;
    std::error_code problem;
    return file_of(number).text && std::any_of(sources.begin(), sources.end(), [&](const fs::path& source) {
               return fs::equivalent(source, reference, problem);
           });
}

}  // namespace nutshell::judge
