// Chapter 3 · The planet's own method: steps that shorten by themselves near the sun.
#pragma once
#include <nutshell/newton.hpp>

namespace nutshell {

// [log_hamiltonian]
/// A planet that carries its own time: how long a step lasts depends on where it is.
struct TimedPlanet {
    PointMass body;
    double time = 0;  ///< [s]
};

/// The leapfrog of the logarithmic Hamiltonian. Its step is not a time but a piece ds of a
/// clock of its own: a drift lasts ds/(v^2/2 + B), a kick r ds/GM, so both are short near the
/// sun and long far from it. B = GM/r - v^2/2 is the binding energy per mass of the start.
/// Every step ends on the exact ellipse, to round-off; only the time at which it gets there is
/// wrong, by O(ds^2). A step advances the eccentric anomaly by 2 atan(ds/2) if GM = a = 1, not
/// by ds: count orbits by the place reached. For Kepler's force only; symmetric, so `Composed`
/// raises its order.
/// Source: S. Mikkola and K. Tanikawa, Celest. Mech. Dyn. Astron. 74 (1999) 287; M. Preto and
/// S. Tremaine, Astron. J. 118 (1999) 2532.
struct LogHamiltonian {
    double gm;       ///< gravity constant times the mass of the sun [m^3/s^2]
    double binding;  ///< B [m^2/s^2], greater than zero

    LogHamiltonian(double gm_of_sun, const PointMass& start)
        : gm(gm_of_sun),
          binding(gm_of_sun / start.position.norm() - start.velocity.squaredNorm() / 2) {
        require_positive(gm, "LogHamiltonian: GM");
        require_positive(
            binding,
            "LogHamiltonian: the binding energy GM/r - v^2/2 (the orbit must be an ellipse)");
    }
    void half_drift(TimedPlanet& planet, double ds) const {
        const double dt = ds / 2 / (planet.body.velocity.squaredNorm() / 2 + binding);
        drift(planet.body, dt);
        planet.time += dt;
    }
    template <class Forces>
    TimedPlanet operator()(TimedPlanet planet, const Forces&, double, double ds) const {
        half_drift(planet, ds);
        planet.body.velocity -= ds / planet.body.position.squaredNorm() * planet.body.position;
        half_drift(planet, ds);
        return planet;
    }
};
// [/log_hamiltonian]

// [run_until]
/// Makes steps of `ds` until the planet's time reaches `end` [s], the last one shortened to end
/// there: its length is found by a few trial steps (secants). @param method  LogHamiltonian, or
/// a composition of it
template <class Method>
TimedPlanet run_until(TimedPlanet planet, Method method, double end, double ds) {
    require_positive(ds, "run_until: the step ds");
    const auto step = [&](double length) { return method(planet, 0, 0.0, length); };
    for (TimedPlanet next = step(ds); next.time < end; next = step(ds)) planet = next;
    double low = 0, low_time = planet.time, high = ds, high_time = step(ds).time;
    for (int trial = 0; trial < 20 && high_time != low_time; ++trial) {
        const double length = high + (end - high_time) * (high - low) / (high_time - low_time);
        low = high, low_time = high_time;
        high = length, high_time = step(length).time;
        if (std::abs(high_time - end) <= 4e-16 * end) break;
    }
    return step(high);
}
// [/run_until]

}  // namespace nutshell
