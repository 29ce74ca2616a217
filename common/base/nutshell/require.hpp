// Contracts at the door: public functions check their arguments with these, inner steps trust their caller.
// Without streams: they would be the larger part of every figure that moves in a page.
#pragma once
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace nutshell {

/// Throws std::invalid_argument with `message` unless `condition` holds. Write what is wrong, where, what to
/// do.
inline void require(bool condition, const std::string& message) {
    if (!condition) throw std::invalid_argument(message);
}

/// A number as messages write it: six digits.
inline std::string digits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

/// Throws std::invalid_argument unless `value` is finite and > 0. `name` is what the message calls it.
inline void require_positive(double value, const char* name) {
    if (std::isfinite(value) && value > 0) return;
    throw std::invalid_argument(std::string(name) + " is " + digits(value) +
                                ", but must be finite and greater than zero");
}

/// Throws std::invalid_argument unless every number of the Eigen vector or matrix `value` is finite.
template <class Values>
void require_finite(const Values& value, const char* name) {
    if (value.allFinite()) return;
    std::string text = std::string(name) + " holds a number that is not finite:";
    for (int column = 0; column < value.cols(); ++column)
        for (int row = 0; row < value.rows(); ++row) text += " " + digits(value(row, column));
    throw std::invalid_argument(text);
}

}  // namespace nutshell
