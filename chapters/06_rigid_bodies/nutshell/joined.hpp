// Chapter 6 · From things to bodies: what a thing's properties make of it, and several joined.
#pragma once
#include <nutshell/assembly.hpp>
#include <nutshell/body.hpp>

namespace nutshell {

// [body_of]
/// The body that a thing with these properties is, at rest, where it lies: its centre becomes the
/// position, its principal axes the orientation. A point p of the shape is the body's point
/// rotate(inverse(orientation), p - position).
/// @throws std::invalid_argument with the reason if no body has them, or it cannot turn
inline Body body_of(const MassProperties& thing) {
    const PrincipalAxes principal =
        principal_axes((thing.inertia + thing.inertia.transpose()) / 2);
    return checked(Body{thing.mass, principal.moments, thing.centre, Vector3::Zero(),
                        Quaternion(principal.axes).normalized(), Vector3::Zero()});
}
// [/body_of]

// [joined]
/// One body out of several that are stuck together as they are: mass, centre and inertia of the
/// whole, their momentum, and their angular momentum about the common centre.
/// Source: eqs. (60)-(62*), errata E32 and E33.
inline Body joined(std::span<const Body> bodies) {
    // exercise 6.7
    std::vector<Part> parts;
    Vector3 momentum = Vector3::Zero(), about_origin = Vector3::Zero();
    for (const Body& body : bodies) {
        parts.push_back(
            solid(body.mass, body.inertia, body.position, rotation_matrix(body.orientation)));
        momentum += body.momentum;
        about_origin += angular_momentum(body);
    }
    Body whole = body_of(assemble(parts));
    whole.momentum = momentum;
    whole.angular_momentum = about_origin - whole.position.cross(momentum);
    return whole;
    // end 6.7
}
// [/joined]

}  // namespace nutshell
