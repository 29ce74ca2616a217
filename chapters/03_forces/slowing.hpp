// Drag alone: what falling.cpp charts and the page lets the reader try.
#pragma once
#include <nutshell/forces_scenes.hpp>

namespace nutshell {

/// A body of 1 kg that only linear drag slows, from 1 m/s; a step is one second, so the drag
/// [kg/s] is nu dt.
struct SlowedByDrag {
    PointMass start{1, {0, 0, 0}, {1, 0, 0}};
    double drag = 0.5, duration = 10;  // [kg/s], [s]

    Vector3 operator()(const PointMass& body, double) const {
        return linear_drag_force(drag, body.velocity);
    }
    double exact_speed(double t) const { return std::exp(-drag * t); }
};

}  // namespace nutshell
