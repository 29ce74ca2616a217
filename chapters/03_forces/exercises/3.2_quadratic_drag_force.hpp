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
    static Exercise about();
#endif
};

inline const bool quadratic_drag_force_entered = enter<QuadraticDrag>();

}  // namespace nutshell::exercises

#ifndef NUTSHELL_SHEET

namespace nutshell::mistakes {

inline Vector3 drag_along_the_velocity(double c, const Vector3& velocity) {
    return c * velocity.norm() * velocity;
}
inline Vector3 drag_that_is_linear(double c, const Vector3& velocity) {
    return -c * velocity;
}
inline Vector3 drag_by_components(double c, const Vector3& velocity) {
    return -c * velocity.cwiseAbs().cwiseProduct(velocity);
}
inline Vector3 drag_of_squared_components(double c, const Vector3& velocity) {
    return -c * velocity.cwiseProduct(velocity);
}
inline Vector3 drag_with_the_cube(double c, const Vector3& velocity) {
    return -c * velocity.squaredNorm() * velocity;
}
inline Vector3 drag_with_a_half(double c, const Vector3& velocity) {
    return -c / 2 * velocity.norm() * velocity;
}
inline Vector3 drag_by_normalising(double c, const Vector3& velocity) {
    return -c * velocity.squaredNorm() * (velocity / velocity.norm());
}

}  // namespace nutshell::mistakes

namespace nutshell::alternatives {

inline Vector3 drag_by_unit_vector(double c, const Vector3& velocity) {
    return -c * velocity.squaredNorm() * velocity.normalized();  // Eigen gives zero for zero
}

}  // namespace nutshell::alternatives

namespace nutshell::exercises {

inline Exercise QuadraticDrag::about() {
    return {
        .title = "Drag in air",
        .hints = {"Twice the speed, four times the force; and always against the motion.",
                  "The velocity has a length and a direction. Its length must enter twice, its "
                  "direction once.",
                  "The velocity itself already brings its length once. Which scalar gives the "
                  "second factor, and which sign turns the force against the motion?"},
        .mistakes =
            {{"pushes along", "classic: the sign",
              "The ball accelerates for ever and leaves the level.",
              "The force points along the velocity. Drag points against it.",
              attempt<QuadraticDrag>(NUTSHELL_CALL(mistakes::drag_along_the_velocity))},
             {"linear drag", "E09: the source's only drag",
              "Fast balls fly too far, slow ones stop too early.",
              "Your force is proportional to the speed, as in honey. In air it grows with the "
              "square.",
              attempt<QuadraticDrag>(NUTSHELL_CALL(mistakes::drag_that_is_linear))},
             {"component by component", "classic",
              "A ball thrown slantwise bends towards an axis of the world: drag depends on where "
              "x points.",
              "You square each component by itself. That is no vector: turn the axes and it "
              "changes. Multiply the velocity by its length.",
              attempt<QuadraticDrag>(NUTSHELL_CALL(mistakes::drag_by_components))},
             {"the squares of the components", "classic: v^2",
              "Thrown to the left the ball speeds up, thrown to the right it slows down.",
              "You square each component: the square has lost its sign, and turning the axes "
              "changes it. v^2 is the norm times the velocity.",
              attempt<QuadraticDrag>(NUTSHELL_CALL(mistakes::drag_of_squared_components))},
             {"one length too many", "classic", "Fast balls stop as if they hit a wall.",
              "The speed enters three times: its square, and once more in the velocity. Take the "
              "norm, not its square.",
              attempt<QuadraticDrag>(NUTSHELL_CALL(mistakes::drag_with_the_cube))},
             {"the half twice", "classic: rho C A v^2/2", "Everything flies a little too far.",
              "The 1/2 is already in c (see air_drag).",
              attempt<QuadraticDrag>(NUTSHELL_CALL(mistakes::drag_with_a_half))},
             {"NaN at rest", "E08: division by a length of zero",
              "A ball that comes to rest vanishes.",
              "You divide by the speed, which may be zero. Written as a norm times the velocity "
              "it needs no division.",
              attempt<QuadraticDrag>(NUTSHELL_CALL(mistakes::drag_by_normalising))}},
        .alternatives = {{"by a unit vector", attempt<QuadraticDrag>(NUTSHELL_CALL(
                                                  alternatives::drag_by_unit_vector))}},
    };
}

}  // namespace nutshell::exercises

#endif
