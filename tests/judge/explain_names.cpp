// Names and members that the compiler does not know: of other languages, of mathematics, misspelled.
#include <algorithm>
#include <array>
#include <cctype>
#include <regex>
#include <utility>
#include "explain_line.hpp"
#include "text.hpp"

namespace nutshell::judge {

namespace {

using Pair = std::pair<const char*, const char*>;

/// Names of other languages and of mathematics, and what C++ has for them.
constexpr Pair dictionary[] = {
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
    {"sqr", "a product, x * x, for the square; the root is std::sqrt"},
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
    {"cuberoot", "std::cbrt"},
    {"arctan", "std::atan, and std::atan2(sine, cosine)"},
    {"arcsin", "std::asin"},
    {"arccos", "std::acos"},
    {"tg", "std::tan"},
    {"Mathf", "std:: for it: std::sqrt, std::cos, pi"},
    {"sum", "a loop for it, begun by for (const auto& each : list)"},
    {"len", "list.size(), and v.norm() for the length of a vector"},
    {"range", "for (int i = 0; i < n; ++i)"},
    {"foreach", "for (const auto& each : list)"},
    {"final", "const"},
    {"boolean", "bool"},
    {"power", "std::pow(x, y)"},
    {"square", "a product: x * x"},
    {"transpose", "a member function: m.transpose()"},
    {"nil", "std::nullopt, where a std::optional is returned"},
    {"undefined", "std::nullopt, where a std::optional is returned"},
};

/// What vectors are asked for under another name.
constexpr Pair members[] = {
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
    {"T", "transpose()"},
    {"inv", "inverse()"},
    {"det", "determinant()"},
    {"conj", "conjugate()"},
    {"X", "x()"},
    {"Y", "y()"},
    {"Z", "z()"},
    {"W", "w()"},
};

/// What quaternions are asked for; the course has functions for it.
constexpr Pair of_quaternions[] = {
    {"log", "logarithm(q)"},       {"exp", "exponential(u)"}, {"mul", "product(a, b)"},
    {"multiply", "product(a, b)"}, {"inv", "inverse(q)"},     {"rotate", "rotate(q, v)"},
    {"length", "q.norm()"},        {"magnitude", "q.norm()"}, {"conj", "q.conjugate()"}};

/// What lists are asked for under another name.
constexpr Pair of_lists[] = {{"append", "push_back(x)"}, {"add", "push_back(x)"}, {"Add", "push_back(x)"},
                             {"push", "push_back(x)"},   {"length", "size()"},    {"Length", "size()"},
                             {"count", "size()"},        {"Count", "size()"},     {"len", "size()"}};

template <std::size_t N>
std::string in(const Pair (&table)[N], const std::string& name) {
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

constexpr const char* standard[] = {
    "max",   "min",   "sqrt",      "exp",   "log",    "pow",        "abs",      "floor",
    "ceil",  "round", "cbrt",      "array", "vector", "accumulate", "clamp",    "numeric_limits",
    "hypot", "fmod",  "remainder", "sin",   "cos",    "tan",        "asin",     "acos",
    "atan",  "atan2", "log10",     "expm1", "trunc",  "lround",     "isfinite", "isnan",
    "swap",  "span",  "complex",   "polar", "numbers"};

}  // namespace

std::string unknown_name(const std::string& name, const Reach& reach, const std::string& line,
                         const std::string& message) {
    static const std::regex first(R"(^(for \()?(\w+) ?= ?[^=])");
    std::smatch found;
    if (std::regex_search(line, found, first) && found[2] == name)
        return "Nothing is called " + name + " yet: the first time, a variable needs its type in front: " +
               (found[1].matched ? "int " + name + " = ..."
                                 : "double " + name + " = ..., or Vector3 " + name + " = ...");
    if (const std::string other = in(dictionary, name); !other.empty())
        return "Nothing is called " + name + " here. C++ has " + other + ".";
    static const std::regex qualified(R"(did you mean '(\w+::\w+)')");
    if (std::regex_search(message, found, qualified) && !starts_with(found[1].str(), "std"))
        return "Nothing is called " + name + " by itself: write " + found[1].str() + ".";
    for (const auto& member : reach.members)
        if (member.substr(member.find('.') + 1) == name)
            return "Nothing is called " + name + " by itself. Do you mean " + member + "?";
    for (const auto* in_std : standard)
        if (name == in_std)
            return "Do you mean std::" + name + "? Names of the standard library begin with std::.";
    if (std::find(reach.names.begin(), reach.names.end(), name) != reach.names.end())
        return name + " is known elsewhere, but not here: what is used must be declared above this line.";
    if ((name == "i" || name == "j") && !contains(line, "["))
        return "Nothing is called " + name +
               " here. The imaginary unit is Complex{0, 1}; a counter is declared "
               "in the head of its loop, for (int i = 0; ...).";
    std::string other = nearest(name, reach.names);
    static const std::regex suggested(R"(did you mean '(?:std::)?(\w+)')");
    if (other.empty() && std::regex_search(message, found, suggested))
        for (const auto* in_std : standard)
            if (found[1] == in_std) other = std::string("std::") + in_std;
    return "Nothing is called " + name + " here" +
           (other.empty() ? ": is it spelled right, and declared above this line?"
                          : ". Do you mean " + other + "?");
}

std::string unknown_in_std(const std::string& name) {
    const std::string other = in(dictionary, name), near_by = nearest(name, {standard, std::end(standard)});
    return "There is no std::" + name +
           (!other.empty()     ? ". C++ has " + other + "."
            : !near_by.empty() ? ". Do you mean std::" + near_by + "?"
                               : ": is it spelled right?");
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
        return "A " + (contains(type, "Matrix") ? type : "vector") + " has no " + name + ": Eigen calls it " +
               other + ".";
    if (const std::string other = in(of_quaternions, name); !other.empty() && contains(type, "Quaternion"))
        return "A Quaternion has no " + name + ": write " + other + ".";
    if (contains(type, "array") && (name == "push_back" || starts_with(in(of_lists, name), "push_back")))
        return "A std::array has a fixed size, and nothing can be put behind it: its entries are a[0], a[1], "
               "...";
    const bool list = contains(type, "span") || contains(type, "vector");
    if (const std::string other = in(of_lists, name); !other.empty() && (list || contains(type, "array")))
        return "A list has no " + name + ": in C++ it is " + other + ".";
    if (list)
        return "A list has no member called " + name + ": go through it with  for (const auto& each : list).";
    std::vector<std::string> all;
    for (const auto& member : reach.members) all.push_back(member.substr(member.find('.') + 1));
    const auto own = reach.of_type.find(type);
    if (own != reach.of_type.end()) all = own->second;
    std::string near_by = nearest(name, all), there_are;
    static const std::regex suggested(R"(did you mean '(\w+)')");
    if (near_by.empty() && std::regex_search(message, found, suggested)) near_by = found[1].str();
    if (own != reach.of_type.end())
        for (std::size_t i = 0; i < std::min<std::size_t>(own->second.size(), 8); ++i)
            there_are += (i ? ", " : "") + own->second[i];
    const bool function = std::find(reach.names.begin(), reach.names.end(), name) != reach.names.end();
    return "A " + type + " has no member called " + name +
           (function            ? ". There is a function of this name: " + name + "(...)."
            : !near_by.empty()  ? ". Do you mean " + near_by + "?"
            : there_are.empty() ? "."
                                : ". It has: " + there_are + ".");
}

}  // namespace nutshell::judge
