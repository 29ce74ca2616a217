// What a method looks like on every chart and picture: colour is its family, mark and dash the member.
// Pure data: common/chart and common/picture have the one palette that turns a family into a colour.
#pragma once

namespace nutshell {

enum class Family {
    explicit_one_step,  ///< Euler
    symplectic,         ///< semi-implicit Euler, Verlet, Yoshida 4, Kahan-Li 8
    runge_kutta,        ///< explicit midpoint, RK4, Dormand-Prince 5(4)
    implicit,           ///< implicit Euler, implicit midpoint
    exponential,        ///< exponential kicks, Magnus
    exact,              ///< exact, exact propagator
    peer,               ///< other engines, all grey
    reference,          ///< theory, the machine's floor
    plain               ///< not a method: "30 Hz", "60 Hz"
};

enum class Mark { circle, square, triangle, diamond, triangle_down, star, plus, cross };

/// The look of one method: its family's colour, its own mark and dash.
struct Look {
    Family family = Family::plain;
    Mark mark = Mark::circle;
    const char* dash = "";  ///< SVG stroke-dasharray, empty = solid: the first member of a family
    bool hollow = false;    ///< a variant of the method whose mark it has
};

/// The look of a variant of a method: its colour and mark, hollow and finely dashed.
constexpr Look variant(Look look) {
    look.hollow = true, look.dash = "1.5 3";
    return look;
}

}  // namespace nutshell
