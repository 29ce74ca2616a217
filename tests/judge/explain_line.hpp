// A compiler's message together with the learner's own line: slips that the message alone does not name.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace nutshell::judge {

/// The names that may stand in a body.
struct Reach {
    std::vector<std::string> names;    ///< arguments, the body's own, the headers' functions and types
    std::vector<std::string> members;  ///< "state.mass": of the arguments
    std::map<std::string, std::string> arguments;             ///< their types
    std::map<std::string, std::string> calls;                 ///< of functions: "spin(q, t)", or "spin(...)"
    std::map<std::string, std::vector<std::string>> of_type;  ///< a structure's members
};

/// What is wrong with the line, or empty if nothing is known of it.
/// @param message  the compiler's, in plain types    @param notes  what it says beside it
std::string meaning_in_line(const std::string& message, const std::string& notes, const std::string& line,
                            const Reach& reach);

/// What may be meant by a name that nothing is called, or by a member that a type does not have.
std::string unknown_name(const std::string& name, const Reach& reach, const std::string& line,
                         const std::string& message);
std::optional<std::string> unknown_member(const std::string& message, const Reach& reach);
/// What is meant by a name that std lacks.
std::string unknown_in_std(const std::string& name);

/// Two operands side by side, as in `2 omega` or `u log(x)`; empty if there are none.
std::string missing_sign(const std::string& line);

/// The same of what needs no name to be looked up.
std::string by_signs(const std::string& message, const std::string& notes, const std::string& line);

}  // namespace nutshell::judge
