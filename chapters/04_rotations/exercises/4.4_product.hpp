// Exercise 4.4: the product of two 4-vectors.
#pragma once
#include <nutshell/rotations.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct Product {
    static constexpr const char *id = "4.4", *function = "product";
    static constexpr auto subject = NUTSHELL_CALL(product);

    static Quaternion unit(double x, double y, double z, double w) {
        return Quaternion(w, x, y, z).normalized();
    }
    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Quaternion a = unit(0.3, -0.5, 0.7, 0.4), b = unit(-0.6, 0.2, 0.1, -0.9),
                         c = unit(0.8, 0.4, -0.3, 0.2), none = unit(0, 0, 0, 1),
                         arrow(0, 0.9, -0.4, 1.3);  // not of length one: a vector as a 4-vector
        for (const auto& [second, first] :
             {std::pair(a, b), {b, a}, {c, a}, {a, none}, {none, c}, {arrow, b}}) {
            paper.input("second", second, "first", first);
            const Quaternion q = answer(second, first);
            paper.output("the 4-vector", q, 1.0);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<Product> about() {
        return {
            .title = "One turn after another",
            .hints =
                {"Choose the mirrors so that the last one of the first turn is the first one "
                 "of the second. What is left?",
                 "(4.d): one number comes from the two w and a dot product; the vector part "
                 "has three terms, one of them a cross product.",
                 "Each vector is multiplied by the other turn's w. In the cross product the "
                 "second turn stands first; four_vector puts the parts together."},
            .mistakes =
                {{"the first turn after the second", "E20: the wrong side",
                  "A push to the left pitches a plane that is banked.",
                  "Your cross product is the wrong way round: you turn by `second` first, or "
                  "about "
                  "the body's axes where the world's are meant.",
                  [](const Quaternion& second, const Quaternion& first) -> Quaternion {
                      return first * second;
                  }},
                 {"no cross product", "classic", "Two turns give the same in either order.",
                  "Without the cross product the order does not matter, and the result is no "
                  "longer as long as one.",
                  [](const Quaternion& second, const Quaternion& first) -> Quaternion {
                      return four_vector(second.w() * first.vec() + first.w() * second.vec(),
                                         second.w() * first.w() - second.vec().dot(first.vec()));
                  }},
                 {"plus the dot product", "classic",
                  "Two half turns about one axis do not come home.",
                  "Two mirrors' angles add, and cos(a + b) is cos a cos b minus sin a sin b: the "
                  "dot product is taken away.",
                  [](const Quaternion& second, const Quaternion& first) -> Quaternion {
                      return four_vector(second.w() * first.vec() + first.w() * second.vec() +
                                             second.vec().cross(first.vec()),
                                         second.w() * first.w() + second.vec().dot(first.vec()));
                  }},
                 {"number by number", "classic", "A body with no turn at all collapses.",
                  "You multiply the four numbers one by one. That is not what one turn after "
                  "another does: try it with (0, 0, 0, 1).",
                  [](const Quaternion& second, const Quaternion& first) -> Quaternion {
                      return Quaternion(
                          Eigen::Vector4d(second.coeffs().cwiseProduct(first.coeffs())));
                  }},
                 {"the scalar in the first row", "E19",
                  "The first step of the game throws every body into another pose.",
                  "The parts are right and stand in the order w, x, y, z of the printed (31); "
                  "here "
                  "the order is x, y, z, w.",
                  [](const Quaternion& second, const Quaternion& first) -> Quaternion {
                      const Quaternion q = second * first;
                      return Quaternion(Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()));
                  }},
                 {"turns added", "classic: rotation vectors as if they were displacements",
                  "Two turns give the same in either order.",
                  "You add the two rotation vectors. That is right only for turns about one "
                  "axis.",
                  [](const Quaternion& second, const Quaternion& first) -> Quaternion {
                      const Eigen::AngleAxisd a(second), b(first);
                      const Vector3 sum = a.angle() * a.axis() + b.angle() * b.axis();
                      return Quaternion(Eigen::AngleAxisd(sum.norm(), sum.normalized()));
                  }},
                 {"the scalars exchanged", "classic", "Poses jump.",
                  "Each vector part is multiplied with the scalar of the other one.",
                  [](const Quaternion& second, const Quaternion& first) -> Quaternion {
                      const Vector3 u = first.vec(), v = second.vec();
                      const double a = first.w(), b = second.w();
                      return four_vector(b * v + a * u + v.cross(u), b * a - v.dot(u));
                  }},
                 {"the scalar without the dot product", "classic",
                  "The result is no longer as long as one.",
                  "From the product of the scalars the dot product of the vector parts is taken "
                  "off.",
                  [](const Quaternion& second, const Quaternion& first) -> Quaternion {
                      const Vector3 u = first.vec(), v = second.vec();
                      const double a = first.w(), b = second.w();
                      return four_vector(b * u + a * v + v.cross(u), b * a);
                  }},
                 {"only one of the vector parts", "classic", "The second turn is half forgotten.",
                  "Both vector parts enter by themselves, each with the other's scalar.",
                  [](const Quaternion& second, const Quaternion& first) -> Quaternion {
                      const Vector3 u = first.vec(), v = second.vec();
                      const double a = first.w(), b = second.w();
                      return four_vector(b * u + v.cross(u), b * a - v.dot(u));
                  }},
                 {"only the other of the vector parts", "classic",
                  "The first turn is half forgotten.",
                  "Both vector parts enter by themselves, each with the other's scalar.",
                  [](const Quaternion& second, const Quaternion& first) -> Quaternion {
                      const Vector3 u = first.vec(), v = second.vec();
                      const double a = first.w(), b = second.w();
                      return four_vector(a * v + v.cross(u), b * a - v.dot(u));
                  }},
                 {"the cross product doubled", "classic",
                  "The result is no longer as long as one.", "The cross product enters once.",
                  [](const Quaternion& second, const Quaternion& first) -> Quaternion {
                      const Vector3 u = first.vec(), v = second.vec();
                      const double a = first.w(), b = second.w();
                      return four_vector(b * u + a * v + 2 * v.cross(u), b * a - v.dot(u));
                  }},
                 {"the sandwich", "classic: how a vector is turned",
                  "The second turn is never seen; only the axis of the first one is.",
                  "You put the first turn between the second and its inverse. That turns the "
                  "axis of the first turn and loses the second turn itself.",
                  [](const Quaternion& second, const Quaternion& first) -> Quaternion {
                      return second * first * second.conjugate();
                  }}},
            .alternatives =
                {{"sixteen products",
                  [](const Quaternion& p, const Quaternion& q) -> Quaternion {
                      return Quaternion(
                          p.w() * q.w() - p.x() * q.x() - p.y() * q.y() - p.z() * q.z(),
                          p.w() * q.x() + p.x() * q.w() + p.y() * q.z() - p.z() * q.y(),
                          p.w() * q.y() - p.x() * q.z() + p.y() * q.w() + p.z() * q.x(),
                          p.w() * q.z() + p.x() * q.y() - p.y() * q.x() + p.z() * q.w());
                  }},
                 {"Eigen's",
                  [](const Quaternion& second, const Quaternion& first) -> Quaternion {
                      return second * first;
                  }}},
        };
    }
#endif
};

inline const bool product_entered = enter<Product>();

}  // namespace nutshell::exercises
