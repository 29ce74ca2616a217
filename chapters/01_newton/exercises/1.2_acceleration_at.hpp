// Exercise 1.2: acceleration from three positions.
#pragma once
#include <nutshell/newton.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct AccelerationAt {
    static constexpr const char *id = "1.2", *function = "acceleration_at";
    static constexpr auto subject = NUTSHELL_CALL(acceleration_at);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const double dt = paper.step(0.4);
        const Vector3 a{0.3, -1.2, 0.7}, b{1.4, 0.6, -0.8}, c{2.1, 1.3, -1.5}, d{-0.5, 1.9, 1.1};
        for (const auto& [before, here, after] :
             {std::array{a, b, c}, {d, b, c}, {a, d, c}, {a, b, d}}) {
            paper.input("before", before, "here", here, "after", after, "dt", dt);
            const Vector3 acceleration = answer(before, here, after, dt);
            paper.output("the acceleration [m/s^2]", acceleration, before / (dt * dt),
                         here / (dt * dt), after / (dt * dt));
        }
    }

#ifndef NUTSHELL_SHEET
    static About<AccelerationAt> about() {
        return {
            .title = "Acceleration from three positions",
            .hints = {"Acceleration is to velocity what velocity is to position. You have just "
                      "written velocity from positions.",
                      "Three positions give two velocities: one before the middle position, one "
                      "after it. They are dt apart.",
                      "Use velocity_between twice, take the later velocity less the earlier one, "
                      "and divide by the time between them."},
            .mistakes =
                {{"the change of velocity, not the acceleration", "classic",
                  "Forces measured from a replay change with the frame rate.",
                  "You stop at the difference of the two velocities. They are dt apart in time, "
                  "and acceleration is the change per second.",
                  [](const Vector3& before, const Vector3& here, const Vector3& after,
                     double dt) -> Vector3 {
                      return velocity_between(here, after, dt) -
                             velocity_between(before, here, dt);
                  }},
                 {"divided by two steps", "classic: the central difference",
                  "Measured gravity is 4.9 m/s^2: half of what it is.",
                  "You divide by 2 dt. The two velocities belong to the middles of neighbouring "
                  "intervals, and these are only dt apart.",
                  [](const Vector3& before, const Vector3& here, const Vector3& after,
                     double dt) -> Vector3 {
                      return (velocity_between(here, after, dt) -
                              velocity_between(before, here, dt)) /
                             (2 * dt);
                  }},
                 {"the middle position counted once", "classic",
                  "A body at rest seems to accelerate away from the origin.",
                  "The middle position ends one interval and begins the next, so it must count "
                  "twice: with three equal positions nothing may be left.",
                  [](const Vector3& before, const Vector3& here, const Vector3& after,
                     double dt) -> Vector3 { return (after - here + before) / (dt * dt); }},
                 {"the earlier velocity less the later one", "classic",
                  "A falling ball seems to be pulled upwards.",
                  "You take the earlier velocity less the later one. A change is new less old.",
                  [](const Vector3& before, const Vector3& here, const Vector3& after,
                     double dt) -> Vector3 {
                      return (velocity_between(before, here, dt) -
                              velocity_between(here, after, dt)) /
                             dt;
                  }},
                 {"always zero", "E02", "Nothing ever falls.",
                  "You return zero whatever the positions are. The source prints the "
                  "acceleration as zero by definition, but that is a consequence for a body "
                  "without force, not what acceleration is.",
                  [](const Vector3&, const Vector3&, const Vector3&, double) -> Vector3 {
                      return Vector3::Zero();
                  }},
                 {"a velocity divided by dt", "classic",
                  "A body in steady motion seems to feel a force.",
                  "You divide a velocity by dt. Only a change of velocity is an acceleration: "
                  "steady motion has none.",
                  [](const Vector3& before, const Vector3&, const Vector3& after, double dt)
                      -> Vector3 { return velocity_between(before, after, 2 * dt) / dt; }},
                 {"a velocity, not an acceleration", "classic",
                  "A body in steady motion seems to feel a force.",
                  "The way from the first place to the last over the time between is a velocity. "
                  "An acceleration is the change of one, so the middle place must enter.",
                  [](const Vector3& before, const Vector3&, const Vector3& after,
                     double dt) -> Vector3 { return (after - before) / (2 * dt); }}},
            .alternatives = {{"the second difference",
                              [](const Vector3& before, const Vector3& here, const Vector3& after,
                                 double dt) -> Vector3 {
                                  return (before - 2 * here + after) / (dt * dt);
                              }}},
        };
    }
#endif
};

inline const bool acceleration_at_entered = enter<AccelerationAt>();

}  // namespace nutshell::exercises
