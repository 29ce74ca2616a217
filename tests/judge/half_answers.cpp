// Mutants that are right as far as one argument, member or component goes.
#include "workshop.hpp"

namespace nutshell::judge {

const char* const mutants_prelude = R"(#pragma once
#include <cmath>
#include <cstdlib>
#include <nutshell/vector.hpp>
#include <type_traits>
inline const int nutshell_mutant = std::getenv("NUTSHELL_MUTANT") ? std::atoi(std::getenv("NUTSHELL_MUTANT")) : -1;
namespace nutshell {
inline double without_fraction(double value) { return std::trunc(value); }
inline int without_fraction(int value) = delete;
template <class Derived>
auto without_fraction(const Eigen::MatrixBase<Derived>& value) {
    return value.unaryExpr([](double x) { return std::trunc(x); }).eval();
}
template <class Derived>
void lose(Eigen::MatrixBase<Derived>& v, int a) { v[a] = 0; }
}
)";

namespace {

void cut_fractions(Workshop& shop) {
    for (std::size_t i = 0; i < shop.tokens_.size(); ++i) {
        const auto word = shop.word(i);
        const bool assigns = word == "=" || word == "+=" || word == "-=" || word == "*=";
        if (!(word == "return" || assigns) || i + 1 >= shop.tokens_.size() || shop.word(i + 1) == "{")
            continue;
        const Span right = shop.right_of(i);
        shop.put(word == "return" ? "result to int" : "fraction cut off", right,
                 "without_fraction(" + std::string(right.of(shop.body_)) + ")");
    }
}

/// A body in which an argument is another value: `change` makes it of a copy called `other`.
std::string with_argument(const Parameter& argument, const std::string& change, std::string_view body) {
    const std::string type = "std::decay_t<decltype(" + argument.name + ")>";
    return change + " { " + (argument.constant ? "const auto& " : "auto ") + argument.name + " = other_" +
           argument.name + ";\n" + std::string(body) + "\n}";
}

void freeze_arguments(Workshop& shop) {
    for (const auto& argument : shop.parameters_) {
        if (argument.name.empty() || !names(shop.body_, argument.name) || argument.changes ||
            contains(argument.type, "span"))
            continue;
        const std::string copy = " other_" + argument.name + " = " + argument.name + ";",
                          plain = "std::decay_t<decltype(" + argument.name + ")>";
        shop.add(argument.name + " frozen",
                 with_argument(argument, "static const " + plain + copy, shop.body_), 0);
        const std::size_t size = argument.type == "Vector3" ? 3 : argument.type == "Flat" ? 2 : 0;
        const std::string other = "other_" + argument.name, start = plain + copy;
        for (std::size_t a = 0; a < size; ++a) {
            const std::string axis = argument.name + "." + "xyz"[a], n = std::to_string(a);
            shop.add(axis + " zeroed",
                     with_argument(argument, start + " lose(" + other + ", " + n + ");", shop.body_), 0);
            if (a + 1 == size && size < 3) break;
            const std::size_t next = (a + 1) % size;
            shop.add(axis + " and " + "xyz"[next] + " swapped",
                     with_argument(argument,
                                   start + " std::swap(" + other + "[" + n + "], " + other + "[" +
                                       std::to_string(next) + "]);",
                                   shop.body_),
                     0);
        }
    }
}

/// Members of an argument that the body reads, each kept as it was when it was first read.
void freeze_members(Workshop& shop) {
    const auto& tokens = shop.tokens_;
    std::vector<std::string> done;
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
        const bool argument = std::any_of(shop.parameters_.begin(), shop.parameters_.end(),
                                          [&](const Parameter& each) { return each.name == tokens[i].word; });
        const std::string member = std::string(shop.word(i)) + "." + std::string(shop.word(i + 2));
        if (!argument || shop.word(i + 1) != "." || shop.word(i + 3) == "(" ||
            std::find(done.begin(), done.end(), member) != done.end())
            continue;
        done.push_back(member);
        std::string body;
        std::size_t from = 0, reads = 0;
        for (std::size_t k = 0; k + 2 < tokens.size(); ++k) {
            const std::string_view after = shop.word(k + 3);
            const bool written =
                after == "=" || after == "+=" || after == "-=" || after == "*=" || after == "/=";
            if (shop.word(k) != shop.word(i) || shop.word(k + 1) != "." ||
                shop.word(k + 2) != shop.word(i + 2) || written)
                continue;
            body += std::string(shop.body_.substr(from, tokens[k].at - from)) + "first_one";
            from = tokens[k + 2].at + tokens[k + 2].word.size();
            ++reads;
        }
        body += std::string(shop.body_.substr(from));
        if (reads)
            shop.add(
                member + " frozen",
                "static const std::decay_t<decltype(" + member + ")> first_one = " + member + ";\n" + body,
                0);
    }
}

void shorten_lists(Workshop& shop) {
    for (const auto& argument : shop.parameters_) {
        if (!contains(argument.type, "span") && !contains(argument.type, "vector<")) continue;
        const std::string& name = argument.name;
        for (const auto* count : {"1", "2", "3", "4"})
            shop.add(name + ": the first " + count + " only",
                     with_argument(argument,
                                   "const std::span other_" + name + " = std::span(" + name +
                                       ").first(std::min<std::size_t>(" + name + ".size(), " + count + "));",
                                   shop.body_),
                     0);
    }
}

}  // namespace

std::vector<Mutant> half_answers_of(std::string_view body, std::string_view signature) {
    Workshop shop(body, signature);
    for (const auto make : {freeze_arguments, freeze_members, shorten_lists, cut_fractions}) make(shop);
    return shop.mutants;
}

}  // namespace nutshell::judge
