// A study: one scene, several methods, many steps. What work-precision charts and tables are made of.
#pragma once
#include <algorithm>
#include <nutshell/lab/run.hpp>
#include <nutshell/look.hpp>
#include <nutshell/method.hpp>
#include <nutshell/need.hpp>
#include <optional>

namespace nutshell::lab {

/// A method with its name and look, ready to be measured on `Scene`. Made by `entry`.
template <class Scene>
struct Entry {
    std::string name;
    Look look;
    std::function<Measurement(const Scene&, long steps)> measure;  ///< error and evaluations
    std::function<double(const Scene&, long steps)> seconds;       ///< processor time of one whole run [s]
};

/// Puts a method on the list for a scene.
template <class Scene, class Method>
Entry<Scene> entry(const Method& method) {
    return {method.name, method.look,
            [method](const Scene& scene, long steps) { return lab::measure(scene, method, steps); },
            [method](const Scene& scene, long steps) {
                return time_of([&] { keep(run(scene, method, steps)); });
            }};
}

/// The same for a tuple of methods.
template <class Scene, class... Starts>
std::vector<Entry<Scene>> entries(const std::tuple<Method<Starts>...>& methods) {
    return std::apply([](const auto&... method) { return std::vector{entry<Scene>(method)...}; }, methods);
}

/// One method's line on a work-precision chart, from the coarsest run to the finest.
struct Curve {
    std::string name;
    Look look;
    std::vector<Measurement> runs;
};

/// Measures every method at every number of steps; with `timed`, the processor time too.
template <class Scene>
std::vector<Curve> work_precision(const Scene& scene, const std::vector<Entry<Scene>>& methods,
                                  const std::vector<long>& steps, bool timed = true) {
    std::vector<Curve> curves;
    for (const auto& method : methods) {
        Curve curve{method.name, method.look, {}};
        for (const long n : steps) {
            curve.runs.push_back(method.measure(scene, n));
            if (timed) curve.runs.back().seconds_per_second = method.seconds(scene, n) / scene.duration;
        }
        curves.push_back(std::move(curve));
    }
    return curves;
}

/// How a method fared with a need: the run with the fewest steps that meets it, or the one with the most
/// tried.
struct Attempt {
    Measurement run;
    bool met;
};

/// Looks for the fewest steps with which a method keeps the largest error within `tolerance`. Doubles from
/// `fewest` until it is met or `most` are not enough, then bisects; found exactly where the error falls
/// steadily with the step.
template <class Scene>
Attempt try_to_meet(const Scene& scene, const Entry<Scene>& method, double tolerance, long fewest = 1,
                    long most = 10'000'000) {
    long low = 0, high = fewest;
    Measurement found = method.measure(scene, high);
    while (!(found.max_error <= tolerance)) {
        if (high >= most) return {found, false};
        low = high, high = std::min(2 * high, most);
        found = method.measure(scene, high);
    }
    while (high - low > 1) {
        const long middle = low + (high - low) / 2;
        const Measurement m = method.measure(scene, middle);
        if (m.max_error <= tolerance)
            high = middle, found = m;
        else
            low = middle;
    }
    return {found, true};
}

/// The same, or none if it is not met.
template <class Scene>
std::optional<Measurement> fewest_steps(const Scene& scene, const Entry<Scene>& method, double tolerance,
                                        long fewest = 1, long most = 10'000'000) {
    const Attempt attempt = try_to_meet(scene, method, tolerance, fewest, most);
    return attempt.met ? std::optional(attempt.run) : std::nullopt;
}

/// The least work with which a method meets a scene's need; or, if it does not, the most work tried.
struct Least {
    std::string name;
    Look look;
    Measurement run;
    bool met = true;
};

/// For every method, the fewest steps that meet the scene's need, timed; in the order of evaluations, and
/// those that do not meet it last.
template <class Scene>
std::vector<Least> least_of_each(const Scene& scene, const std::vector<Entry<Scene>>& methods,
                                 long fewest = 1, long most = 10'000'000) {
    std::vector<Least> all;
    for (const auto& method : methods) {
        const Attempt attempt = try_to_meet(scene, method, scene.need.tolerance, fewest, most);
        all.push_back({method.name, method.look, attempt.run, attempt.met});
        if (attempt.met)
            all.back().run.seconds_per_second = method.seconds(scene, attempt.run.steps) / scene.duration;
    }
    std::stable_sort(all.begin(), all.end(), [](const Least& a, const Least& b) {
        if (a.met != b.met) return a.met;
        return a.met ? a.run.evaluations < b.run.evaluations : a.run.max_error < b.run.max_error;
    });
    return all;
}

/// What this machine can do at best, measured in the same run: the yardstick of every time in a chart.
struct MachineFloor {
    double multiply_add;  ///< one dependent multiplication and addition [s]: nothing that needs the last
                          ///< result is faster
    double square_root;   ///< one dependent square root and division [s]
};
MachineFloor machine_floor();

}  // namespace nutshell::lab
