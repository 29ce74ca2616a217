// Coning: a spin whose axis goes round, where turns do not commute from one step to the next.
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/spinning_methods.hpp>
#include <nutshell/spinning_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

/// The fewest steps whose largest error is within the need, 0 if `most` steps are not enough.
template <class Step>
long fewest_steps(const Coning& scene, const Step& step, long most) {
    const auto meets = [&](long n) {
        return lab::measure(scene, step, n).max_error <= scene.need.tolerance;
    };
    long high = 2;
    while (!meets(high)) {
        if (high >= most) return 0;
        high = std::min(2 * high, most);
    }
    long low = high / 2;
    while (high - low > 1) {
        const long middle = (low + high) / 2;
        (meets(middle) ? high : low) = middle;
    }
    return high;
}

template <class Step>
double nanoseconds(const Coning& scene, const Step& step, long steps) {
    return 1e9 * lab::time_of([&] { lab::keep(lab::run(scene, step, steps)); });
}

}  // namespace

void coning(lab::Report& report) {
    const Coning scene;
    report.heading("Coning: one round of " + lab::rounded(scene.duration) + " s");
    lab::Table table{{"method", "order", "steps for a pixel", "asks for omega", "us"}, {}};
    lab::Table data{{"method", "steps", "evaluations", "largest_error", "ns_a_step"}, {}};
    chart::Ranking ranking;
    ranking.title = "What a pixel costs";
    ranking.subtitle = "Coning, one round within " + scene.need.reason + ".";
    ranking.columns = {"times ω is asked for", "processor time [µs]"};
    chart::Figure figure;
    figure.title = "Error against cost on a cone";
    figure.subtitle = "Coning, one round. Down and left is better.";
    chart::Chart by_evaluations, by_time;
    by_evaluations.title = "by times ω is asked for", by_time.title = "by processor time";
    each(spinning_methods, [&](const auto& method) {
        chart::Series evaluations{method.name}, time{method.name};
        evaluations.look = time.look = method.look;
        std::vector<double> dts, errors;
        for (long steps = 8; steps <= 16384; steps *= 4) {
            const auto m = lab::measure(scene, method, steps);
            if (m.max_error < 1e-13) break;
            const double ns = nanoseconds(scene, method, steps);
            evaluations.x.push_back(static_cast<double>(m.evaluations));
            time.x.push_back(ns / 1000);
            evaluations.y.push_back(m.max_error), time.y.push_back(m.max_error);
            data.add({method.name, std::to_string(steps), std::to_string(m.evaluations),
                      lab::exact_digits(m.max_error),
                      lab::exact_digits(ns / static_cast<double>(steps))});
            if (steps >= 128 && m.max_error > 1e-11)
                dts.push_back(m.dt), errors.push_back(m.max_error);
        }
        by_evaluations.series.push_back(evaluations), by_time.series.push_back(time);
        const double order = lab::observed_order(dts, errors);
        const long steps = fewest_steps(scene, method, 1'000'000);
        const double us = nanoseconds(scene, method, steps) / 1000;
        const auto m = lab::measure(scene, method, steps);
        table.add({method.name, lab::rounded(order, "%.2f"), std::to_string(steps),
                   std::to_string(m.evaluations), lab::rounded(us)});
        ranking.rows.push_back({method.name,
                                method.look,
                                {static_cast<double>(m.evaluations), us},
                                "",
                                std::to_string(steps) + " steps"});
        const std::string key = "coning." + method.key();
        report.number(key + ".order", order);
        report.number(key + ".steps", static_cast<double>(steps));
        report.number(key + ".evaluations", static_cast<double>(m.evaluations));
        report.number(key + ".us", us, "us");
    });
    report.print(table);
    report.number("coning.need", scene.need.tolerance, "rad");
    // Magnus with the sign of the body's axes
    const auto wrong = [](const Quaternion& q, const auto& spin, double t, double dt) {
        const double apart = std::sqrt(3.0) / 6 * dt;
        const Vector3 one = spin(q, t + dt / 2 - apart), two = spin(q, t + dt / 2 + apart);
        return product(
            exponential(dt / 2 * (one + two) + std::sqrt(3.0) / 12 * dt * dt * one.cross(two)),
            q);
    };
    report.number("coning.wrong_sign.order",
                  lab::observed_order({scene.duration / 200, scene.duration / 400},
                                      {lab::measure(scene, wrong, 200).max_error,
                                       lab::measure(scene, wrong, 400).max_error}));
    report.number("coning.wrong_sign.ratio",
                  lab::measure(scene, wrong, 64).max_error /
                      lab::measure(scene, methods::magnus4, 64).max_error);
    for (chart::Chart* one : {&by_evaluations, &by_time}) {
        one->y = {"largest error [rad]", chart::Scale::logarithmic};
        one->tolerance = {scene.need.tolerance, "one pixel, arm of 300"};
        one->guides = {-1, -2, -4};
    }
    by_evaluations.x = {"times ω is asked for", chart::Scale::logarithmic};
    by_time.x = {"processor time [µs]", chart::Scale::logarithmic};
    figure.panels = {by_evaluations, by_time};
    chart::write_svg(ranking, report.path("coning_cost.svg"));
    chart::write_svg(figure, report.path("coning_precision.svg"));
    report.data("coning.csv", data);
}

}  // namespace nutshell
