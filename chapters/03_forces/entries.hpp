// Chapter 3's studies: step control, and the planet's own clock.
#pragma once
#include <nutshell/forces_methods.hpp>
#include <nutshell/forces_scenes.hpp>
#include <nutshell/lab/need_chart.hpp>

namespace nutshell {

/// The curve of Dormand-Prince 5(4) with step control: one run for each tolerance.
template <class Scene>
lab::Curve controlled(const Scene& scene, const std::vector<double>& tolerances,
                      bool timed = true) {
    lab::Curve curve{std::string(methods::dormand_prince.name) + ", controlled",
                     variant(methods::dormand_prince.look),
                     {}};
    for (const double tolerance : tolerances) {
        lab::Measurement m{};
        m.seconds_per_second = std::numeric_limits<double>::quiet_NaN();
        const Tolerance allowed{tolerance, tolerance};
        const double guess = scene.duration / 1000;
        const lab::Counted<Scene> counted(scene, m.evaluations);
        adaptive(flat(scene.start), right_hand_side(scene.start, counted), 0, scene.duration,
                 allowed, guess, [&](const auto& y, double t) {
                     ++m.steps;
                     m.final_error = scene.error(unflat(y, scene.start), t);
                     m.max_error = std::max(m.max_error, m.final_error);
                 });
        m.dt = scene.duration / static_cast<double>(m.steps);
        if (timed)
            m.seconds_per_second =
                lab::time_of([&] {
                    lab::keep(adaptive(flat(scene.start), right_hand_side(scene.start, scene), 0,
                                       scene.duration, allowed, guess,
                                       [](const auto&, double) {}));
                }) /
                scene.duration;
        curve.runs.push_back(m);
    }
    return curve;
}

/// The logarithmic leapfrog or a composition of it, which has method.evaluations kicks a step.
/// @param runs  numbers of steps in a study
template <class Method>
lab::Entry<Planet> clock_entry(const Method& method, const std::vector<long>& runs) {
    return {method.name, method.look,
            [method](const Planet& scene, long steps) {
                const double ds =
                    scene.duration / static_cast<double>(steps);  // 2 pi of s is nearly one orbit
                lab::Measurement m{steps, ds, steps * method.evaluations,
                                   0,     0,  std::numeric_limits<double>::quiet_NaN()};
                TimedPlanet planet{scene.start};
                auto step = method.start(scene);
                for (long n = 0; n < steps; ++n) {
                    planet = step(planet, scene, 0.0, ds);
                    m.max_error = std::max(m.max_error, scene.error(planet.body, planet.time));
                }
                // what it costs: every step, and the trials that find the length of the last one
                long steps_made = 0;
                const auto counted = [&](const TimedPlanet& from, auto, double t, double length) {
                    ++steps_made;
                    return step(from, scene, t, length);
                };
                m.final_error = scene.error(
                    run_until({scene.start}, counted, scene.duration, ds).body, scene.duration);
                m.evaluations = steps_made * method.evaluations;
                m.max_error = std::max(m.max_error, m.final_error);
                return m;
            },
            [method](const Planet& scene, long steps) {
                const double ds = scene.duration / static_cast<double>(steps);
                return lab::time_of([&] {
                    lab::keep(run_until({scene.start}, method.start(scene), scene.duration, ds));
                });
            },
            runs};
}

}  // namespace nutshell
