// What each switch of the engine buys, and what it costs: one turned off at a time.
#include <nutshell/chart/chart.hpp>
#include "program.hpp"
#include "watching.hpp"

namespace nutshell {

void switches(lab::Report& report) {
    report.heading("One switch off at a time: a stack for 10 s, a pile of 1000 for 2 s");
    lab::Table table{{"engine", "stack drifts [mm]", "overlaps [mm]", "last second [m/s]", "us",
                      "pile overlaps [r]", "us"},
                     {}};
    chart::Ranking ranking;
    ranking.title = "What each idea buys, and what it costs";
    ranking.subtitle =
        "One switch off at a time; \"four passes\" does the work of four sub-steps in one step.";
    ranking.columns = {"deepest overlap in a stack [mm]", "time of a body and step, pile [µs]"};
    const auto row = [&](const std::string& key, const std::string& name, Look look,
                         const auto& change) {
        Stack stack;
        Pile pile;
        change(stack.switches), change(pile.switches);
        pile.duration = 2;
        const Watched s = watched(stack, stack.switches),
                      p = watched(pile, pile.switches, 1 / 60.0, 3);
        const double radii = p.overlap / 0.1;
        table.add({name, lab::rounded(1000 * s.drift), lab::rounded(1000 * s.overlap),
                   lab::rounded(s.last_speed), lab::rounded(1e6 * s.body_step),
                   lab::rounded(radii), lab::rounded(1e6 * p.body_step)});
        ranking.rows.push_back({name, look, {1000 * s.overlap, 1e6 * p.body_step}, "", ""});
        const std::string at = "switch." + key;
        report.number(at + ".drift", s.drift, "m");
        report.number(at + ".overlap", s.overlap, "m");
        report.number(at + ".last_speed", s.last_speed, "m/s");
        report.number(at + ".stack_us", 1e6 * s.body_step, "us");
        report.number(at + ".pile_overlap", radii);
        report.number(at + ".pile_us", 1e6 * p.body_step, "us");
        report.number(at + ".pile_energy", p.energy);
        report.number(at + ".pile_escaped", p.escaped);
    };
    const Look off{Family::explicit_one_step, Mark::circle};
    row("all", "everything on", {Family::symplectic, Mark::square}, [](Switches&) {});
    row("manifold", "one contact a pair", off, [](Switches& on) { on.manifold = false; });
    row("warm", "no warm start", off, [](Switches& on) { on.warm_start = false; });
    row("cold", "no extra passes at the start", off, [](Switches& on) { on.cold = 1; });
    row("passes", "four passes, one step", {Family::implicit, Mark::circle},
        [](Switches& on) { on.sub_steps = 1, on.passes = 4, on.relaxing = 4; });
    row("one", "one sub-step", off, [](Switches& on) { on.sub_steps = 1; });
    row("relaxing", "no relaxing pass", off, [](Switches& on) { on.relaxing = 0; });
    row("soft", "hard contacts", off, [](Switches& on) { on.soft = false; });
    row("grid", "every pair looked at", off, [](Switches& on) { on.grid = false; });
    report.print(table);
    chart::write_svg(ranking, report.path("switches.svg"));

    report.heading("Sleep: a pile of 1000, once all of it sleeps");
    Pile pile;
    pile.switches.sleep = true;
    World world = pile.start();
    Engine engine(pile.switches);
    const auto asleep = [&] {
        int count = 0;
        for (std::size_t i = 0; i < world.bodies.size(); ++i) count += engine.asleep(i);
        return count;
    };
    int steps = 0;
    for (; steps < 60 * 60 && asleep() < 1000; ++steps) engine.step(world, 1 / 60.0);
    report.number("sleep.asleep", asleep());
    report.number("sleep.after", steps / 60.0, "s");
    for (const bool sleep : {true, false}) {
        engine.on.sleep = sleep;
        const double begin = lab::processor_seconds();
        for (int i = 0; i < 60; ++i) engine.step(world, 1 / 60.0);
        const double us = (lab::processor_seconds() - begin) / 60 / 1000 * 1e6;
        report.number(std::string("sleep.") + (sleep ? "on" : "off") + ".us", us, "us");
        report.say(std::string(sleep ? "asleep: " : "awake: ") + lab::rounded(us) +
                   " us a body and step");
    }
}

}  // namespace nutshell
