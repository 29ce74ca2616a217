// Diagrams: to scale, in both layouts, every word at a place of its own.
#include <nutshell/chart/diagram.hpp>

#include "chart_gallery.hpp"
#include "check.hpp"

using namespace gallery_of_charts;

namespace {

Diagram spring_and_mass() {
    Diagram d;
    d.title = "A mass on a spring";
    d.wall({0, 0.3}, {0, -0.3})
        .spring({0, 0}, {1.4, 0})
        .ball({1.0, 0}, 0.1)
        .as_ghost()
        .ball({1.5, 0}, 0.1, "m");
    d.arrow({1.5, 0}, {-0.6, 0}, Quantity::force, "F = \u2212k (l \u2212 l\u2080)");
    d.arrow({1.5, 0}, {0.3, 0}, Quantity::velocity, "v");
    d.dimension({0, -0.45}, {1.5, -0.45}, "l = 1.5 m");
    return d;
}

/// What chapters 6 and 7 need: a box on its corner, its own axes, a contact with its normal, lever and
/// torque.
Diagram contact_and_lever() {
    Diagram d;
    d.title = "A contact and its lever";
    const double turned = 0.5, c = std::cos(turned), s = std::sin(turned);
    const Place corner{1 - 0.8 * c + 0.4 * s, 0.9 - 0.8 * s - 0.4 * c};
    d.wall({-1, 0}, {3, 0})
        .box({1, 0.9}, 1.6, 0.8, turned)
        .centre({1, 0.9})
        .axes({1, 0.9}, turned, 1.3, "e\u2081", "e\u2082");
    d.contact(corner, {0, 0.9}).arrow(corner, {0.3, 0.55}, Quantity::force, "F").dashed({{1, 0.9}, corner});
    d.arc({1, 0.9}, 0.7, 0.3, 1.6, Quantity::angular_velocity, "\u03c9");
    d.arc({1, 0.9}, 0.5, 3.4, 2.2, Quantity::torque, "\u03c4 = r \u00d7 F");
    d.angle({1, 0.9}, 1.0, 0, turned, "\u03b8");
    d.rope({1.5, 2}, {2.5, 2}, 0.2).rod({2.5, 2}, {2.5, 1}).path({{-0.5, 1.5}, {0, 1.8}, {0.4, 1.9}});
    return d;
}

Diagrams two_moments() {
    Diagrams all;
    all.title = "Drag grows until it carries the weight";
    for (const double drag : {0.0, 0.7}) {
        Diagram d;
        d.title = drag > 0 ? "Later" : "At the start";
        d.ball({0, 0}, 0.15).arrow({0, 0}, {0, -1}, Quantity::force, "m g");
        d.arrow({0, 0}, {0, drag}, Quantity::force, "\u2212\u03b3 v");
        all.panels.push_back(d);
    }
    return all;
}

/// Where heads of arrows point: the first corner of each.
std::vector<parts::Point> tips(const std::vector<Element>& elements) {
    std::vector<parts::Point> result;
    for (const Element& head : of_class(elements, "head")) result.push_back(corners(head).front());
    return result;
}

}  // namespace

TEST_CASE("a diagram's words keep apart and inside, wide and on a phone") {
    for (const std::string& text : {svg(spring_and_mass()), svg(contact_and_lever()), svg(two_moments())})
        for (const std::string& layout : {wide_layout(text), narrow_layout(text)}) {
            const auto elements = read_svg(layout);
            const Element paper = of_class(elements, "paper").at(0);
            std::vector<std::pair<parts::Box, std::string>> texts;
            for (const Element& e : elements)
                if (e.tag == "text") texts.emplace_back(moved(box_of(e), shift(elements, e)), e.text);
            CHECK(texts.size() >= 4);
            for (std::size_t i = 0; i < texts.size(); ++i) {
                INFO(texts[i].second);
                CHECK(texts[i].first.left >= 0);
                CHECK(texts[i].first.top >= 0);
                CHECK(texts[i].first.right <= paper.number("width"));
                CHECK(texts[i].first.bottom <= paper.number("height"));
                for (std::size_t k = 0; k < i; ++k) {
                    INFO(texts[k].second);
                    CHECK_FALSE(overlap(texts[i].first, texts[k].first));
                }
            }
            for (const parts::Point& tip : tips(elements))
                CHECK((tip.x >= 0 && tip.x <= paper.number("width")));
        }
}

TEST_CASE("arrows, bodies and dimensions of a diagram have one scale") {
    for (const bool narrow : {false, true}) {
        const std::string text = svg(spring_and_mass());
        const auto elements = read_svg(narrow ? narrow_layout(text) : wide_layout(text));
        const Element ball = of_class(elements, "body").back();  // the ghost comes first
        const double metre = ball.number("r") / 0.1;
        const auto at =
            tips(elements);  // written with one decimal, the radius too: off by half a unit at most
        REQUIRE(at.size() == 2);
        CHECK(std::abs((at[0].x - ball.number("cx")) / metre + 0.6) < 0.5 / metre);
        CHECK(std::abs((at[1].x - ball.number("cx")) / metre - 0.3) < 0.5 / metre);
        const auto measure = corners(of_class(elements, "measure").at(0));
        CHECK(std::abs((measure[1].x - measure[0].x) / metre - 1.5) < 0.02);
        CHECK(of_class(elements, "was").size() == 1);
    }
    const auto box = corners(of_class(read_svg(wide_layout(svg(contact_and_lever()))), "body").at(0));
    REQUIRE(box.size() == 4);
    const auto side = [&](std::size_t i) {
        const parts::Point a = box[i], b = box[(i + 1) % 4];
        return std::hypot(b.x - a.x, b.y - a.y);
    };
    CHECK(std::abs(side(0) / side(1) - 2) < 0.02);
    CHECK(std::abs(std::atan2(box[0].y - box[1].y, box[1].x - box[0].x) - 0.5) <
          0.01);  // anticlockwise is up
}

TEST_CASE("panels of diagrams share one scale, and a force of zero is not drawn") {
    const auto elements = read_svg(wide_layout(svg(two_moments())));
    const auto balls = of_class(elements, "body");
    REQUIRE(balls.size() == 2);
    CHECK(balls[0].number("r") == balls[1].number("r"));
    CHECK(tips(elements).size() == 3);
    int named = 0;
    for (const Element& e : of_class(elements, "label")) named += e.text == "\u2212\u03b3 v";
    CHECK(named == 1);
}

TEST_CASE("a diagram that cannot be drawn is refused in words") {
    Diagram empty;
    empty.title = "Nothing";
    CHECK_THROWS_WITH(svg(empty), ContainsSubstring("nothing to draw"));
    Diagram nowhere = spring_and_mass();
    nowhere.arrow({0, 0}, {std::nan(""), 0}, Quantity::force, "F");
    CHECK_THROWS_AS(svg(nowhere), std::invalid_argument);
    Diagram nameless = spring_and_mass();
    nameless.title.clear();
    CHECK_THROWS_WITH(svg(nameless), ContainsSubstring("title"));
}

TEST_CASE("where arrows meet, the name of each stands at its own middle") {
    Diagram d;
    d.title = "A vector, its part and the rest";
    d.arrow({0, 0}, {2, 1.5}, Quantity::velocity, "v");
    d.arrow({0, 0}, {2, 0}, Quantity::plain, "part");
    d.arrow({2, 0}, {0, 1.5}, Quantity::plain, "rest");
    const auto elements = read_svg(wide_layout(svg(d)));
    const auto heads = tips(elements);  // of v, part and rest
    const auto centre_of = [&](const std::string& name) {
        for (const Element& e : of_class(elements, "label"))
            if (e.text == name) {
                const parts::Box box = box_of(e);
                return parts::Point{(box.left + box.right) / 2, (box.top + box.bottom) / 2};
            }
        FAIL("no label " << name);
        return parts::Point{};
    };
    REQUIRE(heads.size() == 3);
    const parts::Point rest = centre_of("rest"), part = centre_of("part");
    CHECK(std::abs(rest.y - (heads[1].y + heads[2].y) / 2) < 25);
    const double unit = (heads[1].y - heads[2].y) / 1.5;
    CHECK(std::abs(part.x - (heads[1].x - unit)) < 40);
}
