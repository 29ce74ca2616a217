// The mass on a spring: the scene that sorts the methods. Then with damping, where drag inside a
// kick costs an order.
#include "entries.hpp"
#include "program.hpp"

namespace nutshell {

namespace {

std::vector<lab::Entry<MassOnSpring>> undamped_methods(const MassOnSpring& scene) {
    using S = MassOnSpring;
    return {
        lab::entry<S>("Euler", euler_method),
        lab::entry<S>("semi-implicit Euler", semi_implicit_euler_method),
        lab::entry<S>("Verlet", VerletFsal<Vector3>{}),
        lab::entry<S>("Yoshida 4", yoshida4()),
        lab::entry<S>("Kahan-Li 8", kahan_li8()),
        flow_entry<S>("explicit midpoint", explicit_midpoint_method),
        flow_entry<S>("RK4", rk4_method),
        flow_entry<S>("Dormand-Prince 5(4)", dormand_prince_method),
        flow_entry<S>("implicit Euler", implicit_euler_method),
        flow_entry<S>("implicit midpoint", implicit_midpoint_method),
        lab::entry<S>("exact propagator", SpringPropagator{scene.omega(), scene.damping_rate()})};
}

std::vector<lab::Entry<MassOnSpring>> damped_methods(const MassOnSpring& scene) {
    using S = MassOnSpring;
    return {
        lab::entry<S>("Euler", euler_method),
        lab::entry<S>("semi-implicit Euler", semi_implicit_euler_method),
        lab::entry<S>("Verlet, naive", VerletFsal<Vector3>{}),
        lab::entry<S>("Yoshida 4, naive", yoshida4()),
        lab::entry<S>("exponential kick", exponential_kick_method),
        lab::entry<S>("exponential Verlet", ExponentialVerlet<>{}),
        lab::entry<S>("exponential Yoshida 4", exponential_yoshida4()),
        flow_entry<S>("RK4", rk4_method),
        flow_entry<S>("Dormand-Prince 5(4)", dormand_prince_method),
        flow_entry<S>("implicit midpoint", implicit_midpoint_method),
        lab::entry<S>("exact propagator", SpringPropagator{scene.omega(), scene.damping_rate()})};
}

/// The energy over its start, once a step, at omega dt = theta.
template <class Step, class Energy>
chart::Series energies(const std::string& name, double theta, double periods, Step step,
                       const Energy& energy) {
    chart::Series series{name};
    series.draw = chart::Draw::line;
    const auto steps = static_cast<long>(periods * 2 * pi / theta);
    const double first = energy();
    for (long n = 0; n <= steps; ++n, step())
        series.x.push_back(static_cast<double>(n) * theta / (2 * pi)),
            series.y.push_back(energy() / first);
    return series;
}

void energy_of_ten_periods(lab::Report& report, const MassOnSpring& scene) {
    const double theta = 0.5, dt = theta / scene.omega();
    chart::Chart chart;
    chart.title = "Who keeps the energy?";
    chart.subtitle = "Mass on a spring, ω dt = 0.5 (about 13 steps a period).";
    chart.x = {"periods", chart::Scale::linear, 0, 10};
    chart.y = {"energy over its start", chart::Scale::linear, 0, 2};
    const auto kick_drift = [&](const std::string& name, auto method) {
        PointMass s = scene.start;
        chart.series.push_back(energies(
            name, theta, 10, [&] { s = method(s, scene, 0.0, dt); },
            [&] { return scene.energy(s); }));
    };
    const auto general = [&](const std::string& name, const auto& method) {
        const Flow flow(scene);
        FlatPoint y = flow.start;
        chart.series.push_back(energies(
            name, theta, 10, [&] { y = method(y, flow, 0.0, dt); },
            [&] { return scene.energy(unflat(y, scene.start)); }));
    };
    kick_drift("Euler", euler_method);
    kick_drift("semi-implicit Euler", semi_implicit_euler_method);
    kick_drift("Verlet", verlet_method);
    general("explicit midpoint", explicit_midpoint_method);
    general("RK4", rk4_method);
    general("implicit Euler", implicit_euler_method);
    general("implicit midpoint", implicit_midpoint_method);
    for (const auto& series : chart.series) {
        double low = 1, high = 1;
        for (const double e : series.y) low = std::min(low, e), high = std::max(high, e);
        report.number("energy." + key_of(series.name) + ".lowest", low);
        report.number("energy." + key_of(series.name) + ".highest", high);
        report.number("energy." + key_of(series.name) + ".end", series.y.back());
    }
    chart::write_svg(chart, report.path("spring_energy.svg"));
}

void overflow(lab::Report& report) {
    MassOnSpring scene;
    scene.stiffness = 1;  // omega = 1 rad/s, energy 1/2 J
    const double theta = 0.1, dt = theta / scene.omega(), periods_a_step = theta / (2 * pi);
    chart::Chart chart;
    chart.title = "How a game ends in NaN";
    chart.subtitle =
        "Mass on a spring, Euler at ω dt = 0.1: every step multiplies the energy by 1.01.";
    chart.x = {"periods", chart::Scale::linear, 0, 2400};
    chart.y = {"decimal exponent", chart::Scale::linear, 0, 320};
    chart.levels_y = {{std::log10(std::numeric_limits<double>::max()), "the largest double"}};
    chart::Series energy{"energy"}, amplitude{"amplitude"};
    energy.style = "Euler", amplitude.style = "Euler, amplitude";
    energy.draw = amplitude.draw = chart::Draw::line;
    lab::Table data{{"periods", "energy_over_start", "amplitude"}, {}};
    PointMass s = scene.start;
    const double first = scene.energy(s);
    long energy_gone = 0, state_gone = 0;
    for (long n = 0; state_gone == 0; ++n) {
        const double e = scene.energy(s) / first,
                     a = std::max(std::abs(s.position.x()), std::abs(s.velocity.x()));
        if (energy_gone == 0 && !std::isfinite(e)) energy_gone = n;
        if (!s.position.allFinite() || !s.velocity.allFinite()) state_gone = n;
        if (n % 500 == 0) {
            const double periods = static_cast<double>(n) * periods_a_step;
            if (std::isfinite(e)) energy.x.push_back(periods), energy.y.push_back(std::log10(e));
            if (std::isfinite(a))
                amplitude.x.push_back(periods), amplitude.y.push_back(std::log10(a));
            data.add({lab::exact_digits(periods), lab::exact_digits(e), lab::exact_digits(a)});
        }
        s = euler(s, scene, 0, dt);
    }
    chart.series = {energy, amplitude};
    report.number("overflow.energy.periods", static_cast<double>(energy_gone) * periods_a_step);
    report.number("overflow.state.periods", static_cast<double>(state_gone) * periods_a_step);
    report.number("overflow.state.minutes_at_1_hz",
                  static_cast<double>(state_gone) * periods_a_step / 60, "min");
    report.say("Euler at omega dt = 0.1: the energy overflows after " +
               lab::rounded(static_cast<double>(energy_gone) * periods_a_step, "%.0f") +
               " periods, the state after " +
               lab::rounded(static_cast<double>(state_gone) * periods_a_step, "%.0f") + ".");
    report.data("overflow.csv", data);
    chart::write_svg(chart, report.path("overflow.svg"));
}

template <class Methods>
void study(lab::Report& report, const MassOnSpring& scene, const std::string& key,
           const Methods& methods, const std::string& title, const std::string& subtitle) {
    least_work(report, key, scene, methods, 10, 100'000);  // Euler, undamped, would take 600 000
    const auto curves =
        lab::work_precision(scene, methods, {10, 20, 40, 80, 160, 320, 640, 1280, 2560, 5120});
    draw_study(report, key, curves, scene.need, 2.5, title, subtitle, {-1, -2, -4, -8});
    for (const auto& curve : curves)
        report.number(key + "." + key_of(curve.method) + ".nanoseconds",
                      1e9 * curve.runs[7].seconds_per_second * curve.runs[7].dt, "ns");  // a step
}

}  // namespace

void springs(lab::Report& report) {
    const MassOnSpring scene;
    report.heading("Mass on a spring: period 1 s, ten periods");
    study(report, scene, "spring", undamped_methods(scene),
          "Which method gives a pixel for the least work?",
          "Mass on a spring, ten periods. Down and left is better. Runs that blew up are left "
          "out.");
    energy_of_ten_periods(report, scene);
    overflow(report);

    const MassOnSpring damped = MassOnSpring::with_damping(0.1);
    report.heading("Damped spring: damping ratio 0.1");
    lab::Table orders{{"method", "order"}, {}};
    for (const auto& method : damped_methods(damped)) {
        if (method.name == "exact propagator") continue;
        std::vector<double> dts, errors;
        for (const long n : {2000, 4000, 8000})
            dts.push_back(damped.duration / static_cast<double>(n)),
                errors.push_back(method.measure(damped, n).max_error);
        if (errors.back() < 1e-12) continue;  // round-off has no order
        const double order = lab::observed_order(dts, errors);
        orders.add({method.name, lab::rounded(order, "%.2f")});
        report.number("damped." + key_of(method.name) + ".order", order);
    }
    report.print(orders);
    study(report, damped, "damped", damped_methods(damped), "Drag inside the kick costs an order",
          "Damped spring, ratio 0.1, ten seconds. Down and left is better. Runs that blew up are "
          "left out.");
}

}  // namespace nutshell
