// A row of dominoes: the speed of its wave, and how coarse a step shows it.
#include <algorithm>
#include <nutshell/chart/chart.hpp>
#include <nutshell/domino_scenes.hpp>
#include <nutshell/lab/run.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

struct Fall {
    double speed = 0;         // of the wave [m/s]
    double off_law = 0;       // of the first piece's rate before it touches [rad/s]
    double us = 0;            // of a body and step
    double body_seconds = 0;  // processor time of a second of the whole row
};

Fall fall_of(const DominoRow& row, double dt) {
    World world = row.start();
    Engine engine(row.switches);
    DominoWave wave(row);
    Fall fall;
    bool alone = true;
    double took = 0;
    const long steps = lab::steps_of(row.duration, dt);
    for (long i = 0; i < steps; ++i) {
        const double begin = lab::processor_seconds();
        engine.step(world, dt);
        took += lab::processor_seconds() - begin;
        wave.look(world, static_cast<double>(i + 1) * dt);
        const double lean = DominoRow::lean_of(world.bodies[0]);
        alone = alone && lean < 0.9 * row.touches_at();
        if (alone && lean > 1.2 * row.lean)
            fall.off_law = std::max(
                fall.off_law,
                std::abs(angular_velocity(world.bodies[0]).norm() / row.exact_rate(lean) - 1));
    }
    fall.speed = wave.speed();
    fall.us = 1e6 * took / static_cast<double>(steps) / row.pieces;
    fall.body_seconds = took / row.duration;
    return fall;
}

}  // namespace

void dominoes(lab::Report& report) {
    report.heading("Twenty dominoes, 0.5 m high, 25 cm apart");
    const DominoRow row;
    DominoRow finest = row;
    finest.switches.sub_steps = 16;
    const double truth = fall_of(finest, 1 / 960.0).speed;
    report.number("dominoes.truth", truth, "m/s");
    report.number("dominoes.truth_over_fall", truth / std::sqrt(earth_gravity * row.height()));
    lab::Table table{{"steps a second", "sub-steps", "wave [m/s]", "off",
                      "first piece off its law", "ms a second"},
                     {}};
    for (const int hertz : {30, 60, 240})
        for (const int sub_steps : {1, 4}) {
            DominoRow one = row;
            one.switches.sub_steps = sub_steps;
            const Fall fall = fall_of(one, 1.0 / hertz);
            table.add({std::to_string(hertz), std::to_string(sub_steps), lab::rounded(fall.speed),
                       lab::rounded(100 * (fall.speed / truth - 1), "%.1f %%"),
                       lab::rounded(100 * fall.off_law, "%.2f %%"),
                       lab::rounded(1000 * fall.body_seconds)});
            const std::string key =
                "dominoes." + std::to_string(hertz) + "." + std::to_string(sub_steps);
            report.number(key + ".speed", fall.speed, "m/s");
            report.number(key + ".off", std::abs(fall.speed / truth - 1));
            report.number(key + ".off_law", fall.off_law);
            report.number(key + ".ms", 1000 * fall.body_seconds, "ms");
        }
    report.print(table);
    report.number("dominoes.need", row.need.tolerance);

    chart::Chart chart;
    chart.title = "The farther apart, the slower the wave";
    chart.subtitle = "Twenty dominoes 0.5 m high, 60 steps a second, by the gap between them.";
    chart.x = {"from one piece to the next [m]"};
    chart.y = {"speed of the wave [m/s]"};
    chart::Series rough{"μ = 0.5"}, grippy{"μ = 1"};
    rough.look = Look{Family::symplectic, Mark::square};
    grippy.look = Look{Family::runge_kutta, Mark::triangle};
    for (double spacing = 0.2; spacing < 0.48; spacing += 0.03) {
        DominoRow one = row;
        one.spacing = spacing;
        for (const double friction : {0.5, 1.0}) {
            World world = one.start();
            world.surface.friction = friction;
            Engine engine(one.switches);
            DominoWave wave(one);
            for (int i = 0; i < 360; ++i) {
                engine.step(world, 1 / 60.0);
                wave.look(world, (i + 1) / 60.0);
            }
            chart::Series& series = friction == 0.5 ? rough : grippy;
            if (wave.speed() > 0) series.x.push_back(spacing), series.y.push_back(wave.speed());
        }
    }
    report.number("dominoes.narrow", rough.y.front(), "m/s", "domino_speed.svg");
    report.number("dominoes.wide", rough.y.back(), "m/s", "domino_speed.svg");
    report.number("dominoes.rubbing", *std::max_element(grippy.y.begin(), grippy.y.end()), "m/s",
                  "domino_speed.svg");
    chart.series = {rough, grippy};
    chart::write_svg(chart, report.path("domino_speed.svg"));
}

}  // namespace nutshell
