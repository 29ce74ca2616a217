// Coning: a spin whose axis goes round, where turns do not commute from one step to the next.
#include <nutshell/lab/need_chart.hpp>
#include <nutshell/spinning_methods.hpp>
#include <nutshell/spinning_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

/// The order seen in those runs of a curve whose error is neither coarse nor round-off.
double order_of(const lab::Curve& curve) {
    std::vector<double> dts, errors;
    for (const lab::Measurement& run : curve.runs)
        if (run.steps >= 128 && run.max_error > 1e-11)
            dts.push_back(run.dt), errors.push_back(run.max_error);
    return lab::observed_order(dts, errors);
}

/// Magnus with the sign that its cross product has for the body's axes.
Quaternion magnus_with_the_wrong_sign(const Quaternion& q, const Coning& spin, double t,
                                      double dt) {
    const double apart = std::sqrt(3.0) / 6 * dt;
    const Vector3 one = spin(q, t + dt / 2 - apart), two = spin(q, t + dt / 2 + apart);
    return product(
        exponential(dt / 2 * (one + two) + std::sqrt(3.0) / 12 * dt * dt * one.cross(two)), q);
}

}  // namespace

void coning(lab::Report& report) {
    const Coning scene;
    report.heading("Coning: one round of " + lab::rounded(scene.duration) + " s");
    const auto entries = lab::entries<Coning>(spinning_methods);
    const auto curves =
        lab::work_precision(scene, entries, {8, 16, 32, 64, 128, 512, 2048, 8192, 32'768});
    lab::Table orders{{"method", "order"}, {}};
    for (const lab::Curve& curve : curves) {
        const double order = order_of(curve);
        orders.add({curve.name, lab::rounded(order, "%.2f")});
        report.number("coning." + key_of(curve.name) + ".order", order);
    }
    report.print(orders);
    const auto least = lab::least_of_each(scene, entries, 2, 1'000'000);
    lab::report_least(report, "coning", least, scene.need);
    lab::draw_study(report,
                    {.key = "coning",
                     .scene = "Coning, one round.",
                     .behind = "Two lines of first order, one of second, two of fourth",
                     .guides = {-1, -2, -4},
                     .work = "times ω is asked for"},
                    curves, least, scene.need);

    // in the picture's 24 steps: along the way, and after the whole round, where both are as far off
    const auto start = lab::measure(scene, methods::exponential_map, 24),
               middle = lab::measure(scene, methods::exponential_midpoint, 24);
    report.number("coning.24." + methods::exponential_map.key(), start.max_error * 180 / pi,
                  "degrees");
    report.number("coning.24.midpoint", middle.max_error * 180 / pi, "degrees");
    report.number("coning.24.end", start.final_error * 180 / pi, "degrees");
    const auto wrong = [&](long steps) {
        return lab::measure(scene, magnus_with_the_wrong_sign, steps).max_error;
    };
    report.number("coning.wrong_sign.order",
                  lab::observed_order({scene.duration / 200, scene.duration / 400},
                                      {wrong(200), wrong(400)}));
    report.number("coning.wrong_sign.ratio",
                  wrong(64) / lab::measure(scene, methods::magnus4, 64).max_error);
}

}  // namespace nutshell
