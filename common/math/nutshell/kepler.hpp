// Kepler's equation: where a planet is at a given time.
#pragma once
#include <nutshell/require.hpp>
#include <nutshell/vector.hpp>

namespace nutshell {

/// Solves Kepler's equation  M = E - e sin E  for the eccentric anomaly E, all angles in radians.
/// Newton's method from E = M + e sin M; the residual is at round-off of M after at most ten turns for e <=
/// 0.9.
/// @param mean_anomaly  M, any finite number      @param eccentricity  0 <= e < 1
/// @throws std::invalid_argument outside these ranges.  Source: J. Kepler, Epitome, 1621.
inline double eccentric_anomaly(double mean_anomaly, double eccentricity) {
    require(std::isfinite(mean_anomaly), "eccentric_anomaly: the mean anomaly is not finite");
    require(eccentricity >= 0 && eccentricity < 1,
            "eccentric_anomaly: the eccentricity must be in [0, 1): an ellipse");
    const double M = std::remainder(mean_anomaly, 2 * pi), e = eccentricity;
    double E = e < 0.8 ? M + e * std::sin(M)
                       : std::copysign(pi, M);  // near e = 1 start from the far side: it converges
    for (int turn = 0; turn < 50; ++turn) {
        const double step = (E - e * std::sin(E) - M) / (1 - e * std::cos(E));
        E -= step;
        if (std::abs(step) <= 1e-15 * (1 + std::abs(E))) break;
    }
    return E + (mean_anomaly - M);
}

/// Place and speed on an ellipse in the x-y plane, focus at the origin, perihelion on +x, counter-clockwise.
struct OrbitPoint {
    Vector3 position;  ///< [m]
    Vector3 velocity;  ///< [m/s]
};

/// The exact orbit of a small body round a heavy one. @param time  since perihelion [s]
/// @param gm  gravity constant times the heavy mass [m^3/s^2]   @param a  semi-major axis [m]   @param e
/// eccentricity Accuracy: round-off of the mean anomaly (about 1e-16 times the angle turned, divided by 1 -
/// e).
inline OrbitPoint kepler_orbit(double time, double gm, double a, double e) {
    require_positive(gm, "kepler_orbit: gm");
    require_positive(a, "kepler_orbit: the semi-major axis");
    const double n = std::sqrt(gm / (a * a * a));  // mean motion [rad/s]
    const double E = eccentric_anomaly(n * time, e), b = a * std::sqrt(1 - e * e);
    const double E_rate = n / (1 - e * std::cos(E));
    return {{a * (std::cos(E) - e), b * std::sin(E), 0},
            {-a * std::sin(E) * E_rate, b * std::cos(E) * E_rate, 0}};
}

}  // namespace nutshell
