// The universe: the source's own program as printed, its own rules mended, and our engine, for
// eight minutes.
#include <nutshell/chart/chart.hpp>
#include <nutshell/game_loop.hpp>
#include <nutshell/universe_scene.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

/// Height [m] of the lowest point of a ball that falls from rest, bounces with e and rests.
double exact_height(const Universe& u, double t) {
    const double g = -u.force.y() / u.mass, fall = u.first_contact();
    if (t < fall) return u.place.y() - u.radius - g * t * t / 2;
    double speed = u.restitution * g * fall, begin = fall;
    while (speed > 1e-9 && t > begin + 2 * speed / g) {
        begin += 2 * speed / g;
        speed *= u.restitution;
    }
    const double s = t - begin;
    return std::max(0.0, speed * s - g * s * s / 2);
}

}  // namespace

void universe(lab::Report& report) {
    report.heading("The universe: eight minutes of the source's program");
    const Universe scene;
    const auto dt = static_cast<float>(scene.dt);
    PrintedUniverse printed;
    World world = world_of(scene);
    Body mended = world.bodies[0];
    Engine engine(universe_switches);
    long first_contact = 0, first_nan = 0, contacts_at_nan = 0;
    double off = 0, off_mended = 0, stretch = 0, lowest = 1, touches = 0, rests = 0;
    chart::Series p{"as printed"}, m{"our engine"}, exact{"exact"};
    p.look = Look{Family::explicit_one_step, Mark::triangle_down};
    m.look = Look{Family::symplectic, Mark::square};
    exact.draw = chart::Draw::ghost;
    for (long i = 1; i <= 60000; ++i) {
        const double t = static_cast<double>(i) * scene.dt;
        printed.evolve(dt);
        engine.step(world, scene.dt);
        evolve_mended(scene, mended, scene.dt);
        if (first_contact == 0 && printed.contacts > 0) first_contact = i;
        if (first_nan == 0) {
            if (printed.R.allFinite())
                stretch =
                    std::max(stretch, std::abs(static_cast<double>(printed.R.determinant()) - 1));
            else
                first_nan = i, contacts_at_nan = printed.contacts;
        }
        lowest = std::min(lowest, static_cast<double>(printed.p.y()) - scene.radius);
        const double height = exact_height(scene, t);
        const Body& ball = world.bodies[0];
        if (touches == 0 && ball.momentum.y() > 0) touches = t;
        if (ball.position.y() - scene.radius > 1e-5)
            rests = t;  // a step of weight moves it 0.6 um
        off = std::max(off, std::abs(world.bodies[0].position.y() - scene.radius - height));
        off_mended = std::max(off_mended, std::abs(mended.position.y() - scene.radius - height));
        if (i % 150 != 0) continue;
        p.x.push_back(t), p.y.push_back(static_cast<double>(printed.p.y()) - scene.radius);
        m.x.push_back(t), m.y.push_back(world.bodies[0].position.y() - scene.radius);
        exact.x.push_back(t), exact.y.push_back(height);
    }
    report.number("universe.first_contact", static_cast<double>(first_contact));
    report.number("universe.first_contact_s", static_cast<double>(first_contact) * scene.dt, "s");
    report.number("universe.first_nan", static_cast<double>(first_nan));
    report.number("universe.first_nan_s", static_cast<double>(first_nan) * scene.dt, "s");
    report.number("universe.contacts", static_cast<double>(contacts_at_nan));
    report.number("universe.printed_spin", static_cast<double>(printed.L.norm()), "kg m^2/s");
    report.number("universe.stretch", stretch);
    report.number("universe.sunk", -lowest, "m");
    report.number("universe.touches", touches, "s");
    report.number("universe.touches_law", scene.first_contact(), "s");
    report.number("universe.rests", rests, "s");
    report.number("universe.rests_law", scene.rest_time(), "s");
    report.number("universe.off", off, "m");
    report.number("universe.mended_off", off_mended, "m");
    report.number("universe.spin", world.bodies[0].angular_momentum.norm(), "kg m^2/s");
    report.number("universe.spin_change", (world.bodies[0].angular_momentum - scene.spin).norm(),
                  "kg m^2/s");
    report.number("universe.weight_ratio", scene.mass * 9.8 / -scene.force.y());
    report.number("universe.with_weight", std::sqrt(2 * scene.place.y() / 9.8), "s");
    report.say("As printed: floor at step " + std::to_string(first_contact) +
               ", not a number at " + std::to_string(first_nan) +
               ". Ours: off the exact bounces by " + lab::rounded(1000 * off) + " mm at most.");

    // chapter 1's game loop: a minute at 60 frames a second, and what the printed loop makes
    GameClock clock{scene.dt};
    long steps = 0;
    for (int frame = 0; frame < 3600; ++frame) steps += steps_due(clock, 1.0 / 60);
    report.number("universe.loop_steps", static_cast<double>(steps));
    report.number("universe.loop_s", static_cast<double>(steps) * scene.dt, "s");
    report.number("universe.printed_loop_s", 3600 * scene.dt, "s");

    chart::Chart chart;
    chart.title = "The lowest point of the source's ball";
    chart.subtitle = "Eight minutes, as printed and by our engine. The floor is at zero.";
    chart.x = {"time [s]"};
    chart.y = {"above the floor [m]"};
    p.draw = m.draw = chart::Draw::line;
    chart.series = {exact, p, m};
    chart.levels_x = {{static_cast<double>(first_nan) * scene.dt,
                       "from here on the printed matrix is no number"}};
    chart::write_svg(chart, report.path("universe_height.svg"));
}

}  // namespace nutshell
