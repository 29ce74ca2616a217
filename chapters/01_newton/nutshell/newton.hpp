// Chapter 1 · Newton: state, drift, kick, and three ways to say them.
#pragma once
#include <nutshell/method.hpp>
#include <nutshell/require.hpp>
#include <nutshell/vector.hpp>
#include <optional>

namespace nutshell {

inline constexpr double earth_gravity = 9.81;  ///< g [m/s^2] at the surface, downwards; Y is up

// [state]
/// A body reduced to a point: all that Newton's law needs to know of it.
struct PointMass {
    double mass = 1;                     ///< [kg], greater than zero
    Vector3 position = Vector3::Zero();  ///< [m], world frame
    Vector3 velocity = Vector3::Zero();  ///< [m/s], world frame
};
// [/state]

/// Gives `body` back if it can be simulated. @throws std::invalid_argument if its mass is not
/// greater than zero or any of its numbers is not finite.
inline PointMass checked(const PointMass& body) {
    require_positive(body.mass, "the mass of a point mass [kg]");
    require_finite(body.position, "the position of a point mass [m]");
    require_finite(body.velocity, "the velocity of a point mass [m/s]");
    return body;
}

// [measure]
/// Velocity [m/s] from two positions [m] that are dt [s] apart: the mean over the interval,
/// which is the velocity at its middle if the acceleration is constant. Source: eq. (1).
/// @throws std::invalid_argument if dt is not finite and greater than zero
inline Vector3 velocity_between(const Vector3& position, const Vector3& next_position,
                                double dt) {
    require_positive(dt, "velocity_between: dt [s]");
    // exercise 1.1
    return (next_position - position) / dt;
    // end 1.1
}

/// Acceleration [m/s^2] at the middle one of three positions [m], dt [s] from each other.
/// Source: eq. (2) applied to two velocities of eq. (1).
/// @throws std::invalid_argument if dt is not finite and greater than zero
inline Vector3 acceleration_at(const Vector3& before, const Vector3& here, const Vector3& after,
                               double dt) {
    require_positive(dt, "acceleration_at: dt [s]");
    // exercise 1.2
    return (velocity_between(here, after, dt) - velocity_between(before, here, dt)) / dt;
    // end 1.2
}
// [/measure]

// [verbs]
/// Drift: the body moves with the velocity it has, for dt seconds. Source: eq. (8).
inline void drift(PointMass& body, double dt) {
    body.position += body.velocity * dt;
}

/// Kick: a force [N], world frame, changes the velocity for dt seconds. Source: eqs. (7), (9).
inline void kick(PointMass& body, const Vector3& force, double dt) {
    body.velocity += force / body.mass * dt;
}
// [/verbs]

// The three methods below move any state that has a drift and a kick.
// `template <class State, class Forces>` reads "for whatever type of state and whatever kind
// of function": the compiler fills in PointMass here, other states later.

// [euler]
/// One step of Euler's method: drift with the velocity of the start of the step, then kick
/// with the force of its start. First order; gains energy on every orbit and every spring.
/// Source: eqs. (8)-(9).
/// @param forces  called as forces(state, t), gives the push (here a force [N], world axes)
/// @param t  time at the start of the step [s]      @param dt  step [s]
template <class State, class Forces>
State euler(State state, const Forces& forces, double t, double dt) {
    // exercise 1.3
    const auto push = forces(state, t);
    drift(state, dt);
    kick(state, push, dt);
    return state;
    // end 1.3
}
// [/euler]

// [semi_implicit_euler]
/// One step of semi-implicit (symplectic) Euler: kick, then drift with the new velocity.
/// First order; keeps the energy of an orbit or a spring in a band.
/// Source: eqs. (8)-(9) with their order exchanged.
/// @param forces  called as forces(state, t), gives the push    @param t, dt  time, step [s]
template <class State, class Forces>
State semi_implicit_euler(State state, const Forces& forces, double t, double dt) {
    // exercise 1.4
    kick(state, forces(state, t), dt);
    drift(state, dt);
    return state;
    // end 1.4
}
// [/semi_implicit_euler]

// [verlet]
/// One step of velocity Verlet (leapfrog): half a kick, a drift, half a kick with the force of
/// the new place. Second order for forces that depend on position and time; keeps the energy
/// in a narrow band.
/// @param forces  called as forces(state, t), gives the push    @param t, dt  time, step [s]
/// Source: L. Verlet, Phys. Rev. 159 (1967) 98; in this form W. Swope et al., J. Chem. Phys.
/// 76 (1982) 637.
template <class State, class Forces>
State verlet(State state, const Forces& forces, double t, double dt) {
    // exercise 1.5
    kick(state, forces(state, t), dt / 2);
    drift(state, dt);
    kick(state, forces(state, t + dt), dt / 2);
    return state;
    // end 1.5
}
// [/verlet]

// [kept_verlet]
/// Verlet for many steps in a row: the push at the end of one step is that at the start of
/// the next ("first same as last"). It is kept, so a step costs one evaluation instead of two.
/// The same numbers as `verlet`, bit for bit, as long as the push depends on the position only.
/// One object per run: it remembers.
/// @tparam Push  what forces(state, t) gives
template <class Push>
struct KeptVerlet {
    std::optional<Push> kept = {};

    template <class State, class Forces>
    State operator()(State state, const Forces& forces, double t, double dt) {
        if (!kept) kept = forces(state, t);
        kick(state, *kept, dt / 2);
        drift(state, dt);
        evaluate(forces, state, t + dt, *kept);  // *kept = forces(state, t + dt)
        kick(state, *kept, dt / 2);
        return state;
    }
};
// [/kept_verlet]

// [laws]
/// When a step kicks, which is where the three methods differ: after the drift (Euler), before it
/// (semi-implicit Euler), or half before and half after (Verlet).
enum class Kicked { after_drift, before_drift, half_and_half };

/// Computed minus exact position [m] after `duration` seconds of constant acceleration
/// [m/s^2] in steps of dt [s]: -a T dt/2 for Euler, +a T dt/2 for semi-implicit Euler, zero
/// for Verlet. Exact, not an estimate. Eq. (1.a).
inline Vector3 throw_error(Kicked kicked, const Vector3& acceleration, double duration,
                           double dt) {
    // exercise 1.6
    const Vector3 half_step_lag = acceleration * duration * dt / 2;
    if (kicked == Kicked::after_drift) return -half_step_lag;
    if (kicked == Kicked::before_drift) return half_step_lag;
    return Vector3::Zero();
    // end 1.6
}

/// The largest step [s] that divides `duration` [s] into whole steps and keeps Euler's error
/// at its end within `tolerance` [m], under constant acceleration [m/s^2]: (1.a) solved.
/// @throws std::invalid_argument if tolerance or duration is not finite and positive
inline double euler_step_within(double tolerance, const Vector3& acceleration, double duration) {
    require_positive(tolerance, "euler_step_within: tolerance [m]");
    require_positive(duration, "euler_step_within: duration [s]");
    // exercise 1.7
    const double steps = std::ceil(acceleration.norm() * duration * duration / (2 * tolerance));
    return duration / std::max(1.0, steps);
    // end 1.7
}
// [/laws]

/// Kinetic energy [J].
inline double kinetic_energy(const PointMass& body) {
    return body.mass * body.velocity.squaredNorm() / 2;
}

/// Angular momentum [kg m^2/s] about the origin, world frame.
inline Vector3 angular_momentum(const PointMass& body) {
    return body.mass * body.position.cross(body.velocity);
}

}  // namespace nutshell
