#include "marks.hpp"
#include <algorithm>
#include <cctype>
#include "text.hpp"
#include "tokens.hpp"

namespace nutshell::judge {

std::optional<Number> number_of(std::string_view text) {
    Number number;
    std::size_t i = 0;
    const auto digits = [&](int& value) {
        const std::size_t begin = i;
        while (i < text.size() && i < begin + 4 && std::isdigit(static_cast<unsigned char>(text[i])))
            value = 10 * value + (text[i++] - '0');
        return i > begin;
    };
    if (!digits(number.chapter) || i >= text.size() || text[i++] != '.' || !digits(number.exercise) ||
        i != text.size())
        return std::nullopt;
    return number;
}

namespace {

/// The number in "// exercise 1.3" for the word "exercise".
std::optional<Number> mark(std::string_view line, std::string_view word) {
    std::string text = trimmed(line);
    if (!starts_with(text, "//")) return std::nullopt;
    text = trimmed(std::string_view(text).substr(2));
    if (!starts_with(text, word)) return std::nullopt;
    return number_of(trimmed(std::string_view(text).substr(word.size())));
}

}  // namespace

Marked marked(std::string_view source) {
    Marked result;
    result.lines = lines_of(source);
    std::map<Number, std::vector<std::size_t>> begins, ends;
    for (std::size_t i = 0; i < result.lines.size(); ++i) {
        if (const auto number = mark(result.lines[i], "exercise")) begins[*number].push_back(i);
        if (const auto number = mark(result.lines[i], "end")) ends[*number].push_back(i);
    }
    std::map<Number, bool> all;
    for (const auto& [number, where] : begins) all[number] = true;
    for (const auto& [number, where] : ends) all[number] = true;
    for (const auto& [number, unused] : all) {
        const auto& begin = begins[number];
        const auto& end = ends[number];
        const std::string open = "`// exercise " + number.text() + "`",
                          close = "`// end " + number.text() + "`";
        const auto twice = [](const std::string& name, const std::vector<std::size_t>& where) {
            return "the mark " + name + " stands " + std::to_string(where.size()) + " times, in lines " +
                   std::to_string(where[0] + 1) + " and " + std::to_string(where[1] + 1) +
                   ": keep the one that belongs to the function";
        };
        std::string& complaint = result.complaints[number];
        if (begin.size() > 1)
            complaint = twice(open, begin);
        else if (end.size() > 1)
            complaint = twice(close, end);
        else if (begin.empty())
            complaint = "the mark " + open + " is gone: put it back on a line of its own above the body";
        else if (end.empty())
            complaint = "the mark " + close + " is gone: put it back on a line of its own below the body";
        else if (end[0] < begin[0])
            complaint = "the mark " + close + " stands above " + open + ": exchange them";
        if (!complaint.empty()) continue;
        std::string text;
        for (std::size_t i = begin[0] + 1; i < end[0]; ++i) text += result.lines[i] + "\n";
        result.complaints.erase(number);
        result.bodies.push_back({number, begin[0], end[0], text});
    }
    std::sort(result.bodies.begin(), result.bodies.end(),
              [](const Body& a, const Body& b) { return a.begin < b.begin; });
    for (std::size_t i = 1; i < result.bodies.size(); ++i)
        if (result.bodies[i].begin < result.bodies[i - 1].end)
            result.complaints[result.bodies[i].number] =
                "the mark `// exercise " + result.bodies[i].number.text() + "` stands inside the body of " +
                result.bodies[i - 1].number.text();
    std::erase_if(result.bodies, [&](const Body& body) { return result.complaints.count(body.number) > 0; });
    return result;
}

const Body* Marked::body(Number number) const {
    for (const Body& body : bodies)
        if (body.number == number) return &body;
    return nullptr;
}

std::string Marked::text() const {
    std::string all;
    for (const auto& line : lines) all += line + "\n";
    return all;
}

std::optional<Number> Marked::at_line(std::size_t line) const {
    for (const Body& body : bodies)
        if (line >= body.begin + 1 && line <= body.end + 2) return body.number;
    return std::nullopt;
}

std::string unanswered(Number number) {
    return "throw Unanswered{\"" + number.text() + "\"};";
}

bool is_unanswered(const Body& body) {
    return bare_code(body.text) == unanswered(body.number);
}

std::string not_a_body(const std::string& text) {
    for (const auto& line : lines_of(text)) {
        const std::string code = trimmed(line);
        if (starts_with(code, "#") || starts_with(code, "%:"))
            return "has a line that begins with #: that is for the top of a file, not for a body.";
        if (!code.empty() && code.back() == '\\') return "has a line that ends in a backslash.";
    }
    int depth = 0;
    const auto tokens = tokens_of(text);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const auto word = tokens[i].word;
        depth += word == "{";
        depth -= word == "}";
        if (depth < 0) return "closes a brace } that it has not opened.";
        const bool raw = tokens[i].kind == Token::text && i > 0 && tokens[i - 1].word.back() == 'R' &&
                         tokens[i - 1].at + tokens[i - 1].word.size() == tokens[i].at;
        if (raw || word == "asm" || word == "__asm__" || word == "_Pragma" || word == "%" || word == "??")
            if (raw || word != "%" ||
                (i + 1 < tokens.size() && (tokens[i + 1].word == ">" || tokens[i + 1].word == ":")))
                return "uses what no answer needs: " + std::string(raw ? "a raw string" : word) + ".";
        if (word == "<" && i + 1 < tokens.size() && tokens[i + 1].word == "%")
            return "uses what no answer needs: <% for a brace.";
    }
    return depth == 0 ? "" : "opens a brace { that it does not close.";
}

std::string with_bodies(const Marked& source, const std::map<Number, std::string>& bodies) {
    std::string all;
    std::size_t next = 0;
    for (const Body& body : source.bodies) {
        const auto found = bodies.find(body.number);
        if (found == bodies.end()) continue;
        for (; next <= body.begin; ++next) all += source.lines[next] + "\n";
        all += found->second;
        next = body.end;
    }
    for (; next < source.lines.size(); ++next) all += source.lines[next] + "\n";
    return all;
}

std::string with_stand_ins(const Marked& source, const std::map<Number, std::string>& bodies,
                           const std::string& file) {
    std::map<Number, std::string> lined;
    for (const Body& body : source.bodies)
        if (const auto found = bodies.find(body.number); found != bodies.end())
            lined[body.number] =
                found->second + "#line " + std::to_string(body.end + 1) + " \"" + file + "\"\n";
    return "#line 1 \"" + file + "\"\n" + with_bodies(source, lined);
}

std::string skeleton(std::string_view reference) {
    const Marked source = marked(reference);
    std::map<Number, std::string> bodies;
    for (const Body& body : source.bodies) {
        const std::string& mark = source.lines[body.begin];
        bodies[body.number] = mark.substr(0, mark.find_first_not_of(" \t")) + unanswered(body.number) + "\n";
    }
    std::string text = with_bodies(source, bodies);
    const std::string once = "#pragma once\n";
    if (const auto at = text.find(once); at != std::string::npos)
        text.insert(at + once.size(), "#include <nutshell/unanswered.hpp>\n");
    return text;
}

std::string signature(const Marked& source, Number number) {
    const Body* body = source.body(number);
    if (!body) return "";
    // upwards from the mark: the declaration begins after the last line that is empty or a comment
    std::size_t begin = body->begin;
    const auto outside = [&](std::size_t i) {
        const std::string line = trimmed(source.lines[i]);
        return line.empty() || starts_with(line, "//");
    };
    while (begin > 0 && !outside(begin - 1)) --begin;
    std::string head;
    for (std::size_t i = begin; i < body->begin; ++i) {
        const auto brace = source.lines[i].find('{');
        head += source.lines[i].substr(0, brace) + " ";
        if (brace != std::string::npos) break;
    }
    head = bare_code(head);
    return starts_with(head, "inline ") ? head.substr(7) : head;
}

std::string unindented(std::string_view text) {
    const auto lines = lines_of(text);
    std::size_t common = std::string::npos;
    for (const auto& line : lines)
        if (const auto first = line.find_first_not_of(' '); first != std::string::npos)
            common = std::min(common, first);
    std::string all;
    for (const auto& line : lines) all += (line.size() > common ? line.substr(common) : "") + "\n";
    return all;
}

}  // namespace nutshell::judge
