// The marks round an exercise's body, and what is made from them: skeletons, solutions, the learner's engine.
//   // exercise 1.3
//   ...
//   // end 1.3
#pragma once
#include <compare>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nutshell::judge {

/// "1.3" as numbers, so that 1.10 comes after 1.9.
struct Number {
    int chapter = 0, exercise = 0;
    auto operator<=>(const Number&) const = default;
    std::string text() const { return std::to_string(chapter) + "." + std::to_string(exercise); }
};
std::optional<Number> number_of(std::string_view text);  ///< "1.3", nothing else

struct Body {
    Number number;
    std::size_t begin, end;  ///< lines of the two marks, counted from 0
    std::string text;        ///< the lines between them, each with its end
};

/// A source with its marked bodies. Marks that do not pair up are complained about, in words for who wrote
/// them.
struct Marked {
    std::vector<std::string> lines;
    std::vector<Body> bodies;  ///< in the order of the file
    std::map<Number, std::string> complaints;

    const Body* body(Number number) const;
    std::string text() const;
    /// The exercise whose body or marks or closing brace is at this line, counted from 1 as compilers do.
    std::optional<Number> at_line(std::size_t line) const;
};
Marked marked(std::string_view source);

std::string unanswered(Number number);  ///< the line of a skeleton: throw Unanswered{"1.3"};
/// Whether a body is still that of the skeleton.
bool is_unanswered(const Body& body);

/// Why a text must not be put between marks by a machine; empty if it may. A body ends where it begins: it
/// closes no brace that it has not opened, and gives the preprocessor nothing to do.
std::string not_a_body(const std::string& text);

/// The source with some bodies replaced. What is not in `bodies` stays.
std::string with_bodies(const Marked& source, const std::map<Number, std::string>& bodies);
/// The same, for a compiler: its messages name the lines of `file`, which holds the source as it was.
std::string with_stand_ins(const Marked& source, const std::map<Number, std::string>& bodies,
                           const std::string& file);
/// The reference's source as a learner gets it.
std::string skeleton(std::string_view reference);
/// Everything from the start of the function's declaration to its opening brace, on one line.
std::string signature(const Marked& source, Number number);
/// Lines without the white space that all of them begin with.
std::string unindented(std::string_view text);

}  // namespace nutshell::judge
