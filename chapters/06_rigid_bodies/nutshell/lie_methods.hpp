// Chapter 6 · General-purpose methods for bodies: on the group of poses, and on flat numbers.
#pragma once
#include <nutshell/body.hpp>
#include <nutshell/right_hand_side.hpp>

namespace nutshell {

// [motion]
/// How a body's state changes per second: what a step adds to position, momentum and angular
/// momentum, and by what it turns the pose.
struct Motion {
    Vector3 velocity = Vector3::Zero();          ///< [m/s]
    Vector3 angular_velocity = Vector3::Zero();  ///< [rad/s], world axes
    Wrench push;                                 ///< [N], [N m]
};
inline Motion operator+(const Motion& a, const Motion& b) {
    return {a.velocity + b.velocity, a.angular_velocity + b.angular_velocity, a.push + b.push};
}
inline Motion operator*(double factor, const Motion& m) {
    return {factor * m.velocity,
            factor * m.angular_velocity,
            {factor * m.push.force, factor * m.push.torque}};
}

/// The motion of a body under a push [N], [N m] about its centre, world axes.
inline Motion motion(const Body& body, const Wrench& push) {
    return {velocity(body), angular_velocity(body), push};
}
/// The same of a pinned one, whose torque is about the pivot.
inline Motion motion(const Pinned& body, const Wrench& push) {
    return {Vector3::Zero(), angular_velocity(body), push};
}

/// The body, moved by m for one second, its pose turned about one axis that stands still.
inline Body moved(Body body, const Motion& m) {
    body.position += m.velocity, body.momentum += m.push.force;
    body.orientation = product(series_exponential(m.angular_velocity), trimmed(body.orientation));
    body.angular_momentum += m.push.torque;
    return body;
}
/// The same of a pinned one.
inline Pinned moved(Pinned body, const Motion& m) {
    body.orientation = product(series_exponential(m.angular_velocity), trimmed(body.orientation));
    body.angular_momentum += m.push.torque;
    return body;
}
// [/motion]

// [lie_rk4]
/// RK4 on the group of rotations: every stage is a turn from the start, and what a stage's
/// angular velocity w adds to that turn u is w - u x w/2 + u x (u x w)/12 (turns do not add).
/// Fourth order for any forces. It takes L in body axes from the pose at every stage: near the
/// middle axis of a free body that costs accuracy.
/// Source: H. Munthe-Kaas, BIT 38 (1998) 92.
template <Turns State, class Forces>
State lie_rk4(const State& state, const Forces& forces, double t, double dt) {
    const auto at = [&](const Motion& step, double time) {
        const State there = moved(state, step);
        Motion m = motion(there, forces(there, time));
        const Vector3 &u = step.angular_velocity, &w = m.angular_velocity, uw = u.cross(w);
        m.angular_velocity = w - uw / 2 + u.cross(uw) / 12;
        return m;
    };
    const Motion k1 = motion(state, forces(state, t));
    const Motion k2 = at(dt / 2 * k1, t + dt / 2);
    const Motion k3 = at(dt / 2 * k2, t + dt / 2);
    const Motion k4 = at(dt * k3, t + dt);
    return moved(state, dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4));
}
// [/lie_rk4]

// [body_flat]
// [pinned_flat]
/// A pinned body as seven numbers for the general-purpose methods: 4-vector, and L in body axes.
/// Nothing keeps the 4-vector's length at one.
using FlatPinned = Eigen::Matrix<double, 7, 1>;

/// To seven numbers ...
inline FlatPinned flat(const Pinned& body) {
    FlatPinned y;
    y << body.orientation.coeffs(), rotate(inverse(body.orientation), body.angular_momentum);
    return y;
}
/// ... and back, the 4-vector made as long as one. @param like  has the moments [kg m^2]
inline Pinned unflat(const FlatPinned& y, Pinned like) {
    like.orientation.coeffs() = y.head<4>().normalized();
    like.angular_momentum = rotate(like.orientation, y.tail<3>());
    return like;
}

/// q' = q (omega, 0)/2 and M' = M x omega + torque, all in body axes. Source: L. Euler, 1758.
/// @param y  the 4-vector of the pose, then M, which is L in body axes [kg m^2/s]
/// @param J  inverse principal moments [1/(kg m^2)]    @param torque  [N m], world axes
inline FlatPinned rate_in_body(const FlatPinned& y, const Vector3& J, const Vector3& torque) {
    // exercise 6.13
    const Quaternion q(Eigen::Vector4d(y.head<4>()));
    const Vector3 M = y.tail<3>(), omega = J.cwiseProduct(M);
    FlatPinned rate;
    rate << product(q, four_vector(omega / 2, 0)).coeffs(),
        gyroscopic_term(J, M) + rotate(inverse(q), torque);
    return rate;
    // end 6.13
}
// [/pinned_flat]
/// How a pinned body's seven numbers change per second. @param push  [N], [N m], world axes
inline FlatPinned rate(const Pinned& body, const Wrench& push) {
    return rate_in_body(flat(body), body.inertia.cwiseInverse(), push.torque);
}

/// A body as thirteen: position, momentum, and these seven.
using FlatBody = Eigen::Matrix<double, 13, 1>;

/// A body's turning alone, about its centre.
inline Pinned turning(const Body& body) {
    return {body.inertia, body.orientation, body.angular_momentum};
}
/// To thirteen numbers ...
inline FlatBody flat(const Body& body) {
    FlatBody y;
    y << body.position, body.momentum, flat(turning(body));
    return y;
}
/// ... and back. @param like  has mass [kg] and moments [kg m^2]
inline Body unflat(const FlatBody& y, Body like) {
    const Pinned turned = unflat(FlatPinned(y.tail<7>()), turning(like));
    like.position = y.head<3>(), like.momentum = y.segment<3>(3);
    like.orientation = turned.orientation, like.angular_momentum = turned.angular_momentum;
    return like;
}
/// How these thirteen change per second. @param push  [N], [N m], world axes
inline FlatBody rate(const Body& body, const Wrench& push) {
    FlatBody y;
    y << velocity(body), push.force, rate(turning(body), push);
    return y;
}
// [/body_flat]

}  // namespace nutshell
