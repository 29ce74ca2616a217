// The planet: Euler spirals out, the symplectic methods turn.
#include <nutshell/apsides.hpp>
#include <nutshell/lab/need_chart.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/newton_scenes.hpp>
#include <nutshell/sentence.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

constexpr long steps_an_orbit = 500;
constexpr long orbits = 21;

/// What the page says of one method.
struct History {
    chart::Series energy;          ///< relative change, against time in orbits
    std::vector<double> momentum;  ///< relative change, at the same times
    double largest_energy = 0, largest_momentum = 0;
    double turn = NAN;  ///< of the axis [rad/orbit]; none of Euler's, which has no ellipse
    double tilt =
        0;  ///< of the first ellipse: direction of the first aphelion, against the exact one [rad]
    double year = NAN;  ///< its length over the exact one, minus 1
};

template <class Method>
History history_of(const Method& method) {
    const Planet scene = Planet::for_orbits(orbits);
    const double energy = scene.energy(scene.start);
    const Vector3 momentum = angular_momentum(scene.start);
    History h{chart::series_of(method, chart::Draw::line), {}};
    Aphelia aphelia;
    lab::run(scene, method, orbits * steps_an_orbit, [&](const PointMass& planet, double t) {
        const double energy_change = (scene.energy(planet) - energy) / std::abs(energy);
        const double momentum_change =
            (angular_momentum(planet) - momentum).norm() / momentum.norm();
        h.energy.add(t / (2 * pi), energy_change), h.momentum.push_back(momentum_change);
        h.largest_energy = std::max(h.largest_energy, std::abs(energy_change));
        h.largest_momentum = std::max(h.largest_momentum, momentum_change);
        aphelia.observe(planet.position);
    });
    if (method.key() == methods::euler.key()) return h;
    h.turn = aphelia.turn_per_orbit();
    // half a turn belongs to the first half year
    h.tilt = std::remainder(aphelia.angles.front() - pi, 2 * pi) - h.turn / 2;
    h.year = aphelia.samples_per_orbit() / steps_an_orbit - 1;
    return h;
}

void conservation(lab::Report& report) {
    lab::Table table{{"method",
                      "energy, largest change",
                      "angular momentum, largest change",
                      {"axis turns [rad/orbit]", "%.5f"},
                      {"first tilt [rad]", "%.5f"},
                      "year too long by"},
                     {}};
    lab::Table data{{"orbits", "method", "energy_change", "angular_momentum_change"}, {}};
    chart::Chart energy;
    energy.title = sentence("{}'s energy jumps away; the other two come back", methods::euler);
    energy.subtitle = "Planet, ε = " + lab::rounded(Planet{}.eccentricity) + ", " +
                      std::to_string(steps_an_orbit) + " steps a year.";
    energy.x = {"years", chart::Scale::linear, 0, 5};
    energy.y = {"relative change of the energy", chart::Scale::linear, -0.1, 0.5};
    energy.cut = true;
    std::vector<double> largest;
    each(newton_methods, [&](const auto& method) {
        History h = history_of(method);
        table.add({method.name, h.largest_energy, h.largest_momentum, h.turn, h.tilt, h.year});
        const std::string key = "planet." + method.key();
        report.number(key + ".energy_change", h.largest_energy, "", "planet_energy.svg");
        report.number(key + ".momentum_change", h.largest_momentum);
        if (std::isfinite(h.turn)) {
            report.number(key + ".turn", h.turn, "rad");
            report.number(key + ".tilt", h.tilt, "rad", "printed");
            report.number(key + ".year_too_long", h.year, "", "printed");
        }
        for (std::size_t i = 0; i < h.momentum.size(); i += 10)
            data.add({h.energy.x[i], method.name, h.energy.y[i], h.momentum[i]});
        energy.series.push_back(std::move(h.energy));
        largest.push_back(h.largest_energy);
    });
    report.number("planet.energy_ratio", largest[1] / largest[2]);
    report.print(table);
    report.data("planet_conservation.csv", data);
    chart::write_svg(energy, report.path("planet_energy.svg"));
}

void orders(lab::Report& report) {
    const Planet scene;
    lab::Table table{{"method",
                      {"order by largest error", "%.3f"},
                      {"order by error after whole orbits", "%.3f"}},
                     {}};
    chart::Chart chart;
    chart.title =
        sentence("{}: first order on the way, second at the end", methods::semi_implicit_euler);
    chart.subtitle =
        "Planet, one orbit: the largest error on the way, and the error at the end of the orbit.";
    chart.x = {"step dt [year/2π]", chart::Scale::logarithmic};
    chart.y = {"position error [a]", chart::Scale::logarithmic};
    chart.guides = {1, 2};
    const auto study = [&](const auto& method, long fewest) {
        const std::string key = "planet." + method.key();
        chart::Series largest = chart::series_of(method), at_end = largest;
        largest.name += " (largest)", at_end.name += " (at the end)";
        at_end.look = variant(method.look);
        for (long steps = fewest; steps <= 8 * fewest; steps *= 2) {
            const auto m = lab::measure(scene, method, steps);
            largest.add(m.dt, m.max_error), at_end.add(m.dt, m.final_error);
        }
        const double by_largest = lab::observed_order(largest.x, largest.y),
                     by_end = lab::observed_order(at_end.x, at_end.y);
        table.add({method.name, by_largest, by_end});
        report.number(key + ".order", by_largest);
        report.number(key + ".order_at_end", by_end, "", "planet_orders.svg");
        return std::pair(largest, at_end);
    };
    study(methods::euler, 16000);
    for (const auto& [largest, at_end] :
         {study(methods::semi_implicit_euler, 2000), study(methods::verlet, 2000)})
        chart.series.push_back(largest), chart.series.push_back(at_end);
    report.number("planet.disguise", chart.series[0].y.back() / chart.series[1].y.back());
    report.print(table);
    chart::write_svg(chart, report.path("planet_orders.svg"));
}

void cost(lab::Report& report) {
    const Planet scene = Planet::for_orbits(3);
    const auto [least, curves] =
        lab::study(report, scene, newton_methods,
                   {.key = "planet",
                    .scene = "Planet, ε = " + lab::rounded(scene.eccentricity) + ", " +
                             lab::rounded(scene.orbits) + " orbits.",
                    .behind = sentence("{}'s error falls twice as steeply", methods::verlet),
                    .guides = {-1, -2},
                    .steps = {300, 600, 1200, 2400, 4800, 9600, 19200, 38400, 76800},
                    .fewest = 100,
                    .most = 400'000});
    for (const auto& way : least) {
        if (!way.met) continue;
        const std::string key = "planet." + key_of(way.name);
        report.number(key + ".steps_an_orbit", static_cast<double>(way.run.steps) / scene.orbits);
        report.number(key + ".microseconds_an_orbit", way.run.seconds_per_second * 2 * pi * 1e6,
                      "us", "planet_need.svg");
    }
    const auto floor = lab::machine_floor();
    const auto& finest = curves[2].runs.back();
    const double per_step = finest.seconds_per_second * finest.dt;
    report.say(phrase("A step of {} takes ", methods::verlet) + lab::rounded(per_step * 1e9) +
               " ns; one square root and division that wait for each other, the heart of its "
               "force, take " +
               lab::rounded(floor.square_root * 1e9) + " ns here.");
}

}  // namespace

void planet(lab::Report& report) {
    report.heading("Planet: e = " + lab::rounded(Planet{}.eccentricity) + ", " +
                   std::to_string(steps_an_orbit) + " steps an orbit, " + std::to_string(orbits) +
                   " orbits");
    conservation(report);
    orders(report);
    cost(report);
}

}  // namespace nutshell
