// Exercise 0.1: the direction from one place to another.
#pragma once
#include <nutshell/toolbox.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct Direction {
    static constexpr const char *id = "0.1", *function = "direction";
    static constexpr auto subject = NUTSHELL_CALL(direction);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Vector3 a{1.2, -0.7, 0.8}, b{2.7, 2.1, -1.6}, c{-1.3, 0.4, 2.9};
        for (const auto& [from, to] : {std::pair{a, b}, {a, c}, {c, b}}) {
            paper.input("from", from, "to", to);
            const Vector3 n = answer(from, to);
            paper.output("the direction", n, Vector3(1, 1, 1));
        }
    }

#ifndef NUTSHELL_SHEET
    static About<Direction> about() {
        return {
            .title = "Which way is it?",
            .hints = {"An arrow from here to there is there minus here.",
                      "A direction has length 1. How long is your arrow, and what do you do with "
                      "that?",
                      "Divide the difference of the two places by its own length; norm() gives "
                      "the length."},
            .mistakes = {{"the wrong way round", "classic: a sign",
                          "Everything that should be pulled is pushed.",
                          "You take here minus there. The arrow that leads to a place is that "
                          "place minus where you are.",
                          [](const Vector3& from, const Vector3& to) -> Vector3 {
                              return (from - to).normalized();
                          }},
                         {"not of length 1",
                          "classic: a force that grows with the distance twice",
                          "Far things pull harder and harder.",
                          "You return the whole way. A direction says only where, so divide the "
                          "way by its length.",
                          [](const Vector3& from, const Vector3& to) -> Vector3 {
                              return to - from;
                          }},
                         {"divided by the square of the length", "classic",
                          "Far things are hardly pulled at all.",
                          "You divide by the squared length, squaredNorm(). Length 1 comes from "
                          "dividing by the length once.",
                          [](const Vector3& from, const Vector3& to) -> Vector3 {
                              return (to - from) / (to - from).squaredNorm();
                          }},
                         {"the direction from the origin", "classic",
                          "Everything is pulled as if it stood in the middle of the world.",
                          "You normalise the position of the goal. It must be the way there from "
                          "where you are.",
                          [](const Vector3& from, const Vector3& to) -> Vector3 {
                              return to.normalized() + 0 * from;
                          }},
                         {"two directions subtracted", "classic",
                          "Things far apart from the middle hardly move.",
                          "You normalise both places and subtract. Subtract first: only the way "
                          "between them has the direction that is asked for.",
                          [](const Vector3& from, const Vector3& to) -> Vector3 {
                              return to.normalized() - from.normalized();
                          }},
                         {"divided by the goal's distance", "classic",
                          "The pull depends on where the world's middle is.",
                          "You divide by the length of the goal's position. Divide by the length "
                          "of the way itself.",
                          [](const Vector3& from, const Vector3& to) -> Vector3 {
                              return (to - from) / to.norm();
                          }}},
            .alternatives = {{"normalized",
                              [](const Vector3& from, const Vector3& to) -> Vector3 {
                                  return (to - from).normalized();
                              }},
                             {"times one over the length",
                              [](const Vector3& from, const Vector3& to) -> Vector3 {
                                  const double shrink = 1 / std::sqrt((to - from).dot(to - from));
                                  return {(to.x() - from.x()) * shrink,
                                          (to.y() - from.y()) * shrink,
                                          (to.z() - from.z()) * shrink};
                              }}},
        };
    }
#endif
};

inline const bool direction_entered = enter<Direction>();

}  // namespace nutshell::exercises
