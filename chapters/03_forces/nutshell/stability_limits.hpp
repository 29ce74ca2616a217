// Chapter 3 · The largest stable steps, from theory. omega = sqrt(kappa/m) [rad/s], nu = gamma/m
// [1/s]; a limit in seconds. Below its limit a method's error stays bounded for ever, above it
// grows by a factor every step.
#pragma once
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <nutshell/require.hpp>

namespace nutshell {

// [euler_limit]
/// Euler on a damped spring: never stable without drag (returns 0). Eqs. (3A.a)-(3A.b).
inline double euler_limit(double omega, double nu) {
    // exercise 3.7
    if (nu * nu < 4 * omega * omega) return nu / (omega * omega);
    return 4 / (nu + std::sqrt(nu * nu - 4 * omega * omega));
    // end 3.7
}
// [/euler_limit]

// [semi_implicit_limit]
/// Semi-implicit Euler with the drag in its kick: 2/omega without drag, 2/nu without spring.
/// Eq. (3.h), (-nu + sqrt(nu^2 + 4 omega^2))/omega^2 written without its cancellation.
inline double semi_implicit_limit(double omega, double nu) {
    // exercise 3.8
    return 4 / (nu + std::sqrt(nu * nu + 4 * omega * omega));
    // end 3.8
}
// [/semi_implicit_limit]

/// Semi-implicit Euler with implicit drag (`semi_implicit_division`): drag makes it more
/// stable.
inline double division_limit(double omega, double nu) {
    if (omega == 0) return std::numeric_limits<double>::infinity();
    return (nu + std::sqrt(nu * nu + 4 * omega * omega)) / (omega * omega);
}

/// The first dt at which margin(dt), positive while stable, is no longer so: searched from
/// `smallest` [s] in steps that grow by half a per cent, then bisected. Infinite if it stays
/// positive to `times` that.
inline double first_limit(const std::function<double(double)>& margin, double smallest,
                          double times = 1e6) {
    require_positive(smallest, "first_limit: the smallest step [s]");
    double high = smallest;
    for (; margin(high) > 0; high *= 1.005)
        if (high > times * smallest) return std::numeric_limits<double>::infinity();
    double low = high / 1.005;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = (low + high) / 2;
        (margin(middle) > 0 ? low : high) = middle;
    }
    return low;
}

// [implicit_limits]
/// Semi-implicit Euler with exponential drag (`semi_implicit_exponential`): (omega dt)^2 < 2 (1
/// + e^(-nu dt)).
inline double exponential_limit(double omega, double nu) {
    if (omega == 0) return std::numeric_limits<double>::infinity();
    return first_limit(
        [=](double dt) { return 2 * (1 + std::exp(-nu * dt)) - omega * omega * dt * dt; },
        0.01 / omega);
}

/// Verlet with the drag inside its kicks, the force evaluated again at the end of the step:
/// nu dt < 4 and (omega dt)^2 < 4 (1 + a^2)/(1 + a) with a = 1 - nu dt/2.
inline double verlet_re_evaluated_limit(double omega, double nu) {
    return first_limit(
        [=](double dt) {
            const double a = 1 - nu * dt / 2;
            return std::min(4 - nu * dt, 4 * (1 + a * a) - omega * omega * dt * dt * (1 + a));
        },
        0.01 / (omega + nu));
}

/// `exponential_verlet`, the half-drags outermost.
inline double exponential_verlet_limit(double omega) {
    return omega == 0 ? std::numeric_limits<double>::infinity() : 2 / omega;
}

/// `ExponentialVerletInside`, the half-drags next to the drift: (omega dt)^2 < 2 (1 + E)/sqrt(E), E =
/// e^(-nu dt), which is 4 cosh(nu dt/2).
inline double exponential_verlet_inside_limit(double omega, double nu) {
    return first_limit(
        [=](double dt) { return 4 * std::cosh(nu * dt / 2) - omega * omega * dt * dt; },
        0.01 / (omega + nu));
}
// [/implicit_limits]

using Complex = std::complex<double>;

// [stability_function]
/// The stability function R(z) of a general-purpose method: what one step multiplies the solution
/// of y' = lambda y by, z = lambda dt. The truth is e^z; a step is stable where |R(z)| <= 1.
struct StabilityFunction {
    static Complex euler(Complex z) { return 1. + z; }
    static Complex explicit_midpoint(Complex z) { return 1. + z * (1. + z / 2.); }
    static Complex rk4(Complex z) {
        return 1. + z * (1. + z / 2. * (1. + z / 3. * (1. + z / 4.)));
    }
    static Complex dormand_prince(Complex z) {
        return rk4(z) + z * z * z * z * z * (1. / 120 + z / 600.);
    }
    static Complex implicit_euler(Complex z) { return 1. / (1. - z); }
    static Complex implicit_midpoint(Complex z) { return (1. + z / 2.) / (1. - z / 2.); }
};
// [/stability_function]

/// The pair of rates lambda of a damped spring: -nu/2 +- sqrt(nu^2/4 - omega^2), complex below
/// critical damping.
inline std::array<Complex, 2> spring_rates(double omega, double nu) {
    const Complex root = std::sqrt(Complex(nu * nu / 4 - omega * omega));
    return {-nu / 2 + root, -nu / 2 - root};
}

/// The limit of a general-purpose method on a damped spring: the first dt at which |R(lambda
/// dt)| passes 1 for either rate. Zero if already the smallest step is unstable; infinite if
/// none is.
inline double general_limit(Complex (*stability)(Complex), double omega, double nu) {
    const auto rates = spring_rates(omega, nu);
    const auto margin = [&](double dt) {
        return 1 + 1e-13 -
               std::max(std::abs(stability(rates[0] * dt)), std::abs(stability(rates[1] * dt)));
    };
    const double smallest = 0.01 / (omega + nu), limit = first_limit(margin, smallest);
    return limit < smallest ? 0 : limit;
}

}  // namespace nutshell
