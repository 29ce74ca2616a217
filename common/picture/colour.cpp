#include "nutshell/picture/colour.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace nutshell::picture {

std::string web(const Colour& colour, Theme theme) {
    const Colour c = colour.on(theme);
    std::array<char, 8> text{};
    auto level = [](float x) { return static_cast<unsigned>(std::lround(255 * x)) & 0xFFU; };
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", level(c.red), level(c.green), level(c.blue));
    return text.data();
}

Colour mix(const Colour& a, const Colour& b, float share) {
    auto between = [share](float x, float y) { return x + share * (y - x); };
    return {between(a.red, b.red),
            between(a.green, b.green),
            between(a.blue, b.blue),
            between(a.dark_red, b.dark_red),
            between(a.dark_green, b.dark_green),
            between(a.dark_blue, b.dark_blue)};
}

}  // namespace nutshell::picture
