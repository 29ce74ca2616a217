// Equations (26) and (28) as the source prints them, for the picture of what they do to a cube.
#pragma once
#include <nutshell/rotations.hpp>

namespace nutshell::printed {

/// Eq. (26): two entries wrong, errata E13 and E14. n of length one.
inline Matrix3 rotation_about(const Vector3& n, double angle) {
    const double c = std::cos(angle / 2), s = std::sin(angle / 2);
    Matrix3 r = nutshell::rotation_about(n, angle);
    r(0, 2) = 2 * (n[0] * n[2] * s * s - n[1] * s * c);
    r(2, 0) = 2 * (n[0] * s * c - n[1] * s * c);
    return r;
}

/// Eq. (28): two entries wrong, errata E16 and E17.
inline Matrix3 rotation_matrix(const Quaternion& q) {
    Matrix3 r = nutshell::rotation_matrix(q);
    r(0, 0) = 2 * (q.x() * q.x() + q.y() * q.y()) - 1;
    r(0, 2) = 2 * (q.x() * q.z() - q.y() * q.w());
    return r;
}

}  // namespace nutshell::printed
