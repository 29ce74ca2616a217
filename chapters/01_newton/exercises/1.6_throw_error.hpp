// Exercise 1.6: the error law of the three methods under constant acceleration, as a prediction.
#pragma once
#include <nutshell/newton.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct ThrowError {
    static constexpr const char *id = "1.6", *function = "throw_error";
    static constexpr auto subject = NUTSHELL_CALL(throw_error);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const double dt = paper.step(0.07);
        const Vector3 down{1.3, -9.81, 2.4}, up{-2.2, 3.7, 0.6};
        for (const auto& [acceleration, duration] :
             {std::pair{down, 1.5}, {down, 4.0}, {up, 1.5}}) {
            const Vector3 term = acceleration * duration * dt;
            paper.input("acceleration", acceleration, "duration", duration, "dt", dt);
            const Vector3 euler = answer(Kicked::after_drift, acceleration, duration, dt);
            paper.output("Euler's error [m]", euler, term);
            const Vector3 semi_implicit =
                answer(Kicked::before_drift, acceleration, duration, dt);
            paper.output("semi-implicit Euler's error [m]", semi_implicit, term);
            const Vector3 verlet = answer(Kicked::half_and_half, acceleration, duration, dt);
            paper.output("Verlet's error [m]", verlet, term);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<ThrowError> about() {
        return {
            .title = "How wrong a throw is, before you throw",
            .hints = {"Compare one step with the truth. Over one step the exact way is v dt + a "
                      "dt^2/2; which velocity does each method drift with?",
                      "Euler drifts with the velocity of the start and lacks a dt^2/2 in each "
                      "step; semi-implicit Euler has as much too much. How many steps are there "
                      "in the duration?",
                      "Number of steps, T/dt, times the error of one step, with its sign: one "
                      "method lags, one leads, one has the mean velocity exactly."},
            .picture = "throw.png",
            .mistakes =
                {{"no error at all", "E04", "The ball flies too high, and nobody can say why.",
                  "You return zero, as the source's remark suggests: Euler is good if the force "
                  "hardly changes in a step. Here it does not change at all, and Euler is still "
                  "wrong: the velocity changes during the step, and the drift does not see it.",
                  [](Kicked, const Vector3&, double, double) -> Vector3 {
                      return Vector3::Zero();
                  }},
                 {"the error of one step only", "classic: local for global error",
                  "Halving dt halves the error, where you promised a quarter.",
                  "a dt^2/2 is what one step adds. There are T/dt of them, and their errors add "
                  "up, so one power of dt is gone at the end.",
                  [](Kicked kicked, const Vector3& acceleration, double, double dt) -> Vector3 {
                      const Vector3 error = acceleration * dt * dt / 2;
                      return kicked == Kicked::after_drift    ? Vector3(-error)
                             : kicked == Kicked::before_drift ? error
                                                              : Vector3::Zero();
                  }},
                 {"the signs exchanged", "classic",
                  "You aim lower to correct, and miss by twice as much.",
                  "The size is right, the sign is not. The error is computed less exact; Euler "
                  "lags behind the acceleration, so with gravity pointing down its ball is too "
                  "high.",
                  [](Kicked kicked, const Vector3& acceleration, double duration, double dt)
                      -> Vector3 { return -throw_error(kicked, acceleration, duration, dt); }},
                 {"a factor of two", "classic", "The promised error is twice the one seen.",
                  "You have a dt^2 for a step. The velocity grows evenly from start to end of a "
                  "step, so on the average it is off by half of a dt.",
                  [](Kicked kicked, const Vector3& acceleration, double duration, double dt)
                      -> Vector3 { return 2 * throw_error(kicked, acceleration, duration, dt); }},
                 {"the same error for both", "classic",
                  "The correction for one method doubles the error of the other.",
                  "Euler drifts with the velocity of the step's start, semi-implicit Euler with "
                  "that of its end: one comes too short, the other too far.",
                  [](Kicked kicked, const Vector3& acceleration, double duration,
                     double dt) -> Vector3 {
                      return kicked == Kicked::half_and_half
                                 ? Vector3::Zero()
                                 : Vector3(-acceleration * duration * dt / 2);
                  }},
                 {"the duration left out", "classic",
                  "A long throw misses by more than you promised.",
                  "The error does not grow with the duration in your formula. Each step adds its "
                  "part, so twice the steps have twice the error.",
                  [](Kicked kicked, const Vector3& acceleration, double duration,
                     double dt) -> Vector3 {
                      return throw_error(kicked, acceleration, duration, dt) / duration;
                  }},
                 {"an error for Verlet", "classic: order taken for error",
                  "You make the step smaller than it need be.",
                  "Verlet is of second order, but that is a bound for any force. With constant "
                  "acceleration it drifts with the exact mean velocity and has no error.",
                  [](Kicked kicked, const Vector3& acceleration, double duration,
                     double dt) -> Vector3 {
                      if (kicked == Kicked::half_and_half)
                          return acceleration * duration * dt * dt / 2;
                      return throw_error(kicked, acceleration, duration, dt);
                  }}},
            .alternatives = {{"steps times the error of one",
                              [](Kicked kicked, const Vector3& acceleration, double duration,
                                 double dt) -> Vector3 {
                                  const double part = kicked == Kicked::after_drift    ? -0.5
                                                      : kicked == Kicked::before_drift ? 0.5
                                                                                       : 0.0;
                                  const double steps = duration / dt;
                                  return part * steps * (dt * dt * acceleration);
                              }}},
            .survivors = {{"statements 2 and 3 swapped",
                           "two questions about the method that exclude each other"},
                          {"result to int, 3", "zero has no fraction"}},
        };
    }
#endif
};

inline const bool throw_error_entered = enter<ThrowError>();

}  // namespace nutshell::exercises
