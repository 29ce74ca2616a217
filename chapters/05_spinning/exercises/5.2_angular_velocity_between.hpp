// Exercise 5.2: the angular velocity that leads from one pose to the next.
#pragma once
#include <nutshell/spinning.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct AngularVelocityBetween {
    static constexpr const char *id = "5.2", *function = "angular_velocity_between";
    static constexpr auto subject = NUTSHELL_CALL(angular_velocity_between);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Quaternion a = Quaternion(0.4, 0.3, -0.5, 0.7).normalized(),
                         b = Quaternion(0.9, -0.6, 0.2, 0.1).normalized(),
                         c = Quaternion(-0.7, 0.1, 0.4, -0.5).normalized();
        for (const auto& [from, to] : {std::pair(a, b), {b, a}, {a, c}, {c, b}})
            for (const double dt : {0.3, 1.7}) {
                paper.input("from", from, "to", to, "dt", dt);
                paper.frame(from);
                const Vector3 omega = answer(from, to, dt);
                paper.output("the angular velocity [rad/s]", omega, 1 / dt);
            }
        paper.input("from", a, "to", a, "dt", 0.3);
        const Vector3 none = answer(a, a, 0.3);
        paper.output("the angular velocity [rad/s]", none, 1.0);
    }

#ifndef NUTSHELL_SHEET
    static Vector3 log_of(const Quaternion& q) {
        const Eigen::AngleAxisd turn(q);
        return turn.angle() * turn.axis();
    }
    static About<AngularVelocityBetween> about() {
        return {
            .title = "Angular velocity from two looks",
            .hints = {"Chapter 1 took the difference of two positions over the time. What is the "
                      "difference of two poses?",
                      "The turn that leads from the first to the second is the second times the "
                      "inverse of the first. Its rotation vector is an angle in a direction.",
                      "Divide the logarithm of that turn by dt."},
            .mistakes =
                {{"in the body's axes", "E20: the wrong side",
                  "A gyroscope's reading is used for the world's, and the view tilts.",
                  "You multiply by the inverse from the left, which gives the axis as the body "
                  "sees it.",
                  [](const Quaternion& from, const Quaternion& to, double dt) -> Vector3 {
                      return log_of(from.conjugate() * to) / dt;
                  }},
                 {"from the second to the first", "classic", "Motion blur points backwards.",
                  "Your turn leads back.",
                  [](const Quaternion& from, const Quaternion& to, double dt) -> Vector3 {
                      return log_of(from * to.conjugate()) / dt;
                  }},
                 {"not divided by the time", "classic", "A slow machine sees faster spins.",
                  "You return the angle turned. Divide by the time it took.",
                  [](const Quaternion& from, const Quaternion& to, double) -> Vector3 {
                      return log_of(to * from.conjugate());
                  }},
                 {"the difference of the 4-vectors", "classic: right for small turns only",
                  "Fast spins are measured too slow.",
                  "Twice the vector part of the product is the sine's, not the angle's.",
                  [](const Quaternion& from, const Quaternion& to, double dt) -> Vector3 {
                      const Quaternion turn = to * from.conjugate();
                      return (turn.w() < 0 ? -2 : 2) * turn.vec() / dt;
                  }},
                 {"the longer way", "classic", "Now and then a body seems to spin furiously.",
                  "For w below zero you take the turn of more than half a turn.",
                  [](const Quaternion& from, const Quaternion& to, double dt) -> Vector3 {
                      const Quaternion turn = to * from.conjugate();
                      const double length = turn.vec().norm();
                      if (length < 1e-12) return Vector3::Zero();
                      return turn.vec() / length * (2 * std::atan2(length, turn.w()) / dt);
                  }},
                 {"the difference of the rotation vectors", "classic",
                  "Right as long as the axis stays.",
                  "You subtract the two logarithms. That is right about one axis only: take the "
                  "logarithm of the turn that leads from one to the other.",
                  [](const Quaternion& from, const Quaternion& to, double dt) -> Vector3 {
                      return (logarithm(to) - logarithm(from)) / dt;
                  }},
                 {"the product without its inverse", "classic", "Bodies at rest seem to spin.",
                  "You take the logarithm of the product of both poses. It is the later one "
                  "times the inverse of the earlier.",
                  [](const Quaternion& from, const Quaternion& to, double dt) -> Vector3 {
                      return logarithm(product(to, from)) / dt;
                  }},
                 {"half of the turn", "classic", "Everything seems half as fast.",
                  "You take half of the logarithm. It is the whole rotation vector already.",
                  [](const Quaternion& from, const Quaternion& to, double dt) -> Vector3 {
                      return logarithm(product(to, inverse(from))) / (2 * dt);
                  }},
                 {"the difference of the numbers", "classic",
                  "Fast turns look slower, and a pose written as -q spins wildly.",
                  "The difference of the four numbers is right for small turns only, and q and "
                  "-q are the same pose. Take the logarithm of the turn between them.",
                  [](const Quaternion& from, const Quaternion& to, double dt) -> Vector3 {
                      return 2 * product(Quaternion((to.coeffs() - from.coeffs()) / dt),
                                         inverse(from))
                                     .vec();
                  }},
                 {"the difference of the vector parts", "classic",
                  "Spins about a tilted axis are wrong.",
                  "You subtract the first three of the four numbers. The turn from one pose to "
                  "the next is a "
                  "product, to times the inverse of from; take its rotation vector.",
                  [](const Quaternion& from, const Quaternion& to, double dt) -> Vector3 {
                      return 2 * (to.vec() - from.vec()) / dt;
                  }}},
            .alternatives = {{"by Eigen's angle and axis",
                              [](const Quaternion& from, const Quaternion& to, double dt)
                                  -> Vector3 { return log_of(to * from.conjugate()) / dt; }},
                             {"in the body, then turned",
                              [](const Quaternion& from, const Quaternion& to,
                                 double dt) -> Vector3 {
                                  return from * Vector3(log_of(from.conjugate() * to) / dt);
                              }}},
        };
    }
#endif
};

inline const bool angular_velocity_between_entered = enter<AngularVelocityBetween>();

}  // namespace nutshell::exercises
