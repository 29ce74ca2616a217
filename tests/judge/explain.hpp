// What a compiler's message means, in words for a learner.
#pragma once
#include <string>

namespace nutshell::judge {

/// "Eigen::CwiseBinaryOp<...>" and the like by names a learner knows; no namespaces, no lists of template
/// arguments.
std::string plain_types(std::string message);
/// What a message in plain types means; empty if no rule knows it.
std::string meaning_of(const std::string& message);

inline constexpr const char* says_const =
    "This may not be changed: it is const. Work on a copy, or on what the function is given to change.";

}  // namespace nutshell::judge
