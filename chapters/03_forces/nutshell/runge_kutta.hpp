// Chapter 3 · General-purpose methods: they know nothing of drift and kick, only y' =
// f(t, y). y is a flat Eigen vector, of fixed size where the size is known: then nothing is
// allocated. `inline` because g++ at -O2 otherwise hands the few numbers over through memory,
// at half the speed.
#pragma once
#include <algorithm>
#include <nutshell/require.hpp>
#include <nutshell/vector.hpp>
#include <optional>

namespace nutshell {

// [midpoint]
/// One step of the explicit midpoint rule: try half a step, use the rate found there. Second
/// order, two evaluations; never stable on an undamped spring (amplitude squared times 1 +
/// (omega dt)^4/4 a step).
template <class Flat, class Rate>
inline Flat explicit_midpoint(const Flat& y, const Rate& f, double t, double dt) {
    const Flat half_way = y + dt / 2 * f(y, t);
    return y + dt * f(half_way, t + dt / 2);
}
// [/midpoint]

// [rk4]
/// One step of the classical Runge-Kutta method: four rates, their weighted mean. Fourth order,
/// four evaluations; on an undamped spring stable to omega dt = 2 sqrt(2), losing energy.
/// Source: W. Kutta, Z. Math. Phys. 46 (1901) 435.
/// @param f  called as f(y, t), gives y'
template <class Flat, class Rate>
inline Flat rk4(const Flat& y, const Rate& f, double t, double dt) {
    // exercise 3.4
    const Flat k1 = f(y, t);
    const Flat k2 = f(Flat(y + dt / 2 * k1), t + dt / 2);
    const Flat k3 = f(Flat(y + dt / 2 * k2), t + dt / 2);
    const Flat k4 = f(Flat(y + dt * k3), t + dt);
    return y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    // end 3.4
}
// [/rk4]

// [dormand_prince]
/// What one step of Dormand and Prince's method finds.
template <class Flat>
struct Trial {
    Flat y;      ///< fifth order
    Flat error;  ///< its distance from the fourth-order result hidden in the same rates
    Flat rate;   ///< y' at the end: the first rate of the next step (first same as last)
};

/// One step of Dormand-Prince 5(4) from y, where the rate is k1: six new evaluations, two
/// results. Source: J. R. Dormand and P. J. Prince, J. Comput. Appl. Math. 6 (1980) 19.
template <class Flat, class Rate>
inline Trial<Flat> dormand_prince_trial(const Flat& y, const Flat& k1, const Rate& f, double t,
                                        double h) {
    const Flat k2 = f(Flat(y + h * (1. / 5 * k1)), t + h / 5);
    const Flat k3 = f(Flat(y + h * (3. / 40 * k1 + 9. / 40 * k2)), t + 3 * h / 10);
    const Flat k4 =
        f(Flat(y + h * (44. / 45 * k1 - 56. / 15 * k2 + 32. / 9 * k3)), t + 4 * h / 5);
    const Flat k5 = f(Flat(y + h * (19372. / 6561 * k1 - 25360. / 2187 * k2 + 64448. / 6561 * k3 -
                                    212. / 729 * k4)),
                      t + 8 * h / 9);
    const Flat k6 = f(Flat(y + h * (9017. / 3168 * k1 - 355. / 33 * k2 + 46732. / 5247 * k3 +
                                    49. / 176 * k4 - 5103. / 18656 * k5)),
                      t + h);
    const Flat end = y + h * (35. / 384 * k1 + 500. / 1113 * k3 + 125. / 192 * k4 -
                              2187. / 6784 * k5 + 11. / 84 * k6);
    const Flat k7 = f(end, t + h);
    return {end,
            h * (71. / 57600 * k1 - 71. / 16695 * k3 + 71. / 1920 * k4 - 17253. / 339200 * k5 +
                 22. / 525 * k6 - 1. / 40 * k7),
            k7};
}

/// Dormand-Prince with a fixed step, for comparison; the controlled one is `adaptive`. It keeps
/// its last rate: six evaluations a step. One object per run.
template <class Flat>
struct DormandPrince {
    std::optional<Flat> kept = {};

    template <class Rate>
    Flat operator()(const Flat& y, const Rate& f, double t, double dt) {
        const Trial<Flat> trial = dormand_prince_trial(y, kept ? *kept : Flat(f(y, t)), f, t, dt);
        kept = trial.rate;
        return trial.y;
    }
};
// [/dormand_prince]

// [adaptive]
/// What the error of one step may be: absolute + relative * |y|, in every component.
struct Tolerance {
    double absolute = 1e-6;
    double relative = 1e-6;
};

/// Runs y' = f(t, y) from t0 to t1 with Dormand-Prince 5(4), choosing every step by its own
/// error, and calls observe(y, t) after each accepted one. The last step is cut to end at t1.
/// @param first_step  a guess [s], corrected by itself
/// @throws std::invalid_argument for a tolerance or step that is not greater than zero, or an
/// end before the start; std::runtime_error if the step shrinks to nothing, as it does where
/// the right-hand side is not finite
template <class Flat, class Rate, class Observer>
Flat adaptive(Flat y, const Rate& f, double t0, double t1, Tolerance tolerance, double first_step,
              Observer&& observe) {
    require_positive(tolerance.absolute, "adaptive: the absolute tolerance");
    require_positive(tolerance.relative, "adaptive: the relative tolerance");
    require_positive(first_step, "adaptive: the first step [s]");
    require_positive(t1 - t0, "adaptive: the time from start to end [s]");
    Flat rate = f(y, t0);
    for (double t = t0, h = first_step; t < t1;) {
        const bool last = t + 1.000001 * h >= t1;
        const double step = last ? t1 - t : h;
        const Trial<Flat> trial = dormand_prince_trial(y, rate, f, t, step);
        double square = 0;  // mean square of the error in units of what is allowed
        for (Eigen::Index i = 0; i < y.size(); ++i) {
            const double largest = std::max(std::abs(y[i]), std::abs(trial.y[i]));
            const double part =
                trial.error[i] / (tolerance.absolute + tolerance.relative * largest);
            square += part * part / static_cast<double>(y.size());
        }
        const bool accepted = square <= 1;  // false for NaN
        if (accepted) {
            t = last ? t1 : t + step;
            y = trial.y, rate = trial.rate;
            observe(y, t);
        }
        // The error grows as h^5: this step would have just passed. Aim at nine tenths of it,
        // change with care.
        const double wanted = square > 0 ? 0.9 * std::pow(square, -0.1) : 5;
        h = step * (std::isfinite(square) ? std::clamp(wanted, 0.2, accepted ? 5.0 : 1.0) : 0.1);
        if (!(t + h > t) && t < t1)
            throw std::runtime_error(
                "adaptive: the step shrank to nothing at t = " + std::to_string(t) +
                " s: the right-hand side is not smooth or not finite there");
    }
    return y;
}
// [/adaptive]

}  // namespace nutshell
