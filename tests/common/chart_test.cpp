// Charts: what is drawn is there, readable, and the same every time.
#include "chart_gallery.hpp"

#include <clocale>
#include <filesystem>
#include <fstream>

#include "check.hpp"

using namespace gallery_of_charts;

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
    const auto elements = read_svg(wide_svg(c));
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
    const auto elements = read_svg(wide_svg(c));
    std::string readable = nasty;
    readable[readable.find('\x01')] = ' ';
    CHECK(elements[1].text == readable);
    CHECK_THAT(of_class(elements, "mark").at(0).tooltip, ContainsSubstring(readable));
    c.bars = {{nasty, 1, 0.5}}, c.series.clear(), c.tolerance.reset(), c.rings.clear();
    CHECK_NOTHROW(read_svg(wide_svg(c)));
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
            if (part.find("#chart") == std::string::npos || part.find("fill") == 0 ||
                part.find("stroke") == 0)
                continue;
            std::istringstream list(part);
            for (std::string selector; std::getline(list, selector, ',');) {
                INFO(selector);
                CHECK(selector.rfind("#" + id, 0) == 0);
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
          "10<tspan class='sup' dy='-6'>\u221212</tspan>");
    CHECK(texts(Scale::linear, 0, 3e-6, 300, false)[1].find("\u22127") != std::string::npos);
}

TEST_CASE("what blows up is seen: arrows at the border with a count, the curve inside") {
    Chart c;
    c.title = "Blow-up";
    c.x = {"time [s]"}, c.y = {"energy [J]", Scale::logarithmic, 0.1, 100};
    c.series = {{"Euler", {0, 1, 2, 3, 4, 5}, {1, 10, 1e3, 1e300, infinity, std::nan("")}},
                {"Verlet", {0, 1, 2, 3}, {1, 0, -2, 1}},
                {"lost", {0, 1}, {std::nan(""), std::nan("")}}};
    const auto elements = read_svg(wide_svg(c));
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
    for (const parts::Point& p : corners(of_class(read_svg(wide_layout(text)), "curve").at(0)))
        least = std::min(least, p.y), most = std::max(most, p.y);
    // from the spike at 3 to the trough at -1: 4 of the axis' 4 units, which are as high as the grid
    double top = infinity, bottom = -infinity;
    for (const Element& line : of_class(read_svg(wide_layout(text)), "grid"))
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
    const auto elements = read_svg(wide_svg(c));
    CHECK(of_class(elements, "ring").size() == 1);
    std::vector<std::string> notes;
    for (const Element& e : of_class(elements, "note")) notes.push_back(e.text);
    CHECK(std::count(notes.begin(), notes.end(), "cheapest") == 1);
    c.tolerance->value = 1e-12;
    CHECK_FALSE(cheapest(c));
    CHECK(of_class(read_svg(wide_svg(c)), "ring").empty());
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
