// Chapter 3 · A better method out of several steps of a good one.
//
// A symmetric method of order 2 (Verlet) is wrong by a known shape of error, e2 dt^3 + e4 dt^5
// + ...  Take some steps forward and some back, of lengths w1 dt, w2 dt, ... that add up to dt,
// and choose them so that the leading errors cancel. What comes out is again made of drifts and
// kicks only, so it keeps what Verlet keeps.
#pragma once
#include <array>
#include <nutshell/newton.hpp>

namespace nutshell {

// [composed]
/// One step made of `Count` steps of another stepper, of lengths weights[i] * dt. The weights add
/// up to 1.
template <class Part, std::size_t Count>
struct Composed {
    Part part;
    std::array<double, Count> weights;

    template <class State, class Forces>
    State operator()(State state, const Forces& forces, double t, double dt) {
        for (const double weight : weights) {
            state = part(std::move(state), forces, t, weight * dt);
            t += weight * dt;
        }
        return state;
    }
};
template <class Part, std::size_t Count>
Composed(Part, std::array<double, Count>) -> Composed<Part, Count>;
// [/composed]

// [yoshida_weights]
/// Three steps w1, w0, w1 of a symmetric second-order method give order 4 if 2 w1 + w0 = 1 and
/// 2 w1^3 + w0^3 = 0. Source: H. Yoshida, Phys. Lett. A 150 (1990) 262.
inline std::array<double, 3> yoshida_weights() {
    // exercise 3.3
    const double w1 = 1 / (2 - std::cbrt(2.0)), w0 = 1 - 2 * w1;
    return {w1, w0, w1};
    // end 3.3
}
// [/yoshida_weights]

// [kahan_li_weights]
/// Fifteen steps give order 8: there is no formula, the numbers solve a system of equations.
/// Source: W. Kahan and R.-C. Li, Math. Comp. 66 (1997) 1089.
inline std::array<double, 15> kahan_li_weights() {
    const double a = 0.74167036435061295344822780, b = -0.40910082580003159399730010,
                 c = 0.19075471029623837995387626, d = -0.57386247111608226665638773,
                 e = 0.29906418130365592384446354, f = 0.33462491824529818378495798,
                 g = 0.31529309239676659663205666, middle = 1 - 2 * (a + b + c + d + e + f + g);
    return {a, b, c, d, e, f, g, middle, g, f, e, d, c, b, a};
}
// [/kahan_li_weights]

/// How a run of a composed method starts. @param weights  a function that gives them
template <class Start, std::size_t Count>
constexpr auto composed(const Method<Start>& part, std::array<double, Count> (*weights)()) {
    return [start = part.start, weights](const auto& scene) {
        return Composed{start(scene), weights()};
    };
}

}  // namespace nutshell
