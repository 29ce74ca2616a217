// The planet: Euler spirals out, the symplectic methods turn.
#include <nutshell/apsides.hpp>
#include <nutshell/lab/need_chart.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/newton_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

constexpr long steps_an_orbit = 500;

const auto entries = lab::entries<Planet>(newton_methods);

/// What the page says of one method, over 20 orbits.
struct History {
    std::string name, key;
    Look look;
    std::vector<double> orbits, energy, momentum;  // relative changes, against time in orbits
    double largest_energy = 0, largest_momentum = 0, turn = 0;
    double tilt =
        0;  // of the first ellipse: direction of the first aphelion, against the exact one [rad]
    double year = 0;  // its length over the exact one, minus 1
};

template <class Method>
History history_of(const Method& method) {
    const Planet scene = Planet::for_orbits(21);
    const double energy = scene.energy(scene.start);
    const Vector3 momentum = angular_momentum(scene.start);
    History h{method.name, method.key(), method.look, {}, {}, {}};
    Aphelia aphelia;
    lab::run(scene, method, 21 * steps_an_orbit, [&](const PointMass& planet, double t) {
        const double energy_change = (scene.energy(planet) - energy) / std::abs(energy);
        const double momentum_change =
            (angular_momentum(planet) - momentum).norm() / momentum.norm();
        h.orbits.push_back(t / (2 * pi)), h.energy.push_back(energy_change),
            h.momentum.push_back(momentum_change);
        h.largest_energy = std::max(h.largest_energy, std::abs(energy_change));
        h.largest_momentum = std::max(h.largest_momentum, momentum_change);
        aphelia.look(planet.position);
    });
    if (h.key == "euler") return h;
    h.turn = aphelia.turn_per_orbit();
    h.tilt = std::remainder(aphelia.angles.front() - pi, 2 * pi) -
             h.turn / 2;  // half a turn belongs to the first half year
    h.year = aphelia.samples_per_orbit() / steps_an_orbit - 1;
    return h;
}

void conservation(lab::Report& report) {
    const std::vector<History> histories{history_of(methods::euler),
                                         history_of(methods::semi_implicit_euler),
                                         history_of(methods::verlet)};
    lab::Table table{{"method", "energy, largest change", "angular momentum, largest change",
                      "axis turns [rad/orbit]"},
                     {}};
    lab::Table data{{"orbits", "method", "energy_change", "angular_momentum_change"}, {}};
    chart::Chart energy;
    energy.title = "Euler's energy jumps away; the other two come back";
    energy.subtitle = "Planet, e = 0.6, " + std::to_string(steps_an_orbit) + " steps a year.";
    energy.x = {"years", chart::Scale::linear, 0, 5};
    energy.y = {"relative change of the energy", chart::Scale::linear, -0.1, 0.5};
    for (const auto& h : histories) {
        table.add({h.name, lab::rounded(h.largest_energy), lab::rounded(h.largest_momentum),
                   h.key == "euler" ? "-" : lab::rounded(h.turn, "%.5f")});
        report.number("planet." + h.key + ".energy_change", h.largest_energy);
        report.number("planet." + h.key + ".momentum_change", h.largest_momentum);
        if (h.key != "euler") {
            report.number("planet." + h.key + ".turn", h.turn, "rad");
            report.number("planet." + h.key + ".tilt", h.tilt, "rad");
            report.number("planet." + h.key + ".year_too_long", h.year);
        }
        for (std::size_t i = 0; i < h.orbits.size(); i += 10)
            data.add({lab::exact_digits(h.orbits[i]), h.name, lab::exact_digits(h.energy[i]),
                      lab::exact_digits(h.momentum[i])});
        chart::Series series{h.name};
        series.look = h.look;
        for (std::size_t i = 0; i < h.orbits.size() && h.orbits[i] <= 5; ++i)
            series.x.push_back(h.orbits[i]), series.y.push_back(h.energy[i]);
        series.draw = chart::Draw::line;
        energy.series.push_back(std::move(series));
    }
    report.number("planet.energy_ratio",
                  histories[1].largest_energy / histories[2].largest_energy);
    report.print(table);
    report.data("planet_conservation.csv", data);
    chart::write_svg(energy, report.path("planet_energy.svg"));
}

void orders(lab::Report& report) {
    const Planet scene;
    lab::Table table{{"method", "order by largest error", "order by error after whole orbits"},
                     {}};
    chart::Chart chart;
    chart.title = "A first-order method in a second-order coat";
    chart.subtitle =
        "Planet, one orbit: the largest error on the way, and the error at the end of the orbit.";
    chart.x = {"step dt [year/2π]", chart::Scale::logarithmic};
    chart.y = {"position error [a]", chart::Scale::logarithmic};
    chart.guides = {1, 2};
    const auto study = [&](const auto& method, long fewest) {
        const std::string name = method.name, key = method.key();
        chart::Series largest{name + " (largest)"}, at_end{name + " (at the end)"};
        largest.look = method.look, at_end.look = variant(method.look);
        for (long steps = fewest; steps <= 8 * fewest; steps *= 2) {
            const auto m = lab::measure(scene, method, steps);
            largest.x.push_back(m.dt), at_end.x.push_back(m.dt);
            largest.y.push_back(m.max_error), at_end.y.push_back(m.final_error);
        }
        const double by_largest = lab::observed_order(largest.x, largest.y),
                     by_end = lab::observed_order(at_end.x, at_end.y);
        table.add({name, lab::rounded(by_largest, "%.3f"), lab::rounded(by_end, "%.3f")});
        report.number("planet." + key + ".order", by_largest);
        report.number("planet." + key + ".order_at_end", by_end);
        if (key == methods::semi_implicit_euler.key())
            report.number("planet.disguise", largest.y.back() / at_end.y.back());
        if (key == "euler") return;
        chart.series.push_back(std::move(largest)), chart.series.push_back(std::move(at_end));
    };
    study(methods::euler, 16000);
    study(methods::semi_implicit_euler, 2000);
    study(methods::verlet, 2000);
    report.print(table);
    chart::write_svg(chart, report.path("planet_orders.svg"));
}

void cost(lab::Report& report) {
    const Planet scene = Planet::for_orbits(3);
    const auto least = lab::least_of_each(scene, entries, 100, 400'000);
    lab::report_least(report, "planet", least, scene.need);
    for (const auto& way : least) {
        if (!way.met) continue;
        const std::string key = key_of(way.name);
        report.number("planet." + key + ".steps_an_orbit",
                      static_cast<double>(way.run.steps) / 3);
        report.number("planet." + key + ".microseconds_an_orbit",
                      way.run.seconds_per_second * 2 * pi * 1e6, "us");
    }
    const auto floor = lab::machine_floor();
    report.number("machine.multiply_add", floor.multiply_add * 1e9, "ns");
    report.number("machine.square_root", floor.square_root * 1e9, "ns");

    const auto curves = lab::work_precision(
        scene, entries, {300, 600, 1200, 2400, 4800, 9600, 19200, 38400, 76800});
    lab::draw_study(report,
                    {"planet",
                     "Planet, e = 0.6, three orbits.",
                     "Verlet's error falls twice as steeply",
                     {-1, -2}},
                    curves, least, scene.need);
    const auto& finest = curves[2].runs.back();
    const double per_step = finest.seconds_per_second * finest.dt;
    report.number("planet.verlet.nanoseconds_a_step", per_step * 1e9, "ns");
    report.number("planet.verlet.step_over_floor", per_step / floor.square_root);
    report.say("A Verlet step takes " + lab::rounded(per_step * 1e9) +
               " ns; one square root and division that wait for each other, the heart of its "
               "force, take " +
               lab::rounded(floor.square_root * 1e9) + " ns here.");
}

}  // namespace

void planet(lab::Report& report) {
    report.heading("Planet: e = 0.6, " + std::to_string(steps_an_orbit) +
                   " steps an orbit, 21 orbits");
    report.number("planet.steps_an_orbit", steps_an_orbit);
    conservation(report);
    orders(report);
    cost(report);
}

}  // namespace nutshell
