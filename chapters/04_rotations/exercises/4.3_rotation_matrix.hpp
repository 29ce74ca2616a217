// Exercise 4.3: the matrix of a 4-vector, where the source's (28) has two wrong entries.
#pragma once
#include <nutshell/rotations.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct RotationMatrix {
    static constexpr const char *id = "4.3", *function = "rotation_matrix";
    static constexpr auto subject = NUTSHELL_CALL(rotation_matrix);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const Eigen::Vector4d& numbers :
             {Eigen::Vector4d(0.3, -0.5, 0.7, 0.4), Eigen::Vector4d(-0.6, 0.2, 0.1, -0.9),
              Eigen::Vector4d(0.8, 0.4, -0.3, 0.2), Eigen::Vector4d(0, 0, 0, 1)}) {
            const Quaternion q(Eigen::Vector4d(numbers.normalized()));
            paper.input("q", q);
            const Matrix3 r = answer(q);
            paper.output("the matrix", r, 1.0);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<RotationMatrix> about() {
        return {
            .title = "The matrix of a 4-vector",
            .hints =
                {"Put x = n0 s, y = n1 s, z = n2 s and w = c into (26*). Nothing else is to "
                 "be done.",
                 "The 4-vector of no turn at all is (0, 0, 0, 1). Which matrix must it give? "
                 "Try it on each diagonal entry.",
                 "Each diagonal entry has the square of its own number and that of w, twice, "
                 "less one. Off the diagonal, partners differ in the sign of the term with w."},
            .picture = "printed.png",
            .mistakes =
                {{"the first entry as printed", "E16",
                  "A body that never turned is turned by half a turn about z and mirrored.",
                  "The entry (0,0) of the printed (28) has a wrong index: the square of w "
                  "belongs "
                  "there, as in the other two.",
                  [](const Quaternion& q) -> Matrix3 {
                      Matrix3 r = q.toRotationMatrix();
                      r(0, 0) = 2 * (q.x() * q.x() + q.y() * q.y()) - 1;
                      return r;
                  }},
                 {"the third entry of the first row as printed", "E17",
                  "A cube that yaws is sheared flat.",
                  "The entry (0,2) of the printed (28) has the wrong sign before the term with "
                  "w.",
                  [](const Quaternion& q) -> Matrix3 {
                      Matrix3 r = q.toRotationMatrix();
                      r(0, 2) = 2 * (q.x() * q.z() - q.y() * q.w());
                      return r;
                  }},
                 {"equation (28) as printed", "E16, E17",
                  "A cube that turns becomes a skewed box, turned inside out.",
                  "Two entries of the printed (28) are wrong: (0,0) has the square of y instead "
                  "of "
                  "w, (0,2) the wrong sign.",
                  [](const Quaternion& q) -> Matrix3 {
                      Matrix3 r = q.toRotationMatrix();
                      r(0, 0) = 2 * (q.x() * q.x() + q.y() * q.y()) - 1;
                      r(0, 2) = 2 * (q.x() * q.z() - q.y() * q.w());
                      return r;
                  }},
                 {"the transpose", "E51: rows for columns",
                  "Everything turns the other way; the camera works, the bodies do not.",
                  "Your matrix turns back: the terms with w have the other sign.",
                  [](const Quaternion& q) -> Matrix3 {
                      return q.toRotationMatrix().transpose();
                  }},
                 {"w taken for the first number", "classic: two orders are in use",
                  "After loading a level every body lies in a wrong pose.",
                  "You read the four numbers as w, x, y, z. Here they are x, y, z, w; use q.x(), "
                  "q.y(), q.z() and q.w() by name.",
                  [](const Quaternion& q) -> Matrix3 {
                      return Quaternion(q.x(), q.y(), q.z(), q.w()).toRotationMatrix();
                  }},
                 {"the one forgotten", "classic", "Everything doubles in size along its axis.",
                  "The diagonal entries are less by one: the matrix of (0, 0, 0, 1) must be the "
                  "identity.",
                  [](const Quaternion& q) -> Matrix3 {
                      return q.toRotationMatrix() + Matrix3::Identity();
                  }},
                 {"the diagonal in another order", "classic",
                  "What turns about one axis is stretched along another.",
                  "The entries beside the diagonal are right. On it the squares are mixed up: "
                  "each axis has its own, or those of the two others.",
                  [](const Quaternion& q) -> Matrix3 {
                      const double x = q.x(), y = q.y(), z = q.z(), w = q.w();
                      Matrix3 r;
                      r << 1 - 2 * (x * x + y * y), 2 * (x * y - w * z), 2 * (x * z + w * y),
                          2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                          2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (y * y + z * z);
                      return r;
                  }},
                 {"the square of the axis itself on the diagonal", "classic",
                  "What should stay on the axis is turned.",
                  "1 - 2 (...) holds the squares of the two other components, not of the axis "
                  "itself.",
                  [](const Quaternion& q) -> Matrix3 {
                      const double x = q.x(), y = q.y(), z = q.z(), w = q.w();
                      Matrix3 r;
                      r << 1 - 2 * x * x, 2 * (x * y - w * z), 2 * (x * z + w * y),
                          2 * (x * y + w * z), 1 - 2 * y * y, 2 * (y * z - w * x),
                          2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * z * z;
                      return r;
                  }},
                 {"no two beside the diagonal", "classic", "Things shrink when they turn.",
                  "Each entry beside the diagonal is a sum of two products, twice.",
                  [](const Quaternion& q) -> Matrix3 {
                      const double x = q.x(), y = q.y(), z = q.z(), w = q.w();
                      Matrix3 r;
                      r << 1 - 2 * (y * y + z * z), x * y - w * z, x * z + w * y, x * y + w * z,
                          1 - 2 * (x * x + z * z), y * z - w * x, x * z - w * y, y * z + w * x,
                          1 - 2 * (x * x + y * y);
                      return r;
                  }},
                 {"no two on the diagonal", "classic", "Things grow when they turn.",
                  "On the diagonal the squares count twice.",
                  [](const Quaternion& q) -> Matrix3 {
                      const double x = q.x(), y = q.y(), z = q.z(), w = q.w();
                      Matrix3 r;
                      r << 1 - (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
                          2 * (x * y + w * z), 1 - (x * x + z * z), 2 * (y * z - w * x),
                          2 * (x * z - w * y), 2 * (y * z + w * x), 1 - (x * x + y * y);
                      return r;
                  }},
                 {"a plus on the diagonal", "classic", "Things explode.",
                  "On the diagonal the squares of the two others are taken off the one.",
                  [](const Quaternion& q) -> Matrix3 {
                      const double x = q.x(), y = q.y(), z = q.z(), w = q.w();
                      Matrix3 r;
                      r << 1 + 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
                          2 * (x * y + w * z), 1 + 2 * (x * x + z * z), 2 * (y * z - w * x),
                          2 * (x * z - w * y), 2 * (y * z + w * x), 1 + 2 * (x * x + y * y);
                      return r;
                  }},
                 {"no two at all", "classic", "Things shrink when they turn.",
                  "Each product counts twice, on the diagonal and beside it.",
                  [](const Quaternion& q) -> Matrix3 {
                      const double x = q.x(), y = q.y(), z = q.z(), w = q.w();
                      Matrix3 r;
                      r << 1 - y * y - z * z, x * y - w * z, x * z + w * y, x * y + w * z,
                          1 - x * x - z * z, y * z - w * x, x * z - w * y, y * z + w * x,
                          1 - x * x - y * y;
                      return r;
                  }}},
            .alternatives = {{"ones on the diagonal less two squares",
                              [](const Quaternion& q) -> Matrix3 {
                                  const double x = q.x(), y = q.y(), z = q.z(), w = q.w();
                                  Matrix3 r;
                                  r << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z),
                                      2 * (x * z + w * y), 2 * (x * y + w * z),
                                      1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                                      2 * (x * z - w * y), 2 * (y * z + w * x),
                                      1 - 2 * (x * x + y * y);
                                  return r;
                              }},
                             {"the images of x, y and z as columns",
                              [](const Quaternion& q) -> Matrix3 {
                                  Matrix3 r;
                                  r << rotate(q, Vector3::UnitX()), rotate(q, Vector3::UnitY()),
                                      rotate(q, Vector3::UnitZ());
                                  return r;
                              }}},
        };
    }
#endif
};

inline const bool rotation_matrix_entered = enter<RotationMatrix>();

}  // namespace nutshell::exercises
