// Where each method breaks: the limit from theory, found again by runs; and the regions of the lambda dt plane.
#include <nutshell/lab/stability.hpp>
#include <nutshell/stability_limits.hpp>
#include "entries.hpp"
#include "program.hpp"

namespace nutshell {

namespace {

MassOnSpring scene_of(double omega, double g) {
    MassOnSpring scene;
    scene.stiffness = omega * omega, scene.drag = g;
    scene.start = {1, {1, 0, 0}, {0.7, 0, 0}};
    return scene;
}

double size_of(const PointMass& s) { return std::max(std::abs(s.position.x()), std::abs(s.velocity.x())); }
double size_of(const FlatPoint& y) { return y.cwiseAbs().maxCoeff(); }

/// The largest stable step by bisection on runs, between half and 1.1 times the predicted one.
template <class Scene, class Method>
double found(const Scene& scene, const Method& method, double predicted) {
    const auto stable = [&](double dt) {
        return lab::stays_within(scene, method, dt, 30000, 200, [](const auto& s) { return size_of(s); });
    };
    return lab::stability_limit(stable, predicted / 2, predicted * 1.1, 1e-3);
}

/// The step as a matrix on (x, v): for the methods whose limit has no formula.
template <class Method>
double by_eigenvalue(double omega, double g, const Method& method, double low, double high) {
    const MassOnSpring scene = scene_of(omega, g);
    return lab::spectral_limit([&](double dt) {
        return lab::step_matrix(Eigen::VectorXd::Zero(2), [&](const Eigen::VectorXd& y) -> Eigen::VectorXd {
            Method fresh = method;
            const PointMass body = fresh(PointMass{1, {y[0], 0, 0}, {y[1], 0, 0}}, scene, 0.0, dt);
            return Eigen::Vector2d(body.position.x(), body.velocity.x());
        });
    }, low, high);
}

/// The four scenes of the table: omega and g; the limit is given as omega dt, for drag alone as gamma dt/m.
struct Column {
    const char *name, *key;
    double omega, g;
};
const Column columns[] = {{"undamped", "undamped", 1, 0}, {"damped, 0.1", "damped", 1, 0.2},
                          {"overdamped, 2", "overdamped", 1, 4}, {"drag alone", "drag", 0, 1}};

/// One row: a limit from theory for each scene (0: never stable, infinite: always), and the same found by runs.
template <class Theory, class Found>
void row(lab::Report& report, lab::Table& table, const std::string& name, const Theory& theory, const Found& by_runs) {
    std::vector<std::string> cells{name};
    for (const Column& c : columns) {
        const double predicted = theory(c.omega, c.g);
        const std::string key = "limit." + key_of(name) + "." + c.key;
        if (predicted == 0) {
            cells.push_back("never");
        } else if (!std::isfinite(predicted)) {
            cells.push_back("always");
        } else {
            const double measured = by_runs(scene_of(c.omega, c.g), predicted);
            report.number(key, predicted);
            report.number(key + ".found", measured);
            cells.push_back(lab::rounded(predicted, "%.4f") + " " + lab::rounded(measured, "%.4f"));
        }
    }
    table.add(cells);
}

void limits_table(lab::Report& report) {
    lab::Table table{{"method: predicted, found", "undamped", "damped, 0.1", "overdamped, 2", "drag alone"}, {}};
    const auto kick_drift = [&](const std::string& name, const auto& method, const auto& theory) {
        row(report, table, name, theory, [&](const MassOnSpring& scene, double limit) { return found(scene, method, limit); });
    };
    const auto general = [&](const std::string& name, const auto& method, Complex (*amplification)(Complex)) {
        row(report, table, name, [&](double omega, double g) { return general_limit(amplification, omega, g); },
            [&](const MassOnSpring& scene, double limit) { return found(Flow(scene), method, limit); });
    };
    const double infinite = std::numeric_limits<double>::infinity();
    kick_drift("Euler", euler_method, [](double omega, double g) { return euler_limit(omega, g); });
    kick_drift("semi-implicit Euler", semi_implicit_euler_method, [](double omega, double g) { return semi_implicit_limit(omega, g); });
    kick_drift("semi-implicit, implicit drag", semi_implicit_division_method,
               [=](double omega, double g) { return omega > 0 ? division_limit(omega, g) : infinite; });
    kick_drift("semi-implicit, exponential drag", semi_implicit_exponential_method,
               [=](double omega, double g) { return omega > 0 ? exponential_limit(omega, g) : infinite; });
    kick_drift("Verlet, naive", verlet_method, [](double omega, double g) { return naive_verlet_limit(omega, g); });
    kick_drift("exponential Verlet", exponential_verlet_method,
               [=](double omega, double) { return omega > 0 ? exponential_verlet_limit(omega) : infinite; });
    kick_drift("Yoshida 4, naive", Composed<Verlet, 3>{{}, yoshida_weights()}, [](double omega, double g) {
        return by_eigenvalue(omega, g, Composed<Verlet, 3>{{}, yoshida_weights()}, 0.1, omega > 0 ? 1.8 : 2.6);
    });
    kick_drift("exponential Yoshida 4", exponential_yoshida4(), [=](double omega, double g) {
        return omega > 0 ? by_eigenvalue(omega, g, exponential_yoshida4(), 0.1, 2.5) : infinite;
    });
    general("explicit midpoint", explicit_midpoint_method, Amplification::midpoint);
    general("RK4", rk4_method, Amplification::rk4);
    general("implicit Euler", implicit_euler_method, Amplification::implicit_euler);
    general("implicit midpoint", implicit_midpoint_method, Amplification::implicit_midpoint);
    report.print(table);
    report.data("limits.csv", table);
    report.number("limit.kahan_li_8.undamped", by_eigenvalue(1, 0, kahan_li8(), 0.5, 5));
    report.number("limit.dormand_prince.undamped", general_limit(Amplification::dormand_prince, 1, 0));
    report.number("limit.dormand_prince.drag", general_limit(Amplification::dormand_prince, 0, 1));
}

constexpr int grid = 141;

/// |one step| - 1 over the plane of z = lambda dt, by making the step: y' = lambda y as a rotation and a stretch.
template <class Method>
lab::Region general_region(const std::string& name, Method method, double left, double right, double top) {
    using Flat = Eigen::Vector2d;
    lab::Region region{name, left, right, -top, top, grid, grid, {}, name};
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j) {
            const double a = left + (right - left) * j / (grid - 1), b = -top + 2 * top * i / (grid - 1);
            const auto flow = [=](const Flat& y, double) -> Flat { return {a * y[0] - b * y[1], b * y[0] + a * y[1]}; };
            region.values.push_back(Method(method)(Flat(1, 0), flow, 0.0, 1.0).norm() - 1 - 1e-9);
        }
    return region;
}

/// The border |R(z)| = 1: follow R(z) = e^(i phi) from z = 0 until it comes back.
lab::Series border(Complex (*amplification)(Complex)) {
    lab::Series line;
    line.draw = lab::Draw::theory;
    Complex z = 0;
    for (int n = 0; n < 40 * 60; ++n) {
        const Complex target = std::polar(1.0, 2 * pi * n / 60);
        for (int turn = 0; turn < 20; ++turn) {
            const Complex h = 1e-6, slope = (amplification(z + h) - amplification(z - h)) / (2. * h);
            z -= (amplification(z) - target) / slope;
        }
        line.x.push_back(z.real()), line.y.push_back(z.imag());
        if (n > 30 && std::abs(z) < 1e-6) break;
    }
    return line;
}

void general_regions(lab::Report& report) {
    lab::Chart chart;
    chart.title = "Where a step is stable";
    chart.subtitle = "Filled: measured, one step of y' = λy. Dashed: theory, |R(z)| = 1.";
    chart.x = {"Re λ dt", lab::Scale::linear, -4, 0.8};
    chart.y = {"Im λ dt", lab::Scale::linear, -3.2, 3.2};
    chart.equal_aspect = true;
    chart.height = 640;
    chart.regions = {general_region("Dormand-Prince 5(4)", DormandPrince<Eigen::Vector2d>{}, -4, 0.8, 3.2),
                     general_region("RK4", rk4_method, -4, 0.8, 3.2),
                     general_region("explicit midpoint", explicit_midpoint_method, -4, 0.8, 3.2),
                     general_region("Euler", [](const auto& y, const auto& flow, double t, double dt) -> Eigen::Vector2d {
                         return y + dt * flow(y, t);
                     }, -4, 0.8, 3.2)};
    for (auto* amplification : {Amplification::dormand_prince, Amplification::rk4, Amplification::midpoint, Amplification::euler})
        chart.series.push_back(border(amplification));
    lab::write_svg(chart, report.path("regions.svg"));
}

/// The same for kick-and-drift methods: z and its mirror image are the two rates of a damped spring with
/// omega dt = |z| and g dt = -2 Re z; the value is the largest eigenvalue of one step, less 1.
template <class Method>
lab::Region spring_region(const std::string& style, const Method& method) {
    const double left = -2.4, right = 0.6, top = 2.6;
    lab::Region region{"", left, right, 0, top, grid, grid, {}, style};
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j) {
            const Complex z(left + (right - left) * j / (grid - 1), top * i / (grid - 1));
            const MassOnSpring scene = scene_of(std::abs(z), -2 * z.real());
            const PointMass a = method(PointMass{1, {1, 0, 0}, {0, 0, 0}}, scene, 0.0, 1.0);
            const PointMass b = method(PointMass{1, {0, 0, 0}, {1, 0, 0}}, scene, 0.0, 1.0);
            const double half_trace = (a.position.x() + b.velocity.x()) / 2;
            const double determinant = a.position.x() * b.velocity.x() - a.velocity.x() * b.position.x();
            const Complex root = std::sqrt(Complex(half_trace * half_trace - determinant));
            region.values.push_back(std::max(std::abs(half_trace + root), std::abs(half_trace - root)) - 1 - 1e-7);
        }
    return region;
}

/// A border given as theta = omega dt for each G = g dt, drawn where the spring is underdamped.
template <class Theta>
lab::Series spring_border(double most_drag, const Theta& theta) {
    lab::Series line;
    line.draw = lab::Draw::theory;
    std::vector<std::pair<double, double>> upper;
    for (int n = 0; n <= 400; ++n) {
        const double G = most_drag * n / 400, square = theta(G) * theta(G) - G * G / 4;
        if (square >= 0) upper.emplace_back(-G / 2, std::sqrt(square));
    }
    for (const auto& [x, y] : upper) line.x.push_back(x), line.y.push_back(y);
    return line;
}

void spring_regions(lab::Report& report) {
    lab::Chart chart;
    chart.title = "A damped spring, kicked and drifted";
    chart.subtitle = "Filled: measured, the largest eigenvalue of one step. Dashed: the closed forms.";
    chart.x = {"Re λ dt", lab::Scale::linear, -2.4, 0.6};
    chart.y = {"Im λ dt", lab::Scale::linear, 0, 2.6};
    chart.equal_aspect = true;
    chart.regions = {spring_region("Verlet, naive", verlet_method), spring_region("exponential Verlet", exponential_verlet_method),
                     spring_region("semi-implicit Euler", semi_implicit_euler_method)};
    const auto naive = [](double G) {
        const double a = 1 - G / 2;
        return 2 * std::sqrt((1 + a * a) / (1 + a));
    };
    const auto exponential = [](double) { return 2.0; };
    const auto semi_implicit = [](double G) { return std::sqrt(4 - 2 * G); };
    chart.series = {spring_border(3.999, naive), spring_border(4, exponential), spring_border(2, semi_implicit)};
    const auto name = [&](double G, const auto& theta, const std::string& words) {
        chart.rings.push_back({-G / 2, std::sqrt(theta(G) * theta(G) - G * G / 4), words});
    };
    name(1.0, semi_implicit, "semi-implicit Euler");
    name(2.6, exponential, "exponential Verlet");
    name(1.6, naive, "Verlet, naive");
    lab::write_svg(chart, report.path("regions_spring.svg"));
}

}  // namespace

void limits(lab::Report& report) {
    report.heading("Largest stable step, predicted and found: omega dt (drag alone: gamma dt/m)");
    limits_table(report);
    general_regions(report);
    spring_regions(report);
}

}  // namespace nutshell
