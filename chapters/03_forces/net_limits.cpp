// The step at which a chain and a cloth fly apart: by formula, by their fastest mode, by running.
#include <algorithm>
#include <nutshell/chart/chart.hpp>
#include <nutshell/sentence.hpp>
#include "method_limits.hpp"
#include "scale.hpp"

namespace nutshell {

namespace {

/// The largest step at which a method does not let a small shake grow, by bisection.
template <class Scene, class Method>
double measured_limit(const Scene& small, const Method& method, double expected) {
    const auto stable = [&](double dt) {
        return lab::stays_within(small, method, dt, 1000, 1e-6,
                                 [](const auto& s) { return fastest_speed(s); });
    };
    return lab::stability_limit(stable, 0.95 * expected, 1.05 * expected, 5e-4);
}

/// Every conditionally stable method on a chain and a cloth, as omega dt with omega of the
/// fastest mode.
void limits_of_methods(lab::Report& report, const SpringNet& a_chain, const SpringNet& a_cloth) {
    lab::Table table{
        {"method", {"predicted", "%.4f"}, {"on_chain", "%.4f"}, {"on_cloth", "%.4f"}}, {}};
    const double chain_omega = fastest_mode(a_chain, a_chain.start).frequency;
    const double cloth_omega = fastest_mode(a_cloth, a_cloth.start).frequency;
    chart::Chart reach;
    reach.title = "A force evaluation goes farthest in the plainest steps";
    reach.subtitle =
        "Chain of ten masses: the longest stable step for each evaluation of its forces.";
    reach.x = {"ω dt of the fastest mode, for each evaluation"};
    const auto line = [&](const auto& method, double theta) {
        const auto found = [&](const SpringNet& net, double dt) {
            return measured_limit(shaken(net), method, dt);
        };
        const double on_chain = chain_omega * found(a_chain, theta / chain_omega);
        const double on_cloth = cloth_omega * found(a_cloth, theta / cloth_omega);
        table.add({method.name, theta, on_chain, on_cloth});
        const std::string key = "net_limit." + method.key(), shown = "net_methods.csv";
        report.number(key + ".predicted", theta, "", shown);
        report.number(key + ".chain", on_chain, "", shown);
        report.number(key + ".cloth", on_cloth, "", shown);
        chart::Bar bar{method.name, on_chain / method.evaluations};
        bar.text = lab::rounded(bar.value, "%.2f");
        bar.look = method.look;
        reach.bars.push_back(bar);
    };
    line(methods::semi_implicit_euler, 2);
    line(methods::verlet, 2);
    line(methods::yoshida4, composed_limit(yoshida_weights()));
    line(methods::kahan_li8, composed_limit(kahan_li_weights()));
    line(methods::rk4, std::sqrt(8.0));
    report.print(table);
    report.data("net_methods.csv", table);
    std::stable_sort(reach.bars.begin(), reach.bars.end(),
                     [](const chart::Bar& a, const chart::Bar& b) { return a.value > b.value; });
    chart::write_svg(reach, report.path("net_reach.svg"));
}

}  // namespace

void net_limits(lab::Report& report) {
    report.heading(
        phrase("The largest step of {} [s]: by formula, by the fastest mode, by running",
               methods::verlet));
    constexpr double mass = 0.02, stiffness = 50;
    lab::Table table{{"scene",
                      {"formula", "%.6f"},
                      {"fastest_mode", "%.6f"},
                      {"measured", "%.6f"},
                      {"measured_over_formula", "%.4f"},
                      {"formula_in_structural", "%.4f"}},
                     {}};
    const auto line = [&](const std::string& name, const std::string& word, const SpringNet& net,
                          double fastest) {
        const double formula = 2 / fastest, mode = 2 / fastest_mode(net, net.start).frequency,
                     measured = measured_limit(shaken(net), methods::verlet, formula);
        const double in_structural = formula / std::sqrt(net.start.mass[0] / stiffness);
        table.add({name, formula, mode, measured, measured / formula, in_structural});
        const std::string key = "net_limit." + word, shown = "chain_cloth_limits.csv";
        report.number(key + ".formula", formula, "s", shown);
        report.number(key + ".mode", mode, "s", shown);
        report.number(key + ".measured", measured, "s", shown);
        report.number(key + ".in_structural", in_structural, "", shown);
    };
    line("chain of 10, both ends held", "chain",
         chain(10, mass, {stiffness, 0.1}, {0, 0, 0}, {1.1, 0, 0}),
         chain_frequency(10, mass, stiffness));
    line("chain of 10, one end free", "chain_free",
         chain(10, mass, {stiffness, 0.1}, {0, 0, 0}, {1, 0, 0}, true),
         chain_frequency(10, mass, stiffness, true));
    for (const auto& [weave, name, word] :
         {std::tuple(Weave::structural, "cloth, along the threads", "cloth_structural"),
          std::tuple(Weave::with_shear, "cloth, and shear", "cloth_shear"),
          std::tuple(Weave::with_shear_and_bend, "cloth, and bend", "cloth_bend")}) {
        const SpringNet net = cloth(24, 1, mass * 24 * 24, stiffness, weave);
        line(name, word, net, cloth_frequency(net.springs.kinds, mass));
    }
    report.print(table);
    report.data("chain_cloth_limits.csv", table);
    limits_of_methods(report, chain(10, mass, {stiffness, 0.1}, {0, 0, 0}, {1.1, 0, 0}),
                      cloth(24, 1, mass * 24 * 24, stiffness, Weave::with_shear_and_bend));
}

}  // namespace nutshell
