// Chapter 6 · Free rotation: how a body turns while nothing twists it. Its angular momentum L
// stands still in the world; its angular velocity does not.
#pragma once
#include <nutshell/rotations.hpp>
#include <nutshell/vector.hpp>

namespace nutshell {

// [angular_velocity]
/// Angular velocity [rad/s], world axes, of a body whose axes `q` are its principal axes: turn L
/// into the body, divide by the principal moments, turn back: R I0^-1 R^T L. Source: eq. (53*).
/// @param inertia  principal moments [kg m^2]    @param L  [kg m^2/s], world axes
inline Vector3 angular_velocity(const Vector3& inertia, const Quaternion& q, const Vector3& L) {
    return rotate(q, rotate(inverse(q), L).cwiseQuotient(inertia));
}
// [/angular_velocity]

/// A length that is nearly one, made nearer by one step of Newton's method: a 4-vector collects
/// an epsilon in every product.
inline void trim(Quaternion& q) {
    q.coeffs() *= 1.5 - 0.5 * q.squaredNorm();
}

// [turn_about]
/// Turns the body about its own principal axis number `axis` for dt [s], at the speed that L's
/// part along this axis alone would give it. M is L in body axes: it turns the other way, so that
/// L stands still in the world.
template <int axis>
inline void turn_about(const Vector3& inertia, Quaternion& q, Vector3& M, double dt) {
    constexpr int i = axis, j = (i + 1) % 3, k = (i + 2) % 3;
    const double half = dt / 2 * M[i] / inertia[i], c = std::cos(half), s = std::sin(half);
    const double cc = c * c - s * s, ss = 2 * s * c;  // of the whole angle
    const double mj = M[j], mk = M[k];
    M[j] = cc * mj + ss * mk, M[k] = cc * mk - ss * mj;
    auto& v = q.coeffs();  // q times (s along the axis, c)
    const double qi = v[i], qj = v[j], qk = v[k], qw = v[3];
    v[i] = c * qi + s * qw, v[j] = c * qj + s * qk, v[k] = c * qk - s * qj,
    v[3] = c * qw - s * qi;
}
// [/turn_about]

// [split_rotation]
/// The free rotation, split: half a turn about x, half about y, a whole one about z, half about
/// y, half about x. Each turn is exact, and so is L; together they are second order, symmetric in
/// time and symplectic, at any step. Source: R. I. McLachlan, Phys. Rev. Lett. 71 (1993) 3043.
/// @param q  changed    @param L  [kg m^2/s], world axes    @param dt  [s]
inline void split_rotation(const Vector3& inertia, Quaternion& q, const Vector3& L, double dt) {
    Vector3 M = rotate(inverse(q), L);
    turn_about<0>(inertia, q, M, dt / 2);
    turn_about<1>(inertia, q, M, dt / 2);
    turn_about<2>(inertia, q, M, dt);
    turn_about<1>(inertia, q, M, dt / 2);
    turn_about<0>(inertia, q, M, dt / 2);
    trim(q);
}
// [/split_rotation]

// [symmetric_rotation]
/// The free rotation of a body with two equal moments, exact: its axis number `axis` goes round L
/// at |L|/I1, I1 the moment across, and the body turns about that axis, seen from its own axes,
/// at M3 (1/I3 - 1/I1). A ball only does the first.
template <int axis>
inline void symmetric_rotation(const Vector3& inertia, Quaternion& q, const Vector3& L,
                               double dt) {
    const double across = inertia[(axis + 1) % 3], along = inertia[axis];
    const double M = rotate(q, Vector3::Unit(axis)).dot(L);
    const double half = dt / 2 * M * (1 / along - 1 / across);
    const Quaternion own = four_vector(std::sin(half) * Vector3::Unit(axis), std::cos(half));
    q = product(exponential(dt / across * L), product(q, own));
    trim(q);
}
// [/symmetric_rotation]

// [free_rotation]
/// The free rotation: exact if two moments are equal, else split.
inline void free_rotation(const Vector3& inertia, Quaternion& q, const Vector3& L, double dt) {
    if (inertia[0] == inertia[1]) return symmetric_rotation<2>(inertia, q, L, dt);
    if (inertia[1] == inertia[2]) return symmetric_rotation<0>(inertia, q, L, dt);
    if (inertia[2] == inertia[0]) return symmetric_rotation<1>(inertia, q, L, dt);
    split_rotation(inertia, q, L, dt);
}
// [/free_rotation]

}  // namespace nutshell
