// Chapter 5 · Spinning: how fast the points of a turning body move, and what a pose does while
// its angular velocity changes. Every angular velocity is given in the world's axes.
#pragma once
#include <nutshell/rotations.hpp>
#include <nutshell/runge_kutta.hpp>

namespace nutshell {

// [velocity]
/// Velocity [m/s] of a point of a spinning body, seen from the point that stays.
/// @param omega  angular velocity [rad/s], world axes
/// @param pose  of the body now      @param p  where the point is in the body [m], body axes
/// Source: eqs. (34), (37*).
inline Vector3 point_velocity(const Vector3& omega, const Quaternion& pose, const Vector3& p) {
    // exercise 5.1
    return omega.cross(rotate(pose, p));
    // end 5.1
}

/// The steady angular velocity [rad/s] that would lead from one pose to the next in dt seconds,
/// the shorter way round: between two pictures nobody can tell a long way from a short one.
/// @throws std::invalid_argument if dt is not finite and greater than zero
inline Vector3 angular_velocity_between(const Quaternion& from, const Quaternion& to, double dt) {
    require_positive(dt, "angular_velocity_between: dt [s]");
    // exercise 5.2
    return logarithm(product(to, inverse(from))) / dt;
    // end 5.2
}
// [/velocity]

// The methods below move a pose q through one step. `spin` is called as spin(q, t) and gives the
// angular velocity [rad/s], world axes; t and dt in seconds.

// [first_order]
/// One step of the source's rule: along the straight line that q begins on. Turns by
/// 2 atan(omega dt/2) and makes q longer by sqrt(1 + (omega dt)^2/4) every time. Source: eq. (32)
/// with the rows of (31*).
template <class Spin>
Quaternion first_order(const Quaternion& q, const Spin& spin, double t, double dt) {
    const Quaternion change = vector_product(spin(q, t) * dt, q);
    return Quaternion(q.coeffs() + change.coeffs() / 2);
}

/// The same, made as long as one again. First order; late by (omega dt)^3/12 a step even where
/// the spin is steady. Source: eq. (32*).
template <class Spin>
Quaternion first_order_unit(const Quaternion& q, const Spin& spin, double t, double dt) {
    return small_turn(q, spin(q, t) * dt);
}
// [/first_order]

// [exponential_map]
/// One step with the angular velocity of its start, exactly: Exp(omega dt) q. First order; exact
/// for a steady spin, however fast. Eq. (5.b).
template <class Spin>
Quaternion exponential_map(const Quaternion& q, const Spin& spin, double t, double dt) {
    // exercise 5.4
    return product(exponential(spin(q, t) * dt), q);
    // end 5.4
}

/// The same with the angular velocity of the middle of the step, which a step of half the length
/// finds if it depends on the pose. Second order. Eq. (5.c).
template <class Spin>
Quaternion exponential_midpoint(const Quaternion& q, const Spin& spin, double t, double dt) {
    // exercise 5.5
    const Quaternion middle = exponential_map(q, spin, t, dt / 2);
    return product(exponential(spin(middle, t + dt / 2) * dt), q);
    // end 5.5
}
// [/exponential_map]

// [magnus]
/// One step with two angular velocities, at the Gauss points of the step, and the term that says
/// that turns do not commute. Fourth order for a spin that depends on time only. Eq. (5.d).
/// Source: A. Iserles and S. Norsett, Phil. Trans. R. Soc. A 357 (1999) 983.
template <class Spin>
Quaternion magnus4(const Quaternion& q, const Spin& spin, double t, double dt) {
    // exercise 5.6
    const double apart = std::sqrt(3.0) / 6 * dt;
    const Vector3 first = spin(q, t + dt / 2 - apart), second = spin(q, t + dt / 2 + apart);
    const Vector3 turn =
        dt / 2 * (first + second) + std::sqrt(3.0) / 12 * dt * dt * second.cross(first);
    return product(exponential(turn), q);
    // end 5.6
}
// [/magnus]

// [rk4_pose]
/// One step of chapter 3's rk4 on the four numbers of q, whose rate is half of (omega, 0) q.
/// Fourth order; does not keep the length: late by (omega dt)^5/1920 a step, and unstable beyond
/// omega dt = 4 sqrt(2).
template <class Spin>
Quaternion rk4_pose(const Quaternion& q, const Spin& spin, double t, double dt) {
    // exercise 5.7
    const auto rate = [&](const Eigen::Vector4d& y, double now) {
        const Quaternion pose(y);
        return Eigen::Vector4d(vector_product(spin(pose, now), pose).coeffs() / 2);
    };
    return Quaternion(rk4(Eigen::Vector4d(q.coeffs()), rate, t, dt));
    // end 5.7
}
// [/rk4_pose]

// [seen]
/// The turn [rad] an eye sees between two pictures of a wheel with `spokes` equal spokes: the
/// shortest one that looks the same, from -pi/spokes to pi/spokes. Eq. (5.f).
/// @throws std::invalid_argument if there are no spokes
inline double seen_turn(double turn, int spokes) {
    require(spokes >= 1, "seen_turn: a wheel needs one spoke at least to be seen turning");
    // exercise 5.8
    return std::remainder(turn, 2 * pi / spokes);
    // end 5.8
}
// [/seen]

}  // namespace nutshell
