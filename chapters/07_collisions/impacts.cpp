// Smooth balls meet: head-on, beside the centre, all at once; and a ball too fast to see.
#include <nutshell/chart/chart.hpp>
#include <nutshell/chart/diagram.hpp>
#include <nutshell/impact_scenes.hpp>
#include <nutshell/impacts_at_once.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

chart::Place seen(const Vector3& v, double scale = 1) {
    return {scale * v.x(), scale * v.y()};
}

double degrees_between(const Vector3& a, const Vector3& b) {
    return std::acos(a.dot(b) / (a.norm() * b.norm())) * 180 / pi;
}

/// Two balls that touch: velocities, normal, and the impulse that each gets.
void contact_diagram(lab::Report& report) {
    const TwoBalls scene = TwoBalls::glancing();
    const Vector3 n = scene.normal(), touch = scene.a.position + 0.5 * n;
    const double j = impact_impulse(scene.a, scene.b, n, 1);
    chart::Diagrams d;
    d.title = "One impulse, along the normal, and its opposite";
    d.subtitle =
        "Two equal smooth balls, the left one at 2 m/s. Blue: velocities; gold: impulses.";
    chart::Diagram before, after;
    before.title = "just before", after.title = "just after";
    for (chart::Diagram* one : {&before, &after}) {
        one->ball(seen(scene.a.position), 0.5, "A").ball(seen(scene.b.position), 0.5, "B");
        one->dashed({seen(scene.a.position - 0.7 * n), seen(scene.b.position + 0.9 * n)});
    }
    before.arrow(seen(scene.a.position), seen(velocity(scene.a), 0.4), chart::Quantity::velocity,
                 "v of A");
    before.contact(seen(touch), seen(n, 0.45));
    before.arrow(seen(scene.b.position), seen(n, 0.4 * j), chart::Quantity::momentum, "j n");
    before.arrow(seen(scene.a.position), seen(n, -0.4 * j), chart::Quantity::momentum, "−j n");
    const auto v = scene.exact();
    after.arrow(seen(scene.a.position), seen(v[0], 0.4), chart::Quantity::velocity, "v of A");
    after.arrow(seen(scene.b.position), seen(v[1], 0.4), chart::Quantity::velocity, "v of B");
    d.panels = {before, after};
    chart::write_svg(d, report.path("contact.svg"));
}

}  // namespace

void head_on(lab::Report& report) {
    report.heading("Head-on: 1 kg at 2 m/s meets 2 kg at -1 m/s");
    lab::Table table{{"restitution", "a after [m/s]", "b after [m/s]", "energy left [J]"}, {}};
    const TwoBalls start = TwoBalls::head_on();
    report.number("head_on.energy", kinetic_energy(start.a) + kinetic_energy(start.b), "J");
    for (const double e : {1.0, 0.5, 0.0}) {
        TwoBalls scene = TwoBalls::head_on();
        scene.restitution = e;
        collide(scene.a, scene.b, scene.normal(), e);
        const double left = kinetic_energy(scene.a) + kinetic_energy(scene.b);
        table.add({lab::rounded(e), lab::rounded(velocity(scene.a).x()),
                   lab::rounded(velocity(scene.b).x()), lab::rounded(left)});
        const std::string key = "head_on." + lab::rounded(10 * e);
        report.number(key + ".a", velocity(scene.a).x(), "m/s");
        report.number(key + ".b", velocity(scene.b).x(), "m/s");
        report.number(key + ".energy", left, "J");
    }
    report.print(table);
    contact_diagram(report);
}

void glancing(lab::Report& report) {
    report.heading("Glancing: a ball at 1 m/s meets an equal one at rest, at 45 degrees");
    const auto hit = [](double e) {
        TwoBalls scene = TwoBalls::glancing(std::sqrt(0.5));
        scene.a.momentum /= 2;  // 1 m/s
        scene.restitution = e;
        collide(scene.a, scene.b, scene.normal(), e);
        return scene;
    };
    for (const double e : {1.0, 0.9}) {
        const TwoBalls after = hit(e);
        const double angle = degrees_between(velocity(after.a), velocity(after.b));
        const std::string key = e == 1 ? "glancing.elastic" : "glancing.nine";
        report.number(key + ".angle", angle, "degrees");
        report.number(key + ".a.x", velocity(after.a).x(), "m/s");
        report.number(key + ".a.y", velocity(after.a).y(), "m/s");
        report.number(key + ".b.x", velocity(after.b).x(), "m/s");
        report.number(key + ".b.y", velocity(after.b).y(), "m/s");
        report.say("e = " + lab::rounded(e) + ": they leave " + lab::rounded(angle, "%.1f") +
                   " degrees apart");
    }
    TwoBalls printed = TwoBalls::glancing(std::sqrt(0.5));
    printed.a.momentum /= 2;
    collide_as_printed(printed.a, printed.b, 1);
    report.number("glancing.printed.a", velocity(printed.a).norm(), "m/s");
    report.number("glancing.printed.b", velocity(printed.b).norm(), "m/s");
    report.say("as printed the first one stops, and the other leaves along the old way");
    // no approach test: a pair that is leaving is pulled together
    Particle c{1, {0, 0, 0}, {-1, 0, 0}}, d{1, {1, 0, 0}, {1, 0, 0}};
    collide_as_printed(c, d, 0.9);
    report.number("apart.printed.a", velocity(c).x(), "m/s");
    report.number("apart.printed.b", velocity(d).x(), "m/s");
    // a wall: all components turn round, not one
    Particle wall{immovable}, ball{1, {0, 1, 0}, {3, -4, 0}};
    collide(wall, ball, {0, 1, 0}, 0.9);
    report.number("wall.x", velocity(ball).x(), "m/s");
    report.number("wall.y", velocity(ball).y(), "m/s");
}

void pool(lab::Report& report) {
    report.heading("Break of pool: fifteen balls, 8 m/s");
    lab::Table table{{"restitution", "impacts in 0.5 s", "momentum off [kg m/s]", "energy kept"},
                     {}};
    for (const double e : {1.0, 0.95}) {
        Balls balls = pool_break();
        balls.restitution = e;
        const Vector3 before = total_momentum(balls.all);
        const double energy = kinetic_energy(balls.all);
        const long impacts = fly_by_events(balls, 0.5);
        const double off = (total_momentum(balls.all) - before).norm(),
                     kept = kinetic_energy(balls.all) / energy;
        table.add({lab::rounded(e), std::to_string(impacts), lab::rounded(off),
                   lab::rounded(kept, "%.12g")});
        const std::string key = e == 1 ? "pool.elastic" : "pool";
        report.number(key + ".impacts", static_cast<double>(impacts));
        report.number(key + ".energy_kept", kept);
    }
    report.print(table);
}

void too_fast(lab::Report& report) {
    report.heading("Too fast to see: a point and a slab of 0.1 m, 60 looks a second");
    const double thickness = 0.1, dt = 1 / 60.0;
    chart::Chart chart;
    chart.title = "A point test misses the slab from " + lab::rounded(thickness / dt) + " m/s on";
    chart.subtitle =
        "Slab of 0.1 m, 60 looks a second. Marks: 100 000 starts each; dashed: the law.";
    chart.x = {"speed [m/s]", chart::Scale::linear, 0, 60};
    chart.y = {"part of all starts that go through", chart::Scale::linear, 0, 1};
    chart::Series point{"point test"}, swept{"swept test"}, law{"1 − h/(v dt)"};
    point.look = Look{Family::explicit_one_step, Mark::circle};
    swept.look = Look{Family::exponential, Mark::triangle};
    law.draw = chart::Draw::theory, point.draw = swept.draw = chart::Draw::marks;
    double worst = 0;
    for (double speed = 2; speed <= 60; speed += 0.5) {
        law.x.push_back(speed), law.y.push_back(miss_probability(thickness, speed, dt));
        if (std::fmod(speed, 4) != 0) continue;
        const int starts = 100000;
        int missed = 0, through = 0;
        for (int i = 0; i < starts; ++i) {
            const double before = 3 + speed * dt * (i + 0.5) / starts;
            missed += !seen_inside(before, thickness, speed, dt);
            through += !swept_inside(before, speed, dt);
        }
        const double part = missed / static_cast<double>(starts);
        worst = std::max(worst, std::abs(part - law.y.back()));
        point.x.push_back(speed), point.y.push_back(part);
        swept.x.push_back(speed), swept.y.push_back(through / static_cast<double>(starts));
    }
    chart.series = {law, point, swept};
    chart.levels_x = {{thickness / dt, "a slab's thickness each look"}};
    report.draw("too_fast", chart);
    report.number("too_fast.limit", thickness / dt, "m/s");
    report.number("too_fast.at_20", miss_probability(thickness, 20, dt));
    report.number("too_fast.at_50", miss_probability(thickness, 50, dt));
    report.number("too_fast.off_the_law", worst);
    report.number("too_fast.swept", *std::max_element(swept.y.begin(), swept.y.end()));
    report.say("At 20 m/s " + lab::rounded(100 * miss_probability(thickness, 20, dt)) +
               " %, at 50 m/s " + lab::rounded(100 * miss_probability(thickness, 50, dt)) +
               " % go through; of a swept test none.");
}

void cradle(lab::Report& report) {
    report.heading("Newton's cradle: five balls, the first comes in at 1 m/s");
    lab::Table table{{"", "1", "2", "3", "4", "5"}, {}};
    const auto row = [&](const std::string& name, const std::string& key,
                         const std::vector<Particle>& all) {
        std::vector<std::string> cells{name};
        double off = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const double v = velocity(all[i]).x();
            cells.push_back(lab::rounded(v));
            off = std::max(off, std::abs(v - (i + 1 == all.size() ? 1 : 0)));
        }
        report.number("cradle." + key + ".first", velocity(all.front()).x(), "m/s");
        report.number("cradle." + key + ".last", velocity(all.back()).x(), "m/s");
        report.number("cradle." + key + ".off", off, "m/s");
        report.number("cradle." + key + ".energy", kinetic_energy(all), "J");
        report.number("cradle." + key + ".momentum", total_momentum(all).x(), "kg m/s");
        table.add(cells);
    };
    const Cradle scene;
    auto one = scene.start(), once = scene.start();
    const long impacts = collide_one_after_another(one, scene.touches(), scene.restitution);
    collide_at_once(once, scene.touches(), scene.restitution);
    Balls gaps = scene.with_gaps();
    fly_by_events(gaps, 1);
    row("one after another", "one", one);
    row("2 cm gaps", "gaps", gaps.all);
    row("all at once", "once", once);
    report.print(table);
    report.number("cradle.impacts", static_cast<double>(impacts));
}

}  // namespace nutshell
