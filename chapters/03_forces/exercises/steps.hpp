// What the exercises of chapter 3 that make a step are tried on: a force with drag, of place and
// time.
#pragma once
#include <nutshell/exponential.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

/// Linear drag, and a pull that depends on the place and on the time.
struct Dragged {
    double drag;
    Vector3 operator()(const PointMass& body, double t) const {
        return -1.7 * body.position + (1 + t) * Vector3{0.9, -1.4, 0.7} - drag * body.velocity;
    }
};

/// A weight and linear drag, whose motion is known exactly.
struct Sinking {
    double drag;
    Vector3 operator()(const PointMass& body, double) const {
        return body.mass * Vector3(0.4, -9.81, 0.3) - drag * body.velocity;
    }
};

/// One step under both forces, for several drags and a mass that is not one.
template <class Answer>
void ask_dragged_step(Paper& paper, const Answer& answer) {
    const double dt = paper.step(0.3);
    const Vector3 here{1.1, -0.8, 0.6}, there{-0.5, 1.4, 0.9}, fast{0.7, 1.3, -0.9};
    for (const auto& [body, drag, t] : {std::tuple{PointMass{2.5, here, fast}, 0.6, 0.7},
                                        {PointMass{2.5, here, fast}, 3.5, 0.7},
                                        {PointMass{2.5, here, fast}, 3.5, 1.9},
                                        {PointMass{0.8, here, fast}, 3.5, 0.7},
                                        {PointMass{2.5, there, fast}, 3.5, 0.7},
                                        {PointMass{2.5, here, there}, 3.5, 0.7}}) {
        const Dragged forces{drag};
        paper.input("mass", body.mass, "position", body.position, "velocity", body.velocity,
                    "drag", drag, "t", t, "dt", dt);
        const PointMass moved = answer(body, forces, t, dt);
        const Vector3 gain = forces(body, t) / body.mass * dt;
        paper.changed("the position [m]", moved.position, body.position, body.velocity * dt,
                      gain * dt);
        paper.changed("the velocity [m/s]", moved.velocity, body.velocity, gain);
        paper.changed("the mass [kg]", moved.mass, body.mass);
    }
}

}  // namespace nutshell::exercises
