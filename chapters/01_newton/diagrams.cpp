// Free-body diagrams of chapter 1, with the scenes' own numbers; and where five machines' balls
// land.
#include <nutshell/chart/chart.hpp>
#include <nutshell/chart/diagram.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/newton_scenes.hpp>
#include <nutshell/sentence.hpp>
#include "frames.hpp"
#include "program.hpp"

namespace nutshell {

namespace {

chart::Place seen(const Vector3& v, double scale = 1) {
    return {scale * v.x(), scale * v.y()};
}

/// The thrown ball at three moments: the velocity turns, the force does not.
void throw_forces(lab::Report& report) {
    const ThrownBall scene;
    const double metres_a_newton = 0.4, metres_a_speed = 0.35;
    chart::Diagram d;
    d.title = "One force all the way, and it never changes";
    d.subtitle = "The thrown ball after 0.3, 1.5 and 2.8 s. Orange: the force, its weight, " +
                 lab::rounded((scene.start.mass * gravity).norm()) + " N. Blue: the velocity.";
    std::vector<chart::Place> arc;
    for (int i = 0; i <= 60; ++i) arc.push_back(seen(scene.exact(0.05 * i).position));
    d.path(arc);
    for (const double t : {0.3, 1.5, 2.8}) {
        const PointMass ball = scene.exact(t);
        const bool first = t < 1;
        d.ball(seen(ball.position), 0.45);
        d.arrow(seen(ball.position), seen(scene(ball, t), metres_a_newton),
                chart::Quantity::force, first ? "F = m g" : "");
        d.arrow(seen(ball.position), seen(ball.velocity, metres_a_speed),
                chart::Quantity::velocity, first ? "v" : "");
    }
    chart::write_svg(d, report.path("throw_forces.svg"));
}

/// The chapter's question: one throw as three machines draw it, each picture a step.
void question(lab::Report& report) {
    const ThrownBall scene;
    const double shown = 0.15;  // [s]
    chart::Diagrams all;
    all.title = "One throw, three machines: do they agree where it lands?";
    all.subtitle = "The ball at every picture of its first " + lab::rounded(shown) +
                   " s, each one step of physics after the last.";
    for (const int rate : {30, 60, 144}) {
        chart::Diagram d;
        d.title = std::to_string(rate) + " pictures a second";
        for (int i = 0; i <= static_cast<int>(shown * rate); ++i)
            d.ball(seen(scene.exact(static_cast<double>(i) / rate).position), 0.07);
        d.arrow(seen(scene.start.position), seen(scene.start.velocity, 0.1),
                chart::Quantity::velocity, "v");
        d.wall({-0.3, -0.12}, {3.6, -0.12});
        d.note({3.1, 0.3}, "?");
        all.panels.push_back(d);
    }
    all.width = 860;
    chart::write_svg(all, report.path("question.svg"));
}

/// The planet at four places of its ellipse: the force points at the sun and is strong near it.
void planet_forces(lab::Report& report) {
    const Planet scene;
    const double length_a_force = 0.115, length_a_speed = 0.3;
    chart::Diagram d;
    const double near = scene(scene.exact(0), 0).norm(), far = scene(scene.exact(pi), pi).norm();
    d.title = "The force points at the sun: " + lab::rounded(near / far) +
              " times stronger near it than far away";
    d.subtitle = "The planet at four times. Orange: the force. Blue: the velocity.";
    std::vector<chart::Place> orbit;
    for (int i = 0; i <= 100; ++i) orbit.push_back(seen(scene.exact(2 * pi * i / 100).position));
    d.path(orbit).ball({0, 0}, 0.07, "sun");
    for (const double year : {0.0, 0.14, 0.5, 0.8}) {
        const PointMass planet = scene.exact(2 * pi * year);
        d.ball(seen(planet.position), 0.035);
        d.arrow(seen(planet.position), seen(scene(planet, 0), length_a_force),
                chart::Quantity::force, year == 0.14 ? "F" : "");
        d.arrow(seen(planet.position), seen(planet.velocity, length_a_speed),
                chart::Quantity::velocity, year == 0.14 ? "v" : "");
    }
    chart::write_svg(d, report.path("planet_forces.svg"));
}

/// The axis of Verlet's ellipse turns: the first orbit and the twentieth, and the angle between.
void tilted_ellipse(lab::Report& report) {
    const Planet scene = Planet::for_orbits(20);
    const long steps = 100;  // an orbit
    std::vector<chart::Place> first, last;
    chart::Place far_first, far_last;
    const double dt = 2 * pi / static_cast<double>(steps);
    PointMass planet = scene.start;
    double longest_first = 0, longest_last = 0;
    // Verlet's year is a little longer: drawn are 1.06 exact ones, so that the curves close
    const long drawn = steps + steps * 6 / 100;
    for (long n = 0; n <= 19 * steps + drawn; ++n) {
        const double r = planet.position.norm();
        if (n <= drawn) {
            first.push_back(seen(planet.position));
            if (r > longest_first) longest_first = r, far_first = first.back();
        }
        if (n >= 19 * steps) {
            last.push_back(seen(planet.position));
            if (r > longest_last) longest_last = r, far_last = last.back();
        }
        planet = verlet(planet, scene, static_cast<double>(n) * dt, dt);
    }
    chart::Diagram d;
    double turned = std::atan2(far_last.y, far_last.x) - std::atan2(far_first.y, far_first.x);
    turned = std::remainder(turned, 2 * pi);
    report.number("planet.twenty_years.turned", turned, "rad", "tilted_ellipse.svg");
    d.title = sentence("{} keeps the ellipse and turns it: ", methods::verlet) +
              lab::rounded(std::abs(turned) * 180 / pi, "%.0f") + "° in 19 years";
    d.subtitle = "Planet, " + std::to_string(steps) +
                 " steps a year. Dotted: the first year. Dashed: the twentieth.";
    d.path(first).dashed(last).ball({0, 0}, 0.06, "sun");
    const double from = std::atan2(far_first.y, far_first.x);
    d.rod({0, 0}, far_first).rod({0, 0}, far_last);
    d.arc({0, 0}, 0.9, from, from + turned, chart::Quantity::angular_velocity, "the axis turns");
    chart::write_svg(d, report.path("tilted_ellipse.svg"));
}

/// Five machines throw one ball, one step a frame: the whole arcs, and where each comes down.
void landing(lab::Report& report) {
    const ThrownBall scene;
    const double flight = -2 * scene.start.velocity.y() / gravity.y();
    const double exact = scene.exact(flight).position.x();
    chart::Figure figure;
    figure.title = "Five machines, one throw, five places to land";
    figure.subtitle =
        phrase("One step of {}, as long as each frame.", methods::semi_implicit_euler);
    chart::Chart arcs;
    arcs.title = "The whole throw";
    arcs.x = {"distance [m]", chart::Scale::linear, 0, 32};
    arcs.y = {"height [m]", chart::Scale::linear, 0, 13};
    arcs.equal_aspect = true, arcs.cut = true;
    chart::Chart marks;
    marks.title = "Where it comes down";
    marks.x = {"metres short of the exact place, " + lab::rounded(exact, "%.2f") + " m"};
    for (const Machine& machine : machines()) {
        chart::Series arc{machine.label};
        arc.draw = chart::Draw::line;
        Vector3 before = scene.start.position;
        double lands = scene.start.position.x();
        play(machine, [&](const Shown& shown) {
            const Vector3& here = shown.following;
            arc.x.push_back(here.x()), arc.y.push_back(here.y());
            if (here.y() > 0)  // the last way down, carried on to the ground
                lands = here.x() + (here.x() - before.x()) * here.y() /
                                       std::max(before.y() - here.y(), 1e-300);
            before = here;
        });
        report.number("landing." + std::to_string(marks.bars.size()) + ".short", exact - lands,
                      "m", "landing.svg");
        arcs.series.push_back(std::move(arc));
        chart::Bar bar{machine.name, exact - lands};
        bar.text = lab::rounded(exact - lands, "%.2f") + " m";
        marks.bars.push_back(bar);
    }
    figure.panels = {arcs, marks};
    chart::write_svg(figure, report.path("landing.svg"));
}

}  // namespace

void diagrams(lab::Report& report) {
    question(report);
    throw_forces(report);
    planet_forces(report);
    tilted_ellipse(report);
    landing(report);
}

}  // namespace nutshell
