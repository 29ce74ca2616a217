// Exercise 5.6: fourth order by two angular velocities and what their order costs.
#pragma once
#include "spins.hpp"

namespace nutshell::exercises {

struct Magnus4 {
    static constexpr const char *id = "5.6", *function = "magnus4";
    static constexpr auto subject = NUTSHELL_CALL(magnus4);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        ask_spin(paper, answer, 0);
    }

#ifndef NUTSHELL_SHEET
    /// The step with its numbers open: where the two looks are, and the factor of the cross term.
    template <class Spin>
    static Quaternion with(const Quaternion& q, const Spin& spin, double t, double dt,
                           double apart, double factor) {
        const Vector3 one = spin(q, t + dt / 2 - apart * dt),
                      two = spin(q, t + dt / 2 + apart * dt);
        return exp_of(dt / 2 * (one + two) + factor * dt * dt * two.cross(one)) * q;
    }
    static About<Magnus4> about() {
        return {
            .title = "Magnus: two looks and a cross product",
            .hints = {"Two looks placed like Gauss's, at the middle minus and plus sqrt(3)/6 of "
                      "dt, sum a smooth function to fourth order. Turns need one term more.",
                      "First along omega_1, then along omega_2 is not the same as along their "
                      "mean: a turn about the cross product is left over.",
                      "The rotation vector is dt/2 times the sum, plus sqrt(3)/12 dt^2 times "
                      "(the second crossed with the first)."},
            .order = 4,
            .picture = "coning.svg",
            .mistakes =
                {{"the cross product the other way", "classic: the formula for body axes",
                  "Refining the step helps less than it should.",
                  "In world axes the later angular velocity comes first in the cross product. "
                  "Your "
                  "sign doubles the error instead of removing it: second order.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return with(q, spin, t, dt, std::sqrt(3.0) / 6, -std::sqrt(3.0) / 12);
                  }},
                 {"no cross product", "classic: a mean of angular velocities",
                  "Twice the looks of the midpoint method, and no higher an order.",
                  "You turn by the mean. Turns do not commute, and that costs two orders.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return with(q, spin, t, dt, std::sqrt(3.0) / 6, 0);
                  }},
                 {"looks at the ends", "classic", "Refining the step helps less than it should.",
                  "You look at the step's start and end. Two looks give fourth order only at "
                  "Gauss's places.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return with(q, spin, t, dt, 0.5, std::sqrt(3.0) / 12);
                  }},
                 {"the sum, not the mean", "classic", "Everything turns twice as fast.",
                  "Two looks: half of dt belongs to each.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const double apart = std::sqrt(3.0) / 6 * dt;
                      const Vector3 one = spin(q, t + dt / 2 - apart),
                                    two = spin(q, t + dt / 2 + apart);
                      return exp_of(dt * (one + two) +
                                    std::sqrt(3.0) / 12 * dt * dt * two.cross(one)) *
                             q;
                  }},
                 {"about the body's axes", "E20: the wrong side",
                  "A tilted body turns about a tilted axis.",
                  "The turn stands on the right of q. omega is in the world's axes: left.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const double apart = std::sqrt(3.0) / 6 * dt;
                      const Vector3 one = spin(q, t + dt / 2 - apart),
                                    two = spin(q, t + dt / 2 + apart);
                      return q * exp_of(dt / 2 * (one + two) +
                                        std::sqrt(3.0) / 12 * dt * dt * two.cross(one));
                  }},
                 {"dt for dt^2", "classic: a unit that does not fit",
                  "The rod leaves its cone however small the step.",
                  "The cross product of two angular velocities is in 1/s^2: it wants dt twice.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return with(q, spin, t, dt, std::sqrt(3.0) / 6, std::sqrt(3.0) / 12 / dt);
                  }},
                 {"the looks twice too far from the middle", "classic",
                  "It is of second order only.",
                  "The two looks are sqrt(3)/6 of the step to either side of its middle. Twice "
                  "that belongs to an interval of length 2.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const double r = std::sqrt(3.0);
                      const Vector3 f = spin(q, t + dt * (0.5 - 1 / r)),
                                    s = spin(q, t + dt * (0.5 + 1 / r));
                      return product(
                          exponential(dt / 2 * (f + s) + r / 12 * dt * dt * s.cross(f)), q);
                  }},
                 {"the cross product twice", "classic", "It is of second order only.",
                  "The factor of the cross product is sqrt(3)/12.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const double r = std::sqrt(3.0);
                      const Vector3 f = spin(q, t + dt * (0.5 - r / 6)),
                                    s = spin(q, t + dt * (0.5 + r / 6));
                      return product(exponential(dt / 2 * (f + s) + r / 6 * dt * dt * s.cross(f)),
                                     q);
                  }},
                 {"the cross product without its root", "classic", "It is of second order only.",
                  "The factor of the cross product is sqrt(3)/12, with the root.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const double r = std::sqrt(3.0);
                      const Vector3 f = spin(q, t + dt * (0.5 - r / 6)),
                                    s = spin(q, t + dt * (0.5 + r / 6));
                      return product(exponential(dt / 2 * (f + s) + dt * dt / 12 * s.cross(f)),
                                     q);
                  }},
                 {"the looks a quarter from the ends", "classic", "It is of second order only.",
                  "The two looks are sqrt(3)/6 of the step to either side of its middle, not a "
                  "quarter.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const double r = std::sqrt(3.0);
                      const Vector3 f = spin(q, t + dt * (0.5 - 0.25)),
                                    s = spin(q, t + dt * (0.5 + 0.25));
                      return product(
                          exponential(dt / 2 * (f + s) + r / 12 * dt * dt * s.cross(f)), q);
                  }},
                 {"the looks too near to the middle", "classic", "It is of second order only.",
                  "The two looks are sqrt(3)/6 of the step to either side of its middle, not "
                  "sqrt(3)/12.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const double r = std::sqrt(3.0);
                      const Vector3 f = spin(q, t + dt * (0.5 - r / 12)),
                                    s = spin(q, t + dt * (0.5 + r / 12));
                      return product(
                          exponential(dt / 2 * (f + s) + r / 12 * dt * dt * s.cross(f)), q);
                  }},
                 {"looks round the start", "classic", "It is of first order only.",
                  "Your two looks lie round t, the start of the step. They belong round its "
                  "middle, t + dt/2.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return with(q, spin, t - dt / 2, dt, std::sqrt(3.0) / 6,
                                  std::sqrt(3.0) / 12);
                  }},
                 {"looks as far apart at every step", "classic: a dt forgotten",
                  "Small steps help nothing.",
                  "Your two looks are sqrt(3)/6 seconds from the middle, outside of a small "
                  "step. It is that "
                  "part of dt.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return with(q, spin, t, dt, std::sqrt(3.0) / 6 / dt, std::sqrt(3.0) / 12);
                  }}},
            .alternatives = {{"minus the first crossed with the second",
                              [](const Quaternion& q, const auto& spin, double t,
                                 double dt) -> Quaternion {
                                  const double r = std::sqrt(3.0);
                                  const Vector3 a = dt * spin(q, t + (3 - r) / 6 * dt),
                                                b = dt * spin(q, t + (3 + r) / 6 * dt);
                                  return exp_of((a + b) / 2 - r / 12 * a.cross(b)) * q;
                              }}},
            .survivors = {{"3.0 without its point", "std::sqrt takes 3 as 3.0"},
                          {"3.0 without its point, 2", "std::sqrt takes 3 as 3.0"}},
        };
    }
#endif
};

inline const bool magnus4_entered = enter<Magnus4>();

}  // namespace nutshell::exercises
