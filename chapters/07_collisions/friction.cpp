// A block on a slope and a bowling ball, by contact impulses alone.
#include <nutshell/chart/chart.hpp>
#include <nutshell/friction_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

World run(const World& start, const Switches& switches, double duration, double dt = 1 / 60.0) {
    World world = start;
    Engine engine(switches);
    for (long i = 0; i < std::lround(duration / dt); ++i) engine.step(world, dt);
    return world;
}

/// A block on a slope; its chart goes into the figure.
void slope(lab::Report& report, chart::Figure& figure) {
    report.heading("A block on a slope, mu = 0.5");
    BlockOnSlope steep;
    chart::Chart chart;
    chart.title = "block, 30°, μ = 0.5, after 2 s";
    chart.x = {"way down, from the box's edge [degrees]", chart::Scale::linear, 0, 90};
    chart.y = {"speed [m/s]", chart::Scale::linear, 0};
    chart::Series cone{"cone"}, pyramid{"pyramid"}, law{""};
    cone.look = Look{Family::symplectic, Mark::square};
    pyramid.look = Look{Family::explicit_one_step, Mark::circle};
    law.draw = chart::Draw::theory;
    double off = 0, slow = 0;
    for (double heading = 0; heading < 91; heading += 7.5) {
        steep.heading = heading * pi / 180;
        const World world = run(steep.start(), steep.switches, steep.duration);
        Switches wrong = steep.switches;
        wrong.pyramid = true;
        const World stuck = run(steep.start(), wrong, steep.duration);
        cone.x.push_back(heading), cone.y.push_back(velocity(world.bodies[0]).norm());
        pyramid.x.push_back(heading), pyramid.y.push_back(velocity(stuck.bodies[0]).norm());
        law.x.push_back(heading), law.y.push_back(steep.exact_speed(steep.duration));
        off = std::max(
            off, std::abs(steep.effective_friction(world, steep.duration) - steep.friction));
        if (heading > 29 && heading < 61) slow = std::max(slow, velocity(stuck.bodies[0]).norm());
    }
    chart.series = {law, cone, pyramid};
    figure.panels.push_back(chart);
    report.number("slope.speed", steep.exact_speed(steep.duration), "m/s");
    report.number("slope.mu_off", off);
    report.number("slope.pyramid.speed", slow, "m/s");

    BlockOnSlope flat;
    flat.slope = 26 * pi / 180, flat.duration = 5;
    double creep = 0;
    for (const double heading : {0.0, 30.0, 45.0}) {
        flat.heading = heading * pi / 180;
        World world = flat.start();
        Engine engine(flat.switches);
        for (int i = 0; i < 300; ++i) {
            engine.step(world, 1 / 60.0);
            creep = std::max(creep, (world.bodies[0].position - Vector3(0, 0.5, 0)).norm());
        }
    }
    report.number("slope.creep", creep, "m");
    report.number("slope.limit", std::atan(flat.friction) * 180 / pi, "degrees");
    report.say("26 degrees, 5 s: it creeps " + lab::rounded(creep) +
               " m. 30 degrees: mu from the speed is off by " + lab::rounded(off) +
               " in any direction; with a pyramid it stands still at 30 and 45 degrees");
}

/// A bowling ball; its chart goes into the figure.
void bowling(lab::Report& report, chart::Figure& figure) {
    const BowlingBall scene;
    report.heading("A bowling ball at 7 m/s, without spin");
    chart::Chart chart;
    chart.title = "bowling ball, 7 m/s, μ = 0.1";
    chart.x = {"time [s]"}, chart.y = {"speed [m/s]", chart::Scale::linear, 0};
    chart::Series ball{"ball"}, point{"its lowest point"}, law{""};
    ball.look = Look{Family::symplectic, Mark::square};
    point.look = Look{Family::runge_kutta, Mark::circle};
    ball.draw = point.draw = chart::Draw::line, law.draw = chart::Draw::theory;
    World world = scene.start();
    Engine engine(scene.switches);
    double off = 0, rolls = 0;
    for (int i = 0; i <= 240; ++i) {
        const double t = i / 60.0, v = velocity(world.bodies[0]).x(),
                     slides = v + angular_velocity(world.bodies[0]).z() * scene.radius;
        ball.x.push_back(t), ball.y.push_back(v);
        point.x.push_back(t), point.y.push_back(slides);
        law.x.push_back(t), law.y.push_back(scene.exact_speed(t));
        off = std::max(off, std::abs(v - scene.exact_speed(t)));
        if (rolls == 0 && slides < 1e-9) rolls = t;
        engine.step(world, 1 / 60.0);
    }
    chart.series = {law, ball, point};
    figure.panels.push_back(chart);
    report.number("bowling.speed", scene.speed, "m/s");
    report.number("bowling.end", velocity(world.bodies[0]).x(), "m/s");
    report.number("bowling.rolls_after", scene.rolls_after(), "s");
    report.number("bowling.rolls_from", scene.rolls_from(), "m");
    report.number("bowling.seen_rolling", rolls, "s");
    report.number("bowling.off", off, "m/s");
    report.say("It rolls after " + lab::rounded(rolls) +
               " s (law: " + lab::rounded(scene.rolls_after()) + " s) at " +
               lab::rounded(velocity(world.bodies[0]).x()) + " m/s");
}

}  // namespace

void friction(lab::Report& report) {
    chart::Figure figure;
    figure.title = "Friction, found by contact impulses alone";
    figure.subtitle = "Marks and lines: runs; dashed: Coulomb's law.";
    slope(report, figure);
    bowling(report, figure);
    chart::write_svg(figure, report.path("friction.svg"));
}

}  // namespace nutshell
