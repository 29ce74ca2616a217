// Pendulums: the period at any angle, what each method needs, and Verlet's limit.
#include <nutshell/lab/run.hpp>
#include <nutshell/pendulum_scenes.hpp>
#include "program.hpp"

namespace nutshell {

void pendulum(lab::Report& report) {
    report.heading("Pendulum on a rod of 1 m: its period");
    lab::Table table{{"let go at [degrees]", "period [s]", "of small swings"}, {}};
    const double small = pendulum_period(1, 0);
    report.number("period.small", small, "s");
    for (const double degrees : {5, 30, 90, 150, 179}) {
        const double period = pendulum_period(1, degrees * pi / 180);
        const std::string key = "period." + lab::rounded(degrees);
        table.add({lab::rounded(degrees), lab::rounded(period, "%.6f"),
                   lab::rounded(period / small, "%.4f")});
        report.number(key, period, "s");
        report.number(key + ".ratio", period / small);
    }
    report.print(table);
}

}  // namespace nutshell
