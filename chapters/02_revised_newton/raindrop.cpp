// The raindrop: mass that arrives at rest, where the printed equations hold as they stand.
#include <nutshell/lab/need_chart.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/revised_newton_scenes.hpp>
#include <nutshell/sentence.hpp>
#include "program.hpp"

namespace nutshell {

void raindrop(lab::Report& report) {
    const Raindrop drop;
    const long steps = 40;
    const double T = drop.duration, dt = T / steps;
    report.heading("Raindrop: " + lab::rounded(1e6 * drop.m0) + " mg grows to " +
                   lab::rounded(1e6 * drop.exact(T).mass) + " mg in " + lab::rounded(T) +
                   " s, steps of " + lab::rounded(dt) + " s");
    const Particle exact = drop.exact(T);
    const double weight_sum = drop.m0 * T + drop.beta * T * (T - dt) / 2,
                 trapezium = drop.m0 * T + drop.beta * T * T / 2;
    lab::Table table{{"method",
                      {"K down [g m/s]", "%.6f"},
                      {"the law says [g m/s]", "%.6f"},
                      "off the law by [g m/s]",
                      "position, off by [m]"},
                     {}};
    const auto compare = [&](const auto& method, double law) {
        const VariableMass end = lab::run(drop, method, steps);
        const double K = -1e3 * end.momentum.y(), says = -1e3 * gravity.y() * law;
        table.add({method.name, K, says, std::abs(K - says), distance(end, exact)});
        report.number("drop." + method.key() + ".K", K, "g m/s", "printed");
        report.number("drop." + method.key() + ".off_the_law", std::abs(K - says), "g m/s",
                      "printed");
        report.number("drop." + method.key() + ".off_at_40", distance(end, exact), "m",
                      "printed");
    };
    compare(methods::euler, weight_sum);
    compare(methods::semi_implicit_euler, weight_sum);
    compare(methods::verlet, trapezium);
    report.print(table);

    const ThrownBall fall;
    const Vector3 v = velocity(exact);
    report.number("drop.speed_down", -v.y(), "m/s");
    report.number("drop.speed_sideways", v.x(), "m/s");
    report.number("drop.free_fall_speed", -gravity.y() * T, "m/s");
    const double late = 1000;
    report.number("drop.late_acceleration",
                  -(velocity(drop.exact(late + 1)) - velocity(drop.exact(late))).y(), "m/s^2");
    report.say("After " + lab::rounded(T) + " s it falls at " + lab::rounded(-v.y(), "%.2f") +
               " m/s; a stone at " + lab::rounded(-gravity.y() * T, "%.2f") +
               " m/s. Its sideways speed is down from " + lab::rounded(velocity(drop.start).x()) +
               " to " + lab::rounded(v.x(), "%.2f") + " m/s.");

    lab::study(report, drop, newton_methods,
               {.key = "drop",
                .scene = "Raindrop, " + lab::rounded(T) + " s through a cloud at rest.",
                .behind = sentence("{} works, at first order; {}'s error falls twice as steeply",
                                   methods::euler, methods::verlet),
                .guides = {-1, -2},
                .steps = {5, 10, 20, 50, 100, 300, 1000, 3000, 10000, 30000}});
}

}  // namespace nutshell
