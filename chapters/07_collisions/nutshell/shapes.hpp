// Chapter 7 · Shapes: what can touch. A shape is at home in the axes of its body, its centre in
// the origin.
#pragma once
#include <nutshell/hull.hpp>
#include <variant>

namespace nutshell {

// [shapes]
/// All points within `radius` [m] of the centre.
struct Sphere {
    double radius;
};

/// All points within `half` [m] of the centre along each of the body's axes.
struct Box {
    Vector3 half;
};

/// A rod with round ends: all points within `radius` [m] of a line of length 2 `half_length` [m]
/// along the body's y axis.
struct Capsule {
    double half_length, radius;
};

/// Or a Hull, a convex piece with flat faces: hull.hpp.
using Shape = std::variant<Sphere, Box, Capsule, Hull>;

/// What never moves: all points x with normal . x <= offset. The normal is a unit vector and
/// points out of the wall, world axes; offset in m.
struct Plane {
    Vector3 normal{0, 1, 0};
    double offset = 0;
};
// [/shapes]

/// How far [m] a point is in front of a plane; negative behind it.
inline double distance_to(const Plane& plane, const Vector3& point) {
    return plane.normal.dot(point) - plane.offset;
}

/// The radius [m] of the sphere round the centre that holds the whole shape.
inline double reach(const Sphere& s) {
    return s.radius;
}
inline double reach(const Box& box) {
    return box.half.norm();
}
inline double reach(const Capsule& rod) {
    return rod.half_length + rod.radius;
}
inline double reach(const Shape& shape) {
    return std::visit([](const auto& s) { return reach(s); }, shape);
}

/// Gives the shape back if it has a volume. @throws std::invalid_argument if a length is not
/// finite or not greater than zero
inline Sphere checked(const Sphere& sphere) {
    require_positive(sphere.radius, "the radius of a sphere [m]");
    return sphere;
}
inline Box checked(const Box& box) {
    for (const double half : box.half)
        require_positive(half, "half the length of an edge of a box [m]");
    return box;
}
inline Capsule checked(const Capsule& rod) {
    require_positive(rod.half_length, "half the length of a rod [m]");
    require_positive(rod.radius, "the radius of a rod [m]");
    return rod;
}
inline Shape checked(const Shape& shape) {
    return std::visit([](const auto& s) -> Shape { return checked(s); }, shape);
}

/// Gives the plane back. @throws std::invalid_argument if its normal is not of length one, or a
/// number is not finite
inline Plane checked(const Plane& plane) {
    require_finite(plane.normal, "the normal of a plane");
    require(std::abs(plane.normal.norm() - 1) < 1e-9,
            "the normal of a plane has length " + digits(plane.normal.norm()) + " instead of 1");
    require(std::isfinite(plane.offset), "the offset of a plane [m] must be finite");
    return plane;
}

}  // namespace nutshell
