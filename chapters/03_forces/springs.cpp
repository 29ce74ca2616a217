// The mass on a spring: the scene that sorts the methods. Then with damping, where drag inside a
// kick costs an order.
#include <nutshell/sentence.hpp>
#include "entries.hpp"
#include "program.hpp"

namespace nutshell {

namespace {

/// The chapter's main road; what goes to higher order, on side road 3B.
const std::tuple undamped_methods{methods::euler,          methods::semi_implicit_euler,
                                  methods::verlet,         methods::rk4,
                                  methods::implicit_euler, methods::exact_propagator};
const std::tuple higher_methods{
    methods::verlet,    methods::explicit_midpoint, methods::yoshida4,         methods::rk4,
    methods::kahan_li8, methods::dormand_prince,    methods::implicit_midpoint};

const std::tuple damped_methods{// and the exact propagator, which has no order
                                methods::euler,
                                methods::semi_implicit_euler,
                                methods::verlet,
                                methods::yoshida4,
                                methods::exponential_kick,
                                methods::exponential_verlet_inside,
                                methods::exponential_yoshida4,
                                methods::rk4,
                                methods::dormand_prince,
                                methods::implicit_midpoint};

void energy_of_ten_periods(lab::Report& report, const MassOnSpring& scene) {
    const double theta = 0.5, dt = theta / scene.omega();
    chart::Chart chart;
    chart.title = "One gains energy, two lose it, two swing and come back";
    chart.subtitle = "Mass on a spring, ω dt = " + lab::rounded(theta) + " (about " +
                     lab::rounded(2 * pi / theta, "%.0f") + " steps a period).";
    chart.x = {"periods", chart::Scale::linear, 0, 10};
    chart.y = {"energy over its start", chart::Scale::linear, 0, 2};
    each(std::tuple{methods::euler, methods::semi_implicit_euler, methods::verlet, methods::rk4,
                    methods::implicit_euler},
         [&](const auto& method) {  // the energy over its start, once a step
             chart::Series series = chart::series_of(method, chart::Draw::line);
             auto step = method.start(scene);
             PointMass s = scene.start;
             for (long n = 0; n <= static_cast<long>(10 * 2 * pi / theta); ++n) {
                 series.add(static_cast<double>(n) * theta / (2 * pi),
                            scene.energy(s) / scene.energy(scene.start));
                 s = step(s, scene, 0.0, dt);
             }
             const std::string key = "energy." + method.key(), shown = "spring_energy.svg";
             const auto [low, high] = std::minmax_element(series.y.begin(), series.y.end());
             report.number(key + ".lowest", *low, "", shown);
             report.number(key + ".highest", *high, "", shown);
             report.number(key + ".end", series.y.back(), "", shown);
             chart.series.push_back(std::move(series));
         });
    chart::write_svg(chart, report.path("spring_energy.svg"));
}

void overflow(lab::Report& report) {
    MassOnSpring scene;
    scene.stiffness = 1;  // omega = 1 rad/s, energy 1/2 J
    const double theta = 0.1, dt = theta / scene.omega(), periods_a_step = theta / (2 * pi);
    chart::Chart chart;
    chart.title = "How a game ends in NaN";
    chart.subtitle = phrase("Mass on a spring, {} at ω dt = ", methods::euler) +
                     lab::rounded(theta) + ": every step multiplies the energy by " +
                     lab::rounded(1 + theta * theta) + ".";
    chart.x = {"periods", chart::Scale::linear, 0, 2400};
    chart.y = {"decimal exponent", chart::Scale::linear, 0, 320};
    chart.levels_y = {{std::log10(std::numeric_limits<double>::max()), "the largest double"}};
    chart::Series energy = chart::series_of(methods::euler, chart::Draw::line),
                  amplitude = energy;
    energy.name = "energy", amplitude.name = "amplitude";
    amplitude.look = variant(methods::euler.look);
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
            if (std::isfinite(e)) energy.add(periods, std::log10(e));
            if (std::isfinite(a)) amplitude.add(periods, std::log10(a));
        }
        s = euler(s, scene, 0, dt);
    }
    chart.series = {energy, amplitude};
    const double energy_periods = static_cast<double>(energy_gone) * periods_a_step,
                 state_periods = static_cast<double>(state_gone) * periods_a_step;
    report.number("overflow.energy.periods", energy_periods);
    report.number("overflow.state.periods", state_periods);
    report.number("overflow.state.minutes_at_1_hz", state_periods / 60, "min");
    report.say(sentence("{} at omega dt = ", methods::euler) + lab::rounded(theta) +
               ": the energy overflows after " + lab::rounded(energy_periods, "%.0f") +
               " periods, the state after " + lab::rounded(state_periods, "%.0f") + ".");
    report.draw("overflow", chart);
}

template <class Methods>
void cost(lab::Report& report, const MassOnSpring& scene, const Methods& methods,
          lab::Plan plan) {
    plan.guides = {-1, -2, -4, -8};
    plan.steps = {10, 20, 40, 80, 160, 320, 640, 1280, 2560, 5120};
    plan.fewest = 10, plan.most = 100'000;  // Euler would take 600 000
    lab::study(report, scene, methods, plan);
}

}  // namespace

void springs(lab::Report& report) {
    const MassOnSpring scene;
    const double period = 2 * pi / scene.omega();
    report.heading("Mass on a spring: period " + lab::rounded(period) + " s, " +
                   lab::rounded(scene.duration / period) + " periods");
    cost(report, scene, undamped_methods,
         {.key = "spring",
          .scene = "Mass on a spring, " + lab::rounded(scene.duration / period) + " periods.",
          .behind = "Slopes are orders"});
    cost(report, scene, higher_methods,
         {.key = "higher",
          .scene = "Mass on a spring, " + lab::rounded(scene.duration / period) + " periods.",
          .behind = "High order wins when the need is strict"});
    energy_of_ten_periods(report, scene);
    overflow(report);

    const double ratio = 0.1;
    const MassOnSpring damped = MassOnSpring::with_damping(ratio);
    report.heading("Damped spring: damping ratio " + lab::rounded(ratio));
    auto entries = lab::entries<MassOnSpring>(damped_methods);
    lab::report_orders(report, "damped", damped, entries, {2000, 4000, 8000}, 1e-12);
    entries.push_back(lab::entry<MassOnSpring>(methods::exact_propagator));
    cost(report, damped, entries,
         {.key = "damped",
          .scene = "Damped spring, ratio " + lab::rounded(ratio) + ", " +
                   lab::rounded(damped.duration) + " seconds.",
          .behind = phrase("Drag inside the kick costs {} an order", methods::verlet)});
}

}  // namespace nutshell
