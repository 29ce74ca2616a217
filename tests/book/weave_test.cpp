// What a good page becomes, and what each kind of bad page is told.
#include <algorithm>

#include "check.hpp"
#include "in_order.hpp"
#include "little_book.hpp"

using namespace book_test;

TEST_CASE("a good page: numbers, references, equations, code, figures, boxes") {
    const LittleBook book;
    book.write(
        "pages/index.md",
        "---\nchapters:\n- 1 First. It begins.\n- 2 Second. It goes on.\n---\n# The book {#sec:front}\n\n"
        "See [@fig:planet] and `01_first/steps %d`{=num}.\n\n::: chapters\n:::\n");
    book.write("pages/01_first.md", R"(# First {#sec:first}

## Here {#sec:here}

Turns by `turn %.2e rad`{=num}, by $\num{turn %.1e rad}$, in `steps %d`{=num} steps, `share *100 %.1f %`{=num},
`turn abs %.4f`{=num}; [@eq:8; @eq:9], [@eq:11star], [@eq:ours], [@eq:more], [@fig:planet], [@sec:here], [@ex:1.1], [@E05].

::: {#eq:8-9}
$$ a = b $$
:::
::: {#eq:11star erratum=E05}
$$ c = d $$
:::
::: {#eq:ours}
$$ e = f $$
:::
::: {#eq:more}
$$ g = h $$
:::

```{region="src/code.hpp#step"}
```

::: {.exercise #ex:1.1 title="A step"}
Do [it](#sec:here), as in [the errata](errata.md#E05).
:::

```{region="src/code.hpp#other"}
```

::: {.exercise .open #ex:1.2 title="Another"}
As here.
:::

![A *planet*, `steps %d`{=num} steps of $x < 1$.](planet.png){#fig:planet}

![One.](one.svg){#fig:one}

![Two.](two.svg){#fig:two}

![Not seen.](dark.png){#fig:dark}

![Not seen either.](dark.png){#fig:night}

::: predict
Which?

::: reveal
That.
:::
:::

::: exercises
:::
)");
    book.write("pages/errata.md", "# Errata {#sec:errata}\n\n::: errata-table\n:::\n");
    const Said said = book.weave();
    INFO(said.text);
    REQUIRE(said.code == 0);

    const std::string page = book.page("01_first");
    check_in_order(page,
                   {"<a class=\"secno\" href=\"#sec:here\">1.1</a>",
                    "\u2212"
                    "1.03\u2009×\u2009"
                    "10<sup>\u2212"
                    "3</sup>\u00a0rad",
                    "class=\"katex\"",
                    "16\u202f"
                    "000</span> steps",
                    "1.2%", "0.0010</span>", "<a class=\"ref\" href=\"#eq:8-9\">(8)</a>",
                    "<a class=\"ref\" href=\"#eq:8-9\">(9)</a>", "href=\"#eq:11star\">(11*)</a>",
                    "href=\"#eq:ours\">(1.a)</a>", "href=\"#eq:more\">(1.b)</a>",
                    "href=\"#fig:planet\">Figure\u00a01.1</a>", "href=\"#sec:here\">Section\u00a01.1</a>",
                    "href=\"#ex:1.1\">Exercise\u00a01.1</a>", "href=\"errata.html#E05\">E05</a>"});
    check_in_order(page, {"id=\"eq:8-9\"", "(8–9)", "id=\"eq:11star\"", "(11*)", "errata.html#E05",
                          "id=\"eq:ours\"", "(1.a)"});
    check_in_order(page, {"/// One step.", "// exercise 1.1: yours", "href=\"source/src/code.hpp.html#L-4\"",
                          "id=\"ex:1.1\"", "Exercise 1.1: yours</b> · A step", "./course check 1.1",
                          "<details class=\"body\">", "x <span class=\"op\">+</span>", "</details>",
                          "</aside>", "/// Another.", "x <span class=\"op\">-</span>",
                          "Exercise 1.2: a worked example</b> · Another", "./course check 1.2", "</aside>"});
    check_in_order(book.page("open/01_first"),
                   {"/// One step.", "x <span class=\"op\">+</span>", "Exercise 1.1: yours</b>", "</aside>",
                    "<img src=\"../pictures/01_first/planet.png\"", "<details open>"});
    CHECK(book.page("open/01_first").find("class=\"body\"") == std::string::npos);
    CHECK(page.find("exercise 1.1\n") == std::string::npos);  // the marks are never shown
    CHECK(page.find("[step]") == std::string::npos);
    check_in_order(
        page,
        {"<figure id=\"fig:planet\"><img src=\"pictures/01_first/planet.png\" alt=\"A planet, 16\u202f"
         "000 steps of x &lt; 1.\" "
         "width=\"1\" height=\"1\">",
         "Figure\u00a01.1.", "<em>planet</em>", "<code class=\"command\">./course run 1</code>",
         "id='chart-one-1'", "Figure\u00a01.2.", "id='chart-two-1'", "Figure\u00a01.3.",
         "<span id=\"fig:dark\"></span><span id=\"fig:night\"></span>Figures\u00a01.4 and 1.5 were not drawn "
         "here: no OpenGL here. Once that is mended, <code>./course run 1</code> draws them."});
    CHECK(page.find("dark.png") == std::string::npos);   // no file's name
    CHECK(page.find("Not seen.") == std::string::npos);  // and no caption of what is not there
    check_in_order(page, {"Predict first", "Which?", "<details><summary>What happens</summary>", "That.",
                          "<a href=\"#ex:1.1\">Exercise 1.1</a> · A step", "Exercise 1.2</a> · Another"});
    CHECK(page.find("<script") == page.find("<script src=\"book.js\" defer></script>"));
    CHECK(page.find("<script") == page.rfind("<script"));
    CHECK(page.find("<form class=\"search\" role=\"search\" hidden>") !=
          std::string::npos);  // until it works
    check_in_order(
        book.file("search-index.js"),
        {"[\"01_first.html\",\"First\"", "[\"01_first.html#sec:here\",\"1.1 Here\"", "Which?", "That."});

    check_in_order(book.page("index"), {"href=\"01_first.html\"", "<span class=\"no\">2</span>Second",
                                        "href=\"01_first.html#fig:planet\"",
                                        "16\u202f"
                                        "000",
                                        "It begins.", "class=\"time\">about ", "<li class=\"coming\">",
                                        "Second <i>(coming)</i>", "It goes on."});
    check_in_order(book.page("errata"), {"<tr id=\"E05\">", "inaccurate", "exactly",
                                         "href=\"01_first.html#eq:11star\">chapter 1, (11*)</a>"});
    check_in_order(book.page("source/src/code.hpp"), {"id=\"L-1\"", "never_closed"});
    CHECK(std::filesystem::exists(book.folder() / "out/pictures/01_first/planet.png"));
}

TEST_CASE(
    "every mistake of a page is named with file, line and what to do, all at once, and the old book stays") {
    const LittleBook book;
    book.write("pages/01_first.md",
               "# First {#sec:first}\n\n::: {#eq:11star erratum=E05}\n$$ c = d $$\n:::\n");
    REQUIRE(book.weave().code == 0);
    const std::string before = book.page("01_first");

    const std::vector<std::pair<std::string, std::string>> mistakes = {
        {"See [@eq:lost].", "unknown reference @eq:lost: it has: eq:11star"},
        {"See [@E99].", "unknown reference @E99: errata.csv has no such row"},
        {"See [there](02_second.md).", "the link 02_second.md leads to no page"},
        {"See [there](#nowhere).", "page 01_first has no id 'nowhere'"},
        {"`turns %.2e`{=num}", "number `turns %.2e`: no such name in 01_first/numbers.csv (it has: turn)"},
        {"`07_last/x`{=num}", "07_last/numbers.csv is not there: run ./course run 7 first"},
        {"`nothing`{=num}", "its value is nan, not a finite number"},
        {"`turn %d`{=num}", "%d wants a whole number"},
        {"`turn %s`{=num}", "format %s is none of"},
        {"$\\num{gone %f}$", "number `gone %f`: no such name"},
        {"```{region=\"src/code.hpp#stop\"}\n```",
         "no region 'stop' in src/code.hpp (it has: 1.1, 1.2, labelled, open, other, step)"},
        {"```{region=\"src/code.hpp#labelled\"}\n```", "names equation (1.b), and page 01_first has none"},
        {"```{region=\"src/code.hpp#open\"}\n```", "the region is opened and never closed"},
        {"```{region=\"src/lost.hpp#step\"}\n```", "there is no file src/lost.hpp"},
        {"![Lost.](lost.png){#fig:lost}", "picture lost.png: there is no 01_first/lost.png: draw it"},
        {"![Gone.](gone.png){#fig:gone}", "picture gone.png: there is no 01_first/gone.png"},
        {"![Lost.](lost.svg){#fig:lostchart}", "picture lost.svg: there is no 01_first/lost.svg"},
        {"Text ![in text](planet.png) is no figure.", "shares its paragraph with text"},
        {"![](planet.png){#fig:mute}", "a numbered figure has a caption"},
        {"::: {#eq:7star}\n$$ a = b $$\n:::", "equation (7*) is a corrected one: say which erratum"},
        {"::: {#eq:two}\n$$ a = b $$ and more\n:::", "equation eq:two holds one $$…$$ and nothing else"},
        {"::: {#eq:11star erratum=E05}\n$$ a = b $$\n:::", "the label eq:11star is given twice"},
        {"::: remark\nx\n:::", "there is no box 'remark'"},
        {"::: exercise\nx\n:::", "an exercise says which one it is"},
        {"[More]{by=\"steps < 15*2\"}.",
         "claim by \"steps < 15*2\": steps < 15*2 does not hold: 16000 and 30"},
        {"[More]{by=\"steps > 5 and share > 1\"}.", "share > 1 does not hold: 0.0123 and 1"},
        {"[More]{by=\"lost > 1\"}.", "claim by \"lost > 1\": no such name in 01_first/numbers.csv"},
        {"[More]{by=\"test: nobody wrote this\"}.", "there is no such test"},
        {"[More]{by=\"eq:nowhere\"}.", "there is no such label"},
        {"[More]{by=\"because\"}.", "it is neither 'test: …', a label, 'words' nor a comparison"},
        {"::: {.exercise #ex:1.3}\nx\n:::", "exercise 1.3 stands where its code is"},
        {"::: {.exercise .open #ex:1.2}\nx\n:::", "exercise 1.2 stands where its code is"},
        {"::: {.exercise .open #ex:1.1}\nx\n:::",
         "exercise 1.1 is open, and 1.2 is already this chapter's worked example"},
        {"$\\wrong{x}$", "bad TeX: Undefined control sequence: \\wrong"},
        {"$$ \\frac{1} $$", "bad TeX: "},
    };
    std::string page = "# First {#sec:first}\n\n::: {#eq:11star erratum=E05}\n$$ c = d $$\n:::\n";
    std::vector<std::size_t> lines;
    for (const auto& [text, message] : mistakes) {
        page += "\n";
        lines.push_back(static_cast<std::size_t>(std::count(page.begin(), page.end(), '\n')) + 1);
        page += text + "\n";
    }
    book.write("pages/01_first.md", page);
    const Said said = book.weave();
    CHECK(said.code == 1);
    for (std::size_t i = 0; i < mistakes.size(); ++i) {
        const std::string where = "pages/01_first.md:" + std::to_string(lines[i]) + ": ";
        INFO(mistakes[i].first << "\nwanted: " << where << mistakes[i].second << "\nsaid:\n" << said.text);
        bool found = false;
        for (std::size_t at = 0; !found && (at = said.text.find(where, at)) != std::string::npos; ++at) {
            const std::string line = said.text.substr(at, said.text.find('\n', at) - at);
            found = line.find(mistakes[i].second) != std::string::npos;
        }
        CHECK(found);
    }
    CHECK(static_cast<std::size_t>(std::count(said.text.begin(), said.text.end(), ':')) >=
          2 * mistakes.size());
    CHECK(book.page("01_first") == before);
    std::size_t beside = 0;  // nothing half written is left
    for (const auto& entry : std::filesystem::directory_iterator(book.folder()))
        beside += entry.path().filename().string().rfind("out", 0) == 0;
    CHECK(beside == 1);
}
