// Exercise 4.6: the turn of a rotation vector, the zero vector included.
#pragma once
#include <nutshell/rotations.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct Exponential {
    static constexpr const char *id = "4.6", *function = "exponential";
    static constexpr auto subject = NUTSHELL_CALL(exponential);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const Vector3& a :
             {Vector3(0.3, -0.2, 0.5), Vector3(-1.1, 0.7, 1.6), Vector3(2.2, 1.4, -3.3),
              Vector3(3e-5, -2e-5, 1e-5), Vector3(2e-9, 3e-9, -1e-9), Vector3(-4e-170, 1e-170, 0),
              Vector3(0, 0, 0)}) {
            paper.input("a", a);
            const Quaternion q = answer(a);
            paper.output("the 4-vector", q, 1.0);
            // where the length of a vanishes in a double, no turn at all is as good
            if (a.norm() == 0 && a != Vector3::Zero()) continue;
            // its vector part alone, to its own last digits, for q and -q alike
            const Vector3 u = q.w() < 0 ? Vector3(-q.vec()) : Vector3(q.vec());
            const bool large_or_none = a.norm() > 1 || a == Vector3::Zero();
            paper.output("the part (x, y, z)", u, large_or_none ? Vector3(1, 1, 1) : a);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<Exponential> about() {
        return {
            .title = "The turn of a rotation vector",
            .hints = {"A rotation vector holds the axis in its direction and the angle in its "
                      "length. Equation (27) wants the two apart.",
                      "For a vector of length zero there is no direction, and none is needed: "
                      "which 4-vector must come out? What is sin(angle/2)/angle near zero?",
                      "Multiply a by one number: sin(angle/2)/angle, and where the square of the "
                      "angle is tiny by the first terms of its series, 1/2 - angle^2/48."},
            .mistakes =
                {{"0/0 at rest", "E52: the source's class Rotation",
                  "Every body that does not spin disappears in the first step.",
                  "You divide by the length of a vector that may be zero. A body at rest turns "
                  "by "
                  "no angle: the answer is (0, 0, 0, 1).",
                  [](const Vector3& a) -> Quaternion {
                      const double square = a[0] * a[0] + a[1] * a[1] + a[2] * a[2],
                                   angle = std::sqrt(square);
                      return four_vector(a / angle * std::sin(angle / 2), std::cos(angle / 2));
                  }},
                 {"no turn where the angle is small", "classic: a guard too timid",
                  "Slow spins stand still.",
                  "You return (0, 0, 0, 1) for small vectors too. A small turn is half of the "
                  "vector, and a million of them are a large one.",
                  [](const Vector3& a) -> Quaternion {
                      const double angle = a.norm();
                      if (angle < 1e-4) return four_vector({0, 0, 0}, 1);
                      return four_vector(a / angle * std::sin(angle / 2), std::cos(angle / 2));
                  }},
                 {"the whole angle", "classic", "Everything turns twice as fast.",
                  "The 4-vector has sine and cosine of half the angle.",
                  [](const Vector3& a) -> Quaternion {
                      const double angle = a.norm();
                      if (angle < 1e-100) return four_vector(a, 1);
                      return four_vector(a / angle * std::sin(angle), std::cos(angle));
                  }},
                 {"the turn back", "E51: the source's class Rotation",
                  "Everything spins the other way.", "Your turn is about the opposite axis.",
                  [](const Vector3& a) -> Quaternion {
                      const double angle = a.norm();
                      if (angle < 1e-100) return four_vector(-a / 2, 1);
                      return four_vector(-a / angle * std::sin(angle / 2), std::cos(angle / 2));
                  }},
                 {"first order only", "E18", "Fast spins lag behind.",
                  "You stop at (a/2, 1). That is the beginning of the series; the sine and the "
                  "cosine are all of it.",
                  [](const Vector3& a) -> Quaternion {
                      return four_vector(a / 2, 1).normalized();
                  }},
                 {"w first", "classic: two orders are in use", "A body at rest lies on its back.",
                  "Your numbers stand in the order w, x, y, z. Here it is x, y, z, w; "
                  "four_vector "
                  "takes the vector first.",
                  [](const Vector3& a) -> Quaternion {
                      const double angle = a.norm(),
                                   scale = angle < 1e-4 ? 0.5 : std::sin(angle / 2) / angle;
                      return Quaternion(Eigen::Vector4d(std::cos(angle / 2), scale * a[0],
                                                        scale * a[1], scale * a[2]));
                  }},
                 {"the vector for its direction", "classic", "Fast turns are no turns at all.",
                  "The sine belongs before the direction of a, a over its length; you have a "
                  "itself.",
                  [](const Vector3& a) -> Quaternion {
                      const double t = a.norm();
                      if (t == 0) return Quaternion::Identity();
                      const Vector3 n = a / t;
                      return four_vector(n * t * std::sin(t / 2), std::cos(t / 2));
                  }},
                 {"sine and cosine exchanged", "classic", "No turn is a half turn.",
                  "The scalar is the cosine of half the angle, the vector part has the sine.",
                  [](const Vector3& a) -> Quaternion {
                      const double t = a.norm();
                      if (t == 0) return Quaternion::Identity();
                      const Vector3 n = a / t;
                      return four_vector(n * std::cos(t / 2), std::sin(t / 2));
                  }},
                 {"the half in the vector part only", "classic",
                  "The result is not as long as one.",
                  "Both sine and cosine are of half the angle.",
                  [](const Vector3& a) -> Quaternion {
                      const double t = a.norm();
                      if (t == 0) return Quaternion::Identity();
                      const Vector3 n = a / t;
                      return four_vector(n * std::sin(t / 2), std::cos(t));
                  }},
                 {"the half in the scalar only", "classic", "The result is not as long as one.",
                  "Both sine and cosine are of half the angle.",
                  [](const Vector3& a) -> Quaternion {
                      const double t = a.norm();
                      if (t == 0) return Quaternion::Identity();
                      const Vector3 n = a / t;
                      return four_vector(n * std::sin(t), std::cos(t / 2));
                  }}},
            .alternatives = {{"a case for tiny angles, the axis for others",
                              [](const Vector3& a) -> Quaternion {
                                  const double angle = a.norm();
                                  if (angle < 1e-8) return four_vector(a / 2, 1);
                                  return quaternion_about(a, angle);
                              }},
                             {"a length that does not underflow",
                              [](const Vector3& a) -> Quaternion {
                                  const double angle = std::hypot(a.x(), a.y(), a.z());
                                  const double scale =
                                      angle == 0 ? 0.5 : std::sin(angle / 2) / angle;
                                  return four_vector(scale * a, std::cos(angle / 2));
                              }}},
            .survivors = {{"- to +",
                           "below 1e-8 the third term of the series is less than the tolerance"},
                          {"48 to 0.999 of it",
                           "below 1e-8 the third term of the series is less than the tolerance"},
                          {"48 to 48 + 1",
                           "below 1e-8 the third term of the series is less than the tolerance"},
                          {"1e-8 to 0.999 of it",
                           "either side of the border both forms are right to the tolerance"},
                          {"< at 0.8 * 1e-8",
                           "either side of the border both forms are right to the tolerance"},
                          {"< at 1.25 * 1e-8",
                           "either side of the border both forms are right to the tolerance"},
                          {"< to <=",
                           "either side of the border both forms are right to the tolerance"}},
        };
    }
#endif
};

inline const bool exponential_entered = enter<Exponential>();

}  // namespace nutshell::exercises
