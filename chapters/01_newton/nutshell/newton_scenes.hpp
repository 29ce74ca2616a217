// The scenes of chapter 1. A scene is data and a few functions:
//   name, start, duration      what moves, from where, how long [s]
//   operator()(state, t)       the force [N], world frame: the scene itself is what a method
//   calls exact(t)                   the exact state, with a word on its own accuracy
//   error(state, t)            how far a computed state is from it, in the unit of `need`
//   need                       the largest error the scene bears, and why
#pragma once
#include <nutshell/kepler.hpp>
#include <nutshell/need.hpp>
#include <nutshell/newton.hpp>

namespace nutshell {

inline const Vector3 gravity{0, -earth_gravity, 0};  ///< [m/s^2], Y is up

/// Distance [m] between the positions of two states.
inline double distance(const PointMass& a, const PointMass& b) {
    return (a.position - b.position).norm();
}

/// No force at all: every method must be exact.
struct StraightLine {
    std::string name = "straight_line";
    PointMass start{1, {0, 1, 0}, {2, 0.5, -1}};
    double duration = 4;  // [s]
    Need need{1e-13, "m", "round-off: there is nothing to get wrong"};

    Vector3 operator()(const PointMass&, double) const { return Vector3::Zero(); }
    PointMass exact(double t) const {
        return {start.mass, start.position + start.velocity * t, start.velocity};
    }
    double error(const PointMass& state, double t) const { return distance(state, exact(t)); }
};

/// A ball thrown without drag (scene S1 of the comparison with other engines).
/// exact: the parabola; accurate to round-off.
struct ThrownBall {
    std::string name = "thrown_ball";
    PointMass start{1, {0, 0, 0}, {10, 15, 0}};
    double duration = 3;  // [s]
    Need need{40.0 / 960, "m", "one pixel of its snapshot, 40 m across 960 pixels"};

    Vector3 operator()(const PointMass& ball, double) const { return ball.mass * gravity; }
    PointMass exact(double t) const {
        return {start.mass, start.position + start.velocity * t + gravity * t * t / 2,
                start.velocity + gravity * t};
    }
    double error(const PointMass& state, double t) const { return distance(state, exact(t)); }
};

/// A planet on an eccentric orbit (scene S5). Units in which GM = 1 and the semi-major axis a =
/// 1; a year is 2 pi. exact: Kepler's equation; accurate to the round-off of the angle turned,
/// 1e-16 * 2 pi * orbits / (1 - e).
struct Planet {
    std::string name = "planet";
    double gm = 1;              // gravity constant times the mass of the sun
    double eccentricity = 0.6;  // of the exact orbit
    PointMass start{1, {0.4, 0, 0}, {0, 2, 0}};
    double orbits = 1;
    double duration = 2 * pi * orbits;
    Need need{3.5 / 960, "a", "one pixel of its snapshot, 3.5 a across 960 pixels"};

    static Planet for_orbits(double orbits) {
        Planet planet;
        planet.orbits = orbits;
        planet.duration = 2 * pi * orbits;
        return planet;
    }
    Vector3 operator()(const PointMass& planet, double) const {
        const double r2 = planet.position.squaredNorm();
        return -gm * planet.mass / (r2 * std::sqrt(r2)) * planet.position;
    }
    PointMass exact(double t) const {
        const OrbitPoint point = kepler_orbit(t, gm, 1, eccentricity);
        return {start.mass, point.position, point.velocity};
    }
    double error(const PointMass& state, double t) const { return distance(state, exact(t)); }
    /// Kinetic and potential energy; negative for a bound orbit.
    double energy(const PointMass& planet) const {
        return kinetic_energy(planet) - gm * planet.mass / planet.position.norm();
    }
};

}  // namespace nutshell
