#include "compare.hpp"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace nutshell::judge {

using exercises::Output;
using exercises::Record;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double apart(double a, double b, double scale) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    if (!std::isfinite(a) || !std::isfinite(b)) return infinity;
    return scale > 0 ? std::abs(a - b) / scale : infinity;
}

}  // namespace

double apart(const Output& output, const Values& right, const Values& yours) {
    if (right.size() != yours.size()) return infinity;
    double most = 0, turned = output.quaternion ? 0 : infinity;  // -q is the same rotation as q
    for (std::size_t i = 0; i < right.size(); ++i) {
        most = std::max(most, apart(right[i], yours[i], output.scale));
        turned = std::max(turned, apart(right[i], -yours[i], output.scale));
    }
    return std::min(most, turned);
}

double difference(const Record& reference, const Record& a, const Record& b) {
    const auto& outputs = reference.outputs;
    if (a.outputs.size() != outputs.size() || b.outputs.size() != outputs.size()) return infinity;
    double most = 0;
    for (std::size_t i = 0; i < outputs.size(); ++i)
        most = std::max(most, apart(outputs[i], a.outputs[i].values, b.outputs[i].values));
    return most;
}

bool agrees(const Record& reference, const std::vector<Values>& yours) {
    const auto& outputs = reference.outputs;
    if (yours.size() != outputs.size()) return false;
    for (std::size_t i = 0; i < outputs.size(); ++i)
        if (!(apart(outputs[i], outputs[i].values, yours[i]) <= tolerance)) return false;
    return true;
}

bool finite(const Values& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

double distance(const Values& a, const Values& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
}

std::string digits(double value, const char* format) {
    char text[40];
    std::snprintf(text, sizeof text, format, value == 0 ? 0 : value);  // no "-0"
    return text;
}

std::string shown(const Values& values, const Values& other, bool matrix) {
    std::size_t first = 0;  // where they differ
    while (first < values.size() && first < other.size() &&
           std::abs(values[first] - other[first]) <= 1e-9 * std::abs(values[first]))
        ++first;
    const std::size_t count = values.size(),
                      begin = other.empty() || first < 9 || count <= 9 ? 0 : std::min(first - 2, count - 9);
    const auto with = [&](const Values& of, const char* format) {
        std::string text;
        for (std::size_t i = begin; i < of.size() && i < begin + 9; ++i)
            text += (i == begin             ? ""
                     : matrix && i % 3 == 0 ? ")\n                ("
                                            : ", ") +
                    digits(of[matrix ? i / 3 + 3 * (i % 3) : i], format);
        if (of.size() == 1) return text;
        return (begin > 0 ? "(..., " : "(") + text + (of.size() > begin + 9 ? ", ...)" : ")") +
               (begin > 0 ? ", from number " + std::to_string(begin + 1) + " of " + std::to_string(count)
                          : "");
    };
    const char* format = "%.9g";
    if (values != other && with(values, format) == with(other, format)) format = "%.17g";
    return with(values, format);
}

}  // namespace nutshell::judge
