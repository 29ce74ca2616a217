// The questions that Euler, semi-implicit Euler and Verlet are asked alike.
#pragma once
#include <nutshell/newton_scenes.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

/// Another state with a drift and a kick: a step must move it as well as a PointMass.
struct Sledge {
    double mass;
    Vector3 position, momentum;
};
inline void drift(Sledge& sledge, double dt) {
    sledge.position += sledge.momentum / sledge.mass * dt;
}
inline void kick(Sledge& sledge, const Vector3& force, double dt) {
    sledge.momentum += force * dt;
}

inline Vector3 velocity_of(const PointMass& body) {
    return body.velocity;
}
inline Vector3 velocity_of(const Sledge& sledge) {
    return sledge.momentum / sledge.mass;
}

/// A force that lets no slip hide: it depends on the place and the time, and if it has drag, on
/// the velocity.
struct Tether {
    double pull, drag;
    template <class State>
    Vector3 operator()(const State& state, double t) const {
        return -pull * state.position + (1 + t) * Vector3{0.9, -1.4, 0.7} -
               drag * velocity_of(state);
    }
};

/// Said of a step that passes, but moves a PointMass only.
inline constexpr const char* beyond_one_state =
    "moves a PointMass only, for it names its members. Said with drift and kick, the same lines "
    "will move "
    "the states of later chapters too, which have no velocity.";

/// One step of each state; then the planet's orbit for one unit of time, against Kepler's
/// equation.
template <class Answer>
void ask_step(Paper& paper, const Answer& answer, double drag) {
    const double dt = paper.step(0.2);
    const PointMass light{2.5, {1.1, -0.8, 0.6}, {0.7, 1.3, -0.9}},
        heavy{7.5, {-0.4, 1.6, 0.9}, {1.2, -0.6, 0.8}};
    for (const auto& [body, pull, t] :
         {std::tuple{light, 1.7, 0.6}, {light, 1.7, 2.3}, {light, 0.4, 0.6}, {heavy, 1.7, 0.6}}) {
        const Tether tether{pull, drag};
        const Vector3 gain = tether(body, t) / body.mass * dt;
        paper.input("a point mass, mass", body.mass, "position", body.position, "velocity",
                    body.velocity, "on a tether of", pull, "t", t, "dt", dt);
        const PointMass moved = answer(body, tether, t, dt);
        paper.changed("the position [m]", moved.position, body.position, body.velocity * dt,
                      gain * dt);
        paper.changed("the velocity [m/s]", moved.velocity, body.velocity, gain);
        paper.changed("the mass [kg]", moved.mass, body.mass);
    }

    const Planet planet;
    const int steps = static_cast<int>(std::lround(1 / paper.step(1.0 / 64)));
    paper.input("the planet's orbit for 1 unit of time, steps", steps);
    PointMass orbiting = planet.start;
    for (int i = 0; i < steps; ++i)
        orbiting = answer(orbiting, planet, i / static_cast<double>(steps), 1.0 / steps);
    paper.run("the planet's position at the end [a]", orbiting.position, planet.exact(1).position,
              planet.start.position);

#ifndef NUTSHELL_ESSENTIALS  // defined when a learner's step moves a PointMass only
    if (!paper.asks_beyond()) return;
    const Tether tether{1.7, drag};
    const Sledge sledge{2.5, light.position, light.mass * light.velocity};
    const Vector3 gain = tether(light, 0.6) / light.mass * dt;
    paper.input("a state of another type, with its own drift and kick, dt", dt);
    const Sledge slid = answer(sledge, tether, 0.6, dt);
    paper.changed("the other state's position [m]", slid.position, sledge.position,
                  light.velocity * dt, gain * dt);
    paper.changed("the other state's momentum [kg m/s]", slid.momentum, sledge.momentum,
                  gain * light.mass);
#endif
}

}  // namespace nutshell::exercises
