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

namespace {

using Pair = std::pair<const char*, const char*>;

/// Names of other languages and of mathematics, and what C++ has for them.
constexpr std::array<Pair, 44> dictionary{{
    {"Math", "std:: for it: std::sqrt, std::round, pi"},
    {"math", "std:: for it: std::sqrt, std::round, pi"},
    {"np", "std:: for numbers, and Eigen's members for vectors: v.norm()"},
    {"glm", "Eigen's members for vectors: v.norm(), a.cross(b)"},
    {"self", "no self: a function uses its arguments"},
    {"function", "functions inside a function as [&](double x) { return ...; }"},
    {"def", "functions inside a function as [&](double x) { return ...; }"},
    {"lambda", "functions inside a function as [&](double x) { return ...; }"},
    {"print", "std::cout << x << \"\\n\", with #include <iostream>"},
    {"vec", "Vector3"},
    {"float3", "Vector3"},
    {"vector", "Vector3 for arrows, std::vector<double> for lists"},
    {"normalize", "a member function: v.normalized()"},
    {"normalized", "a member function: v.normalized()"},
    {"null", "std::nullopt, where a std::optional is returned, and no null for other values"},
    {"elseif", "else if"},
    {"string", "std::string"},
    {"mod", "std::fmod(x, y), or std::remainder for the nearest"},
    {"ln", "std::log, the natural logarithm"},
    {"lg", "std::log10"},
    {"sqr", "a product: x * x"},
    {"e", "std::exp(x) for e to the power x"},
    {"PI", "pi"},
    {"Pi", "pi"},
    {"M_PI", "pi"},
    {"vector3", "Vector3"},
    {"Vec3", "Vector3"},
    {"vec3", "Vector3"},
    {"Vector3d", "Vector3"},
    {"var", "a type: Vector3, double, or auto"},
    {"let", "a type: Vector3, double, or auto"},
    {"elif", "else if"},
    {"then", "nothing: the statement stands right behind if (...)"},
    {"and_then", "a statement of its own"},
    {"None", "std::nullopt, where a std::optional is returned; elsewhere every path must return a value"},
    {"True", "true"},
    {"False", "false"},
    {"Return", "return"},
    {"If", "if"},
    {"For", "for"},
    {"norm", "a member function: velocity.norm()"},
    {"length", "a member function: velocity.norm()"},
    {"dot", "a member function: a.dot(b)"},
    {"cross", "a member function: a.cross(b)"},
}};

/// What vectors are asked for under another name.
constexpr std::array<Pair, 16> members{{
    {"length", "norm()"},
    {"Length", "norm()"},
    {"magnitude", "norm()"},
    {"mag", "norm()"},
    {"abs", "norm()"},
    {"len", "norm()"},
    {"lengthSquared", "squaredNorm()"},
    {"length2", "squaredNorm()"},
    {"squaredLength", "squaredNorm()"},
    {"norm2", "squaredNorm()"},
    {"unit", "normalized()"},
    {"normalised", "normalized()"},
    {"normalize", "normalized()"},
    {"scale", "a factor: 2 * v"},
    {"sub", "a difference: a - b"},
    {"add", "a sum: a + b"},
}};

template <std::size_t N>
std::string in(const std::array<Pair, N>& table, const std::string& name) {
    for (const auto& [from, to] : table)
        if (name == from) return to;
    return "";
}

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// Letters to change, insert, leave out or exchange with their neighbour to make `b` of `a`.
std::size_t distance(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
        for (std::size_t k = 0; k <= b.size(); ++k) {
            if (i == 0 || k == 0) {
                d[i][k] = i + k;
                continue;
            }
            d[i][k] = std::min({d[i - 1][k] + 1, d[i][k - 1] + 1, d[i - 1][k - 1] + (a[i - 1] != b[k - 1])});
            if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
                d[i][k] = std::min(d[i][k], d[i - 2][k - 2] + 1);
        }
    return d[a.size()][b.size()];
}

/// The name within reach that is spelled nearly so; empty if none is.
std::string nearest(const std::string& name, const std::vector<std::string>& all) {
    std::string best;
    std::size_t least = name.size() <= 3 ? 2 : 3;
    for (const auto& other : all) {
        if (name.size() == 1 && lower(name) != lower(other)) continue;  // a letter is near to every letter
        const std::size_t away = lower(name) == lower(other) ? 0 : distance(name, other);
        if (away < least && other != name) best = other, least = away;
    }
    return best;
}

std::string unknown_name(const std::string& name, const Reach& reach, const std::string& line) {
    static const std::regex first(R"(^(for \()?(\w+) ?= ?[^=])");
    std::smatch found;
    if (std::regex_search(line, found, first) && found[2] == name)
        return "Nothing is called " + name + " yet: the first time, a variable needs its type in front: " +
               (found[1].matched ? "int " + name + " = ..."
                                 : "double " + name + " = ..., or Vector3 " + name + " = ...");
    if (const std::string other = in(dictionary, name); !other.empty())
        return "Nothing is called " + name + " here. C++ has " + other + ".";
    for (const auto& member : reach.members)
        if (member.substr(member.find('.') + 1) == name)
            return "Nothing is called " + name + " by itself. Do you mean " + member + "?";
    for (const auto* in_std :
         {"max",   "min",   "sqrt",      "exp",   "log",    "pow",        "abs",      "floor",
          "ceil",  "round", "cbrt",      "array", "vector", "accumulate", "clamp",    "numeric_limits",
          "hypot", "fmod",  "remainder", "sin",   "cos",    "tan",        "asin",     "acos",
          "atan",  "atan2", "log10",     "expm1", "trunc",  "lround",     "isfinite", "isnan",
          "swap",  "span",  "complex",   "polar", "numbers"})
        if (name == in_std)
            return "Do you mean std::" + name + "? Names of the standard library begin with std::.";
    if (std::find(reach.names.begin(), reach.names.end(), name) != reach.names.end())
        return "There is a " + name + ", but not here: what is used must be declared above this line.";
    const std::string other = nearest(name, reach.names);
    return "Nothing is called " + name + " here" +
           (other.empty() ? ": is it spelled right, and declared above this line?"
                          : ". Do you mean " + other + "?");
}

/// Two operands side by side, as in `2 omega` or `u log(x)`.
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

std::optional<std::string> unknown_member(const std::string& message, const Reach& reach) {
    static const std::regex none(
        R"('(?:const )?(?:struct |class )?([\w:]+)[^']*' has no member named '(\w+)'|no member named '(\w+)' in '([\w:]+))");
    std::smatch found;
    if (!std::regex_search(message, found, none)) return std::nullopt;
    const std::string type = found[1].str() + found[4].str(), name = found[2].str() + found[3].str();
    const bool vector = contains(type, "Vector3") || contains(type, "Matrix") || contains(type, "expression");
    if (const std::string other = in(members, name);
        !other.empty() && (vector || contains(message, "expression")))
        return "A vector has no " + name + ": Eigen calls it " + other + ".";
    if (contains(type, "span") || contains(type, "vector<") || type == "std::span" || type == "std::vector")
        return "A list has no member called " + name + ": go through it with  for (const auto& each : list).";
    std::vector<std::string> all;
    for (const auto& member : reach.members) all.push_back(member.substr(member.find('.') + 1));
    const std::string near_by = nearest(name, all);
    const bool function = std::find(reach.names.begin(), reach.names.end(), name) != reach.names.end();
    return "A " + type + " has no member called " + name +
           (function           ? ". There is a function of this name: " + name + "(...)."
            : !near_by.empty() ? ". Do you mean " + near_by + "?"
                               : ": look at its struct in the header.");
}

}  // namespace

std::string meaning_in_line(const std::string& message, const std::string& notes, const std::string& line,
                            const Reach& reach) {
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
        static const std::regex qualified(R"(did you mean '(\w+::\w+)')");
        std::smatch better;
        if (std::regex_search(message, better, qualified) && !starts_with(better[1].str(), "std"))
            return "Nothing is called " + name + " by itself: write " + better[1].str() + ".";
        if (!contains(message, "of 'std'")) return unknown_name(name, reach, line);
    }
    return "";
}

}  // namespace nutshell::judge
