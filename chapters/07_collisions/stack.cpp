// A stack of ten boxes: does it stand, and what does it cost to make it stand?
#include <nutshell/chart/chart.hpp>
#include "program.hpp"
#include "watching.hpp"

namespace nutshell {

namespace {

/// Runs the stack with each number of rounds a step, and makes a curve of its drift.
template <class Change>
chart::Series drift_against_rounds(const std::string& name, Look look, lab::Table& data,
                                   const Change& change) {
    chart::Series series{name};
    series.look = look;
    for (const int rounds : {1, 2, 3, 4, 6, 8, 12, 16, 24}) {
        Stack stack;
        change(stack.switches, rounds);
        const Watched seen = watched(stack, stack.switches);
        series.x.push_back(rounds), series.y.push_back(std::min(seen.drift, 10.0));
        data.add({name, std::to_string(rounds), lab::exact_digits(seen.drift),
                  lab::exact_digits(seen.overlap), lab::exact_digits(seen.last_speed)});
    }
    return series;
}

}  // namespace

void stack(lab::Report& report) {
    report.heading("A stack of ten boxes, ten seconds, steps of 1/60 s");
    const Stack scene;
    const Watched seen = watched(scene, scene.switches);
    report.number("stack.need", scene.need.tolerance, "m");
    report.number("stack.drift", seen.drift, "m");
    report.number("stack.overlap", seen.overlap, "m");
    report.number("stack.last_speed", seen.last_speed, "m/s");
    report.number("stack.body_step", 1e6 * seen.body_step, "us");
    report.number("stack.sub_steps", scene.switches.sub_steps);
    report.say("Drift " + lab::rounded(1000 * seen.drift) + " mm, overlap " +
               lab::rounded(1000 * seen.overlap) + " mm, in the last second " +
               lab::rounded(seen.last_speed) + " m/s; " + lab::rounded(1e6 * seen.body_step) +
               " us a body and step.");

    // one contact at a time, once round, nothing remembered: the engine of the question
    Stack naive;
    naive.duration = 3;
    naive.switches = {.sub_steps = 1, .relaxing = 0, .warm_start = false};
    const Watched fallen = watched(naive, naive.switches);
    report.number("stack.naive.overlap", fallen.overlap, "m");
    report.number("stack.naive.drift", fallen.drift, "m");
    double top = 0;
    for (const Body& box : fallen.end.bodies) top = std::max(top, box.position.y() + 0.5);
    report.number("stack.naive.top", top, "m");
    // the floor carries ten weights; after one round it has been asked for how much?
    for (const int rounds : {1, 10, 100}) {
        World world = scene.start();
        Switches once{.sub_steps = 1, .passes = rounds, .relaxing = 0, .warm_start = false};
        Engine engine(once);
        engine.step(world, 1 / 60.0);
        double carried = 0;
        for (const PressedContact& c : engine.contacts())
            if (c.a < 0) carried += c.normal_impulse;
        report.number("stack.carried." + std::to_string(rounds),
                      carried / (10 * earth_gravity / 60));
    }

    lab::Table data{{"switches", "rounds", "drift", "overlap", "last_speed"}, {}};
    chart::Chart chart;
    chart.title = "The same work, spent on sub-steps or on passes";
    chart.subtitle = "Ten boxes, 10 s, steps of 1/60 s. Down and left is better; 10 m: fallen.";
    chart.x = {"rounds through all contacts in a step", chart::Scale::logarithmic};
    chart.y = {"drift of a box [m]", chart::Scale::logarithmic};
    chart.tolerance = {scene.need.tolerance, "3 mm, one pixel"};
    chart.series = {
        drift_against_rounds("passes, cold", {Family::explicit_one_step, Mark::circle}, data,
                             [](Switches& on, int rounds) {
                                 on.sub_steps = 1, on.passes = rounds, on.warm_start = false;
                             }),
        drift_against_rounds(
            "passes", {Family::explicit_one_step, Mark::square}, data,
            [](Switches& on, int rounds) { on.sub_steps = 1, on.passes = rounds; }),
        drift_against_rounds(
            "sub-steps, cold", {Family::symplectic, Mark::circle}, data,
            [](Switches& on, int rounds) { on.sub_steps = rounds, on.warm_start = false; }),
        drift_against_rounds("sub-steps", {Family::symplectic, Mark::square}, data,
                             [](Switches& on, int rounds) { on.sub_steps = rounds; })};
    chart::write_svg(chart, report.path("stack_rounds.svg"));
    report.data("stack_rounds.csv", data);
    const std::array keys{"passes_cold", "passes", "sub_steps_cold", "sub_steps"};
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const chart::Series& series = chart.series[i];
        for (std::size_t k = 0; k < series.x.size(); ++k)
            report.number(std::string("stack.") + keys[i] + "." + lab::rounded(series.x[k]),
                          series.y[k], "m");
    }

    // heavy on light: what going round does not like
    for (const double mass : {1.0, 10.0, 100.0}) {
        Stack loaded;
        loaded.boxes = 2;
        World world = loaded.start();
        const Box cube{{0.5, 0.5, 0.5}};
        world.bodies[1] = solid_box(mass, cube, world.bodies[1].position);
        Engine engine(loaded.switches);
        double deepest = 0;
        for (int i = 0; i < 300; ++i) {
            engine.step(world, 1 / 60.0);
            deepest = std::max(deepest, deepest_overlap(world));
        }
        report.number("stack.loaded." + lab::rounded(mass), deepest, "m");
    }
    // how high
    for (const int boxes : {20, 40}) {
        Stack tower;
        tower.boxes = boxes;
        const Watched high = watched(tower, tower.switches);
        report.number("stack.high." + std::to_string(boxes), high.drift, "m");
    }
}

}  // namespace nutshell
