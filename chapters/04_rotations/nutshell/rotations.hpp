// Chapter 4 · Rotations: as a matrix, as an axis with an angle, as a 4-vector; one after another.
// Right-handed, y up; +90 degrees about z takes x to y; points are turned, not axes ("active").
// Only functions that say @throws look at their input; in the others NaN in gives NaN out.
#pragma once
#include <cmath>
#include <nutshell/require.hpp>
#include <nutshell/vector.hpp>

namespace nutshell {

// [about_axes]
/// Turn by `angle` [rad] about x. Source: eq. (23).
inline Matrix3 rotation_x(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    Matrix3 r;
    r << 1, 0, 0,  //
        0, c, -s,  //
        0, s, c;
    return r;
}

/// Turn by `angle` [rad] about y. Source: eq. (24).
inline Matrix3 rotation_y(double angle) {
    // exercise 4.1
    const double c = std::cos(angle), s = std::sin(angle);
    Matrix3 r;
    r << c, 0, s,  //
        0, 1, 0,   //
        -s, 0, c;
    return r;
    // end 4.1
}

/// Turn by `angle` [rad] about z. Source: eq. (25).
inline Matrix3 rotation_z(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    Matrix3 r;
    r << c, -s, 0,  //
        s, c, 0,    //
        0, 0, 1;
    return r;
}
// [/about_axes]

/// `axis` with length one; its length does not matter, its direction does.
/// @throws std::invalid_argument if it is not finite, or has no length and so no direction
inline Vector3 direction_of(const Vector3& axis) {
    require_finite(axis, "the axis of a rotation");
    const double largest = axis.cwiseAbs().maxCoeff();
    require(largest > 0,
            "the axis of a rotation is the zero vector, which has no direction: give another "
            "axis, or for no turn at all any axis with the angle 0");
    return (axis / largest).normalized();  // in two steps: squares of tiny numbers are zero
}

// [about_any_axis]
/// Turn by `angle` [rad] about `axis` (of any length but zero). Source: eq. (26*).
/// @throws std::invalid_argument if the axis is zero or a number is not finite
inline Matrix3 rotation_about(const Vector3& axis, double angle) {
    require(std::isfinite(angle), "rotation_about: the angle [rad] must be finite");
    // exercise 4.2
    const Vector3 n = direction_of(axis);
    const double c = std::cos(angle / 2), s = std::sin(angle / 2);
    Matrix3 r;
    r(0, 0) = 2 * (n[0] * n[0] * s * s + c * c) - 1;
    r(0, 1) = 2 * (n[0] * n[1] * s * s - n[2] * s * c);
    r(0, 2) = 2 * (n[0] * n[2] * s * s + n[1] * s * c);
    r(1, 0) = 2 * (n[0] * n[1] * s * s + n[2] * s * c);
    r(1, 1) = 2 * (n[1] * n[1] * s * s + c * c) - 1;
    r(1, 2) = 2 * (n[1] * n[2] * s * s - n[0] * s * c);
    r(2, 0) = 2 * (n[0] * n[2] * s * s - n[1] * s * c);
    r(2, 1) = 2 * (n[1] * n[2] * s * s + n[0] * s * c);
    r(2, 2) = 2 * (n[2] * n[2] * s * s + c * c) - 1;
    return r;
    // end 4.2
}
// [/about_any_axis]

/// The point p after a turn by `angle` [rad] about the unit vector n: the part along n stays, the
/// part across it turns in its plane. Rodrigues' formula, eq. (4.a), as the page derives it.
inline Vector3 turned(const Vector3& p, const Vector3& n, double angle) {
    const Vector3 along = n * n.dot(p), across = p - along;
    return along + std::cos(angle) * across + std::sin(angle) * n.cross(p);
}

// [four_vector]
/// The 4-vector (x, y, z, w) with u = (x, y, z). Eigen stores it in this order, but its
/// constructor wants w first: this is the only place that has to know.
inline Quaternion four_vector(const Vector3& u, double w) {
    return Quaternion(w, u.x(), u.y(), u.z());
}

/// The 4-vector of a turn by `angle` [rad] about `axis` (of any length but zero).
/// Source: eq. (27). @throws std::invalid_argument if the axis is zero or a number is not finite
inline Quaternion quaternion_about(const Vector3& axis, double angle) {
    require(std::isfinite(angle), "quaternion_about: the angle [rad] must be finite");
    return four_vector(direction_of(axis) * std::sin(angle / 2), std::cos(angle / 2));
}
// [/four_vector]

/// Gives q back if it is an orientation. @throws std::invalid_argument if a number is not finite,
/// or its length differs from one by more than a millionth
inline Quaternion checked(const Quaternion& q) {
    require_finite(q.coeffs(), "an orientation's 4-vector");
    require(std::abs(q.norm() - 1) <= 1e-6, "an orientation's 4-vector has length " +
                                                std::to_string(q.norm()) +
                                                " instead of 1: make it `normalised` first");
    return q;
}

/// q divided by its length. @throws std::invalid_argument if a number is not finite, or its length
/// is zero, below 1e-100 or above 1e100: then its square is no number to divide by
inline Quaternion normalised(const Quaternion& q) {
    require_finite(q.coeffs(), "the 4-vector to normalise");
    const double square = q.squaredNorm();
    require(square > 1e-200 && square < 1e200,
            "a 4-vector whose length is zero, or far from any number that turns leave, is no "
            "orientation: it cannot be normalised");
    return q.normalized();
}

// [matrix]
/// The rotation matrix of a 4-vector q of length one; q and -q have the same. Checks nothing: a
/// length of 1.1 gives a matrix that is no rotation at all. Source: eq. (28*).
inline Matrix3 rotation_matrix(const Quaternion& q) {
    // exercise 4.3
    const double x = q.x(), y = q.y(), z = q.z(), w = q.w();
    Matrix3 r;
    r << 2 * (x * x + w * w) - 1, 2 * (x * y - z * w), 2 * (x * z + y * w),  //
        2 * (x * y + z * w), 2 * (y * y + w * w) - 1, 2 * (y * z - x * w),   //
        2 * (x * z - y * w), 2 * (y * z + x * w), 2 * (z * z + w * w) - 1;
    return r;
    // end 4.3
}
// [/matrix]

// [rotate]
/// The point p turned by q without a matrix: p + w t + u x t with t = 2 u x p. Eq. (4.e).
inline Vector3 rotate(const Quaternion& q, const Vector3& p) {
    const Vector3 u = q.vec(), t = 2 * u.cross(p);
    return p + q.w() * t + u.cross(t);
}
// [/rotate]

// [product]
/// The one turn that does `first`, then `second`, both about axes that stand still in the world:
/// R(product(b, a)) = R(b) R(a). Source: eq. (29), its "explicit calculation" as eq. (4.d).
inline Quaternion product(const Quaternion& second, const Quaternion& first) {
    // exercise 4.4
    const Vector3 u1 = first.vec(), u2 = second.vec();
    const double w1 = first.w(), w2 = second.w();
    return four_vector(w2 * u1 + w1 * u2 + u2.cross(u1), w2 * w1 - u2.dot(u1));
    // end 4.4
}

/// The turn back: the same angle about the opposite axis.
inline Quaternion inverse(const Quaternion& q) {
    return four_vector(-q.vec(), q.w());
}
// [/product]

// [small_turn]
/// What the source writes as the product of a rotation vector [rad], world axes, and a 4-vector:
/// the product (29) with (beta, 0). Source: eq. (31*).
inline Quaternion vector_product(const Vector3& beta, const Quaternion& q) {
    return product(four_vector(beta, 0), q);
}

/// q turned by the small rotation vector `beta` [rad], world axes, to first order, and made as
/// long as one again. Turns by 2 atan(|beta|/2) instead of |beta|. Source: eqs. (30*), (31*).
inline Quaternion small_turn(const Quaternion& q, const Vector3& beta) {
    // exercise 4.5
    const Quaternion change = vector_product(beta, q);
    return Quaternion(q.coeffs() + change.coeffs() / 2).normalized();
    // end 4.5
}
// [/small_turn]

// [exponential]
/// The turn about the direction of `a` by the angle |a| [rad]: Exp(a), defined for a = 0 too.
/// Source: eq. (27) with n = a/|a|; erratum E21. Eq. (4.f).
inline Quaternion exponential(const Vector3& a) {
    // exercise 4.6
    const double square = a.squaredNorm(), angle = std::sqrt(square);
    // sin(angle/2)/angle; where a is tiny by the first terms of its series, so nothing is 0/0
    const double scale = square < 1e-8 ? 0.5 - square / 48 : std::sin(angle / 2) / angle;
    return four_vector(scale * a, std::cos(angle / 2));
    // end 4.6
}
// [/exponential]

// [logarithm]
/// The rotation vector [rad] of q, the shorter way round: its length is at most pi, and q and -q
/// have the same. The inverse of `exponential`. The length of q does not matter, from 1e-100 to
/// 1e100; of (0, 0, 0, 0) there is no direction, and NaN comes out. Eq. (4.g).
inline Vector3 logarithm(const Quaternion& q) {
    // exercise 4.7
    const double sign = q.w() < 0 ? -1 : 1;
    const Vector3 u = sign * q.vec();
    const double w = sign * q.w(), square = u.squaredNorm(), length = std::sqrt(square);
    // angle / |u|; where u is tiny by the first terms of the series of the arctangent
    const double scale = square < 1e-8 * w * w ? (2 - 2 * square / (3 * w * w)) / w
                                               : 2 * std::atan2(length, w) / length;
    return scale * u;
    // end 4.7
}
// [/logarithm]

/// The angle [rad], from 0 to pi, of the turn that leads from one orientation to the other.
inline double angle_between(const Quaternion& a, const Quaternion& b) {
    return logarithm(product(b, inverse(a))).norm();
}

// [slerp]
/// `part` of the way from one orientation to the other (0 to 1), about one axis at one speed, the
/// shorter way round. Eq. (4.h). Source: K. Shoemake, SIGGRAPH 1985, there as a formula of sines.
inline Quaternion slerp(const Quaternion& from, const Quaternion& to, double part) {
    // exercise 4.8
    const Vector3 way = logarithm(product(to, inverse(from)));
    return product(exponential(part * way), from);
    // end 4.8
}

/// The same way at an uneven speed, for less: the straight line between the two 4-vectors, made
/// as long as one. Faster in the middle by 1/cos^2(angle/4), the angle between the orientations.
inline Quaternion nlerp(const Quaternion& from, const Quaternion& to, double part) {
    const double sign = from.dot(to) < 0 ? -1 : 1;
    return Quaternion((1 - part) * from.coeffs() + sign * part * to.coeffs()).normalized();
}
// [/slerp]

}  // namespace nutshell
