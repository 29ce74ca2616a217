// Colours of pictures: each once for a light page and once for a dark one. Those of methods and of arrows are
// the course's one palette, <nutshell/palette.hpp>; those of things stand out from the ground in grey too.
#pragma once
#include <nutshell/palette.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

namespace nutshell::picture {

/// What page a picture stands on.
enum class Theme { light, dark };

/// A colour as screens take it (sRGB), red, green and blue from 0 to 1.
struct Colour {
    float red = 0, green = 0, blue = 0;
    float dark_red = red, dark_green = green, dark_blue = blue;  ///< the same thing's on a dark page

    constexpr Colour on(Theme theme) const {
        return theme == Theme::dark ? Colour{dark_red, dark_green, dark_blue} : Colour{red, green, blue};
    }
    friend bool operator==(const Colour&, const Colour&) = default;
};

/// The colour written as on the web: "#D55E00" or "D55E00".
/// @throws std::invalid_argument for anything but six hexadecimal digits
constexpr Colour hex(std::string_view text) {
    const std::string_view digits = text.substr(text.starts_with('#') ? 1 : 0);
    float channels[3] = {};
    bool good = digits.size() == 6;
    for (std::size_t i = 0; good && i < 6; ++i) {
        const char c = digits[i];
        const int digit = c >= '0' && c <= '9'   ? c - '0'
                          : c >= 'a' && c <= 'f' ? c - 'a' + 10
                          : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                                 : -1;
        good = digit >= 0;
        channels[i / 2] = channels[i / 2] * 16 + static_cast<float>(digit);
    }
    if (!good) throw std::invalid_argument("hex: '" + std::string(text) + "' is not a colour like #D55E00");
    return {channels[0] / 255, channels[1] / 255, channels[2] / 255};
}

/// A colour of the course's palette, on light and on dark pages.
constexpr Colour hex(const Shades& shades) {
    const Colour light = hex(std::string_view(shades.light)), dark = hex(std::string_view(shades.dark));
    return {light.red, light.green, light.blue, dark.red, dark.green, dark.blue};
}

/// The colour as on the web, "#d55e00". @param theme on which page
std::string web(const Colour& colour, Theme theme);

/// Between a (share 0) and b (share 1).
Colour mix(const Colour& a, const Colour& b, float share);

/// Named colours.
namespace palette {
inline constexpr Colour explicit_euler = hex(shades_of(Family::explicit_one_step));
inline constexpr Colour symplectic = hex(shades_of(Family::symplectic));
inline constexpr Colour runge_kutta = hex(shades_of(Family::runge_kutta));
inline constexpr Colour implicit = hex(shades_of(Family::implicit));
inline constexpr Colour exponential = hex(shades_of(Family::exponential));
inline constexpr Colour exact = hex(Shades{"#333840", "#C9CFD6"});  ///< ink: the exact path, drawn as a ghost
inline constexpr Colour body{0.208F, 0.490F, 0.741F};               ///< a thing of no particular method: blue
inline constexpr Colour gold{0.945F, 0.690F, 0.180F};               ///< a second thing: gold
inline constexpr Colour star{1.000F, 0.800F, 0.300F};               ///< what shines
inline constexpr Colour steel{0.580F, 0.610F, 0.640F};              ///< supports, rods, walls: grey
inline constexpr Colour ink = hex(nutshell::palette::ink);          ///< text
inline constexpr Colour paper = hex(nutshell::palette::paper);
inline constexpr Colour ground = hex(Shades{"#ECEFF2", "#262B32"});
inline constexpr Colour horizon = hex(Shades{"#F4F6F8", "#1A1E23"});
inline constexpr Colour air = hex(Shades{"#CDDCEC", "#232C37"});  ///< the top of the sky
inline constexpr Colour shadow = hex(Shades{"#737A87", "#0A0C0F"});
inline constexpr Colour velocity = hex(nutshell::palette::velocity);  ///< arrows
inline constexpr Colour momentum = hex(nutshell::palette::momentum);
inline constexpr Colour force = hex(nutshell::palette::force);
inline constexpr Colour torque = hex(nutshell::palette::torque);
inline constexpr Colour angular_momentum = hex(nutshell::palette::angular_momentum);
inline constexpr Colour angular_velocity = hex(nutshell::palette::angular_velocity);
}  // namespace palette

}  // namespace nutshell::picture
