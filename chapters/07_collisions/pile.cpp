// Piles from ten bodies to ten thousand: how deep they overlap, and what a body and step cost.
#include <nutshell/chart/chart.hpp>
#include "program.hpp"
#include "watching.hpp"

namespace nutshell {

namespace {

/// Processor time [s] of a step of one body, of 60 steps.
double body_step(Engine& engine, World& world) {
    constexpr int steps = 60;
    const double begin = lab::processor_seconds();
    for (int i = 0; i < steps; ++i) engine.step(world, 1 / 60.0);
    return (lab::processor_seconds() - begin) / steps / static_cast<double>(world.bodies.size());
}

/// The same while the pile falls, after `settling` seconds, and then with every pair looked at: the
/// least of up to five falls, as many as half a second holds.
struct Cost {
    double falling = immovable, settled = immovable, every = immovable;
};
Cost cost_of(const Pile& pile, double settling, bool with_every_pair) {
    Cost least;
    const double begin = lab::processor_seconds();
    for (int fall = 0; fall < 5 && (fall == 0 || lab::processor_seconds() < begin + 0.5);
         ++fall) {
        World world = pile.start();
        Engine engine(pile.switches);
        least.falling = std::min(least.falling, body_step(engine, world));
        for (long i = lab::steps_of(settling - 1, 1 / 60.0); i > 0; --i)
            engine.step(world, 1 / 60.0);
        least.settled = std::min(least.settled, body_step(engine, world));
        if (!with_every_pair) continue;
        engine.on.grid = false;
        least.every = std::min(least.every, body_step(engine, world));
    }
    return least;
}

}  // namespace

void pile_cost(lab::Report& report) {
    report.heading("What a body and step costs, from ten bodies to ten thousand");
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
            const bool with_every_pair = !cubes && wide <= 10;
            const Cost cost = cost_of(pile, wide > 10 ? 1.5 : 3, with_every_pair);
            const double n = static_cast<double>(pile.start().bodies.size());
            const double a = 1e6 * cost.falling, b = 1e6 * cost.settled;
            falls.x.push_back(n), falls.y.push_back(a), lies.x.push_back(n), lies.y.push_back(b);
            data.add({lab::rounded(n, "%.0f"), cubes ? "cubes" : "spheres", lab::exact_digits(a),
                      lab::exact_digits(b)});
            const std::string key =
                std::string(cubes ? "cubes." : "spheres.") + lab::rounded(n, "%.0f");
            report.number(key + ".falling", a, "us"), report.number(key + ".settled", b, "us");
            if (!cubes && wide == 3) first = a + b;
            if (!cubes && wide == 32) last = a + b;
            if (!with_every_pair) continue;
            every.x.push_back(n), every.y.push_back(1e6 * cost.every);
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
}

}  // namespace nutshell
