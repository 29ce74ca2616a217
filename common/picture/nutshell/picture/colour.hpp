// Colours of pictures: after Okabe and Ito, told apart by colour-blind readers; some a little darker, so that
// all stand out from the ground in grey too.
#pragma once
#include <string_view>

namespace nutshell::picture {

/// A colour as screens take it (sRGB), red, green and blue from 0 to 1.
struct Colour {
    float red = 0, green = 0, blue = 0;
    friend bool operator==(const Colour&, const Colour&) = default;
};

/// The colour written as on the web: "#D55E00" or "D55E00".
/// @throws std::invalid_argument for anything but six hexadecimal digits
Colour hex(std::string_view text);

/// Between a (share 0) and b (share 1).
Colour mix(const Colour& a, const Colour& b, float share);

/// Named colours. Those of methods are their families' on every chart and picture of the course.
namespace palette {
inline constexpr Colour explicit_euler{0.835F, 0.369F, 0.000F};  ///< #D55E00
inline constexpr Colour symplectic{0.000F, 0.588F, 0.427F};      ///< #00966D
inline constexpr Colour runge_kutta{0.000F, 0.447F, 0.698F};     ///< #0072B2
inline constexpr Colour implicit{0.643F, 0.275F, 0.522F};        ///< #A44685
inline constexpr Colour exponential{0.596F, 0.420F, 0.000F};     ///< #986B00
inline constexpr Colour exact{0.200F, 0.220F, 0.250F};           ///< ink: the exact path, drawn as a ghost
inline constexpr Colour body{0.208F, 0.490F, 0.741F};            ///< a thing of no particular method: blue
inline constexpr Colour gold{0.945F, 0.690F, 0.180F};            ///< a second thing: gold
inline constexpr Colour star{1.000F, 0.800F, 0.300F};            ///< what shines
inline constexpr Colour steel{0.580F, 0.610F, 0.640F};           ///< supports, rods, walls: grey
inline constexpr Colour ink{0.106F, 0.122F, 0.149F};             ///< text
inline constexpr Colour paper{1.000F, 1.000F, 1.000F};
inline constexpr Colour ground{0.925F, 0.937F, 0.949F};
inline constexpr Colour shadow{0.450F, 0.480F, 0.530F};
inline constexpr Colour velocity{0.000F, 0.447F, 0.698F};          ///< arrows of velocity: blue
inline constexpr Colour force{0.835F, 0.369F, 0.000F};             ///< arrows of force: vermilion
inline constexpr Colour angular_momentum{0.000F, 0.588F, 0.427F};  ///< arrows of L: green
inline constexpr Colour angular_velocity{0.643F, 0.275F, 0.522F};  ///< arrows of omega: purple
}  // namespace palette

}  // namespace nutshell::picture
