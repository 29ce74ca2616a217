// The lab's centre: run a scene with a method, and measure what came out.
//
// A scene has start, duration, operator()(state, t) for the push, and error(state, t); see a chapter's
// scenes. A method is a value that starts a run: `auto step = method.start(scene)`; see
// <nutshell/method.hpp>. A plain step(state, scene, t, dt) does as well where nobody asks for its name. Both
// come in as template parameters, so the compiler sees through them and a measured time is the time of the
// physics, not of the lab.
#pragma once
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
#include <nutshell/require.hpp>
#include <string>
#include <utility>
#include <vector>

namespace nutshell::lab {

/// The number of steps of dt [s] in `duration` [s]. @throws std::invalid_argument if dt does not divide it
/// (to one part in a million), or is not finite and greater than zero.
inline long steps_of(double duration, double dt) {
    require_positive(dt, "the step dt [s]");
    const double steps = duration / dt;
    require(steps > 0.5 && std::abs(steps - std::round(steps)) < 1e-6 * steps,
            "a duration of " + std::to_string(duration) + " s is not a whole number of steps of " +
                std::to_string(dt) + " s: choose a step that divides it");
    return std::lround(steps);
}

/// The stepper of one run: what a method's start gives, or a copy of a plain step, for a quick try.
template <class Method, class Scene>
auto stepper(const Method& method, const Scene& scene) {
    if constexpr (requires { method.start(scene); })
        return method.start(scene);
    else
        return method;
}

/// Runs `scene` with `steps` equal steps of `method` and calls observe(state, t) at the start and after every
/// step. @return the last state
/// @throws std::invalid_argument if steps < 1 or the scene's duration is not finite and greater than zero
template <class Scene, class Method, class Observer>
auto run(const Scene& scene, const Method& method, long steps, Observer&& observe) {
    require_positive(scene.duration, "the scene's duration [s]");
    require(steps >= 1, "a run needs at least one step, not " + std::to_string(steps));
    const double dt = scene.duration / static_cast<double>(steps);
    auto step = stepper(method, scene);
    auto state = scene.start;
    observe(std::as_const(state), 0.0);
    for (long n = 0; n < steps; ++n) {
        state = step(std::move(state), scene, static_cast<double>(n) * dt, dt);
        observe(std::as_const(state), static_cast<double>(n + 1) * dt);
    }
    return state;
}

/// The same without an observer: only the last state counts.
template <class Scene, class Method>
auto run(const Scene& scene, const Method& method, long steps) {
    return run(scene, method, steps, [](const auto&, double) {});
}

/// The states of a run: the start and that after every `every`-th step.
template <class Scene, class Method>
auto states_of(const Scene& scene, const Method& method, long steps, long every = 1) {
    std::vector<decltype(scene.start)> states;
    long n = 0;
    run(scene, method, steps, [&](const auto& state, double) {
        if (n++ % every == 0) states.push_back(state);
    });
    return states;
}

/// A scene that counts how often its push is asked for; otherwise the scene itself.
template <class Scene>
struct Counted : Scene {
    long* evaluations;
    Counted(const Scene& scene, long& count) : Scene(scene), evaluations(&count) {}
    template <class State>
    auto operator()(const State& state, double t) const {
        ++*evaluations;
        return Scene::operator()(state, t);
    }
    template <class State, class Push>
    requires requires(const Scene& scene, const State& state, Push& into) { scene(state, 0.0, into); }
    void operator()(const State& state, double t, Push& into) const {
        ++*evaluations;
        Scene::operator()(state, t, into);
    }
};

/// What one run cost and how wrong it was. Errors are in the unit of the scene's need.
struct Measurement {
    long steps = 0;
    double dt = 0;           ///< [s]
    long evaluations = 0;    ///< of the push, in the whole run: the same on every machine
    double max_error = 0;    ///< the largest at any step's end; infinite if the run left the finite numbers
    double final_error = 0;  ///< at the end
    double seconds_per_second;  ///< processor time per simulated second, NaN until timed
};

/// Errors and evaluations of one run.
template <class Scene, class Method>
Measurement measure(const Scene& scene, const Method& method, long steps) {
    Measurement m{steps, scene.duration / static_cast<double>(steps), 0, 0,
                  0,     std::numeric_limits<double>::quiet_NaN()};
    const Counted<Scene> counted(scene, m.evaluations);
    run(counted, method, steps, [&](const auto& state, double t) {
        const double error = scene.error(state, t);
        m.final_error = std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
        m.max_error = std::max(m.max_error, m.final_error);
    });
    return m;
}

/// Processor time used by this process so far [s].
inline double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Keeps the optimiser from dropping a result nobody reads.
template <class Value>
void keep(const Value& value) {
    asm volatile("" : : "g"(&value) : "memory");
}

/// Processor time of `work()` [s]: the least of `rounds` rounds, each repeated until it lasts
/// `least_seconds`.
template <class Work>
double time_of(const Work& work, int rounds = 3, double least_seconds = 1e-3) {
    double best = std::numeric_limits<double>::infinity();
    long repeats = 1;
    for (int round = 0; round < rounds;) {
        const double begin = processor_seconds();
        for (long i = 0; i < repeats; ++i) work();
        const double took = processor_seconds() - begin;
        if (took < least_seconds) {
            repeats =
                took <= 0
                    ? repeats * 10
                    : static_cast<long>(
                          static_cast<double>(repeats) * std::min(10.0, 1.2 * least_seconds / took) + 1);
            continue;
        }
        best = std::min(best, took / static_cast<double>(repeats));
        ++round;
    }
    return best;
}

/// How far a quantity strays from its value at the start: the largest distance at any step's end.
/// `quantity(state)` may be a number or a vector; for a vector the distance is that of the vector, not of its
/// length.
template <class Scene, class Method, class Quantity>
double largest_change(const Scene& scene, const Method& method, long steps, const Quantity& quantity) {
    const auto first = quantity(scene.start);
    double largest = 0;
    run(scene, method, steps, [&](const auto& state, double) {
        double change;
        if constexpr (requires { first.norm(); })
            change = (quantity(state) - first).norm();
        else
            change = std::abs(quantity(state) - first);
        largest = std::isfinite(change) ? std::max(largest, change) : std::numeric_limits<double>::infinity();
    });
    return largest;
}

/// Observed order of convergence: the slope of log(error) against log(dt), by least squares.
/// @throws std::invalid_argument if fewer than two points, or any is not greater than zero
inline double observed_order(const std::vector<double>& dts, const std::vector<double>& errors) {
    require(dts.size() == errors.size() && dts.size() >= 2,
            "observed_order: needs two or more pairs of dt and error");
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < dts.size(); ++i) {
        require_positive(dts[i], "observed_order: dt [s]");
        require_positive(errors[i], "observed_order: the error (zero error has no order)");
        const double x = std::log(dts[i]), y = std::log(errors[i]);
        sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    const auto n = static_cast<double>(dts.size());
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// The step at which stability ends, by bisection between a stable and an unstable step, to the relative
/// width given.
/// @param stable  asked with a step; must hold at `low` and not at `high`
/// @throws std::invalid_argument if it does not
template <class Stable>
double stability_limit(const Stable& stable, double low, double high, double relative = 1e-4) {
    require_positive(low, "stability_limit: the lower step");
    require(high > low, "stability_limit: the upper step must be greater than the lower one");
    require(stable(low), "stability_limit: already unstable at the lower step: begin lower");
    require(!stable(high), "stability_limit: still stable at the upper step: begin higher");
    while (high - low > relative * low) {
        const double middle = (low + high) / 2;
        (stable(middle) ? low : high) = middle;
    }
    return (low + high) / 2;
}

/// Does a run of `steps` steps of dt stay within `bound`, measured by size(state)? For stability limits: on a
/// linear scene a method that is stable stays within a constant times the start for ever, one that is not
/// grows exponentially.
template <class Scene, class Method, class Size>
bool stays_within(const Scene& scene, const Method& method, double dt, long steps, double bound,
                  const Size& size) {
    require_positive(dt, "the step dt [s]");
    auto step = stepper(method, scene);
    auto state = scene.start;
    for (long n = 0; n < steps; ++n) {
        state = step(std::move(state), scene, static_cast<double>(n) * dt, dt);
        if (!(size(state) <= bound)) return false;  // also catches NaN
    }
    return true;
}

}  // namespace nutshell::lab
