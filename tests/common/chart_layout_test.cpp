// Two layouts in one picture: a wide one and a phone's. In both nothing is cut off, nothing overlaps, all is
// named.
#include "chart_gallery.hpp"
#include "check.hpp"

using namespace gallery_of_charts;

TEST_CASE("every kind of picture is well-formed and named, and can be walked through by keyboard") {
    for (const auto& [title, text] : pictures()) {
        INFO(title);
        const auto elements = read_svg(text);
        const Element& root = elements.front();
        REQUIRE(root.tag == "svg");
        CHECK(root.css_class == "chart");
        CHECK(elements[1].tag == "title");
        CHECK(elements[1].text == title);
        CHECK(elements[2].tag == "desc");
        CHECK(root.attributes.at("aria-labelledby") == elements[1].attributes.at("id"));
        CHECK(root.attributes.at("aria-describedby") == elements[2].attributes.at("id"));
        for (const Element& e : elements)
            if (e.attributes.count("tabindex")) CHECK_FALSE(e.attributes.at("aria-label").empty());
    }
}

TEST_CASE("wide and narrow, text keeps apart and inside, and curves stay in the picture") {
    for (const auto& [title, text] : pictures())
        for (const std::string& layout : {wide_layout(text), narrow_layout(text)}) {
            const auto elements = read_svg(layout);
            const Element paper = of_class(elements, "paper").at(0);
            INFO(title << ", " << paper.number("width") << " wide");
            std::vector<std::pair<parts::Box, std::string>> texts;
            for (const Element& e : elements)
                if (e.tag == "text") texts.emplace_back(moved(box_of(e), shift(elements, e)), e.text);
            for (std::size_t i = 0; i < texts.size(); ++i) {
                const parts::Box& box = texts[i].first;
                INFO(texts[i].second);
                CHECK(box.left >= 0);
                CHECK(box.top >= 0);
                CHECK(box.right <= paper.number("width"));
                CHECK(box.bottom <= paper.number("height"));
                for (std::size_t k = 0; k < i; ++k) {
                    INFO(texts[k].second);
                    CHECK_FALSE(overlap(box, texts[k].first));
                }
            }
            for (const Element& path : of_class(elements, "curve"))
                for (const parts::Point& p : corners(path)) {
                    const parts::Point off = shift(elements, path);
                    REQUIRE((p.x + off.x >= 0 && p.x + off.x <= paper.number("width")));
                    REQUIRE((p.y + off.y >= 0 && p.y + off.y <= paper.number("height")));
                }
        }
}

TEST_CASE("a narrow layout has no more than a phone's width and names every curve") {
    for (const Chart& chart : gallery()) {
        INFO(chart.title);
        const std::string text = svg(chart);
        const auto names = [](const std::string& layout) {
            std::string all;
            for (const Element& e : of_class(read_svg(layout), "label")) all += e.text + ' ';
            std::sort(all.begin(), all.end());
            return all;
        };
        CHECK(of_class(read_svg(narrow_layout(text)), "paper").at(0).number("width") <= parts::narrow_width);
        const auto letters = [](std::string s) {
            s.erase(std::remove(s.begin(), s.end(), ' '), s.end());
            return s;
        };
        CHECK(letters(names(narrow_layout(text))) == letters(names(wide_layout(text))));
    }
}

TEST_CASE("a ranking puts the least first and who does not get there last, with the ratio to the least") {
    const auto elements = read_svg(wide_layout(svg(ranking())));
    std::vector<std::string> names, notes;
    for (const Element& e : of_class(elements, "label")) names.push_back(e.text);
    for (const Element& e : of_class(elements, "note")) notes.push_back(e.text);
    CHECK(names == std::vector<std::string>{"Kahan-Li 8", "Verlet", "semi-implicit Euler", "Euler"});
    CHECK(notes == std::vector<std::string>{"1020, the least", "2.40 (2.0\u00d7)", "4080 (4.0\u00d7)",
                                            "1.20, the least", "120\u2009200 (118\u00d7)",
                                            "124 (103\u00d7)"});
    Ranking free_of_charge = ranking();
    free_of_charge.rows[0].values[0] = 0;  // has no place on a logarithmic axis
    const auto free_elements = read_svg(wide_layout(svg(free_of_charge)));
    CHECK(of_class(free_elements, "note").at(0).text == "none");
    CHECK(of_class(free_elements, "note").at(2).text == "1020");
    const auto says_decades = [](const Ranking& r) {
        return wide_layout(svg(r)).find("From one grey line") != std::string::npos;
    };
    CHECK(says_decades(ranking()));
    Ranking near = ranking();  // one power of ten, or none, in each column: no line to explain
    near.rows.pop_back();
    CHECK_FALSE(says_decades(near));
    Ranking wrong = ranking();
    wrong.rows[0].values.pop_back();
    CHECK_THROWS_AS(svg(wrong), std::invalid_argument);
    wrong = ranking();
    wrong.rows[0].values[0] = -1;
    CHECK_THROWS_AS(svg(wrong), std::invalid_argument);
    wrong = ranking();
    wrong.rows[1].instead = "";
    CHECK_THROWS_AS(svg(wrong), std::invalid_argument);
}

TEST_CASE("quiet curves are grey, without label or mark, and named in one sentence") {
    Chart c = work_precision_chart();
    c.series[1].quiet = c.series[4].quiet = true;
    for (const std::string& layout : {wide_layout(svg(c)), narrow_layout(svg(c))}) {
        const auto elements = read_svg(layout);
        CHECK(of_class(elements, "label").size() >= 5);
        CHECK(of_class(elements, "quiet").size() == 2);
        std::string said;
        for (const Element& e : of_class(elements, "note")) said += e.text + ' ';
        CHECK_THAT(said, ContainsSubstring("semi-implicit Euler, Yoshida 4."));
        for (const Element& e : of_class(elements, "label")) CHECK(e.text != "Yoshida 4");
    }
}

TEST_CASE("a look at a part leaves out what lies beyond without an arrow") {
    Chart c = work_precision_chart();
    c.y.from = 1e-6, c.y.to = 0.1;
    CHECK_FALSE(of_class(read_svg(wide_svg(c)), "arrow").empty());
    c.cut = true;
    CHECK(of_class(read_svg(wide_svg(c)), "arrow").empty());
}
