// Chapter 7 · A contact: where two bodies touch, and how fast their points pass each other there.
#pragma once
#include <nutshell/body.hpp>
#include <nutshell/impacts.hpp>

namespace nutshell {

/// A body that nothing moves: a wall, the floor, the earth.
inline Body immovable_body(const Vector3& position = Vector3::Zero()) {
    Body wall;
    wall.mass = immovable, wall.inertia = Vector3::Constant(immovable), wall.position = position;
    return wall;
}

// [contact]
/// Where two bodies a and b touch.
struct Contact {
    Vector3 point;          ///< [m], world frame
    Vector3 normal;         ///< unit vector, from a to b, world axes
    double separation = 0;  ///< gap along the normal [m]; negative: how deep they overlap
    int feature = 0;        ///< which parts of the shapes touch: the same from step to step
};

/// Velocity [m/s] of b's point of contact, seen from a's. Eq. (7.d): eq. (66) with eq. (59*).
inline Vector3 contact_velocity(const Body& a, const Body& b, const Contact& at) {
    const Vector3 of_a = velocity(a) + angular_velocity(a).cross(at.point - a.position);
    const Vector3 of_b = velocity(b) + angular_velocity(b).cross(at.point - b.position);
    return of_b - of_a;
}
// [/contact]

// [surface]
/// What two surfaces do when they meet.
struct Surface {
    double restitution = 0;  ///< e, 0 to 1
    double friction = 0;     ///< mu, not negative
};
// [/surface]

/// Gives the surface back. @throws std::invalid_argument if e is not within 0 and 1, mu negative
/// or not finite
inline Surface checked(const Surface& surface) {
    checked_restitution(surface.restitution);
    require(std::isfinite(surface.friction) && surface.friction >= 0,
            "a coefficient of friction must be finite and not negative, not " +
                digits(surface.friction));
    return surface;
}

}  // namespace nutshell
