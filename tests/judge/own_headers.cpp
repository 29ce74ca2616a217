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

fs::path OwnHeaders::overlay(const std::vector<Number>& broken, bool for_a_grader) const {
    if (!for_a_grader && broken.empty()) return {};
    const fs::path folder = rooms.work / (for_a_grader ? "graded" : "overlay");
    for (std::size_t i = 0; i < files.size(); ++i) {
        const Marked& own = files[i].source;
        const Marked& reference = chapter.headers[i].reference;
        const std::string file = files[i].path.string();
        std::map<Number, std::string> bodies;
        for (const Body& body : reference.bodies) {
            const Body* answer = own.body(body.number);
            const bool out =
                !answer || among(broken, body.number) || (for_a_grader && !not_a_body(answer->text).empty());
            if (out)
                bodies[body.number] = unanswered(body.number) + "\n";
            else if (for_a_grader)
                bodies[body.number] = "#line " + std::to_string(answer->begin + 2) + " \"" + file + "\"\n" +
                                      answer->text + "#line 1 \"" + chapter.headers[i].path + "\"\n";
        }
        if (for_a_grader)
            write_if_changed(folder / chapter.headers[i].path,
                             "#include <nutshell/unanswered.hpp>\n" + with_bodies(reference, bodies));
        else if (files[i].text)
            write_if_changed(folder / chapter.headers[i].path, with_stand_ins(own, bodies, file));
    }
    return folder;
}

bool OwnHeaders::reference_among(const std::vector<fs::path>& sources, Number number) const {
    const fs::path reference = rooms.course / "chapters" / chapter.folder / chapter.header_of(number).path;
    std::error_code problem;
    return file_of(number).text && std::any_of(sources.begin(), sources.end(), [&](const fs::path& source) {
               return fs::equivalent(source, reference, problem);
           });
}

}  // namespace nutshell::judge
