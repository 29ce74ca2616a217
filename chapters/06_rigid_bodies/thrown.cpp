// A thrown spanner: its centre is chapter 1's ball, its turning a free body's.
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/need_chart.hpp>
#include <nutshell/rigid_methods.hpp>
#include <nutshell/top_scenes.hpp>
#include "program.hpp"

namespace nutshell {

void thrown(lab::Report& report) {
    const ThrownSpanner scene;
    report.heading("A thrown spanner, 1 s");
    const std::vector entries = lab::entries<ThrownSpanner>(
        std::tuple{methods::printed_step, methods::corrected_step, methods::engine_step,
                   methods::engine_step_without_gyroscopic, methods::verlet, methods::yoshida4,
                   methods::kick_magnus_kick, methods::lie_rk4, methods::rk4});
    const auto least = lab::least_of_each(scene, entries, 2, 60'000);
    lab::report_least(report, "thrown", least, scene.need);
    const auto curves = lab::work_precision(scene, entries, {15, 30, 60, 120, 240, 480});
    lab::draw_study(report,
                    {"thrown",
                     "A spanner thrown across 3 m, 1 s.",
                     "Error against cost for a thrown spanner",
                     {-1, -2, -4}},
                    curves, least, scene.need);
    for (const auto& curve : curves)
        report.number("thrown." + key_of(curve.name) + ".error", curve.runs[2].max_error, "m");
    // the centre alone: a particle is enough
    double off = 0;
    lab::run(scene, methods::verlet, 60, [&](const Body& body, double t) {
        off = std::max(off, (body.position - scene.exact(t).position).norm());
    });
    report.number("thrown.centre", off, "m");
    Particle centre{scene.start.mass, scene.start.position, scene.start.momentum};
    for (int n = 0; n < 60; ++n)
        centre = verlet(
            centre, [](const Particle& p, double) { return Vector3(p.mass * gravity); }, n / 60.,
            1. / 60);
    report.number("thrown.particle", (centre.position - scene.exact(1).position).norm(), "m");
    report.say("At 1/60 s its centre is " + lab::rounded(off) +
               " m from the parabola, and so is a particle.");
    double tip = 0;
    for (int i = 0; i <= 100; ++i)
        tip = std::max(
            tip,
            (point_of(scene.exact(i / 100.), scene.tip) - scene.exact(i / 100.).position).norm());
    report.number("thrown.arm", tip, "m");
}

}  // namespace nutshell
