// C++ source as a list of tokens, and what can be read off them without a compiler.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace nutshell::judge {

struct Token {
    enum Kind { name, number, text, sign } kind;
    std::string_view word;
    std::size_t at;  ///< where it begins in the source
};

/// Comments and white space left out. Signs of two letters (<=, +=, ::, ->) are one token.
std::vector<Token> tokens_of(std::string_view source);

/// The place of the bracket that closes the one at `open`, or the number of tokens.
std::size_t closing(const std::vector<Token>& tokens, std::size_t open);

/// A piece of the source between two places.
struct Span {
    std::size_t begin, end;
    std::string_view of(std::string_view source) const { return source.substr(begin, end - begin); }
};
/// The statements of a body, not those inside its blocks: `if (...) ...;` is one, `for (...) {...}` too.
std::vector<Span> statements_of(std::string_view body);

/// Whether two statements can change places without any change of what they do, as far as their names tell:
/// neither writes what the other names, and neither returns.
bool independent(std::string_view one, std::string_view other);

/// A parameter of a function: `const Vector3& w`.
struct Parameter {
    std::string type;  ///< without const and &: "Vector3"
    std::string name;  ///< empty if it has none
    bool changes;      ///< handed over to be changed: a reference that is not const
    bool constant;
};
std::vector<Parameter> parameters_of(std::string_view signature);

}  // namespace nutshell::judge
