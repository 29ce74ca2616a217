// The leaky cart: what K = m v says when the mass changes, and what is true.
#include <nutshell/lab/need_chart.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/revised_newton_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

constexpr long steps = 1000;

struct Told {
    chart::Series line;  ///< speed against time
    VariableMass end;
    double speed() const { return line.y.back(); }
};

/// The cart's speed as somebody computes it who moves along at `frame` m/s, told to the ground.
Told told_by(const LeakyCart& cart, double frame, const std::string& name = {}) {
    Told told{{name, {}, {}, chart::Draw::line}, {}};
    told.end = lab::run(
        cart.seen_from({frame, 0, 0}), methods::euler, steps,
        [&](const Particle& body, double t) { told.line.add(t, velocity(body).x() + frame); });
    return told;
}

}  // namespace

void leaky_cart(lab::Report& report) {
    const LeakyCart cart, printed = LeakyCart::as_printed();
    const double speed = velocity(cart.start).x(), walk = 4;  // [m/s]
    const std::string at_walk = lab::rounded(walk) + " m/s";
    report.heading("Leaky cart: " + lab::rounded(cart.start.mass) + " kg at " +
                   lab::rounded(speed) + " m/s, half the mass leaves in " +
                   lab::rounded(cart.duration) + " s, no force");
    const Told truth = told_by(cart, 0, "truth"),
               ground = told_by(printed, 0, "computed on the ground"),
               walker = told_by(printed, walk, "computed at " + at_walk),
               passenger = told_by(printed, speed, "computed on the cart");

    lab::Table table{{"computed by",
                      {"K = m v, K constant: final speed [m/s]", "%.6f"},
                      {"momentum books: final speed [m/s]", "%.6f"}},
                     {}};
    table.add({"somebody on the ground", ground.speed(), truth.speed()});
    table.add({"somebody moving at " + at_walk, walker.speed(), told_by(cart, walk).speed()});
    table.add({"somebody on the cart", passenger.speed(), told_by(cart, speed).speed()});
    report.print(table);

    const double energy = kinetic_energy(cart.start), printed_energy = kinetic_energy(ground.end);
    const double true_energy = kinetic_energy(truth.end);
    const double sand_energy =
        (cart.start.mass - truth.end.mass) * velocity(cart.start).squaredNorm() / 2;
    report.say("Kinetic energy: " + lab::rounded(energy) +
               " J at the start. At the end, by the printed reading, the cart alone has " +
               lab::rounded(printed_energy) + " J; in truth cart and sand have " +
               lab::rounded(true_energy) + " + " + lab::rounded(sand_energy) + " J.");
    report.number("cart.truth.speed", truth.speed(), "m/s");
    double off = 0;
    for (const double frame : {0.0, walk, speed})
        for (const double told : told_by(cart, frame).line.y)
            off = std::max(off, std::abs(told - speed));
    report.number("cart.truth.off", off, "m/s");
    report.number("cart.printed.speed", ground.speed(), "m/s");
    report.number("cart.printed.walker", walker.speed(), "m/s");
    report.number("cart.printed.passenger", passenger.speed(), "m/s");
    report.number("cart.truth.path", truth.end.position.x(), "m");
    report.number("cart.printed.path", ground.end.position.x(), "m");
    report.number("cart.energy.start", energy, "J");
    report.number("cart.energy.printed", printed_energy, "J");
    report.number("cart.energy.truth", true_energy, "J");
    report.number("cart.energy.sand", sand_energy, "J");
    report.number(
        "cart.printed.thrust",
        (printed.start.flow.rate * relative_velocity(printed.start.flow, printed.start, 0)).x(),
        "N");
    lab::report_least(report, "cart",
                      lab::least_of_each(cart, lab::entries<LeakyCart>(newton_methods)),
                      cart.need);

    chart::Chart chart;
    chart.title = "One cart, one formula, three observers, three speeds";
    chart.subtitle =
        "Leaky cart, no force. Reading K = m v with F = 0; the truth is the pale line.";
    chart.x = {"time [s]"};
    chart.y = {"speed over the ground [m/s]", chart::Scale::linear, 8, 22};
    chart.series = {truth.line, ground.line, walker.line, passenger.line};
    chart.series[0].draw = chart::Draw::ghost, chart.series[0].look = Look{Family::exact};
    report.draw("cart", chart);
}

}  // namespace nutshell
