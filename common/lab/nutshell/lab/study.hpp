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

/// The fewest steps with which a method meets the scene's need (maximum error within tolerance), or none up
/// to `most`. Doubles from `fewest` until it is met, then bisects; found exactly where the error falls
/// steadily with the step.
template <class Scene>
std::optional<Measurement> fewest_steps(const Scene& scene, const Entry<Scene>& method, double tolerance,
                                        long fewest = 1, long most = 10'000'000) {
    long low = 0, high = fewest;
    Measurement found = method.measure(scene, high);
    while (!(found.max_error <= tolerance)) {
        if (high >= most) return std::nullopt;
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
    return found;
}

/// What it takes to meet a need: the method and the largest step that do, at the least cost in evaluations.
struct Choice {
    std::string method;
    Measurement run;
};

/// The fewest steps of every method that meets the scene's need, cheapest first.
template <class Scene>
std::vector<Choice> ways_to_meet(const Scene& scene, const std::vector<Entry<Scene>>& methods,
                                 long fewest = 1, long most = 10'000'000) {
    std::vector<Choice> choices;
    for (const auto& method : methods)
        if (auto found = fewest_steps(scene, method, scene.need.tolerance, fewest, most)) {
            found->seconds_per_second = method.seconds(scene, found->steps) / scene.duration;
            choices.push_back({method.name, *found});
        }
    std::stable_sort(choices.begin(), choices.end(),
                     [](const Choice& a, const Choice& b) { return a.run.evaluations < b.run.evaluations; });
    return choices;
}

/// What this machine can do at best, measured in the same run: the yardstick of every time in a chart.
struct MachineFloor {
    double multiply_add;  ///< one dependent multiplication and addition [s]: nothing that needs the last
                          ///< result is faster
    double square_root;   ///< one dependent square root and division [s]
};
MachineFloor machine_floor();

}  // namespace nutshell::lab
