// Where the half of the angle comes from: two mirrors make a turn.
#pragma once
#include <nutshell/rotations.hpp>
#include <utility>

namespace nutshell {

// [reflections]
/// The mirror image of p in the plane through the origin with the unit normal `mirror`.
inline Vector3 reflected(const Vector3& p, const Vector3& mirror) {
    return p - 2 * mirror.dot(p) * mirror;
}

/// The 4-vector of two reflections, first in the mirror with normal a, then in that with normal
/// b (unit vectors): a turn by twice the angle between the mirrors. Eq. (4.c).
inline Quaternion two_mirrors(const Vector3& a, const Vector3& b) {
    return four_vector(a.cross(b), a.dot(b));
}
// [/reflections]

/// A unit vector perpendicular to u; some unit vector if u is zero.
inline Vector3 any_perpendicular(const Vector3& u) {
    return u == Vector3::Zero() ? Vector3(Vector3::UnitX()) : direction_of(u).unitOrthogonal();
}

// [mirrors_of]
/// Normals of two mirrors that make the turn q (length one), the second one with the normal `b`,
/// a unit vector perpendicular to q's axis. Any pair at the same angle would do.
inline std::pair<Vector3, Vector3> mirrors_ending_at(const Vector3& b, const Quaternion& q) {
    return {q.w() * b + b.cross(q.vec()), b};
}
inline std::pair<Vector3, Vector3> mirrors_beginning_at(const Vector3& b, const Quaternion& q) {
    return {b, q.w() * b + q.vec().cross(b)};
}

/// The product of two turns without its formula: choose the mirrors so that the last one of the
/// first turn is the first one of the second. Those two undo each other; two mirrors are left.
inline Quaternion product_by_mirrors(const Quaternion& second, const Quaternion& first) {
    const Vector3 across = first.vec().cross(second.vec());
    const Vector3 b = across.norm() > 1e-8 ? Vector3(across.normalized())
                      : first.vec().norm() > second.vec().norm()
                          ? any_perpendicular(first.vec())
                          : any_perpendicular(second.vec());
    return two_mirrors(mirrors_ending_at(b, first).first, mirrors_beginning_at(b, second).second);
}
// [/mirrors_of]

}  // namespace nutshell
