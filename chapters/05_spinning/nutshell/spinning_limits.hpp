// What theory says of the methods of chapter 5 at a steady spin: per step, with theta = omega dt.
#pragma once
#include <nutshell/spinning.hpp>

namespace nutshell {

// [lag]
/// What one step of (32) multiplies the length of q by. Eq. (5.a).
inline double first_order_growth(double theta) {
    return std::sqrt(1 + theta * theta / 4);
}

/// How much of the angle theta [rad] one step of (32) leaves out: theta^3/12 for small theta.
inline double first_order_lag(double theta) {
    // exercise 5.3
    return theta - 2 * std::atan(theta / 2);
    // end 5.3
}

// [/lag]

/// rk4 multiplies q, as it does every vibration of (half) the angle, by a complex number: its
/// length, and how much of theta it leaves out [rad], theta^5/1920 where theta is small.
inline double rk4_pose_growth(double theta) {
    const double h = theta / 2, square = h * h;
    return std::hypot(1 - square / 2 + square * square / 24, h - h * square / 6);
}
inline double rk4_pose_lag(double theta) {
    const double h = theta / 2, square = h * h;
    return theta - 2 * std::atan2(h - h * square / 6, 1 - square / 2 + square * square / 24);
}

/// omega dt beyond which rk4 makes q longer at every step.
inline const double rk4_pose_limit = 4 * std::sqrt(2.0);

// [clamp]
/// omega, cut to a turn of at most `most` radians in dt seconds: what engines do to keep their
/// other parts safe. @throws std::invalid_argument unless dt and most are greater than zero
inline Vector3 clamped(const Vector3& omega, double dt, double most) {
    require_positive(dt, "clamped: dt [s]");
    require_positive(most, "clamped: the largest turn [rad]");
    const double turn = omega.norm() * dt;
    return turn > most ? Vector3(omega * (most / turn)) : omega;
}

/// The angle [rad] that is left of a turn by theta, 0 or more, in one step, where the clamp is made
/// by halves: the angle under sine and cosine is cut to `most`, the vector part is multiplied by the
/// whole speed and divided by the cut one, and all is made as long as one. So does Bullet 3, with
/// pi/4. @throws std::invalid_argument unless most is between 0 and pi
inline double clamped_by_halves(double theta, double most) {
    require(most > 0 && most < pi,
            "clamped_by_halves: the largest turn [rad] is between 0 and pi");
    return theta > most ? 2 * std::atan(std::tan(most / 2) * theta / most) : theta;
}
// [/clamp]

}  // namespace nutshell
