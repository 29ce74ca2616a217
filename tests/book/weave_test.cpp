// What a good page becomes, and what each kind of bad page is told.
#include <algorithm>

#include "check.hpp"
#include "little_book.hpp"

using namespace book_test;

namespace {

/// CHECKs that the pieces stand in `text`, in this order.
void check_in_order(const std::string& text, const std::vector<std::string>& pieces) {
    std::size_t from = 0;
    for (const std::string& piece : pieces) {
        const std::size_t at = text.find(piece, from);
        INFO("looking for: " << piece << "\nafter: " << text.substr(from, 600));
        CHECK(at != std::string::npos);
        if (at != std::string::npos) from = at + piece.size();
    }
}

}  // namespace

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

TEST_CASE(
    "claims: what stands behind each sentence is listed, and what stands behind nothing is told apart") {
    const LittleBook book;
    book.write("tests/some_test.cpp", "TEST_CASE(\"it is \"\n    \"so\") {}\n");
    book.write("pages/01_first.md", R"(# First {#sec:first}

Turns by `turn %.2e rad`{=num}. [More]{by="steps > 2 and share*10 < 1"} of it. Held [always]{by="test: it is so"}, by
[@eq:11star] [exactly]{by="eq:11star"}. This one is better. This "one" has 3 parts. Is it more? Plain.

::: {#eq:11star erratum=E05}
$$ c = d $$
:::
)");
    const Said said = book.weave();
    INFO(said.text);
    REQUIRE(said.code == 0);
    check_in_order(read_text(book.folder() / "out/claims.csv"),
                   {"page,kind,behind,sentence\n",
                    "01_first.md,held,\"01_first/turn = -0.0010345678901234567 rad\",\"Turns by ",
                    "01_first.md,held,\"steps > 2 and share*10 < 1\",\"More of it.\"",
                    "01_first.md,held,\"test: it is so; eq:11star\",\"Held always",
                    "01_first.md,bare,\"better\",\"This one is better.\"",
                    "01_first.md,given,\"\",\"This “one” has 3 parts.\""});
    const std::string list = read_text(book.folder() / "out/claims.csv");
    CHECK(list.find("Is it more") == std::string::npos);
    CHECK(list.find("Plain") == std::string::npos);
    CHECK_THAT(book.page("01_first"),
               ContainsSubstring("<span class=\"claim\" data-by=\"test: it is so\">always</span>"));
}

TEST_CASE("a label on two pages: its own page first, else the page must be named") {
    const LittleBook book;
    const std::string equation = "\n::: {#eq:11star erratum=E05}\n$$ c = d $$\n:::\n";
    book.write("pages/01_first.md", "# First {#sec:first}\n\nOwn: [@eq:11star].\n" + equation);
    book.write("pages/02_second.md",
               "# Second {#sec:second}\n\nOwn: [@eq:11star]; not: [@01_first/eq:11star].\n" + equation);
    book.write("pages/03_third.md", "# Third {#sec:third}\n\n[@01_first/eq:11star]\n");
    const Said good = book.weave();
    INFO(good.text);
    REQUIRE(good.code == 0);
    check_in_order(book.page("02_second"),
                   {"href=\"#eq:11star\">(11*)", "href=\"01_first.html#eq:11star\">(11*)"});

    book.write("pages/03_third.md", "# Third {#sec:third}\n\n[@eq:11star]\n");
    const Said bad = book.weave();
    CHECK(bad.code == 1);
    CHECK_THAT(bad.text, ContainsSubstring("03_third.md:3: ambiguous reference @eq:11star: write "
                                           "@01_first/eq:11star or @02_second/eq:11star"));
}

TEST_CASE("errata.csv is judged too: quoting, cells, and places that are not there") {
    const LittleBook book;
    book.write("pages/01_first.md", "# First {#sec:first}\n\nNothing.\n");
    const Said nowhere = book.weave();
    CHECK(nowhere.code == 1);
    CHECK_THAT(
        nowhere.text,
        ContainsSubstring("errata.csv:2: E05 lives on page 01_first#eq:11star, and there is no such place"));
    book.write("pages/errata.csv",
               "id,where,printed,correct,severity,lives\nE05,\"open,x,y,inaccurate,wording\n");
    CHECK_THAT(book.weave().text, ContainsSubstring("errata.csv:2: a quote is opened and never closed"));
    book.write("pages/errata.csv", "id,where,printed,correct,severity,lives\nE05,x,y,inaccurate,wording\n");
    CHECK_THAT(book.weave().text, ContainsSubstring("errata.csv:2: a row has 6 cells, this one has 5"));
}

TEST_CASE("bad arguments and folders of the book's build get one clear line") {
    const std::string build = "'" PROJECT_DIR "/book/build.sh' ";
    const Said unknown = run(build + "--quick");
    CHECK(unknown.code == 2);
    CHECK_THAT(unknown.text, ContainsSubstring("book: unknown argument '--quick'"));
    const Said bare = run(build + "--out");
    CHECK(bare.code == 2);
    CHECK_THAT(bare.text, ContainsSubstring("book: --out wants a folder"));
    const LittleBook book;
    const Said none = run(build + "--pages '" + book.folder().string() + "/src' --out '" +
                          book.folder().string() + "/out'");
    CHECK(none.code == 1);
    CHECK_THAT(none.text, ContainsSubstring("book: no pages in"));
    book.write("file", "not a folder");
    CHECK(run(build + "--out '" + book.folder().string() + "/file/book'").code == 1);
}
