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

// [gyroscopic_term]
/// How L changes per second as seen from the body [N m], while it stands still in the world:
/// M x omega. Source: L. Euler, 1758.
/// @param J  inverse principal moments [1/(kg m^2)]    @param M  L in body axes [kg m^2/s]
[[gnu::always_inline]] inline Vector3 gyroscopic_term(const Vector3& J, const Vector3& M) {
    // exercise 6.9
    return M.cross(J.cwiseProduct(M));
    // end 6.9
}
// [/gyroscopic_term]

/// A 4-vector whose length is nearly one, nearer by one step of Newton's method: it collects an
/// epsilon in every product.
[[gnu::always_inline]] inline Quaternion trimmed(const Quaternion& q) {
    return Quaternion(Eigen::Vector4d(q.coeffs() * (1.5 - 0.5 * q.squaredNorm())));
}

// [series_exponential]
/// Exp(a) for a step's turn: up to one radian by the series of sine and cosine, to round-off and
/// without a library; beyond as `exponential`. A third of its time, and the same bits everywhere.
[[gnu::always_inline]] inline Quaternion series_exponential(const Vector3& a) {
    const double x = a.squaredNorm() / 4;  // half the angle, squared
    if (!(x <= 0.25)) return exponential(a);
    // Pairs of terms side by side, not one after the other: the processor can do them at once.
    // The first term left out is x^8/16! < 1e-18.
    const double x2 = x * x, x4 = x2 * x2;
    const double cosine =
        (1 - x * (1. / 2)) + x2 * (1. / 24 - x * (1. / 720)) +
        x4 * ((1. / 40320 - x * (1. / 3628800)) + x2 * (1. / 479001600 - x * (1. / 87178291200)));
    const double sine = (1 - x * (1. / 6)) + x2 * (1. / 120 - x * (1. / 5040)) +
                        x4 * ((1. / 362880 - x * (1. / 39916800)) +
                              x2 * (1. / 6227020800 - x * (1. / 1307674368000)));
    return four_vector(0.5 * sine * a, cosine);
}
// [/series_exponential]

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
[[gnu::flatten]] inline void split_rotation(const Vector3& inertia, Quaternion& q,
                                            const Vector3& L, double dt) {
    // exercise 6.10
    Quaternion turned = trimmed(q);
    Vector3 M = rotate(inverse(turned), L);
    turn_about<0>(inertia, turned, M, dt / 2);
    turn_about<1>(inertia, turned, M, dt / 2);
    turn_about<2>(inertia, turned, M, dt);
    turn_about<1>(inertia, turned, M, dt / 2);
    turn_about<0>(inertia, turned, M, dt / 2);
    q = turned;
    // end 6.10
}
// [/split_rotation]

// [symmetric_rotation]
/// The free rotation of a body with two equal moments, exact: its axis number `axis` goes round L
/// at |L|/I1, I1 the moment across, and the body turns about that axis, seen from its own axes,
/// at M3 (1/I3 - 1/I1). A ball only does the first.
template <int axis>
[[gnu::flatten, gnu::always_inline]] inline void symmetric_rotation(const Vector3& inertia,
                                                                    Quaternion& q,
                                                                    const Vector3& L, double dt) {
    const double across = inertia[(axis + 1) % 3], along = inertia[axis];
    const double M = rotate(q, Vector3::Unit(axis)).dot(L);
    const double own = dt * M * (1 / along - 1 / across);
    q = product(series_exponential(dt / across * L),
                product(trimmed(q), series_exponential(own * Vector3::Unit(axis))));
}
// [/symmetric_rotation]

// [free_rotation]
/// The free rotation: exact if two moments are equal, else split.
[[gnu::flatten, gnu::always_inline]] inline void free_rotation(const Vector3& inertia,
                                                               Quaternion& q, const Vector3& L,
                                                               double dt) {
    if (inertia[0] == inertia[1]) return symmetric_rotation<2>(inertia, q, L, dt);
    if (inertia[1] == inertia[2]) return symmetric_rotation<0>(inertia, q, L, dt);
    if (inertia[2] == inertia[0]) return symmetric_rotation<1>(inertia, q, L, dt);
    split_rotation(inertia, q, L, dt);
}
// [/free_rotation]

}  // namespace nutshell
