// A rocket and everything it has thrown out: the books of momentum, kept parcel by parcel.
#pragma once
#include <nutshell/revised_newton.hpp>
#include <vector>

namespace nutshell {

// [books]
/// The rocket and the parcels it has thrown out so far, oldest first.
struct RocketAndExhaust {
    VariableMass rocket;
    std::vector<Particle> exhaust = {};
};

/// What gravity does to them at one moment. A parcel thrown out later is then still on board:
/// its weight is part of the rocket's.
struct Weights {
    Vector3 on_rocket;    ///< [N]
    Vector3 field;        ///< [m/s^2]
    std::size_t parcels;  ///< how many were out
};

/// Drift: everything moves; halfway the rocket throws out what it burns in dt, and the parcel
/// goes its own way.
inline void drift(RocketAndExhaust& all, double dt) {
    for (Particle& parcel : all.exhaust) drift(parcel, dt);
    Particle& rocket = all.rocket;
    const MassFlow& flow = all.rocket.flow;
    drift(rocket, dt / 2);
    const double dm = flow.rate * dt;
    Particle parcel = eject(rocket, -dm, relative_velocity(flow, rocket, dm));
    drift(rocket, dt / 2);
    drift(parcel, dt / 2);
    all.exhaust.push_back(parcel);
}

/// Kick: the parcels fall too.
inline void kick(RocketAndExhaust& all, const Weights& weights, double dt) {
    kick(all.rocket, weights.on_rocket, dt);
    for (std::size_t i = 0; i < weights.parcels; ++i)
        kick(all.exhaust[i], all.exhaust[i].mass * weights.field, dt);
}
// [/books]

/// Momentum of the exhaust alone [kg m/s].
inline Vector3 exhaust_momentum(const RocketAndExhaust& all) {
    Vector3 sum = Vector3::Zero();
    for (const Particle& parcel : all.exhaust) sum += parcel.momentum;
    return sum;
}

/// Momentum of rocket and exhaust [kg m/s].
inline Vector3 total_momentum(const RocketAndExhaust& all) {
    return all.rocket.momentum + exhaust_momentum(all);
}

/// Mass of rocket and exhaust [kg].
inline double total_mass(const RocketAndExhaust& all) {
    double sum = all.rocket.mass;
    for (const Particle& parcel : all.exhaust) sum += parcel.mass;
    return sum;
}

/// Centre of mass of rocket and exhaust [m].
inline Vector3 centre_of_mass(const RocketAndExhaust& all) {
    Vector3 sum = all.rocket.mass * all.rocket.position;
    for (const Particle& parcel : all.exhaust) sum += parcel.mass * parcel.position;
    return sum / total_mass(all);
}

}  // namespace nutshell
