// Charts: what is drawn is there, readable, inside the picture, and the same every time.
#include <nutshell/chart/chart.hpp>

#include <clocale>
#include <filesystem>
#include <fstream>
#include <locale>
#include <numbers>

#include "chart_parts.hpp"
#include "check.hpp"
#include "svg_reader.hpp"

using namespace nutshell::chart;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Errors C * cost^-order down to a floor of round-off.
Series power_law(const std::string& name, double factor, double order) {
    Series s;
    s.name = name;
    for (double cost = 100; cost < 2e5; cost *= 2) {
        s.x.push_back(cost);
        s.y.push_back(std::max(factor * std::pow(cost / 100, -order), 1e-12));
    }
    return s;
}

Chart work_precision_chart() {
    Chart c;
    c.title = "Which method gives the most accuracy for the work?";
    c.subtitle =
        "Planet, e = 0.6, one orbit. Down and left is better, and this sentence is long enough to be broken.";
    c.x = {"force evaluations", Scale::logarithmic};
    c.y = {"largest position error [m]", Scale::logarithmic};
    c.series = {power_law("Euler", 5, 1),
                power_law("semi-implicit Euler", 1, 1),
                power_law("Verlet", 0.3, 2),
                power_law("RK4", 0.2, 4),
                power_law("Yoshida 4", 0.1, 4),
                power_law("Kahan-Li 8", 0.5, 8),
                power_law("Dormand-Prince 5(4)", 0.05, 5)};
    c.tolerance = Level{1e-3, "1 mm: a pixel at 2 m"};
    c.guides = {-1, -2, -4};
    c.ring_cheapest = true;
    return c;
}

Chart time_series() {
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

Region disc(const std::string& name, double radius, int n) {
    Region r{name, -2, 2, -2, 2, n, n};
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            r.values.push_back(std::hypot(-2 + 4.0 * i / (n - 1), -2 + 4.0 * j / (n - 1)) - radius);
    return r;
}

Chart regions_chart() {
    Chart c;
    c.title = "Where \u03bbdt may lie";
    c.x = {"real part"}, c.y = {"imaginary part"};
    c.regions = {disc("RK4", 1.7, 81), disc("Euler", 0.8, 81),
                 disc("a name much too long for a place inside its region", 0.3, 81)};
    Series theory{"theory"};
    for (int k = 0; k <= 100; ++k) {
        theory.x.push_back(0.8 * std::cos(2 * std::numbers::pi * k / 100));
        theory.y.push_back(0.8 * std::sin(2 * std::numbers::pi * k / 100));
    }
    theory.draw = Draw::theory;
    c.series = {theory};
    return c;
}

Chart bars_chart(Scale scale) {
    Chart c;
    c.title = "Cost against the floor";
    c.x = {"time for one particle and step [ns]", scale};
    c.bars = {{"Euler", 2, 1}, {"RK4", 8, 5}, {"a scene without a floor and with a long name", 4}};
    return c;
}

Chart orbit() {
    Chart c;
    c.title = "An orbit";
    c.x = {"x [m]"}, c.y = {"y [m]"};
    c.equal_aspect = true;
    Series exact{"exact"}, euler{"Euler"};
    for (int k = 0; k <= 300; ++k) {
        const double t = 2 * std::numbers::pi * k / 100;
        exact.x.push_back(2 * std::cos(t)), exact.y.push_back(std::sin(t));
        euler.x.push_back((2 + 0.2 * t) * std::cos(t)), euler.y.push_back((1 + 0.2 * t) * std::sin(t));
    }
    c.series = {exact, euler};
    return c;
}

std::vector<Chart> gallery() {
    return {work_precision_chart(),         time_series(), regions_chart(), bars_chart(Scale::linear),
            bars_chart(Scale::logarithmic), orbit()};
}

parts::Box box_of(const Element& text) {
    const bool small = text.css_class == "tick" || text.css_class == "note" || text.css_class == "reason";
    const double size = text.css_class == "title" ? 20 : small ? 15 : 16;
    const double width = parts::text_width(text.text, size), x = text.number("x"), y = text.number("y");
    const auto anchor = text.attributes.find("text-anchor");
    const double part = anchor == text.attributes.end() ? 0 : anchor->second == "middle" ? 0.5 : 1;
    return {x - part * width, y - 0.75 * size, x + (1 - part) * width, y + 0.25 * size};
}

bool overlap(const parts::Box& a, const parts::Box& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// All corners of a path made of M and L.
std::vector<parts::Point> corners(const Element& path) {
    std::string d = path.attributes.at("d");
    for (char& c : d)
        if (c == 'M' || c == 'L' || c == 'Z') c = ' ';
    std::istringstream in(d);
    in.imbue(std::locale::classic());
    std::vector<parts::Point> result;
    for (parts::Point p; in >> p.x >> p.y;) result.push_back(p);
    return result;
}

}  // namespace

TEST_CASE("every kind of chart is well-formed, named, and keeps its text apart and inside") {
    for (const Chart& chart : gallery()) {
        INFO(chart.title);
        const auto elements = read_svg(svg(chart));
        const Element& root = elements.front();
        REQUIRE(root.tag == "svg");
        CHECK(root.css_class == "chart");
        CHECK(root.attributes.at("role") == "img");
        CHECK(elements[1].tag == "title");
        CHECK(elements[1].text == chart.title);
        CHECK(elements[2].tag == "desc");
        CHECK(root.attributes.at("aria-labelledby") ==
              elements[1].attributes.at("id") + " " + elements[2].attributes.at("id"));
        std::vector<Element> texts;
        for (const Element& e : elements)
            if (e.tag == "text") texts.push_back(e);
        for (std::size_t i = 0; i < texts.size(); ++i) {
            const parts::Box box = box_of(texts[i]);
            INFO(texts[i].text);
            CHECK(box.left >= 0);
            CHECK(box.top >= 0);
            CHECK(box.right <= root.number("width"));
            CHECK(box.bottom <= root.number("height"));
            for (std::size_t k = 0; k < i; ++k) {
                INFO(texts[k].text);
                CHECK_FALSE(overlap(box, box_of(texts[k])));
            }
        }
        for (const Element& path : of_class(elements, "curve"))
            for (const parts::Point& p : corners(path)) {
                REQUIRE((p.x >= 0 && p.x <= root.number("width")));
                REQUIRE((p.y >= 0 && p.y <= root.number("height")));
            }
    }
}

TEST_CASE("widths of text are bounds of what a browser measures in Lato") {
    const auto bounds = [](const char* text, double size, double measured) {
        CHECK(parts::text_width(text, size) >= measured);
        CHECK(parts::text_width(text, size) <= 1.15 * measured);
    };
    bounds("semi-implicit Euler", 16, 131.67);  // bold, by getComputedTextLength
    bounds("Dormand-Prince 5(4)", 16, 149);
    bounds("Which method gives the most accuracy for the work?", 20, 471.97);
    CHECK(parts::text_width("imaginary part of \u03bbdt, 10\u207b\u00b3 \u2264 \u03b8", 16) >= 209.97);
}

TEST_CASE("labels of curves that end together are pushed apart, all stay, no two hairlines cross") {
    Chart c;
    c.title = "Crowded";
    c.x = {"x"}, c.y = {"y"};
    for (int i = 0; i < 30; ++i) {  // more than fit: the picture has to grow
        const double end = i % 3 == 0 ? 1 : 0.5;
        c.series.push_back({"curve " + std::to_string(i), {0, end}, {1.0 * i, 0.001 * ((i * 7) % 30)}});
    }
    const auto elements = read_svg(svg(c));
    const auto labels = of_class(elements, "label"), hairs = of_class(elements, "hair");
    CHECK(labels.size() == 30);
    CHECK(elements.front().number("height") > 600);
    for (std::size_t i = 0; i < labels.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) CHECK_FALSE(overlap(box_of(labels[i]), box_of(labels[k])));
    CHECK(hairs.size() == 30);
    const auto turn = [](const Element& a, double x, double y) {
        return (a.number("x2") - a.number("x1")) * (y - a.number("y1")) -
               (a.number("y2") - a.number("y1")) * (x - a.number("x1"));
    };
    const auto parted = [&](const Element& a, const Element& b) {
        return turn(a, b.number("x1"), b.number("y1")) * turn(a, b.number("x2"), b.number("y2")) < -1;
    };
    for (const Element& a : hairs)
        for (const Element& b : hairs) CHECK_FALSE((parted(a, b) && parted(b, a)));
}

TEST_CASE("the same data give the same bytes, in every locale") {
    for (const Chart& chart : gallery()) CHECK(svg(chart) == svg(chart));
    const std::string before = svg(work_precision_chart());
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        std::string do_grouping() const override { return "\1"; }
    };
    const std::locale old = std::locale::global(std::locale(std::locale::classic(), new Comma));
    const char* german = std::setlocale(LC_NUMERIC, "de_DE.UTF-8");  // where it is installed
    const std::string during = svg(work_precision_chart());
    std::locale::global(old);
    if (german) std::setlocale(LC_NUMERIC, "C");
    CHECK(before == during);
}

TEST_CASE("text is escaped wherever it appears") {
    const std::string nasty = "a < b && \"c\" > 'd' \x01 \u03bb";
    Chart c;
    c.title = nasty, c.subtitle = nasty, c.x.name = nasty, c.y.name = nasty;
    c.series = {{nasty, {0, 1}, {0, infinity}}};
    c.series[0].notes = {nasty, nasty};
    c.tolerance = Level{0.5, nasty};
    c.rings = {{0, 0, nasty}};
    const auto elements = read_svg(svg(c));
    std::string readable = nasty;
    readable[readable.find('\x01')] = ' ';
    CHECK(elements[1].text == readable);
    CHECK_THAT(of_class(elements, "mark").at(0).tooltip, ContainsSubstring(readable));
    c.bars = {{nasty, 1, 0.5}}, c.series.clear(), c.tolerance.reset(), c.rings.clear();
    CHECK_NOTHROW(read_svg(svg(c)));
}

TEST_CASE("style sheets reach their own chart only, and several charts stand in one page") {
    Chart first = work_precision_chart(), second = first;
    second.series[0].y[3] *= 1.5;
    const std::string a = svg(first), b = svg(second);
    CHECK_NOTHROW(read_svg("<body>" + a + b + "</body>"));  // fails on an id that comes twice
    const std::string id = read_svg(a).front().attributes.at("id");
    CHECK(id.rfind("chart-which-method-gives-the-most-accuracy", 0) == 0);
    const std::size_t start = a.find("<style>") + 7;
    std::istringstream css(a.substr(start, a.find("</style>") - start));
    int selectors = 0;
    for (std::string line; std::getline(css, line);) {
        std::istringstream rules(line);
        for (std::string part; std::getline(rules, part, '{');) {
            if (part.rfind("@media", 0) == 0 || part.find(':') < part.find('#')) continue;  // no selector
            if (part.find('#') == std::string::npos || part.find("fill") == 0 || part.find("stroke") == 0)
                continue;
            std::istringstream list(part);
            for (std::string selector; std::getline(list, selector, ',');) {
                INFO(selector);
                CHECK(selector.rfind("#" + id + " ", 0) == 0);
                ++selectors;
            }
        }
    }
    CHECK(selectors > 20);
    CHECK(a.find("<script") == std::string::npos);
    CHECK(a.find("prefers-color-scheme:dark") != std::string::npos);
}

TEST_CASE("ticks stand at round values that can be told apart") {
    const auto texts = [](Scale scale, double from, double to, double along, bool horizontal) {
        std::vector<std::string> result;
        for (const auto& tick : parts::ticks(scale, {from, to}, along, horizontal))
            result.push_back(tick.markup);
        return result;
    };
    using List = std::vector<std::string>;
    CHECK(texts(Scale::linear, 0, 10, 400, true) ==
          List{"0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10"});
    CHECK(texts(Scale::linear, -1, 1, 100, false) == List{"\u22121", "0", "1"});
    CHECK(texts(Scale::linear, 0, 20000, 160, true) == List{"0", "10\u2009000", "20\u2009000"});
    CHECK(texts(Scale::logarithmic, 0.01, 100, 400, true) == List{"0.01", "0.1", "1", "10", "100"});
    CHECK(texts(Scale::logarithmic, 1, 10, 300, true) == List{"1", "2", "5", "10"});
    CHECK(texts(Scale::logarithmic, 3.1, 4.2, 300, true) == List{"3.2", "3.4", "3.6", "3.8", "4.0", "4.2"});
    CHECK(texts(Scale::logarithmic, 1e-7, 1e-6, 50, false).size() == 2);
    const auto far = parts::ticks(Scale::logarithmic, {1e-300, 1e300}, 300, false);
    CHECK(far.size() >= 3);
    CHECK(far.size() <= 11);
    CHECK(texts(Scale::logarithmic, 1e-12, 1, 300, false).front() ==
          "10<tspan dy='-6' font-size='11'>\u221212</tspan>");
    CHECK(texts(Scale::linear, 0, 3e-6, 300, false)[1].find("\u22127") != std::string::npos);
}

TEST_CASE("what blows up is seen: arrows at the border with a count, the curve inside") {
    Chart c;
    c.title = "Blow-up";
    c.x = {"time [s]"}, c.y = {"energy [J]", Scale::logarithmic, 0.1, 100};
    c.series = {{"Euler", {0, 1, 2, 3, 4, 5}, {1, 10, 1e3, 1e300, infinity, std::nan("")}},
                {"Verlet", {0, 1, 2, 3}, {1, 0, -2, 1}},
                {"lost", {0, 1}, {std::nan(""), std::nan("")}}};
    const auto elements = read_svg(svg(c));
    const auto arrows = of_class(elements, "arrow");
    REQUIRE(arrows.size() == 3);
    CHECK(arrows[0].tooltip ==
          "Euler: 4 points off the chart above; the first at time [s] 2, energy [J] 1000");
    CHECK(arrows[1].tooltip == "Verlet: 2 points off the chart below; the first at time [s] 1, energy [J] 0");
    CHECK_THAT(arrows[2].tooltip,
               ContainsSubstring("lost: 2 points off the chart above") && ContainsSubstring("not a number"));
    CHECK(of_class(elements, "label").size() == 3);
    CHECK(of_class(elements, "mark").size() == 4);
    const auto grid = of_class(elements, "grid");
    double top = infinity;
    for (const Element& line : grid) top = std::min({top, line.number("y1"), line.number("y2")});
    const auto line = corners(of_class(elements, "curve").at(0));
    CHECK(line.size() == 3);  // 1, 10, and where it leaves through the top at 100
    CHECK(std::abs(line.back().y - top) < 0.11);
    CHECK(arrows[0].attributes.at("transform").find(parts::unit(line.back().x)) != std::string::npos);
}

TEST_CASE("a hundred thousand points make a small file that keeps every extreme") {
    const Chart c = time_series();
    const std::string text = svg(c);
    CHECK(text.size() < 60'000);
    double least = infinity, most = -infinity;
    for (const parts::Point& p : corners(of_class(read_svg(text), "curve").at(0)))
        least = std::min(least, p.y), most = std::max(most, p.y);
    // from the spike at 3 to the trough at -1: 4 of the axis' 4 units, which are as high as the grid
    double top = infinity, bottom = -infinity;
    for (const Element& line : of_class(read_svg(text), "grid"))
        top = std::min(top, line.number("y1")), bottom = std::max(bottom, line.number("y2"));
    CHECK(std::abs((most - least) - (bottom - top)) < 0.5);
}

TEST_CASE("the cheapest method is the first that meets the tolerance and goes on meeting it") {
    Chart c = work_precision_chart();
    c.series = {{"lucky", {10, 20, 40}, {1e-4, 1e-2, 1e-4}},
                {"steady", {10, 30, 60}, {1e-2, 5e-4, 1e-5}},
                {"broken", {5, 50}, {1e-9, std::nan("")}}};
    REQUIRE(cheapest(c));
    CHECK(cheapest(c)->x == 30);
    CHECK(cheapest(c)->y == 5e-4);
    CHECK(cheapest(c)->text == "cheapest: steady");
    const auto elements = read_svg(svg(c));
    CHECK(of_class(elements, "ring").size() == 1);
    c.tolerance->value = 1e-12;
    CHECK_FALSE(cheapest(c));
    CHECK(of_class(read_svg(svg(c)), "ring").empty());
    c.tolerance.reset();
    CHECK_FALSE(cheapest(c));
}

TEST_CASE("long text is broken between words, evenly, and inside a word only where it must be") {
    using Lines = std::vector<std::string>;
    CHECK(parts::wrapped("one two three", 16, 1000) == Lines{"one two three"});
    CHECK(parts::wrapped("", 16, 100).empty());
    CHECK(parts::balanced("semi-implicit Euler (at the end)", 16, 192) ==
          Lines{"semi-implicit", "Euler (at the end)"});
    CHECK(parts::balanced("semi-implicit Euler", 16, 120) == Lines{"semi-implicit", "Euler"});
    std::string joined;
    for (const std::string& line :
         parts::balanced("\u03bb\u03bb\u03bb\u03bb\u03bb\u03bbwithoutanyspace", 16, 50)) {
        CHECK(parts::text_width(line, 16) <= 50);
        CHECK((static_cast<unsigned char>(line[0]) & 0xC0) != 0x80);  // no character is cut
        joined += line;
    }
    CHECK(joined == "\u03bb\u03bb\u03bb\u03bb\u03bb\u03bbwithoutanyspace");
}
