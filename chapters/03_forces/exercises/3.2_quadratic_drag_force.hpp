// Exercise 3.2: drag that grows with the square of the speed.
#pragma once
#include <nutshell/forces.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct QuadraticDrag {
    static constexpr const char *id = "3.2", *function = "quadratic_drag_force";
    static constexpr auto subject = NUTSHELL_CALL(quadratic_drag_force);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const Vector3& velocity : {Vector3(3.1, -4.2, 1.7), Vector3(-12.5, 0.3, 8.4),
                                        Vector3(0.2, 0.1, -0.3), Vector3(0, 0, 0)})
            for (const double c : {0.4, 2.6}) {
                paper.input("c", c, "velocity", velocity);
                const Vector3 force = answer(c, velocity);
                paper.output("the drag [N]", force, c * velocity.squaredNorm(),
                             velocity.isZero() ? c : 0.0);  // at rest: that of 1 m/s
            }
    }

#ifndef NUTSHELL_SHEET
    static About<QuadraticDrag> about() {
        return {
            .title = "Drag in air",
            .hints = {"Twice the speed, four times the force; and always against the motion.",
                      "The velocity has a length and a direction. Its length must enter twice, "
                      "its direction once.",
                      "The velocity itself already brings its length once. Which scalar gives "
                      "the second factor, and which sign turns the force against the motion?"},
            .mistakes =
                {{"pushes along", "classic: the sign",
                  "The ball accelerates for ever and leaves the level.",
                  "The force points along the velocity. Drag points against it.",
                  [](double c, const Vector3& velocity) -> Vector3 {
                      return c * velocity.norm() * velocity;
                  }},
                 {"linear drag", "E09: the source's only drag",
                  "Fast balls fly too far, slow ones stop too early.",
                  "Your force is proportional to the speed, as in honey. In air it grows with "
                  "the square.",
                  [](double c, const Vector3& velocity) -> Vector3 { return -c * velocity; }},
                 {"component by component", "classic",
                  "A ball thrown slantwise bends towards an axis of the world: drag depends on "
                  "where x points.",
                  "You square each component by itself. That is no vector: turn the axes and it "
                  "changes. Multiply the velocity by its length.",
                  [](double c, const Vector3& velocity) -> Vector3 {
                      return -c * velocity.cwiseAbs().cwiseProduct(velocity);
                  }},
                 {"the squares of the components", "classic: v^2",
                  "Thrown to the left the ball speeds up, thrown to the right it slows down.",
                  "You square each component: the square has lost its sign, and turning the axes "
                  "changes it. v^2 is the norm times the velocity.",
                  [](double c, const Vector3& velocity) -> Vector3 {
                      return -c * velocity.cwiseProduct(velocity);
                  }},
                 {"one length too many", "classic", "Fast balls stop as if they hit a wall.",
                  "The speed enters three times: its square, and once more in the velocity. Take "
                  "the norm, not its square.",
                  [](double c, const Vector3& velocity) -> Vector3 {
                      return -c * velocity.squaredNorm() * velocity;
                  }},
                 {"the half twice", "classic: rho C A v^2/2",
                  "Everything flies a little too far.", "The 1/2 is already in c (see air_drag).",
                  [](double c, const Vector3& velocity) -> Vector3 {
                      return -c / 2 * velocity.norm() * velocity;
                  }},
                 {"NaN at rest", "E08: division by a length of zero",
                  "A ball that comes to rest vanishes.",
                  "You divide by the speed, which may be zero. Written as a norm times the "
                  "velocity it needs no division.",
                  [](double c, const Vector3& velocity) -> Vector3 {
                      return -c * velocity.squaredNorm() * (velocity / velocity.norm());
                  }}},
            .alternatives = {{"by a unit vector",
                              [](double c, const Vector3& velocity) -> Vector3 {
                                  return -c * velocity.squaredNorm() *
                                         velocity.normalized();  // Eigen gives zero for zero
                              }}},
        };
    }
#endif
};

inline const bool quadratic_drag_force_entered = enter<QuadraticDrag>();

}  // namespace nutshell::exercises
