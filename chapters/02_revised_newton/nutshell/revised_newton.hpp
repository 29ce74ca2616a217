// Chapter 2 · Revised Newton: momentum as the state, and mass that comes and goes with its
// momentum.
#pragma once
#include <nutshell/newton.hpp>
#include <span>

namespace nutshell {

// [state]
/// A body reduced to a point, described by its momentum: what forces change, and what mass
/// carries along when it comes or goes.
struct Particle {
    double mass = 1;                     ///< [kg], greater than zero
    Vector3 position = Vector3::Zero();  ///< [m], world frame
    Vector3 momentum = Vector3::Zero();  ///< [kg m/s], world frame; the source's K, eq. (10)
};

/// Velocity [m/s], world frame: the momentum over the mass of this moment. Source: eq. (13).
inline Vector3 velocity(const Particle& body) {
    return body.momentum / body.mass;
}
// [/state]

/// Gives `body` back if it can be simulated. @throws std::invalid_argument if its mass is not
/// greater than zero or any of its numbers is not finite.
inline Particle checked(const Particle& body) {
    require_positive(body.mass, "the mass of a particle [kg]");
    require_finite(body.position, "the position of a particle [m]");
    require_finite(body.momentum, "the momentum of a particle [kg m/s]");
    return body;
}

/// Chapter 1's state in momentum. Source: eq. (10).
inline Particle in_momentum(const PointMass& body) {
    return {body.mass, body.position, body.mass * body.velocity};
}

// [verbs]
/// Drift: the particle moves with the momentum it has, for dt seconds. Source: eqs. (13)-(14).
inline void drift(Particle& body, double dt) {
    // exercise 2.1
    body.position += body.momentum / body.mass * dt;
    // end 2.1
}

/// Kick: a force [N], world frame, changes the momentum for dt seconds. No mass in it.
/// Source: eq. (15).
inline void kick(Particle& body, const Vector3& force, double dt) {
    // exercise 2.2
    body.momentum += force * dt;
    // end 2.2
}
// [/verbs]

// [superposition]
/// The one force [N] that does what all of `forces` do together. Source: eqs. (12) and (16).
inline Vector3 total_force(std::span<const Vector3> forces) {
    // exercise 2.3
    Vector3 sum = Vector3::Zero();
    for (const Vector3& force : forces) sum += force;
    return sum;
    // end 2.3
}
// [/superposition]

// [exchange]
/// Exchange: the body gains `dm` kilograms (loses them if dm < 0), and with them the momentum
/// they carry.
/// @param w  velocity of the exchanged mass relative to the body before the exchange [m/s]
/// Whatever w is, body and exchanged mass together keep their momentum: what one gains, the
/// other loses. Eq. (2.a).
/// @throws std::invalid_argument if no mass would be left
inline void exchange(Particle& body, double dm, const Vector3& w) {
    require_positive(body.mass + dm, "exchange: the mass left in the body [kg]");
    // exercise 2.4
    body.momentum += dm * (velocity(body) + w);
    body.mass += dm;
    // end 2.4
}

/// Ejects a parcel of `mass` kilograms at velocity w [m/s] relative to the body: an exchange
/// whose other half is kept.
/// @return the parcel, at the body's place
inline Particle eject(Particle& body, double mass, const Vector3& w) {
    const Particle parcel{mass, body.position, mass * (velocity(body) + w)};
    exchange(body, -mass, w);
    return parcel;
}
// [/exchange]

// [acceleration]
/// Acceleration [m/s^2] of a body that exchanges mass: m a = F + w dm/dt. Source: eq. (11*),
/// the limit of (2.a).
/// @param force  [N]    @param mass  [kg]
/// @param w  velocity of the exchanged mass relative to the body [m/s]
/// @param mass_rate  dm/dt [kg/s], negative if the body loses mass
/// @throws std::invalid_argument if the mass is not greater than zero
inline Vector3 acceleration(const Vector3& force, double mass, const Vector3& w,
                            double mass_rate) {
    require_positive(mass, "acceleration: the mass [kg]");
    // exercise 2.5
    return (force + mass_rate * w) / mass;
    // end 2.5
}
// [/acceleration]

// [midway]
/// A parcel of |dm| that leaves at w relative to the *mean* of the body's velocities before and
/// after: its velocity relative to the velocity before [m/s], as `exchange` wants it. A stream
/// thrown in such parcels has the speed right to second order; relative to the velocity before,
/// only to first. Eq. (2.d).
/// @throws std::invalid_argument if no mass would be left
inline Vector3 midway(double mass, double dm, const Vector3& w) {
    require_positive(mass + dm, "midway: the mass left in the body [kg]");
    // exercise 2.6
    return w * ((mass + dm) / (mass + dm / 2));
    // end 2.6
}
// [/midway]

// [flow]
/// What the velocity of exchanged mass is measured against.
enum class RelativeTo {
    body,    ///< the body before the exchange: an exhaust, a leak
    midway,  ///< the mean of the body before and after: the same, to second order
    world    ///< the world: a cloud of droplets at rest
};

/// A steady exchange of mass with the surroundings.
struct MassFlow {
    double rate = 0;                     ///< dm/dt of the body [kg/s], negative if it loses mass
    Vector3 velocity = Vector3::Zero();  ///< of the exchanged mass [m/s], world axes
    RelativeTo relative_to = RelativeTo::body;
};

/// Velocity of the exchanged mass relative to the body before dm kilograms are exchanged [m/s].
inline Vector3 relative_velocity(const MassFlow& flow, const Particle& body, double dm) {
    if (flow.relative_to == RelativeTo::world) return flow.velocity - velocity(body);
    if (flow.relative_to == RelativeTo::midway) return midway(body.mass, dm, flow.velocity);
    return flow.velocity;
}

/// A particle whose mass changes.
struct VariableMass : Particle {
    MassFlow flow;
};

/// Drift of a particle whose mass changes: half the way with the mass it has, the exchange,
/// half the way with the mass it then has. A kick takes a force as ever.
inline void drift(VariableMass& body, double dt) {
    Particle& particle = body;
    drift(particle, dt / 2);
    const double dm = body.flow.rate * dt;
    exchange(particle, dm, relative_velocity(body.flow, particle, dm));
    drift(particle, dt / 2);
}
// [/flow]

// [rocket]
/// What a rocket's speed gains [m/s] without other forces while its mass falls from m0 to m:
/// u ln(m0/m). Eq. (2.c). Source: K. Tsiolkovsky, 1903.
/// @param u  exhaust speed relative to the rocket [m/s]
/// @param m0, m  mass before and after [kg]
/// @throws std::invalid_argument if a mass is not greater than zero
inline double rocket_gain(double u, double m0, double m) {
    require_positive(m0, "rocket_gain: the mass before [kg]");
    require_positive(m, "rocket_gain: the mass after [kg]");
    // exercise 2.7
    return u * std::log(m0 / m);
    // end 2.7
}

/// The propellant [kg] that a rocket of m0 kilograms must throw out to gain `gain` m/s:
/// eq. (2.c) solved for it.
/// @throws std::invalid_argument if u or m0 is not greater than zero
inline double propellant_for(double gain, double u, double m0) {
    require_positive(u, "propellant_for: the exhaust speed [m/s]");
    require_positive(m0, "propellant_for: the mass before [kg]");
    // exercise 2.8
    return m0 * (1 - std::exp(-gain / u));
    // end 2.8
}
// [/rocket]

/// Kinetic energy [J].
inline double kinetic_energy(const Particle& body) {
    return body.momentum.squaredNorm() / (2 * body.mass);
}

}  // namespace nutshell
