#include "explain_line.hpp"
#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <regex>
#include <utility>
#include "text.hpp"
#include "tokens.hpp"

namespace nutshell::judge {

std::string missing_sign(const std::string& line) {
    const auto tokens = tokens_of(line);
    const auto operand_ends = [&](const Token& token) {
        static const std::array<std::string_view, 12> words{"return", "const", "double",  "auto",
                                                            "int",    "else",  "Vector3", "Flat",
                                                            "State",  "if",    "Matrix3", "for"};
        return token.kind == Token::number || token.word == ")" ||
               (token.kind == Token::name &&
                std::find(words.begin(), words.end(), token.word) == words.end());
    };
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        const Token &left = tokens[i], &right = tokens[i + 1];
        const bool begins = right.kind == Token::name || right.kind == Token::number;
        const bool declares = left.kind == Token::name && i == 0;  // Type name
        if (operand_ends(left) && begins && !declares && left.word != ")")
            return "Between " + std::string(left.word) + " and " + std::string(right.word) +
                   " something is missing, a * perhaps: C++ multiplies only where it is written.";
        if (left.kind == Token::number && right.word == "(")
            return "Between " + std::string(left.word) +
                   " and ( a * is missing: C++ multiplies only where it is "
                   "written.";
    }
    static const std::regex stuck(R"((\d)([a-zA-Z_]\w*))");
    std::smatch found;
    if (std::regex_search(line, found, stuck) && found[2].str()[0] != 'e' && found[2].str()[0] != 'f')
        return "Between " + found[1].str() + " and " + found[2].str() +
               " a * is missing: C++ multiplies only where it is written.";
    return "";
}

namespace {

/// Whether a name stands in the line by itself: not called, no member, not asked for its members.
bool stands_alone(const std::string& line, const std::string& name) {
    return std::regex_search(line, std::regex("(^|[^.:\\w])" + name + "(?![\\w.(\\[]| \\()"));
}

/// A function, a whole structure, or a vector that is called, where a value is needed.
std::string no_value(const std::string& message, const std::string& line, const Reach& reach) {
    static const std::regex operands(
        R"((?:no match for 'operator|invalid operands|wrong type argument).*?(?:'([^']*)' and '([^']*)'|'([^']*)'\)))");
    std::smatch found;
    for (const auto& [name, type] : reach.arguments)
        if (type == "Vector3" &&
            std::regex_search(line, std::regex("(^|[^.:\\w])" + name + " ?\\((?!\\w\\))")))
            return name + " is a vector and no function: between " + name + " and ( a * is missing.";
    if (!std::regex_search(message, found, operands)) return "";
    for (const auto& [name, call] : reach.calls) {
        const bool argument = reach.arguments.count(name) != 0;
        if (stands_alone(line, name) &&
            (argument || contains(message, "(const ") || contains(message, "&)'")))
            return name + " is a function: a value of it is " + call + ".";
    }
    for (const auto& [name, type] : reach.arguments) {
        const auto members = reach.of_type.find(type);
        if (members == reach.of_type.end() || !stands_alone(line, name) || !contains(message, "'" + type))
            continue;
        std::string all;
        for (std::size_t i = 0; i < std::min<std::size_t>(members->second.size(), 6); ++i)
            all += (i ? ", " : "") + name + "." + members->second[i];
        return name + " is a whole " + type + ": which of its members do you mean, " + all + "?";
    }
    return "";
}

}  // namespace

std::string meaning_in_line(const std::string& message, const std::string& notes, const std::string& line,
                            const Reach& reach) {
    if (const std::string meaning = no_value(message, line, reach); !meaning.empty()) return meaning;
    if (contains(message, "expected") && !line.empty() && line.back() == ';' && !starts_with(line, "for") &&
        std::count(line.begin(), line.end(), '(') > std::count(line.begin(), line.end(), ')'))
        return "Count the round brackets: each ( needs its ).";
    if (const std::string meaning = by_signs(message, notes, line); !meaning.empty()) return meaning;
    static const std::regex missed(
        "expected '[;)}]'|expected ',' or ';'|numeric literal operator|invalid (suffix|digit)|"
        "expected primary-expression|cannot be used as a function");
    if (std::regex_search(message, missed))
        if (const std::string missing = missing_sign(line); !missing.empty()) return missing;
    if (const auto member = unknown_member(message, reach)) return *member;
    static const std::regex unknown(
        R"('(\w+)' was not declared in this scope|use of undeclared identifier '(\w+)'|'(\w+)' does not name a type|unknown type name '(\w+)'|there are no arguments to '(\w+)' that depend|'(\w+)' is not a member of 'std')");
    std::smatch found;
    if (std::regex_search(message, found, unknown)) {
        std::string name;
        for (std::size_t i = 1; i < found.size() && name.empty(); ++i) name = found[i].str();
        if (!contains(message, "of 'std'")) return unknown_name(name, reach, line, message);
        return unknown_in_std(name);
    }
    return "";
}

}  // namespace nutshell::judge
