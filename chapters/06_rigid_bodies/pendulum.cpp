// Pendulums: the period at any angle, what each method needs, and Verlet's limit.
#include <nutshell/lab/need_chart.hpp>
#include <nutshell/lab/stability.hpp>
#include <nutshell/pendulum_scenes.hpp>
#include <nutshell/rigid_methods.hpp>
#include <nutshell/sentence.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

constexpr double degree = pi / 180;

const auto pendulum_methods = lab::entries<Pendulum>(
    std::tuple{methods::euler, methods::semi_implicit_euler, methods::verlet, methods::yoshida4,
               methods::kahan_li8, methods::explicit_midpoint, methods::rk4,
               methods::dormand_prince, methods::lie_rk4});

/// When the pendulum first hangs [s]: a quarter of its period.
double first_at_bottom(const Pendulum& scene) {
    return pendulum_period(scene.length(), scene.angle) / 4;
}

void period(lab::Report& report) {
    report.heading("Pendulum on a rod of 1 m: its period");
    lab::Table table{{"let go at [degrees]", "period [s]", "of small swings", "found by a run"},
                     {}};
    const double small = pendulum_period(1, 0);
    report.number("period.small", small, "s");
    for (const double degrees : {5, 30, 60, 90, 120, 150, 170, 179}) {
        const Pendulum scene = rod_pendulum(degrees * degree);
        const double exact = pendulum_period(1, scene.angle);
        // the first time it hangs is a quarter of the period: where the angle changes its sign
        double before = scene.angle, crossed = 0;
        const double dt = exact / 4000;
        Pinned body = scene.start;
        auto step = methods::yoshida4.start(scene);
        for (int n = 1; crossed == 0; ++n) {
            body = step(body, scene, 0.0, dt);
            const double now = scene.angle_of(body);
            if (now <= 0) crossed = (n - now / (now - before)) * dt;
            before = now;
        }
        table.add({lab::rounded(degrees), lab::rounded(exact, "%.6f"),
                   lab::rounded(exact / small, "%.4f"), lab::rounded(4 * crossed, "%.6f")});
        const std::string key = "period." + lab::rounded(degrees);
        report.number(key, exact, "s");
        report.number(key + ".ratio", exact / small);
        report.number(key + ".found_off", std::abs(4 * crossed / exact - 1));
    }
    report.print(table);
}

void race(lab::Report& report) {
    const Pendulum bob = rod_pendulum(pi / 2), rod = compound_pendulum(pi / 2);
    report.heading("A bob on a rod of 1 m, and a rod of 1 m: who hangs first?");
    report.number("race.bob", first_at_bottom(bob), "s");
    report.number("race.rod", first_at_bottom(rod), "s");
    report.number("race.gain", 1 - first_at_bottom(rod) / first_at_bottom(bob));
    report.number("race.length", rod.length(), "m");
    report.number("race.inertia.bob", bob.start.inertia.z(), "kg m^2");
    report.number("race.inertia.rod", rod.start.inertia.z(), "kg m^2");
    report.number("race.torque.bob", std::abs(bob(bob.start, 0).torque.z()), "N m");
    report.number("race.torque.rod", std::abs(rod(rod.start, 0).torque.z()), "N m");
    report.say("The bob hangs after " + lab::rounded(first_at_bottom(bob), "%.3f") +
               " s, the rod after " + lab::rounded(first_at_bottom(rod), "%.3f") + " s.");
}

void limit(lab::Report& report) {
    report.heading(sentence("{}'s largest step on a hanging body", methods::verlet));
    lab::Table table{{"pendulum", "length [m]", "predicted [s]", "found [s]", "off"}, {}};
    chart::Chart chart;
    chart.title = phrase("The largest step that {} bears", methods::verlet);
    chart.subtitle = "Bodies that hang and swing a little. Dashed: 2/ω; marks: found by runs.";
    chart.x = {"length of the equal pendulum, I/(m r) [m]", chart::Scale::logarithmic};
    chart.y = {"largest stable step [s]", chart::Scale::logarithmic};
    chart::Series law{"2/ω"}, rods{"uniform rods"}, bobs{"bobs"};
    law.draw = chart::Draw::theory, rods.draw = bobs.draw = chart::Draw::marks;
    rods.look = methods::verlet.look, bobs.look = variant(methods::verlet.look);
    double worst = 0;
    const auto one = [&](const Pendulum& scene, chart::Series& series) {
        const double predicted = pendulum_verlet_limit(scene.omega());
        const auto stable = [&](double dt) {
            return lab::stays_within(
                scene, methods::verlet, dt, 2000, 1e-3,
                [&](const Pinned& body) { return std::abs(scene.angle_of(body)); });
        };
        const double found = lab::stability_limit(stable, predicted / 2, 1.5 * predicted);
        worst = std::max(worst, std::abs(found / predicted - 1));
        series.x.push_back(scene.length()), series.y.push_back(found);
        return found;
    };
    for (const double length : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0}) {
        const double omega_start = 1e-6;  // [rad]: a swing so small that its equation is linear
        const Vector3 own = cylinder_inertia(1, 0.01 * length, length);
        const Vector3 about_end =
            Vector3(own.x(), own.z(), own.y()) + parallel_axis(1, {0, length / 2, 0}).diagonal();
        const Pendulum rod("rod of " + lab::rounded(length) + " m", 1, length / 2, about_end,
                           omega_start);
        const Pendulum bob("bob at " + lab::rounded(length) + " m", 1, length,
                           {length * length, 1e-3 * length * length, length * length},
                           omega_start);
        for (const Pendulum* scene : {&bob, &rod}) {
            const double predicted = pendulum_verlet_limit(scene->omega());
            const double found = one(*scene, scene == &bob ? bobs : rods);
            table.add({scene->name, lab::rounded(scene->length()),
                       lab::rounded(predicted, "%.5f"), lab::rounded(found, "%.5f"),
                       lab::rounded(found / predicted - 1, "%.1e")});
            if (length == 1) {
                const std::string key = scene == &bob ? "limit.bob" : "limit.rod";
                report.number(key + ".predicted", predicted, "s");
                report.number(key + ".found", found, "s");
            }
        }
    }
    for (double l = 0.05; l < 6; l *= 1.2)
        law.x.push_back(l), law.y.push_back(pendulum_verlet_limit(std::sqrt(-gravity.y() / l)));
    report.number("limit.off", worst);
    report.print(table);
    chart.series = {law, bobs, rods};
    chart::write_svg(chart, report.path("pendulum_limit.svg"));
}

}  // namespace

void pendulum(lab::Report& report) {
    period(report);
    race(report);
    limit(report);

    const Pendulum scene = compound_pendulum(pi / 2);
    report.heading("Compound pendulum: a rod of 1 m let go at 90 degrees, three periods");
    const auto least = lab::least_of_each(scene, pendulum_methods, 6, 400'000);
    lab::report_least(report, "pendulum", least, scene.need);
    const auto curves = lab::work_precision(
        scene, pendulum_methods, {12, 24, 48, 68, 96, 192, 384, 768, 1536, 3072, 6144});
    lab::draw_study(report,
                    {"pendulum",
                     "A rod of 1 m on a pivot, let go at 90°, three periods.",
                     "High order wins where the need is strict",
                     {-1, -2, -4, -8},
                     "",
                     "evaluations of the torque"},
                    curves, least, scene.need);
    lab::Table orders{{"method", "order", "ns a step"}, {}};
    for (const auto& method : pendulum_methods) {
        std::vector<double> dts, errors;
        for (long n = 24; n <= 200'000; n *= 2) {  // the steepest part, before round-off
            const auto m = method.measure(scene, n);
            if (m.max_error < 1e-11) break;
            dts.push_back(m.dt), errors.push_back(m.max_error);
            if (dts.size() > 3) dts.erase(dts.begin()), errors.erase(errors.begin());
        }
        const double order = lab::observed_order(dts, errors);
        const double ns = method.seconds(scene, 1000) * 1e6;
        orders.add({method.name, lab::rounded(order, "%.2f"), lab::rounded(ns, "%.0f")});
        report.number("pendulum." + key_of(method.name) + ".order", order);
        report.number("pendulum." + key_of(method.name) + ".ns", ns, "ns");
    }
    report.print(orders);
}

}  // namespace nutshell
