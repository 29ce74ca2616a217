// Contracts at the door: public functions check their arguments with these, inner steps trust their caller.
#pragma once
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace nutshell {

/// Throws std::invalid_argument with `message` unless `condition` holds. Write what is wrong, where, what to
/// do.
inline void require(bool condition, const std::string& message) {
    if (!condition) throw std::invalid_argument(message);
}

/// Throws std::invalid_argument unless `value` is finite and > 0. `name` is what the message calls it.
inline void require_positive(double value, const char* name) {
    if (std::isfinite(value) && value > 0) return;
    std::ostringstream text;
    text << name << " is " << value << ", but must be finite and greater than zero";
    throw std::invalid_argument(text.str());
}

/// Throws std::invalid_argument unless every number of the Eigen vector or matrix `value` is finite.
template <class Values>
void require_finite(const Values& value, const char* name) {
    if (value.allFinite()) return;
    std::ostringstream text;
    text << name << " holds a number that is not finite: " << value.transpose();
    throw std::invalid_argument(text.str());
}

}  // namespace nutshell
