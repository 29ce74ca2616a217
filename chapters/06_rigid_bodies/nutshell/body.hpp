// Chapter 6 · Rigid bodies: a particle's state and verbs, and the same once more for turning.
#pragma once
#include <nutshell/free_rotation.hpp>
#include <nutshell/moments.hpp>

namespace nutshell {

// [wrench]
/// What pushes a body: a force, and a torque about the point its state is kept for (the centre of
/// mass of a Body, the pivot of a Pinned).
struct Wrench {
    Vector3 force = Vector3::Zero();   ///< [N], world axes
    Vector3 torque = Vector3::Zero();  ///< [N m], world axes
};

/// Two wrenches at once. Source: eqs. (50), (51): forces add up, and so do torques.
inline Wrench operator+(const Wrench& a, const Wrench& b) {
    return {a.force + b.force, a.torque + b.torque};
}

/// A force [N] at the end of a lever arm [m] from the centre of mass or the pivot, both in world
/// axes. Source: eq. (42), tau = r x F.
inline Wrench force_at(const Vector3& force, const Vector3& arm) {
    // exercise 6.1
    return {force, arm.cross(force)};
    // end 6.1
}
// [/wrench]

// [state]
/// A rigid body. Its body axes are its principal axes, their origin its centre of mass.
struct Body {
    double mass = 1;                                  ///< [kg]
    Vector3 inertia = Vector3::Ones();                ///< principal moments [kg m^2]
    Vector3 position = Vector3::Zero();               ///< of the centre of mass [m], world frame
    Vector3 momentum = Vector3::Zero();               ///< [kg m/s], world frame
    Quaternion orientation = Quaternion::Identity();  ///< turns body axes into world axes
    Vector3 angular_momentum = Vector3::Zero();       ///< about the centre [kg m^2/s], world axes
};

/// A rigid body that turns about a pivot at the origin. Its body axes are principal axes for the
/// pivot, and so are the moments (parallel axes).
struct Pinned {
    Vector3 inertia = Vector3::Ones();  ///< principal moments about the pivot [kg m^2]
    Quaternion orientation = Quaternion::Identity();  ///< turns body axes into world axes
    Vector3 angular_momentum = Vector3::Zero();       ///< about the pivot [kg m^2/s], world axes
};
// [/state]

/// Any state that turns.
template <class State>
concept Turns = requires(const State& s) {
    s.inertia, s.orientation, s.angular_momentum;
};

/// Throws std::invalid_argument with the reason if these numbers cannot turn.
template <Turns State>
void require_can_turn(const State& body) {
    require_finite(body.inertia, "the principal moments of inertia [kg m^2]");
    require_positive(
        body.inertia.minCoeff(),
        "the smallest principal moment of inertia [kg m^2] (a rod without thickness has "
        "none: make it a cylinder)");
    const std::string reason = why_impossible(body.inertia);
    require(reason.empty(), "no body has these principal moments: " + reason);
    checked(body.orientation);
    require_finite(body.angular_momentum, "the angular momentum [kg m^2/s]");
}

/// Gives `body` back if it can be simulated. @throws std::invalid_argument with the reason if not
inline Body checked(const Body& body) {
    require_positive(body.mass, "the mass of a body [kg]");
    require_finite(body.position, "the position of a body [m]");
    require_finite(body.momentum, "the momentum of a body [kg m/s]");
    require_can_turn(body);
    return body;
}

/// The same for a pinned one.
inline Pinned checked(const Pinned& body) {
    require_can_turn(body);
    return body;
}

// [verbs]
/// Drift: the body moves with the momentum it has and turns with the angular momentum it has.
/// Source: eqs. (52)-(54), and (56*), whose constant omega is replaced by the free rotation.
[[gnu::always_inline]] inline void drift(Body& body, double dt) {
    body.position += body.momentum / body.mass * dt;
    free_rotation(body.inertia, body.orientation, body.angular_momentum, dt);
}

/// Kick: a force changes the momentum, a torque the angular momentum. Source: eqs. (55), (57).
inline void kick(Body& body, const Wrench& push, double dt) {
    body.momentum += push.force * dt;
    body.angular_momentum += push.torque * dt;
}

/// Drift of a pinned body: it turns with the angular momentum it has.
[[gnu::always_inline]] inline void drift(Pinned& body, double dt) {
    free_rotation(body.inertia, body.orientation, body.angular_momentum, dt);
}

/// Kick of a pinned body: the torque about the pivot. The pivot answers the force.
inline void kick(Pinned& body, const Wrench& push, double dt) {
    body.angular_momentum += push.torque * dt;
}
// [/verbs]

// [derived]
/// Velocity of the centre of mass [m/s], world frame. Source: eq. (52).
inline Vector3 velocity(const Body& body) {
    return body.momentum / body.mass;
}

/// Angular velocity [rad/s], world axes. Source: eq. (53*).
template <Turns State>
Vector3 angular_velocity(const State& body) {
    return angular_velocity(body.inertia, body.orientation, body.angular_momentum);
}

/// Inertia in world axes [kg m^2], R I0 R^T, and its inverse. Source: eq. (53*).
template <Turns State>
Matrix3 world_inertia(const State& body) {
    const Matrix3 R = rotation_matrix(body.orientation);
    return R * body.inertia.asDiagonal() * R.transpose();
}
template <Turns State>
Matrix3 world_inverse_inertia(const State& body) {
    const Matrix3 R = rotation_matrix(body.orientation);
    return R * body.inertia.cwiseInverse().asDiagonal() * R.transpose();
}

/// The body with the angular velocity `omega` [rad/s], world axes: L = I omega. Source: eq. (48).
template <Turns State>
State spinning(State body, const Vector3& omega) {
    const Vector3 own = rotate(inverse(body.orientation), omega);
    body.angular_momentum = rotate(body.orientation, own.cwiseProduct(body.inertia));
    return body;
}

/// Where a point of the body, r [m] in body axes, is in the world. Source: eq. (58).
inline Vector3 point_of(const Body& body, const Vector3& r) {
    return rotate(body.orientation, r) + body.position;
}

/// How fast a point of the body, r [m] in body axes, moves. Source: eq. (59*).
inline Vector3 velocity_of(const Body& body, const Vector3& r) {
    return angular_velocity(body).cross(rotate(body.orientation, r)) + velocity(body);
}

/// Energy of rotation [J]: half of omega L.
template <Turns State>
double rotational_energy(const State& body) {
    const Vector3 M = rotate(inverse(body.orientation), body.angular_momentum);
    return M.dot(M.cwiseQuotient(body.inertia)) / 2;
}

/// Energy of motion and rotation [J].
inline double kinetic_energy(const Body& body) {
    return body.momentum.squaredNorm() / (2 * body.mass) + rotational_energy(body);
}

/// Angular momentum [kg m^2/s] about the origin: of the turning, and of the centre's motion.
inline Vector3 angular_momentum(const Body& body) {
    return body.angular_momentum + body.position.cross(body.momentum);
}
// [/derived]

}  // namespace nutshell
