// Impacts with levers: a spinning ball, a rod on its end, and who gains energy.
#include <nutshell/chart/chart.hpp>
#include <nutshell/chart/diagram.hpp>
#include <nutshell/rest_scenes.hpp>
#include <nutshell/spin_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

constexpr double degrees = 180 / pi;

chart::Place seen(const Vector3& v, double scale = 1) {
    return {scale * v.x(), scale * v.y()};
}

Contact contact_of(const FallingRod& scene) {
    std::vector<Contact> found;
    find_contacts(Plane{}, scene.shape, scene.rod(), 1e-9, found);
    return found.at(0);
}

/// Two bodies that touch: point, normal, levers, impulse and its opposite, what it turns.
void lever_diagram(lab::Report& report) {
    const double tilt = 0.3;
    const Vector3 touch(0, 0, 0), n(std::cos(tilt), std::sin(tilt), 0);
    chart::Diagram d;
    d.title = "Point, normal, levers: all that one impulse needs";
    d.subtitle = "Gold: the impulse on B and its opposite on A. Orange: how these turn the two.";
    // a box to the left whose corner meets the face of a box to the right
    const double right_turn = tilt, left_turn = tilt + 1.35;
    const Vector3 x(std::cos(right_turn), std::sin(right_turn), 0), y(-x.y(), x.x(), 0);
    const Vector3 u(std::cos(left_turn), std::sin(left_turn), 0), v(-u.y(), u.x(), 0);
    const Vector3 centre_b = 0.5 * x + 0.45 * y, centre_a = -0.55 * u + 0.4 * v;
    d.box(seen(centre_a), 1.1, 0.8, left_turn, "A")
        .box(seen(centre_b), 1.0, 1.5, right_turn, "B");
    d.centre(seen(centre_a)).centre(seen(centre_b));
    d.arrow(seen(centre_a), seen(Vector3(touch - centre_a)), chart::Quantity::plain,
            "lever of A");
    d.arrow(seen(centre_b), seen(Vector3(touch - centre_b)), chart::Quantity::plain,
            "lever of B");
    d.arrow(seen(touch), seen(n, 0.55), chart::Quantity::momentum, "J");
    d.arrow(seen(touch), seen(n, -0.55), chart::Quantity::momentum, "−J");
    const auto turning = [&](const Vector3& centre, const Vector3& J) {
        const double side = (touch - centre).cross(J).z() > 0 ? 1 : -1;
        d.arc(seen(centre), 0.22, pi / 2 - side * 1.2, pi / 2 + side * 1.2,
              chart::Quantity::torque, "");
    };
    turning(centre_a, -n), turning(centre_b, n);
    d.contact(seen(touch), seen(y, 0.0), "");
    chart::write_svg(d, report.path("levers.svg"));
}

/// The cone: what friction may do, and where the impulse that sticks lies for both balls.
void cone_diagram(lab::Report& report) {
    chart::Diagrams d;
    d.title = "Inside the cone it sticks, outside it slides";
    d.subtitle =
        "A ball with back-spin. Gold: the impulse; the other arrow: the one that would stick.";
    for (const double mu : {0.8, 0.1}) {
        const SpinningBall scene(mu);
        const Body before = scene.ball();
        Body floor = immovable_body();
        const Vector3 u = contact_velocity(floor, before, scene.contact()), n(0, 1, 0);
        const Matrix3 K = mobility(floor, before, scene.contact());
        const Vector3 J = clamped_impulse(K, u, n, scene.surface.restitution, mu);
        const Vector3 stick = -K.inverse() * (u + scene.surface.restitution * n.dot(u) * n);
        chart::Diagram one;
        one.title = "μ = " + lab::rounded(mu) + (mu > 0.5 ? ": sticks" : ": slides");
        const double scale = 0.25, top = 1.75;
        one.wall({-1.6, 0}, {1.6, 0});
        one.dashed({{-mu * top, top}, {0, 0}, {mu * top, top}});
        one.arrow({0, 0}, seen(stick, scale), chart::Quantity::plain,
                  mu > 0.5 ? "" : "would stick");
        one.arrow({0, 0}, seen(J, scale), chart::Quantity::momentum, "J");
        one.angle({0, 0}, 0.9, pi / 2 - std::atan(mu), pi / 2, "arctan μ");
        d.panels.push_back(one);
    }
    chart::write_svg(d, report.path("cone.svg"));
}

}  // namespace

void levers(lab::Report& report) {
    report.heading("Impacts with spin");
    lever_diagram(report);
    cone_diagram(report);
    lab::Table table{{"mu", "law", "v [m/s]", "up [m/s]", "spin [rad/s]", "contact slides [m/s]",
                      "energy kept"},
                     {}};
    for (const double mu : {0.2, 0.8}) {
        const SpinningBall scene(mu);
        const Body before = scene.ball();
        Body floor = immovable_body();
        each(impact_laws, [&](const ImpactLaw& law) {
            const Body after = scene.after(law);
            const double slides = contact_velocity(floor, after, scene.contact()).x(),
                         kept = kinetic_energy(after) / kinetic_energy(before);
            const std::string key = "ball." + law.key() + (mu > 0.5 ? ".sticks" : ".slides");
            report.number(key + ".v", velocity(after).x(), "m/s");
            report.number(key + ".up", velocity(after).y(), "m/s");
            report.number(key + ".spin", angular_velocity(after).z(), "rad/s");
            report.number(key + ".contact", slides, "m/s");
            report.number(key + ".kept", kept);
            table.add({lab::rounded(mu), law.name, lab::rounded(velocity(after).x()),
                       lab::rounded(velocity(after).y()),
                       lab::rounded(angular_velocity(after).z()), lab::rounded(slides),
                       lab::rounded(kept)});
        });
    }
    report.number(
        "ball.contact_before",
        contact_velocity(immovable_body(), SpinningBall().ball(), SpinningBall().contact()).x(),
        "m/s");
    report.print(table);
    const FallingRod rod;
    const Body fallen = rod.after(laws::clamped);
    const double end = 1 / mobility(immovable_body(), rod.rod(), contact_of(rod))(1, 1);
    report.number("rod.effective_mass", end, "kg");
    report.number("rod.up", velocity(fallen).y(), "m/s");
    report.number("rod.spin", angular_velocity(fallen).z(), "rad/s");
    report.number("rod.energy_off",
                  std::abs(kinetic_energy(fallen) / kinetic_energy(rod.rod()) - 1));
    report.say("A rod at 30 degrees answers at its end like " + lab::rounded(end) +
               " kg; it leaves at " + lab::rounded(velocity(fallen).y()) + " m/s and " +
               lab::rounded(angular_velocity(fallen).z()) + " rad/s");
}

void gaining(lab::Report& report) {
    report.heading("Who gains energy: a rough rod on its end, restitution 0.9");
    const FallingRod scene = FallingRod::rough();
    chart::Chart chart;
    chart.title = "A bounce that makes energy";
    chart.subtitle = "A turning rod on its end, 40° to the floor, restitution 0.9.";
    chart.x = {"coefficient of friction μ", chart::Scale::linear, 0, 1};
    chart.y = {"energy after / energy before", chart::Scale::linear, 0};
    chart.levels_y = {{1, "no more than before"}};
    const double before = kinetic_energy(scene.rod());
    each(impact_laws, [&](const ImpactLaw& law) {
        chart::Series series{law.name};
        series.look = law.look;
        series.draw = chart::Draw::line;
        double most = 0, at = 0;
        for (double mu = 0; mu < 1.001; mu += 0.01) {
            FallingRod rod = scene;
            rod.surface.friction = mu;
            const double kept = kinetic_energy(rod.after(law)) / before;
            series.x.push_back(mu), series.y.push_back(kept);
            if (kept > most) most = kept, at = mu;
        }
        report.number("gain." + law.key() + ".most", most);
        report.number("gain." + law.key() + ".at", at);
        report.number("gain." + law.key(), kinetic_energy(scene.after(law)) / before);
        report.say(std::string(law.name) + ": " +
                   lab::rounded(kinetic_energy(scene.after(law)) / before) +
                   " of the energy is there after the impact");
        chart.series.push_back(series);
    });
    // the worst of many rods of chance
    for (const double e : {0.9, 1.0}) {
        Dice dice(2);
        double worst[2] = {0, 0};
        for (int i = 0; i < 20000; ++i) {
            FallingRod rod;
            rod.slope = dice(0.02, pi / 2), rod.speed = dice(0, 1), rod.sideways = dice(-1, 1);
            rod.spin = dice(-6, 6), rod.surface = {e, dice(0, 1)};
            int k = 0;
            each(impact_laws, [&](const ImpactLaw& law) {
                const double gain = kinetic_energy(rod.after(law)) / kinetic_energy(rod.rod());
                worst[k] = std::max(worst[k], gain), ++k;
            });
        }
        const std::string key = e == 1 ? "gain.worst_elastic." : "gain.worst.";
        report.number(key + "clamped", worst[0]);
        report.number(key + "echo_off", worst[1] - 1);
        report.say("20 000 rods of chance, e = " + lab::rounded(e) + ": at most " +
                   lab::rounded(worst[0]) + " (clamped) and " + lab::rounded(worst[1]) +
                   " (echo)");
    }
    report.number("gain.slope", scene.slope * degrees, "degrees");
    report.draw("gain", chart);
}

}  // namespace nutshell
