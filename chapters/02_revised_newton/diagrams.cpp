// Diagrams of chapter 2, with the scenes' own numbers: an exchange of mass, four ropes on a ring.
#include <nutshell/chart/diagram.hpp>
#include <nutshell/revised_newton_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

using chart::Quantity;

/// From above: x to the right, z downwards.
chart::Place from_above(const Vector3& v, double scale = 1) {
    return {scale * v.x(), -scale * v.z()};
}

/// With a real minus sign.
std::string signed_words(double value) {
    return (value < 0 ? "−" : "") + lab::rounded(std::abs(value));
}

/// The chapter's question: the cart at the start and at the end, and a speed that is asked for.
void question(lab::Report& report) {
    const LeakyCart scene;
    const double metres_a_speed = 0.16;
    chart::Diagrams all;
    all.title = "Half of the cart's mass runs out. How fast is it then?";
    all.subtitle = "A frozen lake: no drag, no push. Blue: the velocity.";
    for (const double t : {0.0, scene.duration}) {
        const bool first = t == 0;
        chart::Diagram d;
        d.title = first ? "at the start" : lab::rounded(t) + " s later";
        const double load = 0.9 * (scene.mass(t) - 0.5);  // what the cart holds, as a height
        d.wall({-1.4, -0.72}, {2.4, -0.72});
        d.ball({-0.55, -0.52}, 0.2).ball({0.55, -0.52}, 0.2);
        d.polygon({{-0.9, -0.3}, {0.9, -0.3}, {0.9, load - 0.3}, {-0.9, load - 0.3}});
        for (int grain = 1; grain <= 3; ++grain) d.ball({0, -0.3 - 0.1 * grain}, 0.03);
        d.note({-0.3, load / 2 - 0.3}, lab::rounded(scene.mass(t)) + " kg");
        const double speed = velocity(scene.start).norm();
        if (first)
            d.arrow({0.9, 0.25}, {metres_a_speed * speed, 0}, chart::Quantity::velocity,
                    lab::rounded(speed) + " m/s");
        else
            d.note({1.2, 0.1}, "? m/s");
        all.panels.push_back(d);
    }
    all.width = 860;
    chart::write_svg(all, report.path("question.svg"));
}

/// One parcel leaves the rocket: the momenta before and after, and their sums.
void exchange_of_momentum(lab::Report& report) {
    Rocket scene;
    Particle rocket = scene.start;
    rocket.momentum = rocket.mass * Vector3(60, 0, 0);  // under way, so that all is seen to move
    const double parcel_mass = 2, metres_a_momentum = 0.004;
    const Particle before = rocket;
    const Particle parcel = eject(rocket, parcel_mass, scene.start.flow.velocity);
    const auto draw = [&](chart::Diagram& d, const Particle& body, double x, double width,
                          const std::string& name) {
        d.box({x, 0}, width, 0.5, 0, name + ", " + lab::rounded(body.mass) + " kg");
        d.arrow({x, -0.55}, {metres_a_momentum * body.momentum.x(), 0}, Quantity::momentum,
                signed_words(body.momentum.x()) + " kg m/s");
    };
    chart::Diagrams all;
    all.title = "What the parcel takes, the rocket gets: the sum stays";
    all.subtitle = "A rocket at 60 m/s throws a parcel backwards, " +
                   lab::rounded(scene.start.flow.velocity.norm()) +
                   " m/s slower than itself. Arrows: momentum.";
    chart::Diagram first, second;
    first.title = "Before: " + lab::rounded(before.momentum.x()) + " kg m/s";
    draw(first, before, 0, 1.5, "rocket");
    second.title = "After: " + signed_words(parcel.momentum.x()) + " + " +
                   lab::rounded(rocket.momentum.x()) + " = " +
                   lab::rounded(parcel.momentum.x() + rocket.momentum.x()) + " kg m/s";
    draw(second, rocket, 0.3, 1.2, "rocket");
    draw(second, parcel, -1.4, 0.4, "parcel");
    all.panels = {first, second};
    all.width = 860;
    chart::write_svg(all, report.path("exchange.svg"));
}

/// The ring and its ropes: the forces as they pull, and laid head to tail.
void ring_forces(lab::Report& report) {
    const ManyForces scene;
    const double metres_a_newton = 1.0 / 100;
    Vector3 net = Vector3::Zero();
    chart::Diagrams all;
    chart::Diagram pulls, sum;
    pulls.title = "As they pull";
    pulls.ball({0, 0}, 0.25);
    sum.title = "Head to tail";
    for (std::size_t i = 0; i < scene.ropes.size(); ++i) {
        const Vector3& force = scene.ropes[i];
        const std::string words = lab::rounded(force.norm(), "%.0f") + " N";
        pulls.arrow({0, 0}, from_above(force, metres_a_newton), Quantity::force, words);
        sum.arrow(from_above(net, metres_a_newton), from_above(force, metres_a_newton),
                  Quantity::force, "");
        net += force;
    }
    sum.dashed({{0, 0}, from_above(net, metres_a_newton)});
    sum.note(from_above(net, metres_a_newton), "the sum: " + lab::rounded(net.norm()) + " N");
    all.title = "Four ropes pull hard, and nearly nothing is left";
    all.subtitle = "A ring on ice, from above; 1 m is 100 N.";
    all.panels = {pulls, sum};
    all.width = 860;
    chart::write_svg(all, report.path("ring_forces.svg"));
}

}  // namespace

void diagrams(lab::Report& report) {
    question(report);
    exchange_of_momentum(report);
    ring_forces(report);
}

}  // namespace nutshell
