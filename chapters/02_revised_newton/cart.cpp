// The leaky cart: what K = m v says when the mass changes, and what is true.
#include <nutshell/lab/need_chart.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/revised_newton_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

constexpr long steps = 1000;

struct Told {
    std::vector<double> t, speed;
    VariableMass end;
};

/// The cart's speed as somebody computes it who moves along at `frame` m/s, told to the ground.
Told told_by(const LeakyCart& cart, double frame) {
    Told told;
    told.end = lab::run(cart.seen_from({frame, 0, 0}), methods::euler, steps,
                        [&](const Particle& body, double t) {
                            told.t.push_back(t), told.speed.push_back(velocity(body).x() + frame);
                        });
    return told;
}

}  // namespace

void leaky_cart(lab::Report& report) {
    const LeakyCart cart, printed = LeakyCart::as_printed();
    report.heading("Leaky cart: 2 kg at 10 m/s, half the mass leaves in 10 s, no force");
    const Told truth = told_by(cart, 0), truth_moving = told_by(cart, 4);
    const Told ground = told_by(printed, 0), walker = told_by(printed, 4),
               passenger = told_by(printed, 10);

    lab::Table table{{"computed by", "K = m v, K constant: final speed [m/s]",
                      "momentum books: final speed [m/s]"},
                     {}};
    table.add({"somebody on the ground", lab::rounded(ground.speed.back(), "%.6f"),
               lab::rounded(truth.speed.back(), "%.6f")});
    table.add({"somebody moving at 4 m/s", lab::rounded(walker.speed.back(), "%.6f"),
               lab::rounded(truth_moving.speed.back(), "%.6f")});
    table.add({"somebody on the cart", lab::rounded(passenger.speed.back(), "%.6f"),
               lab::rounded(told_by(cart, 10).speed.back(), "%.6f")});
    report.print(table);

    const double energy = kinetic_energy(cart.start), printed_energy = kinetic_energy(ground.end);
    const double true_energy = kinetic_energy(truth.end);
    const double sand_energy =
        (cart.start.mass - truth.end.mass) * velocity(cart.start).squaredNorm() / 2;
    report.say("Kinetic energy: " + lab::rounded(energy) +
               " J at the start. At the end, by the printed reading, the cart alone has " +
               lab::rounded(printed_energy) + " J; in truth cart and sand have " +
               lab::rounded(true_energy) + " + " + lab::rounded(sand_energy) + " J.");
    report.number("cart.truth.speed", truth.speed.back(), "m/s");
    double off = 0;
    for (const double frame : {0.0, 4.0, 10.0})
        for (const double speed : told_by(cart, frame).speed)
            off = std::max(off, std::abs(speed - 10));
    report.number("cart.truth.off", off, "m/s");
    report.number("cart.printed.speed", ground.speed.back(), "m/s");
    report.number("cart.printed.walker", walker.speed.back(), "m/s");
    report.number("cart.printed.passenger", passenger.speed.back(), "m/s");
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

    lab::Table data{{"t", "truth", "printed_ground", "printed_moving_4", "printed_moving_10"},
                    {}};
    for (std::size_t i = 0; i < truth.t.size(); i += 10)
        data.add({lab::exact_digits(truth.t[i]), lab::exact_digits(truth.speed[i]),
                  lab::exact_digits(ground.speed[i]), lab::exact_digits(walker.speed[i]),
                  lab::exact_digits(passenger.speed[i])});
    report.data("cart.csv", data);

    chart::Chart chart;
    chart.title = "One cart, one formula, three observers, three speeds";
    chart.subtitle =
        "Leaky cart, no force. Reading K = m v with F = 0; the truth is the pale line.";
    chart.x = {"time [s]"};
    chart.y = {"speed over the ground [m/s]", chart::Scale::linear, 8, 22};
    chart::Series truth_line{"truth", truth.t, truth.speed, chart::Draw::ghost};
    truth_line.look = Look{Family::exact};
    chart.series.push_back(truth_line);
    const auto line = [&](const std::string& name, const Told& told) {
        chart.series.push_back({name, told.t, told.speed, chart::Draw::line});
    };
    line("computed on the ground", ground);
    line("computed at 4 m/s", walker);
    line("computed on the cart", passenger);
    chart::write_svg(chart, report.path("cart.svg"));
}

}  // namespace nutshell
