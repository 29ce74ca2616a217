// The names a learner may mean: what stands in the chapter's headers, and in those before it.
#include <algorithm>
#include <regex>
#include "explain_line.hpp"
#include "sheets.hpp"
#include "text.hpp"
#include "tokens.hpp"

namespace nutshell::judge {

namespace fs = std::filesystem;

namespace {

/// Members and member functions of the structures in a header's lines.
void add_structures(const std::vector<std::string>& lines, Reach& reach) {
    static const std::regex structure(R"(^struct (\w+))"),
        member(R"(^    [\w:<>, ]+ (\w+)(?: =.*|\{.*\})?;)"), function(R"(^    [\w:<>&]+ (\w+)\(.*\{)");
    std::string type;
    std::smatch found;
    for (const auto& line : lines) {
        if (line.size() > 300) continue;
        if (std::regex_search(line, found, structure)) type = found[1];
        if (starts_with(line, "}")) type.clear();
        if (type.empty()) continue;
        if (std::regex_search(line, found, member) || std::regex_search(line, found, function))
            reach.of_type[type].push_back(found[1]);
    }
}

/// "spin(q, t)", as the text calls a function with plain names; "spin(...)" if it hands over more than names.
std::string call_in(const std::string& text, const std::string& name) {
    std::smatch found;
    if (std::regex_search(text, found, std::regex("\\b" + name + R"(\([\w, ]*\))"))) return found[0];
    return contains(text, name + "(") ? name + "(...)" : "";
}

}  // namespace

/// The names that may stand in the body of `number`.
Reach Sheets::reach_in(const Marked& learner, Number number) const {
    Reach reach;
    reach.names = {"Vector3", "Matrix3", "Quaternion", "return", "const", "double"};
    const Body* body = learner.body(number);
    if (!body) return reach;
    for (const Chapter& chapter : chapters_of(rooms_)) {
        if (chapter.number > chapter_.number) continue;
        for (const auto& entry :
             fs::directory_iterator(rooms_.course / "chapters" / chapter.folder / "nutshell"))
            if (entry.path().extension() == ".hpp") add_structures(lines_of(read_text(entry.path())), reach);
    }
    std::string text;
    for (const auto& header : chapter_.headers) text += header.reference.text();
    const auto arguments = parameters_of(signature(learner, number));
    const Body* right = chapter_.header_of(number).reference.body(number);
    for (const Parameter& argument : arguments) {
        reach.names.push_back(argument.name);
        reach.arguments[argument.name] = argument.type;
        if (const std::string call = right ? call_in(right->text, argument.name) : "";
            !call.empty() && argument.type != "Vector3" && argument.type != "double")
            reach.calls[argument.name] = call;
        for (const auto& [type, members] : reach.of_type)  // any of those with a place may be a State
            if (argument.type == "State" && std::count(members.begin(), members.end(), "position"))
                for (const auto& member : members) reach.members.push_back(argument.name + "." + member);
        const auto members = reach.of_type.find(argument.type);
        if (members != reach.of_type.end())
            for (const auto& member : members->second) reach.members.push_back(argument.name + "." + member);
        const std::regex used("\\b(" + argument.name + R"(\.\w+)\b(?!\())");  // of a template's argument
        for (std::sregex_iterator each(text.begin(), text.end(), used), end; each != end; ++each)
            if (const std::string member = (*each)[1];
                std::find(reach.members.begin(), reach.members.end(), member) == reach.members.end())
                reach.members.push_back(member);
    }
    const auto tokens = tokens_of(body->text);
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i)  // what the body declares
        if (tokens[i].kind == Token::name && tokens[i + 1].kind == Token::name && tokens[i + 2].word == "=")
            reach.names.emplace_back(tokens[i + 1].word);
    static const std::regex function(R"(^(?:inline )?[\w:<>, ]+[ >](\w+)\()");
    std::smatch found;
    for (const auto& line : lines_of(text)) {
        if (line.size() > 300 || !std::regex_search(line, found, function)) continue;
        const std::string name = found[1];
        reach.names.push_back(name);
        std::string call;
        for (const Parameter& parameter : parameters_of(line)) {  // with the arguments of those types
            const auto same = std::find_if(arguments.begin(), arguments.end(), [&](const Parameter& each) {
                return each.type == parameter.type;
            });
            call += (call.empty() ? "" : ", ") + (same == arguments.end() ? parameter.name : same->name);
        }
        reach.calls.emplace(name, name + (call.empty() ? "(...)" : "(" + call + ")"));
    }
    return reach;
}

}  // namespace nutshell::judge
