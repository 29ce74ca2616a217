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
    std::vector<long> steps = {};  ///< of its runs in a study; empty: those of the study
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

/// The same method on what `other(scene)` makes of the scene: another formula for the same motion.
template <class Scene, class Method, class Other>
Entry<Scene> entry_on(std::string name, const Look& look, const Method& method, const Other& other) {
    const auto of_other = entry<decltype(other(std::declval<const Scene&>()))>(method);
    return {std::move(name), look,
            [=](const Scene& scene, long steps) { return of_other.measure(other(scene), steps); },
            [=](const Scene& scene, long steps) { return of_other.seconds(other(scene), steps); }};
}

/// A list as it is, or made of a tuple of methods.
template <class Scene>
const std::vector<Entry<Scene>>& entries(const std::vector<Entry<Scene>>& methods) {
    return methods;
}
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

/// Measures every method at every number of steps, or its own; with `timed`, the processor time too.
template <class Scene>
std::vector<Curve> work_precision(const Scene& scene, const std::vector<Entry<Scene>>& methods,
                                  const std::vector<long>& steps, bool timed = true) {
    std::vector<Curve> curves;
    for (const auto& method : methods) {
        Curve curve{method.name, method.look, {}};
        for (const long n : method.steps.empty() ? steps : method.steps) {
            curve.runs.push_back(method.measure(scene, n));
            if (timed) curve.runs.back().seconds_per_second = method.seconds(scene, n) / scene.duration;
        }
        curves.push_back(std::move(curve));
    }
    return curves;
}

/// The observed order of a method on a scene: of its largest errors with these numbers of steps.
template <class Scene>
double order_of(const Scene& scene, const Entry<Scene>& method, const std::vector<long>& steps) {
    std::vector<double> dts, errors;
    for (const long n : steps) {
        const Measurement m = method.measure(scene, n);
        dts.push_back(m.dt), errors.push_back(m.max_error);
    }
    return observed_order(dts, errors);
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

/// What a study is asked beside scene and methods, and what its charts say in words.
struct Plan {
    std::string key;                                ///< of its numbers and files
    std::string scene;                              ///< in the subtitles: "Planet, three orbits."
    std::string behind;                             ///< title of the error against the cost
    std::vector<double> guides = {};                ///< slopes drawn there
    std::string lead = {};                          ///< title of the lead chart where the finding will not do
    std::string work = "evaluations of the force";  ///< what the first cost counts
    std::vector<long> steps = {};                   ///< of the runs there
    long fewest = 1, most = 10'000'000;             ///< steps between which the need is searched for
};

/// What a study found.
struct Study {
    std::vector<Least> least;   ///< what its need costs, cheapest first
    std::vector<Curve> curves;  ///< error against cost
};

/// Measures what a scene's need costs with each method, and error against cost.
/// @param methods  a tuple of methods, or a list of entries
template <class Scene, class Methods>
Study measured(const Scene& scene, const Methods& methods, const Plan& plan) {
    const auto& list = entries<Scene>(methods);
    return {least_of_each(scene, list, plan.fewest, plan.most), work_precision(scene, list, plan.steps)};
}

/// What this machine can do at best, measured in the same run: the yardstick of every time in a chart.
struct MachineFloor {
    double multiply_add;  ///< one dependent multiplication and addition [s]: nothing that needs the last
                          ///< result is faster
    double square_root;   ///< one dependent square root and division [s]
};
MachineFloor machine_floor();

}  // namespace nutshell::lab
