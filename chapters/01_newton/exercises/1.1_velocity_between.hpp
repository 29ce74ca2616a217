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
        const double h = paper.step(0.4), other = paper.step(0.7);
        const Vector3 a{1.2, -0.7, 2.1}, b{1.7, 2.9, -0.6}, c{-2.3, 0.8, 3.1};
        for (const auto& [position, next, dt] :
             {std::tuple{a, b, h}, {a, c, h}, {b, c, h}, {b, c, other}}) {
            paper.input("position", position, "next_position", next, "dt", dt);
            const Vector3 velocity = answer(position, next, dt);
            paper.output("the velocity [m/s]", velocity, position / dt, next / dt);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<VelocityBetween> about() {
        return {
            .title = "Velocity from two positions",
            .hints = {"Velocity is how far the body gets in one second. You know how far it gets "
                      "in dt seconds.",
                      "Where it is then, less where it was, is the way it went: a vector. How "
                      "often does dt fit into a second?",
                      "The way from the first position to the second one, divided by the time it "
                      "took."},
            .mistakes = {{"the way, not the velocity", "classic: moving by frames",
                          "The game runs twice as fast on a screen with twice the frames.",
                          "You return how far the body moved in this interval; a velocity is "
                          "that per second, so the time it took must enter.",
                          [](const Vector3& position, const Vector3& next_position,
                             double) -> Vector3 { return next_position - position; }},
                         {"multiplied by dt", "classic",
                          "Almost nothing moves, and the shorter the frame the less.",
                          "You multiply the way by dt. A shorter time for the same way means a "
                          "higher velocity, so dt belongs below the line.",
                          [](const Vector3& position, const Vector3& next_position,
                             double dt) -> Vector3 { return (next_position - position) * dt; }},
                         {"backwards in time", "classic", "Everything flies backwards.",
                          "You take the old position less the new one. The way goes from the old "
                          "position to the new one: new less old.",
                          [](const Vector3& position, const Vector3& next_position,
                             double dt) -> Vector3 { return (position - next_position) / dt; }},
                         {"two steps where there is one", "classic: the central difference",
                          "Everything moves at half its speed.",
                          "You divide by 2 dt. That is right for positions two steps apart; "
                          "these are one step apart.",
                          [](const Vector3& position, const Vector3& next_position, double dt)
                              -> Vector3 { return (next_position - position) / (2 * dt); }},
                         {"the sum, not the difference", "classic", "Things at rest fly away.",
                          "You add the two positions. The way is their difference.",
                          [](const Vector3& position, const Vector3& next_position,
                             double dt) -> Vector3 { return (position + next_position) / dt; }},
                         {"the new place only", "classic",
                          "Things at rest far away fly the fastest.",
                          "You divide the new position by dt. The way begins at the old one: "
                          "take it off.",
                          [](const Vector3&, const Vector3& next_position, double dt) -> Vector3 {
                              return next_position / dt;
                          }}},
            .alternatives = {{"each position times the rate",
                              [](const Vector3& position, const Vector3& next_position,
                                 double dt) -> Vector3 {
                                  const double rate = 1 / dt;
                                  return rate * next_position - rate * position;
                              }}},
        };
    }
#endif
};

inline const bool velocity_between_entered = enter<VelocityBetween>();

}  // namespace nutshell::exercises
