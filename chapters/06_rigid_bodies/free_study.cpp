// Free bodies: what a need costs, error against cost, and how long a step may be.
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/need_chart.hpp>
#include <nutshell/rigid_methods.hpp>
#include <nutshell/top_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

/// Nothing pushes a free body, so nothing is asked for its forces: what is counted are steps.
template <class Method>
lab::Entry<FreeBody> by_steps(const Method& method) {
    lab::Entry<FreeBody> entry = lab::entry<FreeBody>(method);
    entry.measure = [method](const FreeBody& scene, long steps) {
        lab::Measurement m = lab::measure(scene, method, steps);
        m.evaluations = steps;
        return m;
    };
    return entry;
}

void near_the_middle_axis(lab::Report& report) {
    const FreeBody scene = near_middle_axis();
    report.heading("Free body near its middle axis, 100 s: scene S7");
    const std::vector entries{
        by_steps(methods::corrected_step),  by_steps(methods::engine_step),
        by_steps(methods::kick_split_kick), by_steps(methods::yoshida4),
        by_steps(methods::kahan_li8),       by_steps(methods::kick_magnus_kick),
        by_steps(methods::lie_rk4),         by_steps(methods::rk4)};
    const auto least = lab::least_of_each(scene, entries, 100, 48'000);
    lab::report_least(report, "s7", least, scene.need);
    const auto curves =
        lab::work_precision(scene, entries, {250, 500, 1000, 1500, 3000, 6000, 12'000, 24'000});
    const auto fastest = std::min_element(
        least.begin(), least.end(), [](const lab::Least& a, const lab::Least& b) {
            return a.run.seconds_per_second < b.run.seconds_per_second;
        });
    lab::draw_study(report,
                    {"s7",
                     "A free body almost about its middle axis, 100 s.",
                     "Order pays for 100 seconds of flips",
                     {-2, -4},
                     fastest->name == methods::kick_magnus_kick.name
                         ? "Magnus' step is the fastest for 100 seconds of flips"
                         : "",
                     "steps"},
                    curves, least, scene.need);
    // the closed form has no largest step: it is timed by itself
    const auto exact = by_steps(methods::kick_exact_kick);
    report.number("s7.kick_exact.error", exact.measure(scene, 6000).max_error, "rad");
    report.number("s7.kick_exact.ns", 1e9 * exact.seconds(scene, 6000) / 6000, "ns");
    for (const auto& curve : curves) {
        const lab::Measurement& at_60 = curve.runs[5];  // 6000 steps
        const std::string key = "s7." + key_of(curve.name);
        report.number(key + ".error", at_60.max_error, "rad");
        report.number(key + ".ns", 1e9 * at_60.seconds_per_second * at_60.dt, "ns");
        const lab::Measurement& finer = curve.runs[6];
        if (at_60.max_error < 1 && finer.max_error > 1e-8)
            report.number(key + ".order", std::log2(at_60.max_error / finer.max_error));
    }
}

/// The largest error [rad] of Magnus' step over ten turns at |omega| dt = theta, for 200 bodies
/// and spins of every kind: the worst, and the middle one.
std::array<double, 2> worst_and_middle(double theta) {
    double value = 0.1;
    const auto next = [&] { return value = 3.9 * value * (1 - value); };
    std::vector<double> errors;
    for (int i = 0; i < 200; ++i) {
        const Vector3 part = Vector3::Constant(0.1) + Vector3(next(), next(), next());
        const Vector3 inertia = Vector3::Constant(part.sum()) - part;
        const Vector3 axis = Vector3(next() - 0.5, next() - 0.5, next() - 0.5).normalized();
        const double steps = std::ceil(20 * pi / theta);  // of one second
        const FreeBody body("some", inertia, theta * axis, steps, {1, "rad", ""});
        errors.push_back(
            lab::measure(body, methods::kick_magnus_kick, std::lround(steps)).max_error);
    }
    std::sort(errors.begin(), errors.end());
    return {errors.back(), errors[100]};
}

void how_long_a_step(lab::Report& report) {
    report.heading("How far may a step turn? Ten turns of 200 bodies");
    const double pixel = 1. / 960;
    lab::Table table{{"turn in a step [rad]", "worst error [rad]", "middle one"}, {}};
    chart::Chart chart;
    chart.title = "How far one step may turn a body";
    chart.subtitle =
        "Magnus' step, ten turns of 200 bodies of every shape and wobble: the worst and the "
        "middle one.";
    chart.x = {"turn in one step, ω dt [rad]", chart::Scale::logarithmic};
    chart.y = {"largest error [rad]", chart::Scale::logarithmic};
    chart.tolerance = {pixel, "one pixel at 960"};
    chart.levels_x = {{longest_turn, "the rule: 0.3"}};
    chart.guides = {4};
    chart::Series worst{"worst"}, middle{"middle one"};
    worst.look = methods::kick_magnus_kick.look;
    middle.look = variant(methods::kick_magnus_kick.look);
    for (const double theta : {0.1, 0.2, longest_turn, 0.6, 1.2, 2.4}) {
        const auto [most, half] = worst_and_middle(theta);
        worst.x.push_back(theta), worst.y.push_back(most);
        middle.x.push_back(theta), middle.y.push_back(half);
        table.add({lab::rounded(theta), lab::rounded(most), lab::rounded(half)});
        report.number("rule.worst." + lab::rounded(theta), most, "rad");
        report.number("rule.middle." + lab::rounded(theta), half, "rad");
    }
    chart.series = {worst, middle};
    report.print(table);
    report.number("rule.pixels", worst.y[2] / pixel);
    chart::write_svg(chart, report.path("longest_turn.svg"));

    const FreeBody wobble = fast_wobble(), spin = fast_spin();
    const int parts = substeps(wobble.start, 1. / 60);
    const long frames = lab::steps_of(wobble.duration, 1. / 60);
    report.number("wobble.turn", angular_velocity(wobble.start).norm() / 60, "rad");
    report.number("wobble.parts", parts);
    report.number("wobble.whole",
                  lab::measure(wobble, methods::kick_magnus_kick, frames).max_error, "rad");
    report.number("wobble.cut",
                  lab::measure(wobble, methods::kick_magnus_kick, frames * parts).max_error,
                  "rad");
    report.number("wobble." + methods::rk4.key(),
                  lab::measure(wobble, methods::rk4, frames * parts).max_error, "rad");
    // A small wobble of a round plate goes round in the body at M3 (1/I1 - 1/I3), by RK4: it dies
    // out below 2 sqrt(2) a step and grows beyond.
    const FreeBody plate("plate", {1, 1, 2}, {1e-6, 0, 10}, 1, {1, "rad", ""});
    const auto dies_out = [&](double turn) {
        return lab::stays_within(
            plate, methods::kick_magnus_kick, turn / 10, 4000, 2e-6, [](const Pinned& body) {
                const Vector3 M = rotate(inverse(body.orientation), body.angular_momentum);
                return std::hypot(M.x(), M.y());
            });
    };
    report.number("limit.magnus.predicted", 2 * std::sqrt(2.0), "rad");
    report.number("limit.magnus.found", lab::stability_limit(dies_out, 2, 3), "rad");
    const long steps = lab::steps_of(spin.duration, 1. / 60);
    each(std::tuple{methods::kick_magnus_kick, methods::kick_split_kick, methods::lie_rk4,
                    methods::rk4},
         [&](const auto& method) {
             report.number("spin." + method.key(), lab::measure(spin, method, steps).max_error,
                           "rad");
         });
}

}  // namespace

void free_study(lab::Report& report) {
    near_the_middle_axis(report);
    how_long_a_step(report);
}

}  // namespace nutshell
