// Falling with drag: what a first-order method, Verlet with drag in its kicks and an exact step make
// of it, and where they break.
#include <nutshell/sentence.hpp>
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
             .behind = phrase("Slopes are orders; the {} has no error to shrink",
                              methods::exponential_kick),
             .guides = {-1, -2, -4},
             .lead = phrase("The {} is exact: one step for the whole fall",
                            methods::exponential_kick),
             .steps = {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000},
             .most = 100'000});
    };
    study("falling", std::tuple{methods::euler, methods::semi_implicit_euler, methods::verlet,
                                methods::rk4, methods::exponential_kick});  // the main road's
    study("falling_all", entries);

    const FallingInAir air;
    report.number("air.terminal_speed", air.terminal_speed(), "m/s");
}

}  // namespace nutshell
