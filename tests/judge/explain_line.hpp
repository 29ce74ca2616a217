// A compiler's message together with the learner's own line: slips that the message alone does not name.
#pragma once
#include <string>
#include <vector>

namespace nutshell::judge {

/// The names that may stand in a body.
struct Reach {
    std::vector<std::string> names;    ///< arguments, the body's own, the headers' functions and types
    std::vector<std::string> members;  ///< "state.mass": of the arguments
};

/// What is wrong with the line, or empty if nothing is known of it.
/// @param message  the compiler's, in plain types    @param notes  what it says beside it
std::string meaning_in_line(const std::string& message, const std::string& notes, const std::string& line,
                            const Reach& reach);

/// The same of what needs no name to be looked up.
std::string by_signs(const std::string& message, const std::string& notes, const std::string& line);

}  // namespace nutshell::judge
