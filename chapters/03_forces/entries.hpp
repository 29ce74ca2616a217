// Chapter 3's methods, ready to be measured: those that take flows, step control, and the
// planet's own clock.
#pragma once
#include <nutshell/forces_methods.hpp>
#include <nutshell/forces_scenes.hpp>
#include <nutshell/lab/work_chart.hpp>
#include <nutshell/log_hamiltonian.hpp>

namespace nutshell {

/// A method for flows on the list of a scene of point masses.
template <class Scene, class Method>
lab::Entry<Scene> flow_entry(std::string name, Method method) {
    return {std::move(name),
            [method](const Scene& scene, long steps) {
                return lab::measure(Flow<Scene>(scene), method, steps);
            },
            [method](const Scene& scene, long steps) {
                const Flow<Scene> flow(scene);
                return lab::time_of([&] { lab::keep(lab::run(flow, method, steps)); });
            }};
}

/// The curve of Dormand-Prince 5(4) with step control: one run for each tolerance.
template <class Scene>
lab::Curve controlled(const Scene& scene, const std::vector<double>& tolerances,
                      bool timed = true) {
    lab::Curve curve{"Dormand-Prince 5(4), controlled", {}};
    for (const double tolerance : tolerances) {
        lab::Measurement m{};
        m.seconds_per_second = std::numeric_limits<double>::quiet_NaN();
        const Tolerance allowed{tolerance, tolerance};
        const double guess = scene.duration / 1000;
        const lab::Counted<Flow<Scene>> counted(Flow<Scene>(scene), m.evaluations);
        adaptive(counted.start, counted, 0, scene.duration, allowed, guess,
                 [&](const auto& y, double t) {
                     ++m.steps;
                     m.final_error = counted.error(y, t);
                     m.max_error = std::max(m.max_error, m.final_error);
                 });
        m.dt = scene.duration / static_cast<double>(m.steps);
        const Flow<Scene> flow(scene);
        if (timed)
            m.seconds_per_second =
                lab::time_of([&] {
                    lab::keep(adaptive(flow.start, flow, 0, scene.duration, allowed, guess,
                                       [](const auto&, double) {}));
                }) /
                scene.duration;
        curve.runs.push_back(m);
    }
    return curve;
}

/// The logarithmic leapfrog or a composition of it, which has `kicks` kicks a step.
template <class Method>
lab::Entry<Planet> clock_entry(std::string name, Method method, long kicks) {
    return {std::move(name),
            [method, kicks](const Planet& scene, long steps) {
                const double ds =
                    scene.duration / static_cast<double>(steps);  // 2 pi of s is one orbit
                lab::Measurement m{steps, ds, steps * kicks,
                                   0,     0,  std::numeric_limits<double>::quiet_NaN()};
                TimedPlanet planet{scene.start};
                for (long n = 0; n < steps; ++n) {
                    planet = Method(method)(planet, scene, 0.0, ds);
                    m.max_error = std::max(m.max_error, scene.error(planet.body, planet.time));
                }
                m.final_error = scene.error(
                    run_until({scene.start}, method, scene.duration, ds).body, scene.duration);
                m.max_error = std::max(m.max_error, m.final_error);
                return m;
            },
            [method](const Planet& scene, long steps) {
                const double ds = scene.duration / static_cast<double>(steps);
                return lab::time_of(
                    [&] { lab::keep(run_until({scene.start}, method, scene.duration, ds)); });
            }};
}

/// A name as a part of a number's name: "Dormand-Prince 5(4)" becomes "dormand_prince_5_4".
inline std::string key_of(const std::string& name) {
    std::string key;
    for (const char c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)))
            key += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!key.empty() && key.back() != '_')
            key += '_';
    }
    while (!key.empty() && key.back() == '_') key.pop_back();
    return key;
}

/// Prints and keeps the least of every method that meets the scene's need.
template <class Scene>
void least_work(lab::Report& report, const std::string& scene_key, const Scene& scene,
                const std::vector<lab::Entry<Scene>>& methods, long fewest, long most) {
    const auto ways = lab::ways_to_meet(scene, methods, fewest, most);
    report.say("Needs " + lab::rounded(scene.need.tolerance) + " " + scene.need.unit + ": " +
               scene.need.reason + ". The least that gives it:");
    report.print(lab::ways_table(ways, scene.need));
    report.number(scene_key + ".need", scene.need.tolerance, scene.need.unit);
    for (const auto& way : ways) {
        const std::string key = scene_key + "." + key_of(way.method);
        report.number(key + ".steps", static_cast<double>(way.run.steps));
        report.number(key + ".step", way.run.dt, "s");
        report.number(key + ".evaluations", static_cast<double>(way.run.evaluations));
        report.number(key + ".error", way.run.max_error, scene.need.unit);
    }
}

/// Draws a study on both cost axes and keeps its data. Runs that are off by more than `lost` are
/// in the data only.
inline void draw_study(lab::Report& report, const std::string& file,
                       std::vector<lab::Curve> curves, const Need& need, double lost,
                       const std::string& title, const std::string& subtitle,
                       const std::vector<double>& guides) {
    report.data(file + ".csv", lab::work_precision_data(curves));
    for (auto& curve : curves)
        std::erase_if(curve.runs, [&](const auto& run) { return !(run.max_error <= lost); });
    for (const auto cost : {lab::Cost::evaluations, lab::Cost::time}) {
        chart::Chart chart = lab::work_precision_chart(curves, need, cost);
        chart.title = title;
        chart.subtitle = subtitle;
        chart.guides = guides;
        chart.height = 520;
        chart::write_svg(
            chart, report.path(file + (cost == lab::Cost::evaluations ? ".svg" : "_time.svg")));
    }
}

}  // namespace nutshell
