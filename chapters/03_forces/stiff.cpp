// What games do about a stiff cloth: the same swing by Verlet in small steps, and by implicit Euler
// and position-based dynamics in one step a frame; what each costs and what each loses.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <nutshell/chart/chart.hpp>
#include <nutshell/forces_methods.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/sentence.hpp>
#include <nutshell/spring_limits.hpp>
#include <nutshell/stiff_steps.hpp>
#include "scale.hpp"

namespace nutshell {

namespace {

constexpr std::size_t n = 16;
constexpr double side = 1.5, mass = 0.5, stiffness = 1000;  // [m], [kg], [N/m]
constexpr double frame = 1.0 / 60, swing_time = 6;          // [s]

/// The cloth, held along its upper edge and turned about it by 0.3 rad.
SpringNet swinging_cloth() {
    SpringNet net = cloth(n, side, mass, stiffness, Weave::with_shear);
    for (std::size_t i = 0; i < n; ++i) net.held.push_back(i);
    for (std::size_t i = 0; i < n * n; ++i) {
        const double down = net.start.position.y[i];
        net.start.position.y[i] = down * std::cos(0.3);
        net.start.position.z[i] = down * std::sin(0.3);
    }
    return net;
}

double sideways(const Particles& all) {
    double sum = 0;
    for (const double z : all.position.z) sum += z / static_cast<double>(all.size());
    return sum;
}

/// A run of the swing: where the cloth's centre is, and the farthest it swings in the last two
/// seconds, as a share of the start.
struct Swing {
    chart::Series line;
    double kept, milliseconds;  // of processor time per simulated second
};
template <class Stepper>
Swing swing(const std::string& name, const SpringNet& net, Stepper step, double dt) {
    Swing result{{name, {}, {}, chart::Draw::line}, 0, 0};
    const double start = std::abs(sideways(net.start));
    Particles all = net.start;
    const long steps = std::lround(swing_time / dt);
    const long every = std::max(1L, std::lround(frame / dt));
    const auto begin = std::clock();
    for (long i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) * dt;
        if (i % every == 0) {
            result.line.add(t, sideways(all) / start);
            if (t > swing_time - 2)
                result.kept = std::max(result.kept, std::abs(result.line.y.back()));
        }
        if (i < steps) all = step(std::move(all), net, t, dt);
    }
    result.milliseconds =
        1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / swing_time;
    return result;
}

/// How much longer than at rest length the cloth hangs, in the end: braked for ten seconds.
template <class Stepper>
double stretch(SpringNet net, Stepper step, double dt) {
    net.drag = 0.02;
    net.start = cloth(n, side, mass, stiffness, Weave::with_shear).start;
    Particles all = net.start;
    for (long i = std::lround(10 / dt); i > 0; --i) all = step(std::move(all), net, 0.0, dt);
    return -*std::min_element(all.position.y.begin(), all.position.y.end()) / side - 1;
}

}  // namespace

void stiff_cloth(lab::Report& report) {
    report.heading(phrase("A stiff cloth swings: small steps, {}, position-based dynamics",
                          methods::implicit_euler));
    const SpringNet net = swinging_cloth();
    const double limit = 2 / fastest_mode(net, net.start).frequency;
    const double steps_a_frame = std::ceil(frame / (0.9 * limit)), small = frame / steps_a_frame;
    report.number("stiff.steps_a_frame", steps_a_frame);
    report.number("stiff.frame_over_limit", frame / limit);

    const std::string by_newton = methods::implicit_euler.name;
    const Swing verlet = swing(methods::verlet.name, net, methods::verlet.start(net), small);
    const Swing implicit = swing(by_newton, net, LinearImplicitEuler{}, frame);
    const Swing implicit_small =
        swing(by_newton + ", 4 steps", net, LinearImplicitEuler{}, frame / 4);
    const Swing based = swing("position-based", net, PositionBased{20}, frame);
    lab::Table table{{"step", "steps a frame", {"swing kept", "%.3f"}, "ms per second"}, {}};
    const auto row = [&](const Swing& s, const std::string& key, double steps) {
        table.add({s.line.name, steps, s.kept, s.milliseconds});
        report.number("stiff." + key + ".kept", s.kept, "", "printed");
        report.number("stiff." + key + ".milliseconds", s.milliseconds, "ms", "printed");
    };
    row(verlet, methods::verlet.key(), steps_a_frame);
    row(implicit, "implicit", 1);
    row(implicit_small, "implicit_4", 4);
    row(based, "position_based", 1);
    report.print(table);

    lab::Table rest{{"step", {"stretch at rest [%]", "%.2f"}}, {}};
    const auto hang = [&](const std::string& name, const std::string& key, double by) {
        rest.add({name, 100 * by});
        report.number("stiff." + key + ".stretch", by, "", "printed");
    };
    hang(by_newton, "implicit", stretch(net, LinearImplicitEuler{}, frame));
    hang("position-based, 5 iterations", "based_5", stretch(net, PositionBased{5}, frame));
    hang("position-based, 20 iterations", "based_20", stretch(net, PositionBased{20}, frame));
    hang("position-based, 80 iterations", "based_80", stretch(net, PositionBased{80}, frame));
    hang("position-based, 20 iterations, 4 steps a frame", "based_20_4",
         stretch(net, PositionBased{20}, frame / 4));
    report.print(rest);

    chart::Figure figure;
    figure.title = "Stable at one step a frame, but the swing dies away";
    figure.subtitle =
        phrase("A cloth held along its upper edge swings, no drag. {} makes ", methods::verlet) +
        lab::rounded(steps_a_frame) + " steps a frame, the others one.";
    chart::Chart swings;
    swings.title = "How it swings";
    swings.x = {"time [s]"};
    swings.y = {"centre, sideways, over its start"};
    swings.series = {verlet.line, implicit.line, based.line};
    swings.series[0].look = methods::verlet.look;
    swings.series[1].look = methods::implicit_euler.look;
    chart::Chart costs;
    costs.title = "What it costs";
    costs.x = {"processor time for a second of cloth [ms]"};
    for (std::size_t i = 0; i < 3; ++i) {
        const Swing* of[] = {&verlet, &implicit, &based};
        chart::Bar bar{of[i]->line.name, of[i]->milliseconds};
        bar.text = lab::rounded(bar.value, bar.value < 10 ? "%.1f ms, " : "%.0f ms, ") +
                   lab::rounded(100 * of[i]->kept, "%.0f %% kept");
        bar.look = swings.series[i].look;
        costs.bars.push_back(bar);
    }
    figure.panels = {swings, costs};
    chart::write_svg(figure, report.path("stiff.svg"));
}

}  // namespace nutshell
