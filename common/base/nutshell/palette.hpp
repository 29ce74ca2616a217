// The one palette of charts, diagrams and pictures: each colour once for light paper and once for dark.
// Okabe and Ito's hues, shifted in lightness until each has a contrast of 4.5 with its paper, so that names
// can be written in them, and all families stay apart for readers who do not see red, green or blue (a test
// measures both).
#pragma once
#include <nutshell/look.hpp>

namespace nutshell {

/// A colour as #RRGGBB, on light paper and on dark.
struct Shades {
    const char *light, *dark;
};

namespace palette {
inline constexpr Shades vermilion{"#C44E00", "#F5875A"};
inline constexpr Shades green{"#00804D", "#30D893"};
inline constexpr Shades blue{"#0068C4", "#35B0FF"};
inline constexpr Shades purple{"#8A1F74", "#F373D8"};
inline constexpr Shades gold{"#6B4E00", "#E8C430"};
inline constexpr Shades grey{"#6B7178", "#99A1AB"};
inline constexpr Shades ink{"#1D2126", "#ECEFF3"};  ///< the colour of the text
inline constexpr Shades paper{"#FFFFFF", "#15181C"};

// Quantities drawn as arrows, the same on diagrams and pictures.
inline constexpr Shades force = vermilion, torque = vermilion;
inline constexpr Shades velocity = blue, momentum = gold;
inline constexpr Shades angular_velocity = purple, angular_momentum = green;
}  // namespace palette

/// The colour of a family of methods. `plain` has the text's; charts that show several plain things have
/// steps of their own for them.
constexpr Shades shades_of(Family family) {
    switch (family) {
        case Family::explicit_one_step:
            return palette::vermilion;
        case Family::symplectic:
            return palette::green;
        case Family::runge_kutta:
            return palette::blue;
        case Family::implicit:
            return palette::purple;
        case Family::exponential:
            return palette::gold;
        case Family::peer:
            return palette::grey;
        case Family::exact:
        case Family::reference:
        case Family::plain:
            break;
    }
    return palette::ink;
}

}  // namespace nutshell
