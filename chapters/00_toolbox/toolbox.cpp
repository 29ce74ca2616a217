// The toolbox's charts and numbers.  ./course run 0  runs it; results in out/00_toolbox.
#include <nutshell/chart/chart.hpp>
#include <nutshell/chart/diagram.hpp>
#include <nutshell/lab/parts.hpp>
#include <nutshell/toolbox.hpp>

namespace nutshell {

namespace {

using chart::Chart;
using chart::Draw;
using chart::Scale;
using chart::Series;

Chart plane(const std::string& title, const std::string& subtitle) {
    Chart chart;
    chart.title = title;
    chart.subtitle = subtitle;
    chart.x.name = "x";
    chart.y.name = "y";
    chart.equal_aspect = true;
    return chart;
}

void products(lab::Report& report) {
    report.heading("Two products of vectors");
    const Vector3 v{2, 1.5, 0}, along{3, 0.6, 0}, n = along.normalized();
    const double part = part_along(v, n);
    report.number("dot.length", v.norm());
    report.number("dot.part", part);
    report.number("dot.rest", (v - part * n).dot(n));
    report.number("cross.area", triangle_area(v, along));
    report.say("v = (2, 1.5) has length " + lab::rounded(v.norm()) + "; along (3, 0.6) it has " +
               lab::rounded(part) + ", and what is left has " +
               lab::rounded((v - part * n).dot(n)) + " along it.");
    const Vector3 foot = part * n, corner = 0.12 * (v - foot).normalized(), far = 3 * n;
    const auto place = [](const Vector3& p) { return chart::Place{p.x(), p.y()}; };
    chart::Diagram d;
    d.title = "A vector is its part along n and a rest";
    d.subtitle = "The rest is at right angles to n.";
    d.dashed({{0, 0}, place(far)}).note(place(far), "along n");
    d.dashed({place(foot - 0.12 * n), place(foot - 0.12 * n + corner), place(foot + corner)});
    d.arrow({0, 0}, place(v), chart::Quantity::velocity, "v");
    d.arrow({0, 0}, place(foot), chart::Quantity::plain,
            "part along n, " + lab::rounded(part, "%.2f"));
    d.arrow(place(foot), place(v - foot), chart::Quantity::plain, "rest");
    d.width = 520;
    chart::write_svg(d, report.path("dot.svg"));
}

void slopes(lab::Report& report) {
    report.heading("Slope and area of sin x");
    const auto f = [](double x) { return std::sin(x); };
    const double x = 1, exact = std::cos(x);
    Series one_side{"one side", {}, {}}, both{"both sides", {}, {}};
    for (int k = 0; k <= 12; ++k) {
        const double h = std::pow(10, -k);
        one_side.x.push_back(h), both.x.push_back(h);
        one_side.y.push_back(std::abs((f(x + h) - f(x)) / h - exact));
        both.y.push_back(std::abs(slope(f, x, h) - exact));
    }
    report.number("slope.one_side", one_side.y[2]);
    report.number("slope.both_sides", both.y[2]);
    report.number("area.10", std::abs(area_under(f, 0, pi, 10) - 2));
    report.number("area.20", std::abs(area_under(f, 0, pi, 20) - 2));
    report.number("area.gain", (area_under(f, 0, pi, 10) - 2) / (area_under(f, 0, pi, 20) - 2));
    Chart chart;
    chart.title = "Ask on both sides, and do not come too close";
    chart.subtitle = "Slope of sin x at x = 1: error against the distance h.";
    chart.x = {"distance h", Scale::logarithmic};
    chart.y = {"error of the slope", Scale::logarithmic};
    chart.series = {one_side, both};
    chart.guides = {1, 2};
    chart::write_svg(chart, report.path("slope.svg"));
}

void growth(lab::Report& report) {
    report.heading("Growth in steps");
    Chart chart;
    chart.title = "More steps of growth come to the exponential";
    chart.subtitle =
        "y grows by y per second. In n steps it comes to (1 + 1/n)ⁿ after one second.";
    chart.x.name = "time [s]";
    chart.y.name = "y";
    for (const int n : {1, 2, 4, 16}) {
        Series steps{"n = " + std::to_string(n), {0}, {1}, Draw::line_and_marks};
        for (int i = 1; i <= n; ++i) {
            steps.x.push_back(static_cast<double>(i) / n);
            steps.y.push_back(steps.y.back() * (1 + 1.0 / n));
        }
        report.number("growth.steps_" + std::to_string(n), steps.y.back());
        chart.series.push_back(steps);
    }
    Series exact{"eᵗ", {}, {}, Draw::theory};
    for (int i = 0; i <= 40; ++i)
        exact.x.push_back(i / 40.0), exact.y.push_back(grown(1, 1, i / 40.0));
    chart.series.push_back(exact);
    report.number("growth.e", grown(1, 1, 1));
    report.number("growth.half_life", std::log(2) / 0.5, "s");
    report.number("growth.left", grown(1, -0.5, 3));
    chart::write_svg(chart, report.path("growth.svg"));
}

void turns(lab::Report& report) {
    report.heading("Turns and spirals");
    Chart chart = plane("Multiplied again and again by one number",
                        "Each time it turns by 20°. Its size decides what becomes of the point.");
    for (const double size : {0.95, 1.0, 1.03}) {
        Series path{"size " + lab::rounded(size), {}, {}, Draw::line_and_marks};
        for (Complex z = 1; path.x.size() < 25; z = turned(z * size, pi / 9)) {
            path.x.push_back(z.real());
            path.y.push_back(z.imag());
        }
        report.number("turns.after_24." + lab::rounded(size, "%.2f"),
                      std::hypot(path.x.back(), path.y.back()));
        chart.series.push_back(path);
    }
    const Complex quarter = turned({3, 1}, pi / 2);
    report.number("turns.quarter.x", quarter.real());
    report.number("turns.quarter.y", quarter.imag());
    const Complex swings = spiralled(1, {-0.5, 2 * pi}, 1);
    report.number("turns.spiral.size", std::abs(swings));
    report.number("turns.spiral.angle", std::arg(swings), "rad");
    chart::write_svg(chart, report.path("turns.svg"));
}

void matrices(lab::Report& report) {
    report.heading("One matrix again and again");
    const Matrix2 A{{1.1, 0.2}, {0.3, 0.6}};
    Chart chart =
        plane("Every start ends along one line",
              "Five starts, the same matrix applied six times. Lengths are set to 1, 2, 3 "
              "and so on, so that the way shows.");
    for (int start = 0; start < 5; ++start) {
        const double angle = 0.3 + start * 0.6;
        Vector2 v{std::cos(angle), std::sin(angle)};
        Series path{"", {}, {}, Draw::line_and_marks};
        for (int i = 1; i <= 7; ++i) {
            path.x.push_back(i * v.x());
            path.y.push_back(i * v.y());
            v = mapped(A, v).normalized();
        }
        chart.series.push_back(path);
    }
    Vector2 v{1, 0};
    for (int i = 0; i < 60; ++i) v = mapped(A, v).normalized();
    Series line{"the line", {-7 * v.x(), 7 * v.x()}, {-7 * v.y(), 7 * v.y()}, Draw::ghost};
    line.look = Look{Family::exact};
    chart.series.push_back(line);
    report.number("matrix.trace", A.trace());
    report.number("matrix.determinant", A.determinant());
    report.number("matrix.factor", largest_factor(A));
    report.number("matrix.measured", mapped(A, v).norm());
    const double theta = 0.5;  // Euler's step on a spring: position, velocity / omega
    const Matrix2 euler{{1, theta}, {-theta, 1}};
    report.number("matrix.euler.factor", largest_factor(euler));
    report.number("matrix.euler.steps_to_double", std::log(2) / std::log(largest_factor(euler)));
    chart::write_svg(chart, report.path("matrix.svg"));
}

void newton(lab::Report& report) {
    report.heading("Newton's method for the square root of 2");
    const auto f = [](double x) { return x * x - 2; };
    const auto df = [](double x) { return 2 * x; };
    lab::Table table{{"turns", "x", "error"}, {}};
    for (int turns = 0; turns <= 5; ++turns) {
        const double x = newton_root(f, df, 3, turns);
        table.add({std::to_string(turns), lab::rounded(x, "%.15f"),
                   lab::rounded(std::abs(x - std::sqrt(2)))});
        report.number("newton.error_" + std::to_string(turns), std::abs(x - std::sqrt(2)));
    }
    report.print(table);
    Chart chart;
    chart.title = "Down the tangent to where it crosses zero";
    chart.subtitle = "x² = 2, from the guess 3.";
    chart.x.name = "x";
    chart.y.name = "x² − 2";
    Series curve{"x² − 2", {}, {}, Draw::line},
        steps{"Newton's way", {}, {}, Draw::line_and_marks};
    for (int i = 0; i <= 40; ++i) {
        curve.x.push_back(1 + i * 0.055);
        curve.y.push_back(f(curve.x.back()));
    }
    for (int turns = 0; turns <= 2; ++turns) {
        const double x = newton_root(f, df, 3, turns);
        steps.x.insert(steps.x.end(), {x, x});
        steps.y.insert(steps.y.end(), {0, f(x)});
    }
    chart.series = {curve, steps};
    chart::write_svg(chart, report.path("newton.svg"));
}

}  // namespace

}  // namespace nutshell

int main(int argc, char** argv) {
    using namespace nutshell;
    return lab::program(argc, argv, "00_toolbox",
                        {{"products", products},
                         {"slopes", slopes},
                         {"growth", growth},
                         {"turns", turns},
                         {"matrices", matrices},
                         {"newton", newton}});
}
