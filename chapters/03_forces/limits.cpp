// Where each method breaks: the limit from theory, found again by runs; and the regions of the
// lambda dt plane.
#include "entries.hpp"
#include "method_limits.hpp"
#include "program.hpp"

namespace nutshell {

namespace {

/// The four scenes of the table; a limit is shown as omega dt, for drag alone as gamma dt/m.
struct Column {
    const char *name, *key;
    double omega, g;
};
const Column columns[] = {{"undamped", "undamped", 1, 0},
                          {"damped, 0.1", "damped", 1, 0.2},
                          {"overdamped, 2", "overdamped", 1, 4},
                          {"drag alone", "drag", 0, 1}};

void limits_table(lab::Report& report) {
    lab::Table table{
        {"method: predicted, found", "undamped", "damped, 0.1", "overdamped, 2", "drag alone"},
        {}};
    each_method<Vector3, FlatPoint>([&](const std::string& name, const auto& method, auto as,
                                        const OnSpring& theory) {
        std::vector<std::string> cells{name};
        for (const Column& c : columns) {
            const double predicted = theory.limit(c.omega, c.g);
            if (predicted == 0 || !std::isfinite(predicted)) {
                cells.push_back(predicted == 0 ? "never" : "always");
                continue;
            }
            const long steps = std::max(30'000L, theory.steps_to_grow(3e3, c.omega, c.g));
            const auto stable = [&](double dt) {
                return lab::stays_within(as(spring_of(c.omega, c.g)), method, dt, steps, 1000,
                                         [](const auto& s) { return size_of(s); });
            };
            const double found =
                lab::stability_limit(stable, predicted / 2, predicted * 1.1, 1e-3);
            const std::string key = "limit." + key_of(name) + "." + c.key;
            report.number(key, predicted);
            report.number(key + ".found", found);
            cells.push_back(lab::rounded(predicted, "%.4f") + " " + lab::rounded(found, "%.4f"));
        }
        table.add(cells);
    });
    report.print(table);
    report.data("limits.csv", table);
}

constexpr int grid = 141;

/// |one step| - 1 over the plane of z = lambda dt, by making the step: y' = lambda y as a
/// rotation and a stretch.
template <class Method>
chart::Region general_region(const std::string& name, Method method, double left, double right,
                             double top) {
    using Flat = Eigen::Vector2d;
    chart::Region region{name, left, right, -top, top, grid, grid, {}, name};
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j) {
            const double a = left + (right - left) * j / (grid - 1),
                         b = -top + 2 * top * i / (grid - 1);
            const auto flow = [=](const Flat& y, double) -> Flat {
                return {a * y[0] - b * y[1], b * y[0] + a * y[1]};
            };
            region.values.push_back(Method(method)(Flat(1, 0), flow, 0.0, 1.0).norm() - 1 - 1e-9);
        }
    return region;
}

/// The border |R(z)| = 1: follow R(z) = e^(i phi) from z = 0 until it comes back.
chart::Series border(Complex (*amplification)(Complex)) {
    chart::Series line;
    line.draw = chart::Draw::theory;
    Complex z = 0;
    for (int n = 0; n < 40 * 60; ++n) {
        const Complex target = std::polar(1.0, 2 * pi * n / 60);
        for (int turn = 0; turn < 20; ++turn) {
            const Complex h = 1e-6,
                          slope = (amplification(z + h) - amplification(z - h)) / (2. * h);
            z -= (amplification(z) - target) / slope;
        }
        line.x.push_back(z.real()), line.y.push_back(z.imag());
        if (n > 30 && std::abs(z) < 1e-6) break;
    }
    return line;
}

void general_regions(lab::Report& report) {
    chart::Chart chart;
    chart.title = "Where a step is stable";
    chart.subtitle = "Filled: measured, one step of y' = λy. Dashed: theory, |R(z)| = 1.";
    chart.x = {"Re λ dt", chart::Scale::linear, -4, 0.8};
    chart.y = {"Im λ dt", chart::Scale::linear, -3.2, 3.2};
    chart.equal_aspect = true;
    chart.height = 640;
    chart.regions = {
        general_region("Dormand-Prince 5(4)", DormandPrince<Eigen::Vector2d>{}, -4, 0.8, 3.2),
        general_region("RK4", rk4_method, -4, 0.8, 3.2),
        general_region("explicit midpoint", explicit_midpoint_method, -4, 0.8, 3.2),
        general_region(
            "Euler",
            [](const auto& y, const auto& flow, double t, double dt) -> Eigen::Vector2d {
                return y + dt * flow(y, t);
            },
            -4, 0.8, 3.2)};
    for (auto* amplification : {Amplification::dormand_prince, Amplification::rk4,
                                Amplification::midpoint, Amplification::euler})
        chart.series.push_back(border(amplification));
    chart::write_svg(chart, report.path("regions.svg"));
}

/// The same for kick-and-drift methods: z and its mirror image are the two rates of a damped
/// spring with omega dt = |z| and g dt = -2 Re z; the value is the largest eigenvalue of one
/// step, less 1.
template <class Method>
chart::Region spring_region(const std::string& style, const Method& method) {
    const double left = -2.4, right = 0.6, top = 2.6;
    chart::Region region{"", left, right, 0, top, grid, grid, {}, style};
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j) {
            const Complex z(left + (right - left) * j / (grid - 1), top * i / (grid - 1));
            const MassOnSpring scene = spring_of(std::abs(z), -2 * z.real());
            const PointMass a = method(PointMass{1, {1, 0, 0}, {0, 0, 0}}, scene, 0.0, 1.0);
            const PointMass b = method(PointMass{1, {0, 0, 0}, {1, 0, 0}}, scene, 0.0, 1.0);
            const double half_trace = (a.position.x() + b.velocity.x()) / 2;
            const double determinant =
                a.position.x() * b.velocity.x() - a.velocity.x() * b.position.x();
            const Complex root = std::sqrt(Complex(half_trace * half_trace - determinant));
            region.values.push_back(
                std::max(std::abs(half_trace + root), std::abs(half_trace - root)) - 1 - 1e-7);
        }
    return region;
}

/// A border given as theta = omega dt for each G = g dt, drawn where the spring is underdamped.
template <class Theta>
chart::Series spring_border(double most_drag, const Theta& theta) {
    chart::Series line;
    line.draw = chart::Draw::theory;
    std::vector<std::pair<double, double>> upper;
    for (int n = 0; n <= 400; ++n) {
        const double G = most_drag * n / 400, square = theta(G) * theta(G) - G * G / 4;
        if (square >= 0) upper.emplace_back(-G / 2, std::sqrt(square));
    }
    for (const auto& [x, y] : upper) line.x.push_back(x), line.y.push_back(y);
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
    chart.regions = {spring_region("Verlet, naive", verlet_method),
                     spring_region("exponential Verlet", exponential_verlet_method),
                     spring_region("semi-implicit Euler", semi_implicit_euler_method)};
    const auto naive = [](double G) {
        const double a = 1 - G / 2;
        return 2 * std::sqrt((1 + a * a) / (1 + a));
    };
    const auto exponential = [](double) { return 2.0; };
    const auto semi_implicit = [](double G) { return std::sqrt(4 - 2 * G); };
    chart.series = {spring_border(3.999, naive), spring_border(4, exponential),
                    spring_border(2, semi_implicit)};
    const auto name = [&](double G, const auto& theta, const std::string& words) {
        chart.rings.push_back({-G / 2, std::sqrt(theta(G) * theta(G) - G * G / 4), words});
    };
    name(1.0, semi_implicit, "semi-implicit Euler");
    name(2.6, exponential, "exponential Verlet");
    name(1.6, naive, "Verlet, naive");
    chart::write_svg(chart, report.path("regions_spring.svg"));
}

}  // namespace

void limits(lab::Report& report) {
    report.heading("Largest stable step, predicted and found: omega dt (drag alone: gamma dt/m)");
    limits_table(report);
    general_regions(report);
    spring_regions(report);
}

}  // namespace nutshell
