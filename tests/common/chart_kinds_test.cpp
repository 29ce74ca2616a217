// Regions, planes and bars are drawn to scale, and charts that cannot be drawn are refused in words.
#include <nutshell/chart/chart.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>

#include "chart_parts.hpp"
#include "check.hpp"
#include "svg_reader.hpp"

using namespace nutshell::chart;

namespace {

std::string wide_svg(const Chart& chart) {
    return wide_layout(svg(chart));
}

Region region_of(const std::function<double(double, double)>& f, int n = 101) {
    Region r{"Euler", -2, 2, -2, 2, n, n};
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) r.values.push_back(f(-2 + 4.0 * i / (n - 1), -2 + 4.0 * j / (n - 1)));
    return r;
}

/// A frame in which the picture's coordinates are the data's.
parts::Frame bare() {
    return {{-2, -2, 2, 2}, {Scale::linear, {-2, 2}, -2, 2}, {Scale::linear, {-2, 2}, -2, 2}};
}

double area(const parts::Line& loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const parts::Point a = loop[i], b = loop[(i + 1) % loop.size()];
        sum += (a.x * b.y - b.x * a.y) / 2;
    }
    return std::abs(sum);
}

/// The border without the simplification that suits a picture's units: 100 units of picture for one of data.
parts::Contour fine_contour(const Region& region) {
    parts::Frame frame = bare();
    frame.x.low = frame.y.low = -200, frame.x.high = frame.y.high = 200;
    return parts::contour(region, style_of(nutshell::Look{}), frame);
}

Chart plain_chart() {
    Chart c;
    c.title = "A chart";
    c.x = {"x"}, c.y = {"y"};
    c.series = {{"Verlet", {1, 2, 3}, {1, 2, 3}}};
    return c;
}

void refused(const std::function<void(Chart&)>& spoil, const std::string& why) {
    Chart c = plain_chart();
    spoil(c);
    INFO(why);
    try {
        svg(c);
        CHECK(false);
    } catch (const std::invalid_argument& refusal) {
        CHECK_THAT(refusal.what(), ContainsSubstring(why));
        CHECK_THAT(refusal.what(), ContainsSubstring("chart \""));
    }
}

}  // namespace

TEST_CASE("a region's border lies where the function is zero") {
    const auto circle = fine_contour(region_of([](double x, double y) { return std::hypot(x, y) - 1; }));
    REQUIRE(circle.fill.size() == 1);
    REQUIRE(circle.outline.size() == 1);
    CHECK(std::abs(area(circle.fill[0]) / 1e4 - std::numbers::pi) < 0.01);
    for (const parts::Point& p : circle.fill[0]) CHECK(std::abs(std::hypot(p.x, p.y) / 100 - 1) < 1e-3);
}

TEST_CASE("regions may have holes, reach the border, hold what is not a number, or be nowhere") {
    const auto ring =
        fine_contour(region_of([](double x, double y) { return std::abs(std::hypot(x, y) - 1) - 0.5; }));
    REQUIRE(ring.fill.size() == 2);
    CHECK(std::abs(std::abs(area(ring.fill[0]) - area(ring.fill[1])) / 1e4 - 2 * std::numbers::pi) < 0.02);

    // the left half: filled to the border, but outlined only where it really ends
    const auto half = fine_contour(region_of([](double x, double) { return x; }));
    REQUIRE(half.fill.size() == 1);
    CHECK(std::abs(area(half.fill[0]) / 1e4 - 8) < 1e-6);
    double length = 0;
    for (const parts::Line& line : half.outline)
        for (std::size_t i = 1; i < line.size(); ++i) {
            CHECK(std::abs(line[i].x) < 1e-9);
            length += std::abs(line[i].y - line[i - 1].y);
        }
    CHECK(std::abs(length / 100 - 4) < 0.05);

    const auto without = fine_contour(region_of([](double x, double y) {
        return x > 0 ? std::nan("") : y > 0 ? std::numeric_limits<double>::infinity() : -1;
    }));
    REQUIRE(without.fill.size() == 1);
    CHECK(std::abs(area(without.fill[0]) / 1e4 - 4) < 0.2);
    CHECK(fine_contour(region_of([](double, double) { return 1.0; })).fill.empty());
}

TEST_CASE("where two pieces touch at a corner of the grid, its middle decides whether they hang together") {
    Region r{"Euler", 0, 1, 0, 1, 2, 2, {-3, 1, 1, -3}};  // inside at two opposite corners, and in the middle
    CHECK(fine_contour(r).fill.size() == 1);
    r.values = {-1, 3, 3, -1};
    CHECK(fine_contour(r).fill.size() == 2);
    r.values = {1, -3, -3, 1};
    CHECK(fine_contour(r).fill.size() == 1);
    r.values = {3, -1, -1, 3};
    CHECK(fine_contour(r).fill.size() == 2);
}

TEST_CASE("in a plane a metre of x is as long as a metre of y") {
    for (const double height : {0.1, 1.0, 3.0, 30.0}) {
        Chart c = plain_chart();
        c.equal_aspect = true;
        c.series = {{"Verlet", {0, 2, 1, 0}, {0, 0, height, 0}}};
        const auto path = of_class(read_svg(wide_svg(c)), "curve").at(0).attributes.at("d");
        double x[3], y[3];
        REQUIRE(std::sscanf(path.c_str(), "M%lf %lfL%lf %lfL%lf %lf", x, y, x + 1, y + 1, x + 2, y + 2) == 6);
        INFO(height);
        CHECK(std::abs((y[0] - y[2]) / (x[1] - x[0]) - height / 2) < 0.02 * std::max(1.0, height));
    }
}

TEST_CASE("bars are as long as their values, and say how far from the floor they are") {
    Chart c;
    c.title = "Cost";
    c.x = {"time [ns]"};
    c.bars = {{"Euler", 2, 1}, {"RK4", 8, 5}, {"Verlet", 4}};
    const auto elements = read_svg(wide_svg(c));
    const auto bars = of_class(elements, "bar");
    REQUIRE(bars.size() == 3);
    CHECK(std::abs(bars[1].number("width") / bars[0].number("width") - 4) < 0.01);
    CHECK(std::abs(bars[2].number("width") / bars[0].number("width") - 2) < 0.01);
    CHECK(of_class(elements, "floor").size() == 2);
    const auto notes = of_class(elements, "note");
    const auto said = [&](const std::string& text) {
        return std::any_of(notes.begin(), notes.end(), [&](const Element& e) { return e.text == text; });
    };
    CHECK(said("2 (2.0\u00d7 floor)"));
    CHECK(said("8 (1.6\u00d7 floor)"));
    CHECK(said("4"));
}

TEST_CASE("a fan of guides has the slopes it names") {
    Chart c = plain_chart();
    c.x.scale = c.y.scale = Scale::logarithmic;
    c.series = {{"Verlet", {1, 10, 100}, {1, 1e-2, 1e-4}}};  // order 2, drawn beside its guide
    c.guides = {-1, -2};
    const auto elements = read_svg(wide_svg(c));
    double x[3], y[3], u[4], v[4];
    REQUIRE(std::sscanf(of_class(elements, "curve").at(0).attributes.at("d").c_str(), "M%lf %lfL%lf %lf", x,
                        y, x + 1, y + 1) == 4);
    for (const Element& e : elements)
        if (e.tag == "path" && elements[e.parent].css_class == "guide")
            REQUIRE(std::sscanf(e.attributes.at("d").c_str(), "M%lf %lfL%lf %lfM%lf %lfL%lf %lf", u, v, u + 1,
                                v + 1, u + 2, v + 2, u + 3, v + 3) == 8);
    const double curve = (y[1] - y[0]) / (x[1] - x[0]);
    CHECK(std::abs((v[3] - v[2]) / (u[3] - u[2]) / curve - 1) < 0.01);
    CHECK(std::abs((v[1] - v[0]) / (u[1] - u[0]) / curve - 0.5) < 0.01);
}

TEST_CASE("a chart that cannot be drawn is refused with what, where and what to do") {
    const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
    refused([](Chart& c) { c.title = ""; }, "no title");
    refused([](Chart& c) { c.series.clear(); }, "nothing to draw");
    refused([](Chart& c) { c.series[0].y.pop_back(); }, "series \"Verlet\" has 3 values of x and 2 of y");
    refused([](Chart& c) { c.series[0].x.clear(), c.series[0].y.clear(); }, "no points");
    refused([](Chart& c) { c.series[0].notes = {"one"}; }, "1 notes for 3 points");
    refused(
        [=](Chart& c) {
            c.series[0].y = {nan, infinity, -infinity};
        },
        "no point that its axis \"y\" can show");
    refused(
        [](Chart& c) {
            c.y.scale = Scale::logarithmic, c.series[0].y = {0, -1, -2};
        },
        "positive on a logarithmic axis");
    refused([](Chart& c) { c.x.scale = Scale::logarithmic, c.x.from = 0; },
            "axis x is logarithmic and ends at 0");
    refused([=](Chart& c) { c.y.to = infinity; }, "axis y ends at infinity");
    refused([](Chart& c) { c.x.from = 2, c.x.to = 1; }, "axis x goes from 2 to 1");
    refused([](Chart& c) { c.y.from = 1, c.y.to = 1; }, "axis y goes from 1 to 1");
    refused([](Chart& c) { c.y.from = 10; }, "has no room on axis \"y\", which goes from 10 to 10");
    refused([](Chart& c) { c.y.from = -1e301; }, "beyond 1e300");
    refused(
        [](Chart& c) {
            c.y.scale = Scale::logarithmic, c.tolerance = Level{0, "none"};
        },
        "the tolerance is 0");
    refused([=](Chart& c) { c.levels_x = {{nan, "limit"}}; }, "level \"limit\" is not a number");
    refused([=](Chart& c) { c.rings = {{1, infinity, "here"}}; }, "ring \"here\" is infinity");
    refused([](Chart& c) { c.guides = {-1}; }, "slope guides");
    refused([](Chart& c) { c.bars = {{"Euler", 1}}; }, "bars and something else");
    refused([=](Chart& c) { c.series.clear(), c.bars = {{"Euler", nan}}; }, "bar \"Euler\" is not a number");
    refused(
        [](Chart& c) {
            c.series.clear(), c.x.scale = Scale::logarithmic, c.bars = {{"Euler", 1, 0}};
        },
        "the floor of bar");
    refused([](Chart& c) { c.equal_aspect = true, c.y.scale = Scale::logarithmic; }, "logarithmic axis");
    refused([](Chart& c) { c.regions = {{"r", 0, 1, 0, 1, 3, 3, {1, 2}}}; }, "2 values for a grid of 9");
    refused([](Chart& c) { c.regions = {{"r", 0, 1, 0, 1, 1, 1, {1}}}; }, "at least 2 by 2");
    refused([](Chart& c) { c.regions = {{"r", 1, 0, 0, 1, 2, 2, {1, 2, 3, 4}}}; }, "left < right");
    refused([](Chart& c) { c.width = 10; }, "too small");
}

TEST_CASE("a chart is written whole or not at all, under an id from its file's name") {
    const auto folder = std::filesystem::temp_directory_path() / "nutshell_chart_test";
    std::filesystem::remove_all(folder);
    write_svg(plain_chart(), folder / "Planet error.svg");
    std::ifstream in(folder / "Planet error.svg");
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    CHECK(read_svg(wide_layout(text)).front().attributes.at("id").rfind("chart-planet-error-", 0) == 0);
    CHECK(std::distance(std::filesystem::directory_iterator(folder), {}) == 1);
    CHECK_THROWS_AS(write_svg(plain_chart(), folder / "Planet error.svg" / "below.svg"), std::runtime_error);
    Chart bad = plain_chart();
    bad.series.clear();
    CHECK_THROWS_AS(write_svg(bad, folder / "bad.svg"), std::invalid_argument);
    CHECK_FALSE(std::filesystem::exists(folder / "bad.svg"));
    std::filesystem::remove_all(folder);
}

TEST_CASE("no data make a drawing with a place that is no number") {
    const std::vector<double> strange{
        0,       1,         -1,           1e-300,
        5e-324,  -5e-324,   1e300,        -1e300,
        1.7e308, 1 + 1e-15, 1e-15,        123456,
        1e15,    1e15 + 1,  std::nan(""), std::numeric_limits<double>::infinity()};
    for (const Scale scale : {Scale::linear, Scale::logarithmic})
        for (const double a : strange)
            for (const double b : strange) {
                INFO(a << ", " << b);
                Chart c;
                c.title = "Strange";
                c.x = c.y = {"value", scale};
                c.series = {{"Euler", {a, b}, {b, a}}};
                try {
                    for (const Element& e : read_svg(wide_svg(c)))
                        for (const char* place : {"d", "x", "y", "x1", "y1", "x2", "y2", "transform"}) {
                            const auto found = e.attributes.find(place);
                            if (found == e.attributes.end()) continue;
                            REQUIRE(found->second.find("nan") == std::string::npos);
                            REQUIRE(found->second.find("inf") == std::string::npos);
                        }
                } catch (const std::invalid_argument& refusal) {
                    CHECK_THAT(refusal.what(), ContainsSubstring("can show"));
                }
            }
}
