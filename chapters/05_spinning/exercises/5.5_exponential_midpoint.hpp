// Exercise 5.5: the exponential with the angular velocity of the step's middle.
#pragma once
#include "spins.hpp"

namespace nutshell::exercises {

struct ExponentialMidpoint {
    static constexpr const char *id = "5.5", *function = "exponential_midpoint";
    static constexpr auto subject = NUTSHELL_CALL(exponential_midpoint);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        ask_spin(paper, answer, 0.6);
    }

#ifndef NUTSHELL_SHEET
    static About<ExponentialMidpoint> about() {
        return {
            .title = "The middle of the step",
            .hints =
                {"A difference belongs to the middle of its interval, chapter 1 said. So "
                 "does a turn: which angular velocity is the best one for the whole step?",
                 "That of the time t + dt/2. If it depends on the pose, you need the pose of "
                 "the middle too, and you can make it: with half a step of exercise 5.4.",
                 "First a half step gives the middle's pose. Ask spin there and then; turn "
                 "the pose of the start by that, for the whole dt."},
            .order = 2,
            .picture = "coning.svg",
            .mistakes =
                {{"the start's angular velocity", "classic: exercise 5.4",
                  "The coning rod is late, and stays late.",
                  "You use the angular velocity of the start. That is first order.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return exp_of(spin(q, t) * dt) * q;
                  }},
                 {"the middle's time, the start's pose", "classic",
                  "Right for a spin that follows the clock, not for one that follows the body.",
                  "You ask for the middle's time but with the pose of the start.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return exp_of(spin(q, t + dt / 2) * dt) * q;
                  }},
                 {"the middle's pose, the start's time", "classic",
                  "Right for a spin that follows the body, not for one that follows the clock.",
                  "You ask with the middle's pose, but for the time t.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const Quaternion middle = exp_of(spin(q, t) * (dt / 2)) * q;
                      return exp_of(spin(middle, t) * dt) * q;
                  }},
                 {"from the middle on", "classic", "Everything turns half as far again.",
                  "You turn the pose of the middle by the whole step. The step begins at q.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const Quaternion middle = exp_of(spin(q, t) * (dt / 2)) * q;
                      return exp_of(spin(middle, t + dt / 2) * dt) * middle;
                  }},
                 {"about the body's axes", "E20: the wrong side",
                  "A tilted body turns about a tilted axis.",
                  "Both turns stand on the right of the pose. omega is in the world's axes: "
                  "left.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const Quaternion middle = q * exp_of(spin(q, t) * (dt / 2));
                      return q * exp_of(spin(middle, t + dt / 2) * dt);
                  }},
                 {"the step's end for its middle", "classic", "It is of second order no more.",
                  "You go a whole step to find the middle: half a step, dt/2.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const Quaternion m = exponential_map(q, spin, t, dt);
                      return product(exponential(spin(m, t + dt / 2) * dt), q);
                  }},
                 {"the angular velocity of the end", "classic", "It is of first order only.",
                  "You ask for the angular velocity at the end of the step, not at its middle.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const Quaternion m = exponential_map(q, spin, t, dt);
                      return product(exponential(spin(m, t + dt) * dt), q);
                  }},
                 {"the mean of start and end", "classic", "As good, but another method.",
                  "You take the mean of the angular velocities of both ends. The one of the "
                  "middle was asked for.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const Quaternion m = exponential_map(q, spin, t, dt);
                      return product(exponential((spin(q, t) + spin(m, t + dt)) * (dt / 2)), q);
                  }},
                 {"the end's time with the middle's pose", "classic",
                  "It is of first order only.",
                  "The pose of the middle belongs to the time t + dt/2.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const Quaternion m = exponential_map(q, spin, t, dt / 2);
                      return product(exponential(spin(m, t + dt) * dt), q);
                  }},
                 {"half a turn at the end", "classic", "Everything spins at half its speed.",
                  "The last turn lasts the whole of dt.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const Quaternion m = exponential_map(q, spin, t, dt / 2);
                      return product(exponential(spin(m, t + dt / 2) * (dt / 2)), q);
                  }},
                 {"two halves with two angular velocities", "classic",
                  "It is of first order only.",
                  "You turn the pose of the middle on by half a step, so the first half was "
                  "turned with the "
                  "start's angular velocity. The middle's turns the start's pose by all of dt.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const Quaternion middle = exp_of(spin(q, t) * (dt / 2)) * q;
                      return exp_of(spin(middle, t + dt / 2) * (dt / 2)) * middle;
                  }}},
            .alternatives =
                {{"in one breath",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return exp_of(dt * spin(exp_of(dt / 2 * spin(q, t)) * q, t + dt / 2)) * q;
                  }},
                 {"by exercise 5.4's step from the middle's angular velocity",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const Vector3 omega = spin(exponential_map(q, spin, t, dt / 2), t + dt / 2);
                      const auto steady = [&](const Quaternion&, double) { return omega; };
                      return exponential_map(q, steady, t, dt);
                  }}},
        };
    }
#endif
};

inline const bool exponential_midpoint_entered = enter<ExponentialMidpoint>();

}  // namespace nutshell::exercises
