// Where each method breaks: the limit from theory, found again by runs; and the regions of the
// lambda dt plane.
#include "entries.hpp"
#include "method_limits.hpp"
#include "program.hpp"

namespace nutshell {

namespace {

/// The four scenes of the table; a limit is shown as omega dt, for drag alone as gamma dt/m.
struct Column {
    const char* key;
    double omega, nu;
};
const Column columns[] = {
    {"undamped", 1, 0}, {"damped", 1, 0.2}, {"overdamped", 1, 4}, {"drag", 0, 1}};

constexpr long longest_run = 200'000;  // [steps]; what grows more slowly is left to the tests

/// Each limit as predicted (0 never, infinite always) and as found by running.
void limits_table(lab::Report& report) {
    lab::Table table{{"method"}, {}};
    for (const Column& c : columns)
        for (const std::string found : {"", "_found"})
            table.columns.push_back({c.key + found, "%.4f"});
    each_limit([&](const auto& method, const OnSpring& theory) {
        std::vector<lab::Cell> cells{method.name};
        for (const Column& c : columns) {
            const double predicted = theory.limit(c.omega, c.nu);
            cells.push_back(predicted);
            const bool has_limit = predicted > 0 && std::isfinite(predicted);
            // near its limit a stable run may stray to a hundred times its start
            const long steps =
                has_limit ? std::max(10'000L, theory.steps_to_grow(3e3, c.omega, c.nu)) : 0;
            if (!has_limit || steps > longest_run) {
                cells.push_back("");
                continue;
            }
            const auto stable = [&](double dt) {
                return lab::stays_within(spring_of(c.omega, c.nu), method, dt, steps, 1000,
                                         [](const auto& s) { return size_of(s); });
            };
            const double found =
                lab::stability_limit(stable, 0.98 * predicted, 1.02 * predicted, 1e-3);
            const std::string key = "limit." + method.key() + "." + c.key;
            report.number(key, predicted, "", "limits.csv");
            report.number(key + ".found", found, "", "limits.csv");
            cells.push_back(found);
        }
        table.add(cells);
    });
    report.number("limits.longest_run", longest_run, "steps");
    report.print(table);
    report.data("limits.csv", table);
}

constexpr int grid = 141;

/// |one step| - 1 over the plane of z = lambda dt, by making the step: y' = lambda y as a
/// rotation and a stretch.
struct Linear {
    double a, b;  // lambda dt = a + ib
    Eigen::Vector2d start{1, 0};
    Eigen::Vector2d operator()(const Eigen::Vector2d& y, double) const {
        return {a * y[0] - b * y[1], b * y[0] + a * y[1]};
    }
};

template <class Method>
chart::Region general_region(const Method& method) {
    const double left = -4, right = 0.8, top = 3.2;
    chart::Region region{method.name, left, right, -top, top, grid, grid, {}, method.look};
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j) {
            const Linear scene{left + (right - left) * j / (grid - 1),
                               -top + 2 * top * i / (grid - 1)};
            auto step = method.start(scene);
            region.values.push_back(step(scene.start, scene, 0.0, 1.0).norm() - 1 - 1e-9);
        }
    return region;
}

/// The border |R(z)| = 1: follow R(z) = e^(i phi) from z = 0 until it comes back.
chart::Series border(Complex (*stability)(Complex)) {
    chart::Series line;
    line.draw = chart::Draw::theory;
    Complex z = 0;
    for (int n = 0; n < 40 * 60; ++n) {
        const Complex target = std::polar(1.0, 2 * pi * n / 60);
        for (int iteration = 0; iteration < 20; ++iteration) {
            const Complex h = 1e-6, slope = (stability(z + h) - stability(z - h)) / (2. * h);
            z -= (stability(z) - target) / slope;
        }
        line.add(z.real(), z.imag());
        if (n > 30 && std::abs(z) < 1e-6) break;
    }
    return line;
}

/// Euler's method for a flat state, which has no drift and kick.
const Method flat_euler{methods::euler.name, methods::euler.look, 1, 1,
                        on_flat([](const auto& y, const auto& f, double t, double dt) {
                            return (y + dt * f(y, t)).eval();
                        })};

struct General {
    chart::Region region;
    Complex (*stability)(Complex);
    bool ringed;  ///< too narrow between its neighbours for a name: a ring on its border has it
};

void general_regions(lab::Report& report, const std::string& file,
                     const std::vector<General>& methods) {
    chart::Chart chart;
    chart.title = "Where a step is stable";
    chart.subtitle = "Filled: measured, one step of y' = λy. Dashed: theory, |R(z)| = 1.";
    chart.x = {"Re λ dt", chart::Scale::linear, -4, 0.8};
    chart.y = {"Im λ dt", chart::Scale::linear, -3.2, 3.2};
    chart.equal_aspect = true;
    chart.height = 640;
    for (const General& method : methods) {
        const chart::Series line = border(method.stability);
        chart.regions.push_back(method.region), chart.series.push_back(line);
        if (!method.ringed) continue;
        std::size_t upper_left = 0;
        for (std::size_t k = 0; k < line.x.size(); ++k)
            if (line.y[k] - line.x[k] > line.y[upper_left] - line.x[upper_left]) upper_left = k;
        chart.rings.push_back({line.x[upper_left], line.y[upper_left], method.region.name});
        chart.regions.back().name = "";
    }
    chart::write_svg(chart, report.path(file));
}

/// The same for kick-and-drift methods: z and its mirror image are the two rates of a damped
/// spring with omega dt = |z| and nu dt = -2 Re z; the value is the largest eigenvalue of one
/// step, less 1.
template <class Method>
chart::Region spring_region(const Method& method) {
    const double left = -2.4, right = 0.6, top = 2.6;
    chart::Region region{"", left, right, 0, top, grid, grid, {}, method.look};
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j) {
            const Complex z(left + (right - left) * j / (grid - 1), top * i / (grid - 1));
            const MassOnSpring scene = spring_of(std::abs(z), -2 * z.real());
            const auto moved = [&](const Vector3& x, const Vector3& v) {
                return method.start(scene)(PointMass{1, x, v}, scene, 0.0, 1.0);
            };
            const PointMass a = moved({1, 0, 0}, {0, 0, 0}), b = moved({0, 0, 0}, {1, 0, 0});
            const double half_trace = (a.position.x() + b.velocity.x()) / 2;
            const double determinant =
                a.position.x() * b.velocity.x() - a.velocity.x() * b.position.x();
            const Complex root = std::sqrt(Complex(half_trace * half_trace - determinant));
            region.values.push_back(
                std::max(std::abs(half_trace + root), std::abs(half_trace - root)) - 1 - 1e-7);
        }
    return region;
}

/// A border given as theta = omega dt for each nu dt, drawn where the spring is underdamped.
template <class Theta>
chart::Series spring_border(double most_drag, const Theta& theta) {
    chart::Series line;
    line.draw = chart::Draw::theory;
    for (int n = 0; n <= 400; ++n) {
        const double G = most_drag * n / 400, square = theta(G) * theta(G) - G * G / 4;
        if (square >= 0) line.add(-G / 2, std::sqrt(square));
    }
    return line;
}

void spring_regions(lab::Report& report) {
    chart::Chart chart;
    chart.title = "A damped spring, kicked and drifted";
    chart.subtitle =
        "Filled: measured, the largest eigenvalue of one step. Dashed: the closed forms.";
    chart.x = {"Re λ dt", chart::Scale::linear, -2.4, 0.6};
    chart.y = {"Im λ dt", chart::Scale::linear, 0, 2.6};
    chart.equal_aspect = true;
    chart.regions = {spring_region(methods::verlet_re_evaluated),
                     spring_region(methods::exponential_verlet),
                     spring_region(methods::semi_implicit_euler)};
    const auto verlet = [](double G) {
        const double a = 1 - G / 2;
        return 2 * std::sqrt((1 + a * a) / (1 + a));
    };
    const auto exponential = [](double) { return 2.0; };
    const auto semi_implicit = [](double G) { return std::sqrt(4 - 2 * G); };
    chart.series = {spring_border(3.999, verlet), spring_border(4, exponential),
                    spring_border(2, semi_implicit)};
    const auto name = [&](double G, const auto& theta, const std::string& words) {
        chart.rings.push_back({-G / 2, std::sqrt(theta(G) * theta(G) - G * G / 4), words});
    };
    name(1.0, semi_implicit, methods::semi_implicit_euler.name);
    name(2.6, exponential, methods::exponential_verlet.name);
    name(1.6, verlet, methods::verlet_re_evaluated.name);
    chart::write_svg(chart, report.path("regions_spring.svg"));
}

}  // namespace

void limits(lab::Report& report) {
    report.heading("Largest stable step, predicted and found: omega dt (drag alone: gamma dt/m)");
    limits_table(report);
    const General euler{general_region(flat_euler), StabilityFunction::euler, false},
        rk4{general_region(methods::rk4), StabilityFunction::rk4, false};
    general_regions(report, "regions.svg", {rk4, euler});
    general_regions(
        report, "regions_all.svg",
        {{general_region(methods::dormand_prince), StabilityFunction::dormand_prince, true},
         rk4,
         {general_region(methods::explicit_midpoint), StabilityFunction::explicit_midpoint, true},
         euler});
    spring_regions(report);
}

}  // namespace nutshell
