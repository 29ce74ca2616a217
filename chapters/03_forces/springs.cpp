// The mass on a spring: the scene that sorts the methods. Then with damping, where drag inside a
// kick costs an order.
#include "entries.hpp"
#include "program.hpp"

namespace nutshell {

namespace {

const auto undamped_methods = lab::entries<MassOnSpring>(std::tuple{
    methods::euler, methods::semi_implicit_euler, methods::verlet, methods::yoshida4,
    methods::kahan_li8, methods::explicit_midpoint, methods::rk4, methods::dormand_prince,
    methods::implicit_euler, methods::implicit_midpoint, methods::exact_propagator});

const auto damped_methods = lab::entries<MassOnSpring>(
    std::tuple{methods::euler, methods::semi_implicit_euler, methods::verlet, methods::yoshida4,
               methods::exponential_kick, methods::exponential_verlet_inside,
               methods::exponential_yoshida4, methods::rk4, methods::dormand_prince,
               methods::implicit_midpoint, methods::exact_propagator});

void energy_of_ten_periods(lab::Report& report, const MassOnSpring& scene) {
    const double theta = 0.5, dt = theta / scene.omega();
    chart::Chart chart;
    chart.title = "Some gain energy, some lose it; two swing round the truth";
    chart.subtitle = "Mass on a spring, ω dt = 0.5 (about 13 steps a period).";
    chart.x = {"periods", chart::Scale::linear, 0, 10};
    chart.y = {"energy over its start", chart::Scale::linear, 0, 2};
    each(std::tuple{methods::euler, methods::semi_implicit_euler, methods::verlet,
                    methods::explicit_midpoint, methods::rk4, methods::implicit_euler,
                    methods::implicit_midpoint},
         [&](const auto& method) {  // the energy over its start, once a step
             chart::Series series{method.name};
             series.look = method.look;
             series.draw = chart::Draw::line;
             auto step = method.start(scene);
             PointMass s = scene.start;
             for (long n = 0; n <= static_cast<long>(10 * 2 * pi / theta); ++n) {
                 series.x.push_back(static_cast<double>(n) * theta / (2 * pi));
                 series.y.push_back(scene.energy(s) / scene.energy(scene.start));
                 s = step(s, scene, 0.0, dt);
             }
             chart.series.push_back(std::move(series));
         });
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
    energy.look = methods::euler.look, amplitude.look = variant(methods::euler.look);
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
void study(lab::Report& report, const MassOnSpring& scene, const Methods& methods,
           const lab::StudyWords& words) {
    const auto least =
        lab::least_of_each(scene, methods, 10, 100'000);  // Euler would take 600 000
    lab::report_least(report, words.key, least, scene.need);
    const auto curves =
        lab::work_precision(scene, methods, {10, 20, 40, 80, 160, 320, 640, 1280, 2560, 5120});
    lab::draw_study(report, words, curves, least, scene.need);
    for (const auto& curve : curves)
        report.number(words.key + "." + key_of(curve.name) + ".nanoseconds",
                      1e9 * curve.runs[7].seconds_per_second * curve.runs[7].dt, "ns");  // a step
}

}  // namespace

void springs(lab::Report& report) {
    const MassOnSpring scene;
    report.heading("Mass on a spring: period 1 s, ten periods");
    study(report, scene, undamped_methods,
          {"spring",
           "Mass on a spring, ten periods.",
           "Slopes are orders: high order wins when the need is strict",
           {-1, -2, -4, -8}});
    energy_of_ten_periods(report, scene);
    overflow(report);

    const MassOnSpring damped = MassOnSpring::with_damping(0.1);
    report.heading("Damped spring: damping ratio 0.1");
    lab::Table orders{{"method", "order"}, {}};
    for (const auto& method : damped_methods) {
        if (method.name == methods::exact_propagator.name) continue;
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
    study(report, damped, damped_methods,
          {"damped",
           "Damped spring, ratio 0.1, ten seconds.",
           "Drag inside the kick costs Verlet an order",
           {-1, -2, -4, -8}});
}

}  // namespace nutshell
