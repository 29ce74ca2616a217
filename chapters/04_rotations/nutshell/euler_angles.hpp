// Three angles for an orientation, as flight simulators and animation programs show them, and
// the pose where they lock.
#pragma once
#include <nutshell/rotations.hpp>

namespace nutshell {

// [euler_angles]
/// Roll about the body's z first, then pitch about x, then yaw about y, which points up. Read
/// the other way round: yaw, then pitch and roll about the axes that have turned along.
struct EulerAngles {
    double yaw = 0, pitch = 0, roll = 0;  ///< [rad]
};

/// The orientation of three angles. Eq. (4.i).
inline Quaternion orientation_of(const EulerAngles& angles) {
    const Quaternion yaw = quaternion_about(Vector3::UnitY(), angles.yaw),
                     pitch = quaternion_about(Vector3::UnitX(), angles.pitch),
                     roll = quaternion_about(Vector3::UnitZ(), angles.roll);
    return product(yaw, product(pitch, roll));
}

/// The three angles of an orientation of length one: pitch from -pi/2 to pi/2, the others from
/// -pi to pi. Where the pitch is +-pi/2 to the last digits ("gimbal lock"), only yaw - roll or
/// yaw + roll has a meaning: there the roll is given as 0.
inline EulerAngles euler_angles(const Quaternion& q) {
    const Matrix3 r = rotation_matrix(q);
    const double level = std::hypot(r(1, 0), r(1, 1));  // cosine of the pitch
    const double pitch = std::atan2(-r(1, 2), level);
    if (level < 1e-15) return {std::atan2(-r(2, 0), r(0, 0)), pitch, 0};
    const double yaw = std::atan2(r(0, 2), r(2, 2)), c = std::cos(yaw), s = std::sin(yaw);
    // the roll that belongs to this yaw: the first row of the matrix with the yaw turned back
    const double roll = std::atan2(s * r(2, 1) - c * r(0, 1), c * r(0, 0) - s * r(2, 0));
    return {yaw, pitch, roll};
}
// [/euler_angles]

// [rates]
/// How fast the three angles must change [rad/s] while the body turns with the angular velocity
/// `omega` [rad/s], world axes. Divides by the cosine of the pitch: near +-pi/2 there is no
/// bound. @throws std::invalid_argument at the lock itself
inline EulerAngles euler_rates(const EulerAngles& angles, const Vector3& omega) {
    const double c = std::cos(angles.pitch), s = std::sin(angles.pitch);
    require(std::abs(c) > 1e-15,
            "euler_rates: at a pitch of 90 degrees two of the three angles "
            "turn about one axis, and some turns cannot be made at all: use "
            "a 4-vector");
    const double ahead = std::sin(angles.yaw) * omega.x() + std::cos(angles.yaw) * omega.z();
    const double aside = std::cos(angles.yaw) * omega.x() - std::sin(angles.yaw) * omega.z();
    return {omega.y() + ahead * s / c, aside, ahead / c};
}
// [/rates]

}  // namespace nutshell
