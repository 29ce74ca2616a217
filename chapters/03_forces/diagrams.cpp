// Free-body diagrams of chapter 3, with the scenes' own numbers: spring, drag, a mass of a chain.
#include <nutshell/chart/diagram.hpp>
#include <nutshell/forces_methods.hpp>
#include <nutshell/forces_scenes.hpp>
#include <nutshell/hanging_chain.hpp>
#include <nutshell/lab/looks.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

using chart::Quantity;

/// A mass on a spring with a rest length: pulled out, at rest, pushed in.
void spring_forces(lab::Report& report) {
    const Spring spring{40, 0.8};  // [N/m], [m]
    const double metres_a_newton = 0.03;
    chart::Diagrams all;
    all.title = "A spring pulls when it is long and pushes when it is short";
    all.subtitle = "κ = " + lab::rounded(spring.stiffness) +
                   " N/m, rest length l₀ = " + lab::rounded(spring.rest_length) +
                   " m. Orange: the force on the mass.";
    for (const double length : {1.2, 0.8, 0.5}) {
        chart::Diagram d;
        const double force =
            spring_force(spring, {length, 0, 0}, Vector3::Zero()).x();  // on the mass
        d.title = "l = " + lab::rounded(length) + " m: " +
                  (force == 0 ? std::string("no force")
                              : lab::rounded(std::abs(force)) + " N " +
                                    (force < 0 ? "inwards" : "outwards"));
        d.wall({0, 0.18}, {0, -0.18}).spring({0, 0}, {length, 0}, 7, 0.14);
        d.dashed({{spring.rest_length, 0.2}, {spring.rest_length, -0.24}});
        d.ball({length, 0}, 0.08);
        d.arrow({length, 0}, {metres_a_newton * force, 0}, Quantity::force, "F");
        d.dimension({0, -0.26}, {spring.rest_length, -0.26}, "l₀");
        all.panels.push_back(d);
    }
    all.width = 900;
    chart::write_svg(all, report.path("spring_forces.svg"));
}

/// The fall with linear drag: it grows with the speed until it carries the weight.
void drag_forces(lab::Report& report) {
    const FallingWithDrag scene;
    const double metres_a_newton = 0.1, metres_a_speed = 0.05;
    chart::Diagrams all;
    all.title = "Drag grows with the speed until it carries the weight";
    all.subtitle = "A body falls, γ = " + lab::rounded(scene.drag) +
                   " kg/s. Orange: forces, 1 m is 10 N. Blue: the velocity.";
    for (const double t : {0.0, 1.0, scene.duration}) {
        const PointMass body = scene.exact(t);
        const Vector3 weight = gravity_force(body.mass),
                      drag = linear_drag_force(scene.drag, body.velocity);
        chart::Diagram d;
        d.title = t == 0 ? "let go" : "after " + lab::rounded(t) + " s";
        d.subtitle = lab::rounded(body.velocity.norm(), "%.1f") + " m/s";
        d.ball({0, 0}, 0.14);
        d.arrow({0, 0}, {0, metres_a_newton * weight.y()}, Quantity::force, "m g");
        d.arrow({0, 0}, {0, metres_a_newton * drag.y()}, Quantity::force, "−γ v");
        d.arrow({0.55, 0}, {0, metres_a_speed * body.velocity.y()}, Quantity::velocity, "v");
        all.panels.push_back(d);
    }
    chart::write_svg(all, report.path("drag_forces.svg"));
}

/// A chain of three masses at rest: the forces on one of them balance.
void chain_forces(lab::Report& report) {
    HangingChain chain{3, 0.5, {60, 0.45}, {1.5, 0}};
    const auto tension = end_tension([&](const EndTension& at) { return reach(chain, at); },
                                     chain.end, {5, 1.5 * chain.mass * chain.g});
    const double metres_a_newton = 0.05;
    chart::Diagram d;
    d.title = "Two links and the weight: at rest they cancel";
    d.subtitle = "A hanging chain of three masses of " + lab::rounded(chain.mass) +
                 " kg. Orange: the forces on the second, 1 m is 20 N.";
    Vector2 at = Vector2::Zero(), second = at;
    std::vector<Vector2> pulls;
    d.wall({0.12, 0}, {-0.12, 0}).wall({chain.end.x() + 0.12, 0}, {chain.end.x() - 0.12, 0});
    EndTension link = tension;
    for (std::size_t i = 0; i <= chain.masses; ++i) {
        link.vertical = tension.vertical - static_cast<double>(i) * chain.mass * chain.g;
        const Vector2 next = at + hanging_link(chain.link, link);
        d.spring({at.x(), at.y()}, {next.x(), next.y()}, 6, 0.06);
        if (i < chain.masses) d.ball({next.x(), next.y()}, 0.05);
        if (i == 1) second = next, pulls.push_back({-link.horizontal, link.vertical});
        if (i == 2) pulls.push_back({link.horizontal, -link.vertical});
        at = next;
    }
    const auto force = [&](const Vector2& F, const std::string& name) {
        d.arrow({second.x(), second.y()}, {metres_a_newton * F.x(), metres_a_newton * F.y()},
                Quantity::force, name);
    };
    const Vector2 weight(0, -chain.mass * chain.g);
    force(pulls[0], "left link, " + lab::rounded(pulls[0].norm(), "%.1f") + " N");
    force(pulls[1], "right link, " + lab::rounded(pulls[1].norm(), "%.1f") + " N");
    force(weight, "weight, " + lab::rounded(weight.norm(), "%.1f") + " N");
    report.number("chain.diagram.sum", (pulls[0] + pulls[1] + weight).norm(), "N",
                  "chain_forces.svg");
    chart::write_svg(d, report.path("chain_forces.svg"));
}

}  // namespace

void diagrams(lab::Report& report) {
    spring_forces(report);
    drag_forces(report);
    chain_forces(report);
    chart::write_svg(lab::looks(forces_methods, "Methods that move points: chapters 1 to 3"),
                     report.path("methods.svg"));
}

}  // namespace nutshell
