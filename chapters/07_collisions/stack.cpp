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

/// Part of the weight of all boxes that the floor has been asked for after some rounds in the
/// first step, from nothing.
double carried_after(int boxes, int rounds) {
    Stack scene;
    scene.boxes = boxes;
    World world = scene.start();
    Switches rigid{.sub_steps = 1, .passes = rounds, .relaxing = 0, .warm_start = false};
    rigid.soft = false;
    Engine engine(rigid);
    engine.step(world, 1 / 60.0);
    double sum = 0;
    for (const PressedContact& c : engine.contacts())
        if (c.a < 0) sum += c.normal_impulse;
    return sum / (boxes * earth_gravity / 60);
}

void carried(lab::Report& report) {
    chart::Chart chart;
    chart.title = "What the floor has been asked to carry";
    chart.subtitle = "Stacks of 5, 10 and 20 boxes, from nothing, in one step.";
    chart.x = {"rounds through all contacts", chart::Scale::logarithmic};
    chart.y = {"part of the whole weight"};
    const std::array marks{Mark::circle, Mark::square, Mark::triangle};
    std::size_t k = 0;
    for (const int boxes : {5, 10, 20}) {
        chart::Series series{std::to_string(boxes) + " boxes"};
        series.look = Look{Family::symplectic, marks[k++]};
        for (const int rounds : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000}) {
            series.x.push_back(rounds), series.y.push_back(carried_after(boxes, rounds));
            if (boxes == 10)
                report.number("stack.carried." + std::to_string(rounds), series.y.back());
        }
        int few = 1, enough = 2;  // rounds until the floor carries nine tenths
        while (carried_after(boxes, enough) < 0.9) few = enough, enough *= 2;
        while (enough - few > 1) {
            const int middle = (few + enough) / 2;
            (carried_after(boxes, middle) < 0.9 ? few : enough) = middle;
        }
        report.number("stack.rounds_to_carry." + std::to_string(boxes), enough);
        chart.series.push_back(series);
    }
    chart.levels_y = {{1, "all of it"}};
    chart::write_svg(chart, report.path("carried.svg"));
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
    carried(report);

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
