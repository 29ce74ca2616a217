// Diagrams of chapter 6's first half, with the scenes' own numbers.
#include <nutshell/chart/diagram.hpp>
#include <nutshell/pendulum_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

using chart::Diagram;
using chart::Quantity;

/// The same force at the end of the same bar, in three directions: what turns is the part across.
void torque(lab::Report& report) {
    const double force = 10, arm = 1;  // [N], [m]
    const double metres_a_newton = 0.055;
    chart::Diagrams all;
    all.title = "Only the part of a force across the bar turns it";
    all.subtitle = "A bar of 1 m on a pivot, a force of 10 N. Dashed: the part across.";
    all.width = 900;
    for (const double degrees : {90., 30., 0.}) {
        const double angle = degrees * pi / 180;
        const Vector3 F = force * Vector3(std::cos(angle), std::sin(angle), 0);
        const double tau = force_at(F, {arm, 0, 0}).torque.z();
        Diagram d;
        d.title = degrees == 90  ? "across the bar"
                  : degrees == 0 ? "along the bar"
                                 : "30° off it";
        d.subtitle = "τ = " + lab::rounded(tau) + " N m";
        d.rod({0, 0}, {arm, 0}).ball({0, 0}, 0.03);
        if (degrees == 30) d.dashed({{arm, 0}, {arm, metres_a_newton * F.y()}});
        d.arrow({arm, 0}, {metres_a_newton * F.x(), metres_a_newton * F.y()}, Quantity::force,
                "F");
        if (tau > 0) d.arc({0, 0}, 0.3, 0.15, 0.15 + 0.16 * tau, Quantity::torque, "τ");
        d.dimension({0, -0.16}, {arm, -0.16}, "r = 1 m");
        all.panels.push_back(d);
    }
    chart::write_svg(all, report.path("torque.svg"));
}

/// The pendulum at 50 degrees: the weight, its arm, and how long the arm across it is.
void pendulum_forces(lab::Report& report) {
    const Pendulum scene = rod_pendulum(50 * pi / 180);
    const Vector3 bob = rotate(scene.start.orientation, {0, -scene.distance, 0});
    const double torque = scene(scene.start, 0).torque.z();
    Diagram d;
    d.title = "The weight turns the pendulum back";
    d.subtitle = "1 kg on a rod of 1 m, at 50°: m g r sin θ = " + lab::rounded(-torque, "%.2f") +
                 " N m, clockwise.";
    d.wall({0.25, 0}, {-0.25, 0});
    d.dashed({{0, 0}, {0, -1.15}});
    d.rod({0, 0}, {bob.x(), bob.y()}).ball({bob.x(), bob.y()}, 0.07);
    d.arrow({bob.x(), bob.y()}, {0, -0.5}, Quantity::force, "m g");
    d.angle({0, 0}, 0.35, -pi / 2, -pi / 2 + scene.angle, "θ");
    d.dimension({0, -1.3}, {bob.x(), -1.3}, "r sin θ");
    d.arc({0, 0}, 0.62, -pi / 2 + scene.angle - 0.1, -pi / 2 + 0.25, Quantity::torque, "τ");
    chart::write_svg(d, report.path("pendulum_forces.svg"));
    report.number("diagram.pendulum.torque", torque, "N m");
}

/// A particle that goes round the upright axis: what counts is its distance from the axis.
void particles(lab::Report& report) {
    const double degrees = 40, angle = degrees * pi / 180, r = 1;
    const Vector3 place = r * Vector3(std::cos(angle), std::sin(angle), 0), omega(0, 1, 0);
    const Matrix3 I = point_inertia(1, place);
    const Vector3 L = I * omega;
    Diagram d;
    d.title = "L need not point along ω";
    d.subtitle =
        "One particle of 1 kg at r = 1 m, 40° above the level; it turns about the "
        "dashed axis.";
    d.dashed({{0, -0.2}, {0, 1.2}});
    d.rod({0, 0}, {place.x(), place.y()}).ball({place.x(), place.y()}, 0.06);
    d.arrow({0, 0}, {0, 1}, Quantity::angular_velocity, "ω");
    d.arrow({0, 0}, {L.x(), L.y()}, Quantity::angular_momentum, "L");
    d.dimension({0, -0.28}, {place.x(), -0.28}, "distance from the axis");
    report.number("diagram.particle.along", L.y(), "kg m^2/s");
    report.number("diagram.particle.across", L.x(), "kg m^2/s");
    report.number("diagram.particle.printed", r * r, "kg m^2/s");
    chart::write_svg(d, report.path("particle.svg"));
}

/// Turn L into the body, divide by its own moments, turn back.
void there_and_back(lab::Report& report) {
    const double angle = 35 * pi / 180;
    const Quaternion q = exponential({0, 0, angle});
    const Vector3 inertia(0.4, 1.2, 1.6);  // a bar along its own x
    const Vector3 L(0.22, 0.82, 0), own = rotate(inverse(q), L);
    const Vector3 omega = own.cwiseQuotient(inertia), back = rotate(q, omega);
    const double metres_a_radian = 0.6;
    chart::Diagrams all;
    all.title = "In its own axes the body only divides";
    all.subtitle =
        "A bar turned by 35°; its moments are 0.4 kg m² about its length and 1.2 "
        "across.";
    all.width = 900;
    const auto panel = [&](const std::string& title, double turned, const Vector3* L_shown,
                           const Vector3* omega_shown) {
        Diagram d;
        d.title = title;
        d.box({0, 0}, 1.3, 0.26, turned);
        d.axes({0, 0}, turned, 0.55);
        if (L_shown != nullptr)
            d.arrow({0, 0}, {L_shown->x(), L_shown->y()}, Quantity::angular_momentum, "L");
        if (omega_shown != nullptr)
            d.arrow({0, 0},
                    {metres_a_radian * omega_shown->x(), metres_a_radian * omega_shown->y()},
                    Quantity::angular_velocity, "ω");
        all.panels.push_back(d);
    };
    panel("L in the world", angle, &L, nullptr);
    panel("Rᵀ: seen from the body; divide", 0, &own, &omega);
    panel("R: ω in the world", angle, &L, &back);
    chart::write_svg(all, report.path("there_and_back.svg"));
}

/// A particle of a body, seen from the centre of mass and from another point.
void parallel(lab::Report& report) {
    Diagram d;
    d.title = "The mixed terms cancel, two squares remain";
    d.subtitle = "A particle seen from the centre of mass and from a point A.";
    const chart::Place centre{0, 0}, point{-1.3, -0.35}, particle{0.45, 0.35};
    d.polygon({{-0.9, -0.5},
               {0.1, -0.75},
               {1.0, -0.4},
               {1.05, 0.35},
               {0.5, 0.75},
               {-0.5, 0.6},
               {-1.0, 0.15}});
    d.dashed({point, particle});
    d.centre(centre);
    d.ball(particle, 0.05);
    d.arrow(centre, {particle.x - centre.x, particle.y - centre.y}, Quantity::plain, "x");
    d.arrow(point, {centre.x - point.x, centre.y - point.y}, Quantity::plain, "c");
    d.note({point.x - 0.1, point.y - 0.12}, "A");
    chart::write_svg(d, report.path("parallel.svg"));
}

}  // namespace

void diagrams(lab::Report& report) {
    torque(report);
    pendulum_forces(report);
    particles(report);
    there_and_back(report);
    parallel(report);
}

}  // namespace nutshell
