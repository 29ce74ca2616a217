// Chapter 7 · Time of impact: when two things that fly freely will touch.
#pragma once
#include <array>
#include <nutshell/shapes.hpp>
#include <optional>

namespace nutshell {

// [roots]
/// The time t >= 0 [s] from which on a t^2 + b t + c, a distance [m] that is not negative now,
/// gets negative: its first fall through zero. Nothing if it never does. Without the loss of
/// digits of the school's formula; what touches already (c <= 0) and closes in, meets at once.
inline std::optional<double> falls_through_zero(double a, double b, double c) {
    // exercise 7.3
    if (c <= 0 && (b < 0 || (b == 0 && a < 0))) return 0.0;
    const double square = b * b - 4 * a * c;
    if (!(square >= 0)) return {};                                    // never zero; NaN neither
    const double q = -(b + std::copysign(std::sqrt(square), b)) / 2;  // the roots: q/a and c/q
    if (a < 0) return q > 0 ? c / q : q / a;
    if (b < 0) return c / q;
    return {};
    // end 7.3
}
// [/roots]

// [sphere_plane]
/// When [s] a sphere that flies under constant acceleration touches a plane: exact.
/// @param centre, velocity, acceleration  of the sphere [m, m/s, m/s^2], world frame
inline std::optional<double> time_of_impact(const Sphere& sphere, const Vector3& centre,
                                            const Vector3& velocity, const Vector3& acceleration,
                                            const Plane& plane) {
    return falls_through_zero(plane.normal.dot(acceleration) / 2, plane.normal.dot(velocity),
                              distance_to(plane, centre) - sphere.radius);
}
// [/sphere_plane]

// [sphere_sphere]
/// When [s] a point that flies straight comes within `radius` [m] of the origin: exact. Also two
/// spheres, of radii that add up to it, seen from one of them.
inline std::optional<double> time_of_impact(const Vector3& place, const Vector3& velocity,
                                            double radius) {
    return falls_through_zero(velocity.squaredNorm(), 2 * place.dot(velocity),
                              place.squaredNorm() - radius * radius);
}
// [/sphere_sphere]

// [sphere_box]
/// When [s] a sphere that flies straight touches a box at rest: exact. The sphere's centre meets
/// the box grown by the radius: its six faces, twelve edges (cylinders) and eight corners
/// (spheres). Place and velocity of the sphere in the axes of the box, from its centre.
inline std::optional<double> time_of_impact(const Sphere& sphere, const Vector3& place,
                                            const Vector3& velocity, const Box& box) {
    std::optional<double> first;
    // A hit of a face, edge or corner counts where the box has no nearer one: on each axis the
    // centre is then beyond the box's own slab (side +1 or -1) or within it (side 0).
    for (int part = 0; part < 27; ++part) {
        const std::array side{part % 3 - 1, part / 3 % 3 - 1, part / 9 - 1};
        Vector3 from = Vector3::Zero(), going = Vector3::Zero();
        for (int axis = 0; axis < 3; ++axis)
            if (side[static_cast<std::size_t>(axis)] != 0) {
                from[axis] = place[axis] - side[static_cast<std::size_t>(axis)] * box.half[axis];
                going[axis] = velocity[axis];
            }
        const auto t = part == 13 ? std::nullopt : time_of_impact(from, going, sphere.radius);
        if (!t || (first && *t >= *first)) continue;
        bool belongs = true;
        for (int axis = 0; axis < 3; ++axis) {
            const double at = place[axis] + *t * velocity[axis];
            const int s = side[static_cast<std::size_t>(axis)];
            belongs =
                belongs && (s == 0 ? std::abs(at) <= box.half[axis] : s * at >= box.half[axis]);
        }
        if (belongs) first = t;
    }
    return first;
}
// [/sphere_box]

}  // namespace nutshell
