// Exercise 0.2: the part of a vector along a direction.
#pragma once
#include <nutshell/toolbox.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct PartAlong {
    static constexpr const char *id = "0.2", *function = "part_along";
    static constexpr auto subject = NUTSHELL_CALL(part_along);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Vector3 n{0.48, 0.6, -0.64}, m{-0.6, 0.64, 0.48}, a{1.7, -2.3, 0.9},
            b{2.2, 1.9, -1.4};
        for (const auto& [v, along] : {std::pair{a, n}, {b, n}, {a, m}}) {
            paper.input("v", v, "n", along);
            const double part = answer(v, along);
            paper.output("the part along n", part, v);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<PartAlong> about() {
        return {
            .title = "How much of it along there?",
            .hints = {"Which product of two vectors is a number?",
                      "It is zero when the two are at right angles, and negative when they point "
                      "apart.",
                      "Multiply component by component and add: the dot product."},
            .picture = "dot.svg",
            .mistakes =
                {{"always positive", "classic: a length instead of a part",
                  "A ball that leaves a wall is turned round again and sticks to it.",
                  "You return a size. The part along n is negative when v points against "
                  "n, and the sign says whether a ball comes or leaves.",
                  [](const Vector3& v, const Vector3& n) -> double {
                      return std::abs(v.dot(n));
                  }},
                 {"the part at right angles", "classic: the other product",
                  "A ball glides along the wall that it should bounce off.",
                  "That is the length of the cross product: how much of v points past n. "
                  "The part along n is the dot product.",
                  [](const Vector3& v, const Vector3& n) -> double { return v.cross(n).norm(); }},
                 {"the cosine", "classic", "Fast and slow things bounce alike.",
                  "You divide by the length of v and return the cosine of the angle. The "
                  "part along n is |v| times the cosine.",
                  [](const Vector3& v, const Vector3& n) -> double {
                      return v.dot(n) / v.norm();
                  }},
                 {"the whole length", "classic", "A glancing hit is as hard as a full one.",
                  "You return the length of v, whatever n is.",
                  [](const Vector3& v, const Vector3& n) -> double {
                      return v.norm() + 0 * n.x();
                  }},
                 {"the angle seen in the plane", "classic: atan2 in space",
                  "What comes from above bounces as if from the side.",
                  "You take the angle between the two from x and y alone. In space z is a part "
                  "of it.",
                  [](const Vector3& v, const Vector3& n) -> double {
                      return v.norm() *
                             std::cos(std::atan2(v.y(), v.x()) - std::atan2(n.y(), n.x()));
                  }},
                 {"x and y only", "classic: a plane's formula in space",
                  "A ball that falls along z never meets its floor.",
                  "You leave z out. The dot product has three terms.",
                  [](const Vector3& v, const Vector3& n) -> double {
                      return v.head<2>().dot(n.head<2>());
                  }}},
            .alternatives = {{"three products added",
                              [](const Vector3& v, const Vector3& n) -> double {
                                  return v.x() * n.x() + v.y() * n.y() + v.z() * n.z();
                              }},
                             {"as a row times a column",
                              [](const Vector3& v, const Vector3& n) -> double {
                                  return (n.transpose() * v).value();
                              }}},
        };
    }
#endif
};

inline const bool part_along_entered = enter<PartAlong>();

}  // namespace nutshell::exercises
