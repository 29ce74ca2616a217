// Chapter 3 · A mistake kept for its lesson: drag computed from the velocity of the step
// before.
#pragma once
#include <nutshell/newton.hpp>

namespace nutshell::mistakes {

// [stale_drag]
/// Euler in the order of the source's program (E59): it works out its forces before it
/// refreshes the velocity from the momentum, so they see the velocity of one step ago. Drag
/// then follows v'' = v' - x v, x = gamma dt/m: it swings beyond x = 1/4 and grows beyond x =
/// 1, where Euler itself holds to 2.
struct StaleEuler {
    std::optional<Vector3> last_velocity = {};

    template <class State, class Forces>
    State operator()(State state, const Forces& forces, double t, double dt) {
        State seen = state;
        if (last_velocity) seen.velocity = *last_velocity;
        last_velocity = state.velocity;
        const auto push = forces(seen, t);
        drift(state, dt);
        kick(state, push, dt);
        return state;
    }
};
// [/stale_drag]

inline constexpr Method stale_euler{"Euler, stale drag",
                                    {Family::explicit_one_step, Mark::triangle_down, "8 3"},
                                    1,
                                    1,
                                    [](const auto&) { return StaleEuler{}; }};

}  // namespace nutshell::mistakes
