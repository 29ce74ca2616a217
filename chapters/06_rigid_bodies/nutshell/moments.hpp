// Chapter 6 · Moments of inertia: of simple solids, and which of them no body can have.
#pragma once
#include <nutshell/require.hpp>
#include <nutshell/vector.hpp>
#include <sstream>

namespace nutshell {

// [possible]
/// The reason why no body can have these principal moments [kg m^2], or nothing. Each is a sum of
/// m (y^2 + z^2) and the like, so none is negative, and two of them are at least the third: Ix +
/// Iy - Iz = 2 times the sum of m z^2. `slack` is what round-off may take, relative to the
/// largest.
inline std::string why_impossible(const Vector3& moments, double slack = 1e-12) {
    std::ostringstream text;
    if (!moments.allFinite()) return "a moment of inertia is not finite";
    const double largest = moments.cwiseAbs().maxCoeff();
    if (moments.minCoeff() < -slack * largest) {
        text << "a moment of inertia is negative: " << moments.minCoeff() << " kg m^2";
        return text.str();
    }
    const double one = moments.maxCoeff(), others = moments.sum() - one;
    if (one > others + slack * largest) {
        text << "the moment of inertia " << one
             << " kg m^2 is larger than the two others together, " << others
             << " kg m^2: no mass lies like that";
        return text.str();
    }
    return "";
}
// [/possible]

// [shapes]
// Principal moments [kg m^2] about the centre of uniform solids. Masses in kg, lengths in m; the
// axis of a cylinder, rod, cone or capsule is the body's z. All throw std::invalid_argument for a
// mass or a length that is not finite and greater than zero.

/// A ball: 2/5 m r^2 about any axis.
inline Vector3 ball_inertia(double mass, double radius) {
    require_positive(mass, "ball_inertia: the mass [kg]");
    require_positive(radius, "ball_inertia: the radius [m]");
    return Vector3::Constant(0.4 * mass * radius * radius);
}

/// A box of edges `size`.
inline Vector3 box_inertia(double mass, const Vector3& size) {
    require_positive(mass, "box_inertia: the mass [kg]");
    require_positive(size.minCoeff(), "box_inertia: the shortest edge [m]");
    const Vector3 square = size.cwiseAbs2();
    return mass / 12 * (Vector3::Constant(square.sum()) - square);
}

/// A cylinder, or a disc if it is flat.
inline Vector3 cylinder_inertia(double mass, double radius, double height) {
    require_positive(mass, "cylinder_inertia: the mass [kg]");
    require_positive(radius, "cylinder_inertia: the radius [m]");
    require_positive(height, "cylinder_inertia: the height [m]");
    const double across = mass * (3 * radius * radius + height * height) / 12;
    return {across, across, mass * radius * radius / 2};
}

/// A rod without thickness. About its own axis it has none: as a body of its own give it a radius
/// and make it a cylinder.
inline Vector3 rod_inertia(double mass, double length) {
    require_positive(mass, "rod_inertia: the mass [kg]");
    require_positive(length, "rod_inertia: the length [m]");
    const double across = mass * length * length / 12;
    return {across, across, 0};
}

/// An ellipsoid of half axes `radii`.
inline Vector3 ellipsoid_inertia(double mass, const Vector3& radii) {
    require_positive(mass, "ellipsoid_inertia: the mass [kg]");
    require_positive(radii.minCoeff(), "ellipsoid_inertia: the shortest half axis [m]");
    const Vector3 square = radii.cwiseAbs2();
    return mass / 5 * (Vector3::Constant(square.sum()) - square);
}

/// A capsule: a cylinder of length 2 `half_length` with half a ball at each end.
inline Vector3 capsule_inertia(double mass, double radius, double half_length) {
    require_positive(half_length, "capsule_inertia: the half length [m]");
    require_positive(radius, "capsule_inertia: the radius [m]");
    const double r = radius, h = 2 * half_length;
    const double density = mass / (pi * r * r * (h + 4 * r / 3));  // [kg/m^3]
    const double middle = density * pi * r * r * h, caps = density * 4 * pi / 3 * r * r * r;
    // half a ball's centre of mass lies 3/8 r from its flat side
    const double across = caps * (0.4 * r * r + h * h / 4 + 3 * h * r / 8);
    const Vector3 along = cylinder_inertia(middle, r, h);
    return along + Vector3(across, across, 0.4 * caps * r * r);
}
// [/shapes]

}  // namespace nutshell
