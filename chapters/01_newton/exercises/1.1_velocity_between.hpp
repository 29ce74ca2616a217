// Exercise 1.1: velocity from two positions.
#pragma once
#include <nutshell/newton.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct VelocityBetween {
    static constexpr const char *id = "1.1", *function = "velocity_between";
    static constexpr auto subject =
        NUTSHELL_CALL(velocity_between);  // in the sheet this is the learner's

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const double dt = paper.step(0.1);
        for (const Vector3& next : {Vector3{1.7, 2.9, -0.6}, Vector3{-2.3, 0.8, 3.1}}) {
            const Vector3 position{1.2, -0.7, 2.1};
            paper.input("position", position, "next_position", next, "dt", dt);
            const Vector3 velocity = answer(position, next, dt);
            paper.output("the velocity [m/s]", velocity, position / dt, next / dt);
        }
    }
#ifndef NUTSHELL_SHEET
    static Exercise about();
#endif
};

inline const bool velocity_between_entered = enter<VelocityBetween>();

}  // namespace nutshell::exercises

#ifndef NUTSHELL_SHEET

namespace nutshell::mistakes {

inline Vector3 displacement_for_velocity(const Vector3& position, const Vector3& next_position,
                                         double) {
    return next_position - position;
}
inline Vector3 velocity_times_dt(const Vector3& position, const Vector3& next_position,
                                 double dt) {
    return (next_position - position) * dt;
}
inline Vector3 velocity_backwards(const Vector3& position, const Vector3& next_position,
                                  double dt) {
    return (position - next_position) / dt;
}
inline Vector3 velocity_over_two_steps(const Vector3& position, const Vector3& next_position,
                                       double dt) {
    return (next_position - position) / (2 * dt);
}

}  // namespace nutshell::mistakes

namespace nutshell::alternatives {

inline Vector3 velocity_by_rate(const Vector3& position, const Vector3& next_position,
                                double dt) {
    const double rate = 1 / dt;
    return rate * next_position - rate * position;
}

}  // namespace nutshell::alternatives

namespace nutshell::exercises {

inline Exercise VelocityBetween::about() {
    return {
        .title = "Velocity from two positions",
        .hints =
            {"Velocity is how far the body gets in one second. You know how far it gets in dt "
             "seconds.",
             "Where it is then, less where it was, is the way it went: a vector. How often does "
             "dt fit "
             "into a second?",
             "The way from the first position to the second one, divided by the time it took."},
        .mistakes =
            {{"the way, not the velocity", "classic: moving by frames",
              "The game runs twice as fast on a screen with twice the frames.",
              "You return how far the body moved in this interval; a velocity is that per "
              "second, so the "
              "time it took must enter.",
              attempt<VelocityBetween>(NUTSHELL_CALL(mistakes::displacement_for_velocity))},
             {"multiplied by dt", "classic",
              "Almost nothing moves, and the shorter the frame the less.",
              "You multiply the way by dt. A shorter time for the same way means a higher "
              "velocity, so dt "
              "belongs below the line.",
              attempt<VelocityBetween>(NUTSHELL_CALL(mistakes::velocity_times_dt))},
             {"backwards in time", "classic", "Everything flies backwards.",
              "You take the old position less the new one. The way goes from the old position to "
              "the new "
              "one: new less old.",
              attempt<VelocityBetween>(NUTSHELL_CALL(mistakes::velocity_backwards))},
             {"two steps where there is one", "classic: the central difference",
              "Everything moves at half its speed.",
              "You divide by 2 dt. That is right for positions two steps apart; these are one "
              "step apart.",
              attempt<VelocityBetween>(NUTSHELL_CALL(mistakes::velocity_over_two_steps))}},
        .alternatives = {{"each position times the rate", attempt<VelocityBetween>(NUTSHELL_CALL(
                                                              alternatives::velocity_by_rate))}},
    };
}

}  // namespace nutshell::exercises

#endif
