// Heavy tops: steady precession, the nodding top of scene S8, and the top that sleeps.
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/need_chart.hpp>
#include <nutshell/rigid_methods.hpp>
#include <nutshell/sentence.hpp>
#include <nutshell/top_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

constexpr double degrees = 180 / pi;

void steady(lab::Report& report) {
    const Top top = standard_top();
    const double L3 = top.along * 30;
    const auto [slow, fast] = steady_precession(top, L3, pi / 6);
    report.heading("A heavy top: 1 kg, its centre 0.5 m from the pivot, 30 rad/s");
    report.number("steady.slow", slow, "rad/s");
    report.number("steady.fast", fast, "rad/s");
    report.number("steady.simple", top.weight / L3, "rad/s");
    report.say("It can go round steadily at " + lab::rounded(slow, "%.4f") + " or at " +
               lab::rounded(fast, "%.4f") + " rad/s.");
    for (const std::size_t which : {0u, 1u}) {
        const HeavyTopScene scene = steady_top(which);
        const std::string key = which == 0 ? "steady.slow" : "steady.fast";
        const Pinned last = lab::run(scene, methods::yoshida4, 600);
        const Vector3 c = scene.centre(last);
        report.number(key + ".rises", std::abs(c.y() - scene.centre(scene.start).y()), "m");
        report.number(key + ".error", lab::measure(scene, methods::yoshida4, 600).max_error, "m");
    }
    // The gyroscopic term left out: how fast the top then goes round
    const HeavyTopScene scene = steady_top(0);
    double turned = 0, before = 0, least = pi, most = 0;
    lab::run(scene, methods::engine_step_without_gyroscopic, 6000, [&](const Pinned& b, double) {
        const Vector3 c = scene.centre(b);
        const double now = std::atan2(-c.z(), c.x());
        turned += std::remainder(now - before, 2 * pi), before = now;
        const double lean = std::atan2(std::hypot(c.x(), c.z()), c.y());
        least = std::min(least, lean), most = std::max(most, lean);
    });
    report.number("steady.no_gyroscopic", turned / scene.duration, "rad/s");
    report.number("steady.no_gyroscopic.nods", (most - least) * degrees, "degrees");
}

void nodding(lab::Report& report) {
    const HeavyTopScene scene = nodding_top();
    report.heading("The same top let go at 30 degrees, 10 s: scene S8");
    const auto [low, high] = scene.solution.swing();
    report.number("nodding.down", low * degrees, "degrees");
    report.number("nodding.up", high * degrees, "degrees");
    const std::vector entries = lab::entries<HeavyTopScene>(std::tuple{
        methods::corrected_step, methods::engine_step, methods::semi_implicit_euler,
        methods::verlet, methods::yoshida4, methods::kahan_li8, methods::kick_split_kick,
        methods::kick_magnus_kick, methods::lie_rk4, methods::rk4});
    const auto least = lab::least_of_each(scene, entries, 50, 40'000);
    lab::report_least(report, "s8", least, scene.need);
    const auto curves = lab::work_precision(
        scene, entries, {36, 75, 150, 300, 600, 1200, 2400, 4800, 9600, 19'200});
    lab::draw_study(report,
                    {"s8",
                     "A heavy top that nods, 10 s.",
                     "A heavy top pays for order, and for an exact drift",
                     {-1, -2, -4},
                     "What a millimetre costs on a heavy top",
                     "evaluations of the torque"},
                    curves, least, scene.need);
    for (const auto& curve : curves) {
        const std::string key = "s8." + key_of(curve.name);
        report.number(key + ".error", curve.runs[4].max_error, "m");  // 600 steps
        report.number(key + ".ns", 1e9 * curve.runs[4].seconds_per_second * curve.runs[4].dt,
                      "ns");
        if (curve.runs[6].max_error < 0.1 && curve.runs[7].max_error > 1e-9)
            report.number(key + ".order",
                          std::log2(curve.runs[6].max_error / curve.runs[7].max_error));
    }
}

/// Energy, L about the vertical and L about the top's own axis, as changes relative to the start.
void what_a_top_keeps(lab::Report& report) {
    const HeavyTopScene scene = nodding_top();
    chart::Figure figure;
    figure.title = "What a nodding top keeps";
    figure.subtitle =
        "Scene S8, steps of 1/60 s; changes relative to the start. A method that keeps something "
        "to the last bit has no line there.";
    figure.columns = 3;
    const std::array<const char*, 3> titles{"energy", "L about the vertical",
                                            "L about its own axis"};
    const std::array<std::function<double(const Pinned&)>, 3> quantities{
        [&](const Pinned& b) { return scene.energy(b); },
        [&](const Pinned& b) { return scene.about_vertical(b); },
        [&](const Pinned& b) { return scene.about_axis(b); }};
    for (std::size_t i = 0; i < 3; ++i) {
        chart::Chart panel;
        panel.title = titles[i];
        panel.x = {"time [s]", chart::Scale::linear, 0, scene.duration};
        panel.y = {"relative change", chart::Scale::logarithmic, 1e-16, 10};
        panel.cut = true;
        const double first = quantities[i](scene.start);
        each(std::tuple{methods::corrected_step, methods::verlet, methods::yoshida4,
                        methods::lie_rk4, methods::rk4},
             [&](const auto& method) {
                 chart::Series series{method.name, {}, {}, chart::Draw::line};
                 series.look = method.look;
                 double largest = 0;
                 long n = 0;
                 lab::run(scene, method, 600, [&](const Pinned& b, double t) {
                     const double change = std::abs(quantities[i](b) / first - 1);
                     largest = std::max(largest, change);
                     if (n++ % 3 == 0) series.x.push_back(t), series.y.push_back(change);
                 });
                 if (largest > 0) panel.series.push_back(series);  // else kept to the bit
                 report.number("top_keeps." + method.key() + "." +
                                   std::string(i == 0   ? "energy"
                                               : i == 1 ? "vertical"
                                                        : "own"),
                               largest);
             });
        figure.panels.push_back(panel);
    }
    chart::write_svg(figure, report.path("top_keeps.svg"));
}

/// The largest lean [rad] within 40 s of a top that starts a thousandth of a radian from upright,
/// with the spin L3.
double largest_lean(double L3) {
    const SleepingTop scene(L3, 1e-3);
    double most = 0;
    auto step = methods::verlet.start(scene);
    Pinned body = scene.start;
    constexpr double dt = 1. / 120;
    for (int n = 0; n < 4800; ++n) {
        body = step(body, scene, n * dt, dt);
        const Vector3 axis = rotate(body.orientation, {0, 0, 1});
        most = std::max(most, std::atan2(std::hypot(axis.x(), axis.z()), axis.y()));
    }
    return most;
}

void sleeping(lab::Report& report) {
    report.heading("The sleeping top");
    const double limit = sleeping_limit(standard_top());
    const auto sleeps = [&](double slowness) {  // 1/L3
        const SleepingTop scene(1 / slowness, 1e-6);
        return lab::stays_within(scene, methods::verlet, 1. / 120, 4800, 1e-3,
                                 [](const Pinned& b) {
                                     const Vector3 axis = rotate(b.orientation, {0, 0, 1});
                                     return axis.y() > 0 ? std::hypot(axis.x(), axis.z()) : 1.0;
                                 });
    };
    const double found = 1 / lab::stability_limit(sleeps, 0.5 / limit, 2 / limit);
    report.number("sleeping.lean", 1e-3 * degrees, "degrees");
    report.number("sleeping.law", limit, "kg m^2/s");
    report.number("sleeping.found", found, "kg m^2/s");
    report.number("sleeping.off", std::abs(found / limit - 1));
    report.number("sleeping.spin", limit / standard_top().along, "rad/s");
    report.say("It wakes below L3 = " + lab::rounded(found, "%.4f") + "; the law says " +
               lab::rounded(limit, "%.4f") + " kg m^2/s.");
    chart::Chart chart;
    chart.title = "A top sleeps until its spin falls below the law's";
    chart.subtitle =
        phrase("Started 0.06° from upright; how far it leans within 40 s. {}, 1/120 s.",
               methods::verlet);
    chart.x = {"L along its axis over the law's limit"};
    chart.y = {"largest lean [°]", chart::Scale::logarithmic};
    chart.levels_x = {{1, "L₃² = 4 I₁ m g l"}};
    chart::Series lean{"largest lean"};
    lean.look = methods::verlet.look;
    for (const double part : {0.8, 0.84,  0.88, 0.92,  0.95, 0.97, 0.98, 0.985, 0.99, 0.995,
                              1.0, 1.005, 1.01, 1.015, 1.02, 1.03, 1.05, 1.1,   1.15, 1.2}) {
        lean.x.push_back(part), lean.y.push_back(degrees * largest_lean(part * limit));
        if (part == 0.95) report.number("sleeping.lean_below", lean.y.back(), "degrees");
        if (part == 1.05) report.number("sleeping.lean_above", lean.y.back(), "degrees");
    }
    chart.series = {lean};
    chart::write_svg(chart, report.path("sleeping.svg"));
}

}  // namespace

void heavy_tops(lab::Report& report) {
    steady(report);
    nodding(report);
    what_a_top_keeps(report);
    sleeping(report);
}

}  // namespace nutshell
