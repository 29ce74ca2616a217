// Exercise 0.3: the area of a triangle.
#pragma once
#include <nutshell/toolbox.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct TriangleArea {
    static constexpr const char *id = "0.3", *function = "triangle_area";
    static constexpr auto subject = NUTSHELL_CALL(triangle_area);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Vector3 one{1.4, -0.8, 2.3}, two{2.6, 1.1, -0.7}, three{-1.9, 0.6, 1.5};
        for (const auto& [a, b] : {std::pair{one, two}, {one, three}, {three, two}}) {
            paper.input("a", a, "b", b);
            const double area = answer(a, b);
            paper.output("the area", area, a.norm() * b.norm());
        }
    }

#ifndef NUTSHELL_SHEET
    static About<TriangleArea> about() {
        return {
            .title = "The area between two arrows",
            .hints = {"Which product of two vectors has to do with an area?",
                      "The length of the cross product is the area of a parallelogram. How much "
                      "of that is the triangle?",
                      "Half of the length of a x b: cross(), norm(), and a two."},
            .mistakes = {{"the parallelogram", "classic: the half forgotten",
                          "Areas are twice too large, and so are masses made from them.",
                          "The length of the cross product is the area of the parallelogram. The "
                          "triangle is half of it.",
                          [](const Vector3& a, const Vector3& b) -> double {
                              return a.cross(b).norm();
                          }},
                         {"the dot product", "classic: the other product",
                          "Long thin triangles have the largest area.",
                          "You use the dot product, which is largest when the two sides point "
                          "the same way. Then there is no area at all.",
                          [](const Vector3& a, const Vector3& b) -> double {
                              return std::abs(a.dot(b)) / 2;
                          }},
                         {"as if at right angles", "classic", "Every triangle is too large.",
                          "Half of length times length is the area only if the sides are at "
                          "right angles.",
                          [](const Vector3& a, const Vector3& b) -> double {
                              return a.norm() * b.norm() / 2;
                          }},
                         {"one component only", "classic: a plane's formula in space",
                          "The area depends on how the triangle is turned.",
                          "You take one component of the cross product: the area as seen along "
                          "that axis. In space all three count.",
                          [](const Vector3& a, const Vector3& b) -> double {
                              return std::abs(a.cross(b).z()) / 2;
                          }},
                         {"the square of a length", "classic",
                          "Areas grow with the fourth power of the size.",
                          "You take squaredNorm(): the length itself is norm().",
                          [](const Vector3& a, const Vector3& b) -> double {
                              return a.cross(b).squaredNorm() / 2;
                          }},
                         {"the components added up", "classic",
                          "The area depends on how the triangle is turned.",
                          "You add the components of the cross product. Its length is the root "
                          "of the sum of their squares.",
                          [](const Vector3& a, const Vector3& b) -> double {
                              return std::abs(a.cross(b).sum()) / 2;
                          }},
                         {"Heron with the whole perimeter", "classic: s is half of it",
                          "Areas are many times too large.",
                          "You use Heron's formula with the sum of the three sides. It works "
                          "with half of that sum.",
                          [](const Vector3& a, const Vector3& b) -> double {
                              const double p = a.norm(), q = b.norm(), r = (b - a).norm(),
                                           s = p + q + r;
                              return std::sqrt(s * (s - p) * (s - q) * (s - r));
                          }}},
            .alternatives = {{"from the angle",
                              [](const Vector3& a, const Vector3& b) -> double {
                                  const double c = a.dot(b) / (a.norm() * b.norm());
                                  return a.norm() * b.norm() * std::sqrt(1 - c * c) / 2;
                              }},
                             {"base times height",
                              [](const Vector3& a, const Vector3& b) -> double {
                                  const Vector3 n = a / a.norm();
                                  return a.norm() * (b - b.dot(n) * n).norm() / 2;
                              }}},
        };
    }
#endif
};

inline const bool triangle_area_entered = enter<TriangleArea>();

}  // namespace nutshell::exercises
