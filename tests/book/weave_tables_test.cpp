// What the weaver lists and takes from lists: claims, labels, errata, tables from a CSV, numbers nobody
// quotes.
#include "check.hpp"
#include "in_order.hpp"
#include "little_book.hpp"

using namespace book_test;

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

TEST_CASE("a table's rows come from a CSV: one row is written, and repeated") {
    const LittleBook book;
    book.write(
        "results/01_first/limits.csv",
        "# command: a test\nmethod,limit,found,drag\n\"A, again\",2,2.0004,inf\nB,0,,1.5\nC,1,1.001,0.5\n");
    const auto page = [&](const std::string& attributes, const std::string& row) {
        book.write("pages/01_first.md", "# First {#sec:first}\n\n::: {.table " + attributes +
                                            "}\n| method | limit |\n|---|---|\n" + row +
                                            "\n| D | never |\n:::\n\n::: {#eq:11star erratum=E05}\n"
                                            "$$ c = d $$\n:::\n");
        return book.weave();
    };
    const Said good = page("from=\"limits.csv\" but=\"C\"",
                           "| `method`{=cell} | `limit found *2 %.2f s`{=cell}, `drag %.1f`{=cell} |");
    INFO(good.text);
    REQUIRE(good.code == 0);
    const std::string html = book.page("01_first");
    check_in_order(html, {"<td", "A, again</td>", "01_first/limits.csv, A, again, limit = 2\">4.00",
                          "s</span> · ", "4.00", "∞", "B</td>", "0, <span", "1.5</span>", "D</td>", "never"});
    CHECK(html.find("C</td>") == std::string::npos);
    check_in_order(read_text(book.folder() / "out/unquoted.txt"), {"01_first/nothing\n", "01_first/steps\n"});

    const Said bad = page("from=\"limits.csv\" only=\"E\"", "| `lost %.1f`{=cell} | |");
    CHECK(bad.code == 1);
    CHECK_THAT(bad.text, ContainsSubstring(
                             "01_first.md:3: 01_first/limits.csv has no row 'E' (it has: A, again, B, C)"));
    const Said cell = page("from=\"limits.csv\"", "| `lost %.1f`{=cell} | |");
    CHECK_THAT(cell.text,
               ContainsSubstring("01_first.md:6: cell `lost %.1f`: 01_first/limits.csv has no such column"));
    CHECK_THAT(page("from=\"gone.csv\"", "| | |").text, ContainsSubstring("there is no 01_first/gone.csv"));
    CHECK_THAT(page("", "| | |").text, ContainsSubstring("a table says where its rows stand"));
}
