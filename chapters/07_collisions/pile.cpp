// Piles from ten bodies to ten thousand: how deep they overlap, and what a body and step cost.
#include <nutshell/chart/chart.hpp>
#include "program.hpp"
#include "watching.hpp"

namespace nutshell {

namespace {

/// Processor time [s] of 60 steps, per body and step: the least of some runs.
double body_step(const World& start, const Switches& switches) {
    const bool small = start.bodies.size() <= 1000,
               balls = std::holds_alternative<Sphere>(start.shapes[0]);
    const int steps = 60, runs = start.bodies.size() < 300 ? 5 : small || balls ? 3 : 1;
    double least = immovable;
    for (int run = 0; run < runs; ++run) {
        World world = start;
        Engine engine(switches);
        const double begin = lab::processor_seconds();
        for (int i = 0; i < steps; ++i) engine.step(world, 1 / 60.0);
        least = std::min(least, lab::processor_seconds() - begin);
    }
    return least / steps / static_cast<double>(start.bodies.size());
}

/// The pile after `seconds` [s].
World settled(const Pile& pile, double seconds) {
    World world = pile.start();
    Engine engine(pile.switches);
    for (int i = 0; i < static_cast<int>(std::lround(60 * seconds)); ++i)
        engine.step(world, 1 / 60.0);
    return world;
}

void cost_against_size(lab::Report& report) {
    chart::Figure figure;
    figure.title = "What a body costs in a pile of N";
    figure.subtitle = "60 steps of a falling pile and of a settled one; the box grows with N.";
    lab::Table data{{"bodies", "pile", "spheres_us", "cubes_us"}, {}};
    double first = 0, last = 0;
    for (const bool cubes : {false, true}) {
        chart::Chart chart;
        chart.title = cubes ? "cubes" : "spheres";
        chart.x = {"bodies", chart::Scale::logarithmic};
        chart.y = {"time of a body and step [µs]", chart::Scale::logarithmic};
        chart::Series falls{"falling"}, lies{"settled"}, every{"every pair"};
        falls.look = Look{Family::symplectic, Mark::circle};
        lies.look = Look{Family::symplectic, Mark::square};
        every.look = Look{Family::explicit_one_step, Mark::triangle};
        for (const int wide : {1, 3, 5, 10, 20, 32}) {
            if (cubes && wide > 20) continue;  // a minute of its own
            Pile pile;
            pile.wide = wide, pile.cubes = cubes;
            const World start = pile.start(), rest = settled(pile, wide > 10 ? 1.5 : 3);
            const double n = static_cast<double>(start.bodies.size());
            const double a = 1e6 * body_step(start, pile.switches),
                         b = 1e6 * body_step(rest, pile.switches);
            falls.x.push_back(n), falls.y.push_back(a), lies.x.push_back(n), lies.y.push_back(b);
            data.add({lab::rounded(n, "%.0f"), cubes ? "cubes" : "spheres", lab::exact_digits(a),
                      lab::exact_digits(b)});
            const std::string key =
                std::string(cubes ? "cubes." : "spheres.") + lab::rounded(n, "%.0f");
            report.number(key + ".falling", a, "us"), report.number(key + ".settled", b, "us");
            if (!cubes && wide == 3) first = a + b;
            if (!cubes && wide == 32) last = a + b;
            if (cubes || wide > 10) continue;
            Switches all = pile.switches;
            all.grid = false;
            every.x.push_back(n), every.y.push_back(1e6 * body_step(rest, all));
            report.number(key + ".every", every.y.back(), "us");
        }
        chart.series = {falls, lies};
        if (!cubes)
            chart.series.push_back(every), chart.guides = {0, 1}, chart.guide_name = "power";
        figure.panels.push_back(chart);
    }
    chart::write_svg(figure, report.path("pile_cost.svg"));
    report.data("pile_cost.csv", data);
    report.number("spheres.growth", last / first);
    report.say("From 90 to 10 240 spheres a body and step cost " + lab::rounded(last / first) +
               " times as much.");
}

}  // namespace

void pile(lab::Report& report) {
    report.heading("A pile of 1000 spheres, five seconds");
    for (const bool cubes : {false, true}) {
        Pile scene;
        scene.cubes = cubes;
        if (cubes) scene.wide = 6;
        const Watched seen = watched(scene, scene.switches);
        const std::string key = cubes ? "pile.cubes" : "pile";
        report.number(key + ".bodies", static_cast<double>(seen.end.bodies.size()));
        report.number(key + ".overlap", seen.overlap / 0.1);
        report.number(key + ".overlap_m", seen.overlap, "m");
        report.number(key + ".energy", seen.energy);
        report.number(key + ".escaped", seen.escaped);
        report.number(key + ".last_speed", seen.last_speed, "m/s");
        report.number(key + ".rest_overlap_m", deepest_overlap(seen.end), "m");
        report.number(key + ".body_step", 1e6 * seen.body_step, "us");
        report.say(std::to_string(seen.end.bodies.size()) + (cubes ? " cubes" : " spheres") +
                   ": overlap " + lab::rounded(1000 * seen.overlap) + " mm, " +
                   std::to_string(seen.escaped) + " escaped, energy at most " +
                   lab::rounded(seen.energy, "%.6f") + " of its start");
    }
    Pile fine;
    fine.cubes = true, fine.wide = 6, fine.switches.sub_steps = 16, fine.duration = 2;
    report.number("pile.cubes.fine_overlap_m", watched(fine, fine.switches).overlap, "m");
    report.number("pile.need", Pile{}.need.tolerance, "m");
    cost_against_size(report);
}

}  // namespace nutshell
