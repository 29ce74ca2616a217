// Exercise 4.7: back from the 4-vector to the rotation vector.
#pragma once
#include <nutshell/rotations.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct Logarithm {
    static constexpr const char *id = "4.7", *function = "logarithm";
    static constexpr auto subject = NUTSHELL_CALL(logarithm);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Vector3 n = Vector3(2, -3, 6) / 7, m = Vector3(-6, 2, 3) / 7;
        for (const Vector3& axis : {n, m})
            for (const double angle : {0.7, 2.9, 3.3, 5.1, -1.2, 1.98e-4, 2e-5, 3e-9}) {
                const Quaternion q = four_vector(std::sin(angle / 2) * axis, std::cos(angle / 2));
                paper.input("q", q);
                const Vector3 a = answer(q);
                const double shorter = std::remainder(angle, 2 * pi);
                paper.output("the rotation vector [rad]", a, Vector3(shorter * axis));
            }
        for (const double length : {2.5, 0.2})  // its length does not matter
            for (const double angle : {0.7, 5.1}) {
                const Quaternion q(
                    four_vector(std::sin(angle / 2) * n, std::cos(angle / 2)).coeffs() * length);
                paper.input("q", q);
                const Vector3 a = answer(q);
                paper.output("the rotation vector [rad]", a,
                             Vector3(std::remainder(angle, 2 * pi) * n));
            }
        paper.input("q", four_vector({0, 0, 0}, 1));
        const Vector3 none = answer(four_vector({0, 0, 0}, 1));
        paper.output("the rotation vector [rad]", none, 1.0);
        paper.input("q", four_vector({0, 0, 0}, -1));
        const Vector3 also_none = answer(four_vector({0, 0, 0}, -1));
        paper.output("the rotation vector [rad]", also_none, 1.0);
    }

#ifndef NUTSHELL_SHEET
    static About<Logarithm> about() {
        return {
            .title = "The rotation vector of a 4-vector",
            .hints =
                {"You know the sine of half the angle (the length of x, y, z) and its cosine "
                 "(w). Which function takes both?",
                 "q and -q are the same pose: of the two, take the one with w not negative, "
                 "and you go the shorter way.",
                 "Multiply the vector by 2 atan2(length, w)/length; where the length is tiny "
                 "that is 2/w to all its digits, nearly: take off a third of 2 length^2."},
            .mistakes =
                {{"half of the angle", "classic", "Tweens stop half-way.",
                  "The arc tangent gives half of the angle: the 4-vector knows no more.",
                  [](const Quaternion& q) -> Vector3 {
                      const double sign = q.w() < 0 ? -1 : 1, length = q.vec().norm();
                      if (length == 0) return Vector3::Zero();
                      return sign * q.vec() / length * std::atan2(length, sign * q.w());
                  }},
                 {"the arc cosine of w", "classic", "Slow turns stand still, then jerk.",
                  "Near 1 the cosine has forgotten the angle: 3e-9 rad leave no trace in w. The "
                  "sine has them all; use both in atan2.",
                  [](const Quaternion& q) -> Vector3 {
                      const double sign = q.w() < 0 ? -1 : 1, length = q.vec().norm();
                      if (length == 0) return Vector3::Zero();
                      return sign * q.vec() / length *
                             (2 * std::acos(std::min(1.0, sign * q.w())));
                  }},
                 {"the longer way", "classic", "A door swings open through the wall.",
                  "For w below zero you turn by more than half a turn. -q is the same pose, the "
                  "shorter way.",
                  [](const Quaternion& q) -> Vector3 {
                      const double length = q.vec().norm();
                      if (length == 0) return Vector3::Zero();
                      return q.vec() / length * (2 * std::atan2(length, q.w()));
                  }},
                 {"twice the vector", "classic: the small-angle rule for large angles",
                  "Large turns fall short.",
                  "2 (x, y, z) is the rotation vector of small turns only: it is twice the sine "
                  "of "
                  "half the angle.",
                  [](const Quaternion& q) -> Vector3 { return (q.w() < 0 ? -2 : 2) * q.vec(); }},
                 {"0/0 where there is no turn", "E52", "A thing that stands still disappears.",
                  "You divide by the length of a vector that may be zero.",
                  [](const Quaternion& q) -> Vector3 {
                      const double sign = q.w() < 0 ? -1 : 1, length = q.vec().norm();
                      return sign * q.vec() / length * (2 * std::atan2(length, sign * q.w()));
                  }},
                 {"the arguments of atan2 exchanged", "classic", "No turn is half a turn.",
                  "atan2 takes the sine first: the length of the vector part, then w.",
                  [](const Quaternion& q) -> Vector3 {
                      const double s = q.w() < 0 ? -1 : 1, w = s * q.w();
                      const Vector3 u = s * q.vec();
                      const double l = u.norm();
                      if (l == 0) return Vector3::Zero();
                      return 2 * std::atan2(w, l) / l * u;
                  }},
                 {"the axis not made of length one", "classic", "Small turns vanish.",
                  "The vector part has the length of the sine: divide it by that before the "
                  "angle is multiplied on.",
                  [](const Quaternion& q) -> Vector3 {
                      const double s = q.w() < 0 ? -1 : 1, w = s * q.w();
                      const Vector3 u = s * q.vec();
                      const double l = u.norm();
                      if (l == 0) return Vector3::Zero();
                      return 2 * std::atan2(l, w) * u;
                  }},
                 {"the direction alone", "classic", "All turns are alike.",
                  "You return the direction of the axis. Its length must be the angle.",
                  [](const Quaternion& q) -> Vector3 {
                      const double s = q.w() < 0 ? -1 : 1, w = s * q.w();
                      const Vector3 u = s * q.vec();
                      const double l = u.norm();
                      if (l == 0) return Vector3::Zero();
                      return u / l + 0 * w * u;
                  }},
                 {"the angle without the sign, the axis with it", "classic",
                  "Tweens beyond half a turn run backwards.",
                  "For w below zero you make the angle the short one and leave the axis. -q is "
                  "the same pose: turn the sign of all four numbers.",
                  [](const Quaternion& q) -> Vector3 {
                      const double l = q.vec().norm();
                      if (l == 0) return Vector3::Zero();
                      return 2 * std::atan2(l, std::abs(q.w())) / l * q.vec();
                  }},
                 {"the longer way, by the arc cosine", "classic",
                  "A door swings open through the wall, and slow turns stand still.",
                  "For w below zero you turn by more than half a turn: -q is the same pose, the "
                  "shorter way. And near 1 the cosine has forgotten the angle: use atan2.",
                  [](const Quaternion& q) -> Vector3 {
                      if (q.vec().norm() == 0) return Vector3::Zero();
                      return 2 * std::acos(q.w()) * q.vec().normalized();
                  }},
                 {"the arc sine", "classic: right for a length of one only",
                  "Poses that have lost a little of their length turn too far.",
                  "The arc sine takes the length of the vector part for a sine, which it is only "
                  "if q is of "
                  "length one. atan2 needs the ratio alone.",
                  [](const Quaternion& q) -> Vector3 {
                      const Vector3 u = (q.w() < 0 ? -1 : 1) * q.vec();
                      const double l = u.norm();
                      if (l == 0) return Vector3::Zero();
                      return 2 * std::asin(std::min(1.0, l)) / l * u;
                  }},
                 {"half a turn taken off", "classic: pi for 2 pi",
                  "Tweens beyond half a turn stop somewhere else.",
                  "You bring angles beyond half a turn down by pi. The pose comes back after a "
                  "whole turn only, and what is left then is negative: the other way round.",
                  [](const Quaternion& q) -> Vector3 {
                      const double l = q.vec().norm();
                      if (l == 0) return Vector3::Zero();
                      const double angle = 2 * std::atan2(l, q.w());
                      return (angle > pi ? angle - pi : angle) / l * q.vec();
                  }}},
            .alternatives = {{"the arc sine, and two cases",
                              [](const Quaternion& q) -> Vector3 {
                                  const Quaternion p = q.normalized();
                                  const double sign = p.w() < 0 ? -1 : 1, length = p.vec().norm();
                                  if (length < 1e-7) return 2 * sign * p.vec();
                                  const double angle = length < 0.7 ? 2 * std::asin(length)
                                                                    : 2 * std::acos(sign * p.w());
                                  return sign * p.vec() * (angle / length);
                              }},
                             {"Eigen's",
                              [](const Quaternion& q) -> Vector3 {
                                  const Eigen::AngleAxisd turn(q);
                                  return turn.angle() * turn.axis();
                              }}},
            .survivors =
                {{"* to /, 3", "w is one to 5e-9 where the series is used"},
                 {"* to /, 4", "w is one to 5e-9 where the series is used"},
                 {"* to /, 6", "w is one to 5e-9 where the series is used"},
                 {"* to /, 7", "w is one to 5e-9 where the series is used"},
                 {"1 to 0.999 of it", "a common factor of u and w drops out"},
                 {"1 to 0.999 of it, 2", "a common factor of u and w drops out"},
                 {"1 to 1 + 1", "a common factor of u and w drops out"},
                 {"1 to 1 + 1, 2", "a common factor of u and w drops out"},
                 {"2 to 0.999 of it, 2",
                  "it changes the answer by less than the tolerance where the series is used"},
                 {"3 to 0.999 of it",
                  "it changes the answer by less than the tolerance where the series is used"},
                 {"3 to 3 + 1",
                  "it changes the answer by less than the tolerance where the series is used"},
                 {"1e-8 to 0.999 of it",
                  "either side of the border both forms are right to the tolerance"},
                 {"< at 0.8 * 1e-8 * w * w",
                  "either side of the border both forms are right to the tolerance"},
                 {"< at 1.25 * 1e-8 * w * w",
                  "either side of the border both forms are right to the tolerance"},
                 {"< to <=, 2",
                  "either side of the border both forms are right to the tolerance"},
                 {"< to <=", "half a turn: both ways are as short, and no question is there"},
                 {"an int for sign", "it is 1 or -1"}},
        };
    }
#endif
};

inline const bool logarithm_entered = enter<Logarithm>();

}  // namespace nutshell::exercises
