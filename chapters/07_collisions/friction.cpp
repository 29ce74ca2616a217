// A block on a slope and a bowling ball, by contact impulses alone.
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

void slope(lab::Report& report) {
    report.heading("A block on a slope, mu = 0.5");
    BlockOnSlope steep;
    double off = 0, slow = 0, least = immovable;
    for (double heading = 0; heading < 91; heading += 7.5) {
        steep.heading = heading * pi / 180;
        const World world = run(steep.start(), steep.switches, steep.duration);
        Switches wrong = steep.switches;
        wrong.pyramid = true;
        const World stuck = run(steep.start(), wrong, steep.duration);
        least = std::min(least, velocity(world.bodies[0]).norm());
        off = std::max(
            off, std::abs(steep.effective_friction(world, steep.duration) - steep.friction));
        if (heading > 29 && heading < 61) slow = std::max(slow, velocity(stuck.bodies[0]).norm());
    }
    report.number("slope.speed", least, "m/s");
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

void bowling(lab::Report& report) {
    const BowlingBall scene;
    report.heading("A bowling ball at 7 m/s, without spin");
    World world = scene.start();
    Engine engine(scene.switches);
    double off = 0, rolls = 0;
    for (int i = 0; i <= 240; ++i) {
        const double t = i / 60.0, v = velocity(world.bodies[0]).x(),
                     slides = v + angular_velocity(world.bodies[0]).z() * scene.radius;
        off = std::max(off, std::abs(v - scene.exact_speed(t)));
        if (rolls == 0 && slides < 1e-9) rolls = t;
        engine.step(world, 1 / 60.0);
    }
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
    slope(report);
    bowling(report);
}

}  // namespace nutshell
