// Falling with drag: what a first-order method, Verlet with drag in its kicks and an exact step make
// of it, and where they break.
#include <nutshell/stability_limits.hpp>
#include <nutshell/stale_drag.hpp>
#include "entries.hpp"
#include "program.hpp"

namespace nutshell {

namespace {

const auto with_an_order = std::tuple{methods::euler,
                                      methods::semi_implicit_euler,
                                      methods::verlet,
                                      methods::explicit_midpoint,
                                      methods::rk4,
                                      methods::dormand_prince,
                                      methods::exponential_verlet_inside,
                                      methods::exponential_yoshida4};

/// The speed of a body that drag alone slows down, with gamma dt/m = 0.5, 1.5 and 2.5, and with the
/// drag of the step before.
void slowing_down(lab::Report& report) {
    constexpr int steps = 10;
    struct Slowing {
        PointMass start{1, {0, 0, 0}, {1, 0, 0}};
        double drag, duration = steps;  // one second a step
        Vector3 operator()(const PointMass& body, double) const {
            return linear_drag_force(drag, body.velocity);
        }
    };
    chart::Figure figure;
    figure.title = "The longer the step, the more Euler's drag turns the body round";
    figure.subtitle = "The velocity of a body that only drag slows, over its start. Pale: exact.";
    lab::Table data{{"method", "x", "step", "velocity"}, {}};
    const auto follow = [&](chart::Chart& chart, const auto& method, double x) {
        chart::Series series = chart::series_of(method, chart::Draw::line_and_marks);
        const Slowing scene{{1, {0, 0, 0}, {1, 0, 0}}, x};
        lab::run(scene, method, steps, [&](const PointMass& body, double n) {
            series.add(n, body.velocity.x());
            data.add({method.name, x, n, body.velocity.x()});
        });
        chart.series.push_back(std::move(series));
    };
    const auto panel = [&](const std::string& title, double x) {
        chart::Chart chart;
        chart.title = title, chart.height = 300, chart.cut = true;
        chart.x = {"steps", chart::Scale::linear, 0, steps};
        chart.y = {"", chart::Scale::linear, -2, 2};
        chart::Series exact{"exact"};
        exact.look = Look{Family::exact};
        for (int i = 0; i <= 10 * steps; ++i) exact.add(0.1 * i, std::exp(-x * 0.1 * i));
        chart.series.push_back(std::move(exact));
        return chart;
    };
    chart::Chart small = panel("ν dt = 0.5: slows down, a little too fast", 0.5);
    chart::Chart middle = panel("ν dt = 1.5: turned round in every step", 1.5);
    chart::Chart large = panel("ν dt = 2.5: drag makes it faster and faster", 2.5);
    chart::Chart stale = panel("ν dt = 1.1, drag of the step before: grows too", 1.1);
    follow(small, methods::euler, 0.5);
    follow(middle, methods::euler, 1.5);
    follow(large, methods::euler, 2.5);
    follow(large, methods::exponential_kick, 2.5);
    follow(stale, mistakes::stale_euler, 1.1);
    figure.panels = {small, middle, large, stale};
    report.data("slowing.csv", data);
    chart::write_svg(figure, report.path("slowing.svg"));
}

}  // namespace

void falling(lab::Report& report) {
    const FallingWithDrag scene;
    report.heading("Falling with linear drag: gamma = " + lab::rounded(scene.drag) + " kg/s, " +
                   lab::rounded(scene.duration) + " s");
    report.number("falling.terminal_speed", scene.terminal_velocity().norm(), "m/s");
    // where linear drag is true: a steel ball of 2 mm in honey (Stokes: gamma = 6 pi eta radius)
    const double radius = 1e-3, honey = 1400, steel = 7850,
                 viscosity = 10;  // [m], [kg/m^3], [Pa s]
    const double sinks = 2.0 / 9 * (steel - honey) * earth_gravity * radius * radius / viscosity;
    report.number("falling.honey.speed", sinks, "m/s");
    report.number("falling.honey.reynolds", honey * sinks * 2 * radius / viscosity);
    report.number("falling.kick_300.error",
                  lab::measure(scene, methods::exponential_kick, 300).max_error, "m");
    // Scaling the velocity alone, as `v *= 0.98` does: what is lost is the drift under it.
    const double scaled = lab::measure(scene, methods::semi_implicit_exponential, 300).max_error;
    report.number("falling.scaled_300.error", scaled, "m");
    auto entries = lab::entries<FallingWithDrag>(with_an_order);
    lab::report_orders(report, "falling", scene, entries, {80, 160, 320});
    entries.push_back(lab::entry<FallingWithDrag>(methods::exponential_kick));  // exact: no order
    const auto study = [&](const std::string& key, const auto& methods) {
        lab::study(
            report, scene, methods,
            {.key = key,
             .scene = "A body falls with linear drag for " + lab::rounded(scene.duration) + " s.",
             .behind = "Slopes are orders; the exponential kick has no error to shrink",
             .guides = {-1, -2, -4},
             .lead = "The exponential kick is exact: one step for the whole fall",
             .steps = {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000},
             .most = 100'000});
    };
    study("falling", std::tuple{methods::euler, methods::semi_implicit_euler, methods::verlet,
                                methods::rk4, methods::exponential_kick});  // the main road's
    study("falling_all", entries);
    slowing_down(report);

    const FallingInAir air;
    report.number("air.terminal_speed", air.terminal_speed(), "m/s");
}

}  // namespace nutshell
