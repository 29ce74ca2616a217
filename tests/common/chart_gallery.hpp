// One chart of each kind, and where their texts stand.
#pragma once
#include <nutshell/chart/chart.hpp>
#include <nutshell/forces_methods.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <locale>
#include <numbers>
#include <sstream>

#include "chart_parts.hpp"
#include "svg_reader.hpp"

namespace gallery_of_charts {

using namespace nutshell::chart;
using nutshell::Look;
namespace methods = nutshell::methods;

inline std::string wide_svg(const Chart& chart) {
    return wide_layout(svg(chart));
}

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Errors C * cost^-order down to a floor of round-off.
template <class Method>
Series power_law(const Method& method, double factor, double order) {
    Series s = series_of(method);
    for (double cost = 100; cost < 2e5; cost *= 2) {
        s.x.push_back(cost);
        s.y.push_back(std::max(factor * std::pow(cost / 100, -order), 1e-12));
    }
    return s;
}

inline Chart work_precision_chart() {
    Chart c;
    c.title = "Which method gives the most accuracy for the work?";
    c.subtitle =
        "Planet, e = 0.6, one orbit. Down and left is better, and this sentence is long enough to be broken.";
    c.x = {"force evaluations", Scale::logarithmic};
    c.y = {"largest position error [m]", Scale::logarithmic};
    c.series = {power_law(methods::euler, 5, 1),
                power_law(methods::semi_implicit_euler, 1, 1),
                power_law(methods::verlet, 0.3, 2),
                power_law(methods::rk4, 0.2, 4),
                power_law(methods::yoshida4, 0.1, 4),
                power_law(methods::kahan_li8, 0.5, 8),
                power_law(methods::dormand_prince, 0.05, 5)};
    c.tolerance = Level{1e-3, "1 mm: a pixel at 2 m"};
    c.guides = {-1, -2, -4};
    c.ring_cheapest = true;
    return c;
}

inline Chart time_series() {
    Chart c;
    c.title = "A long run";
    c.x = {"time [s]"}, c.y = {"position [m]"};
    Series s{"60 Hz"};
    for (int i = 0; i < 100'000; ++i) s.x.push_back(i * 0.001), s.y.push_back(std::sin(i * 0.05));
    s.y[54'321] = 3;  // must survive the thinning
    c.series = {s};
    c.levels_y = {{1, "amplitude"}}, c.levels_x = {{50, "half time"}};
    return c;
}

inline Region disc(const std::string& name, double radius, int n) {
    Region r{name, -2, 2, -2, 2, n, n};
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            r.values.push_back(std::hypot(-2 + 4.0 * i / (n - 1), -2 + 4.0 * j / (n - 1)) - radius);
    return r;
}

inline Chart regions_chart() {
    Chart c;
    c.title = "Where \u03bbdt may lie";
    c.x = {"real part"}, c.y = {"imaginary part"};
    c.regions = {disc(methods::rk4.name, 1.7, 81), disc(methods::euler.name, 0.8, 81),
                 disc("a name much too long for a place inside its region", 0.3, 81)};
    Series theory{"theory"};
    for (int k = 0; k <= 100; ++k) {
        theory.x.push_back(0.8 * std::cos(2 * std::numbers::pi * k / 100));
        theory.y.push_back(0.8 * std::sin(2 * std::numbers::pi * k / 100));
    }
    theory.draw = Draw::theory;
    c.series = {theory};
    c.regions[0].look = methods::rk4.look, c.regions[1].look = methods::euler.look;
    return c;
}

inline Chart bars_chart(Scale scale) {
    Chart c;
    c.title = "Cost against the floor";
    c.x = {"time for one particle and step [ns]", scale};
    c.bars = {{"Euler", 2, 1}, {"RK4", 8, 5}, {"a scene without a floor and with a long name", 4}};
    return c;
}

inline Chart orbit() {
    Chart c;
    c.title = "An orbit";
    c.x = {"x [m]"}, c.y = {"y [m]"};
    c.equal_aspect = true;
    Series exact{"exact"}, euler = series_of(methods::euler);
    exact.look = Look{nutshell::Family::exact};
    for (int k = 0; k <= 300; ++k) {
        const double t = 2 * std::numbers::pi * k / 100;
        exact.x.push_back(2 * std::cos(t)), exact.y.push_back(std::sin(t));
        euler.x.push_back((2 + 0.2 * t) * std::cos(t)), euler.y.push_back((1 + 0.2 * t) * std::sin(t));
    }
    c.series = {exact, euler};
    return c;
}

inline std::vector<Chart> gallery() {
    return {work_precision_chart(),         time_series(), regions_chart(), bars_chart(Scale::linear),
            bars_chart(Scale::logarithmic), orbit()};
}

inline Ranking ranking() {
    Ranking r{"What a pixel costs",
              "Planet, three orbits.",
              {"evaluations of the force", "processor time [\u00b5s]"}};
    r.rows = {{"Verlet", nutshell::Look{nutshell::Family::symplectic}, {4080, 1.2}, "", "dt = 0.01"},
              {"Euler", std::nullopt, {}, "does not get there: still 0.3 m off with 400 000 steps", ""},
              {"Kahan-Li 8",
               nutshell::Look{nutshell::Family::symplectic, nutshell::Mark::star},
               {1020, 2.4},
               "",
               ""},
              {"semi-implicit Euler", std::nullopt, {120200, 124}, "", ""}};
    return r;
}

inline Legend legend() {
    Legend l{"What each look means", "Colour is the family, mark and dash the member."};
    l.groups = {{"one step, explicit", {{"Euler", nutshell::Look{nutshell::Family::explicit_one_step}}}},
                {"kicks and drifts",
                 {{"Verlet", nutshell::Look{nutshell::Family::symplectic, nutshell::Mark::square}},
                  {"semi-implicit Euler",
                   nutshell::Look{nutshell::Family::symplectic, nutshell::Mark::triangle, "9 4"}}}},
                {"exact", {{"exact", nutshell::Look{nutshell::Family::exact}}}}};
    return l;
}

inline Figure panels() {
    Chart left = work_precision_chart(), right = time_series();
    left.title = "In evaluations", left.subtitle = "", right.title = "";
    left.series[1].quiet = true;
    return {"One finding, several panels", "Wide: side by side.", {left, right, orbit()}};
}

/// Title and text of one picture of each kind.
inline std::vector<std::pair<std::string, std::string>> pictures() {
    std::vector<std::pair<std::string, std::string>> all;
    for (const Chart& chart : gallery()) all.emplace_back(chart.title, svg(chart));
    all.emplace_back(ranking().title, svg(ranking()));
    all.emplace_back(panels().title, svg(panels()));
    all.emplace_back(legend().title, svg(legend()));
    return all;
}

/// By how much the groups round an element move it.
inline parts::Point shift(const std::vector<Element>& elements, const Element& element) {
    parts::Point sum;
    for (std::size_t at = element.parent; at != 0; at = elements[at].parent) {
        const auto found = elements[at].attributes.find("transform");
        double x = 0, y = 0;
        if (found != elements[at].attributes.end() &&
            std::sscanf(found->second.c_str(), "translate(%lf %lf)", &x, &y) == 2)
            sum.x += x, sum.y += y;
    }
    return sum;
}

inline parts::Box moved(const parts::Box& box, parts::Point by) {
    return {box.left + by.x, box.top + by.y, box.right + by.x, box.bottom + by.y};
}

inline parts::Box box_of(const Element& text) {
    const bool small =
        text.css_class == "tick" || text.css_class.rfind("note", 0) == 0 || text.css_class == "reason";
    const double size = text.css_class == "title" ? 20 : small ? 15 : 16;
    const double width = parts::text_width(text.text, size), x = text.number("x"), y = text.number("y");
    const auto anchor = text.attributes.find("text-anchor");
    const double part = anchor == text.attributes.end() ? 0 : anchor->second == "middle" ? 0.5 : 1;
    return {x - part * width, y - 0.75 * size, x + (1 - part) * width, y + 0.25 * size};
}

inline bool overlap(const parts::Box& a, const parts::Box& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// All corners of a path made of M and L.
inline std::vector<parts::Point> corners(const Element& path) {
    std::string d = path.attributes.at("d");
    for (char& c : d)
        if (c == 'M' || c == 'L' || c == 'Z') c = ' ';
    std::istringstream in(d);
    in.imbue(std::locale::classic());
    std::vector<parts::Point> result;
    for (parts::Point p; in >> p.x >> p.y;) result.push_back(p);
    return result;
}

}  // namespace gallery_of_charts
