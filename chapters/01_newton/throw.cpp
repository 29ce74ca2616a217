// The straight line and the thrown ball: what the three methods do when the force never changes.
#include <nutshell/lab/need_chart.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/newton_scenes.hpp>
#include <nutshell/sentence.hpp>
#include "program.hpp"

namespace nutshell {

void straight_line(lab::Report& report) {
    const StraightLine scene;
    constexpr long steps = 100;
    report.heading("Straight line: no force, " + lab::rounded(scene.duration) + " s in " +
                   std::to_string(steps) + " steps");
    lab::Table table{{"method", "largest error [m]"}, {}};
    double largest = 0;
    each(newton_methods, [&](const auto& method) {
        const double error = lab::measure(scene, method, steps).max_error;
        largest = std::max(largest, error);
        table.add({method.name, error});
    });
    report.print(table);
    report.number("line.largest_error", largest, "m");

    // eq. (1) on a curved path: the forward difference belongs to the middle of its interval
    const ThrownBall ball;
    const double t = 1, dt = 0.5;
    const Vector3 difference =
        velocity_between(ball.exact(t).position, ball.exact(t + dt).position, dt);
    report.number("line.difference_minus_start", (difference - ball.exact(t).velocity).norm(),
                  "m/s");
    report.number("line.difference_minus_middle",
                  (difference - ball.exact(t + dt / 2).velocity).norm(), "m/s");
    report.say("Velocity of a thrown ball from two positions " + lab::rounded(dt) +
               " s apart: off by " + lab::rounded((difference - ball.exact(t).velocity).norm()) +
               " m/s from that of the start, by " +
               lab::rounded((difference - ball.exact(t + dt / 2).velocity).norm()) +
               " m/s from that of the middle.");
}

void thrown_ball(lab::Report& report) {
    const ThrownBall scene;
    const double rate = 60, dt = 1 / rate;  // [Hz], [s]
    const long steps = lab::steps_of(scene.duration, dt);
    report.heading("Thrown ball: " + lab::rounded(scene.duration) + " s in steps of 1/" +
                   lab::rounded(rate) + " s");
    lab::Table table{{"method",
                      {"computed - exact, up [m]", "%.6f"},
                      {"the law says [m]", "%.6f"},
                      "off the law by [m]"},
                     {}};
    const auto compare = [&](const auto& method, Kicked law) {
        const double error =
            (lab::run(scene, method, steps).position - scene.exact(scene.duration).position).y();
        const double predicted = throw_error(law, gravity, scene.duration, dt).y();
        table.add({method.name, error, predicted, std::abs(error - predicted)});
        report.number("throw." + method.key() + ".error", error, "m");
        report.number("throw." + method.key() + ".off_the_law", std::abs(error - predicted), "m",
                      "printed");
    };
    compare(methods::euler, Kicked::after_drift);
    compare(methods::semi_implicit_euler, Kicked::before_drift);
    compare(methods::verlet, Kicked::half_and_half);
    report.print(table);

    lab::study(
        report, scene, newton_methods,
        {.key = "throw",
         .scene = "Thrown ball, " + lab::rounded(scene.duration) + " s, constant force.",
         .behind = phrase("Both {}s fall by ten for ten times the work", methods::euler),
         .guides = {-1},
         .lead = sentence("{} is exact at any step: two evaluations will do", methods::verlet),
         .steps = {3, 6, 12, 30, 90, 180, 432, 1000, 3000, 10000}});
}

}  // namespace nutshell
