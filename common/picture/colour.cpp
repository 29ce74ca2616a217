#include "nutshell/picture/colour.hpp"

#include <stdexcept>
#include <string>

namespace nutshell::picture {

namespace {

int digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

}  // namespace

Colour hex(std::string_view text) {
    const std::string_view digits = text.substr(text.starts_with('#') ? 1 : 0);
    bool good = digits.size() == 6;
    for (char c : digits) good = good && digit(c) >= 0;
    if (!good) {
        throw std::invalid_argument("hex: '" + std::string(text) + "' is not a colour like #D55E00");
    }
    auto channel = [&](std::size_t i) {
        return float(16 * digit(digits[i]) + digit(digits[i + 1])) / 255.0F;
    };
    return {channel(0), channel(2), channel(4)};
}

Colour mix(const Colour& a, const Colour& b, float share) {
    auto between = [share](float x, float y) { return x + share * (y - x); };
    return {between(a.red, b.red), between(a.green, b.green), between(a.blue, b.blue)};
}

}  // namespace nutshell::picture
