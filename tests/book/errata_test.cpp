// errata.csv: all 80 rows, well formed, and what a row says about where its defect lives is true.
#include <algorithm>
#include <regex>
#include <set>

#include "check.hpp"
#include "little_book.hpp"

namespace fs = std::filesystem;
using namespace book_test;

namespace {

using Row = std::vector<std::string>;

/// RFC 4180. @throws std::runtime_error with the line of a quote that is never closed or stands where none
/// may
std::vector<Row> parse_csv(const std::string& text) {
    std::vector<Row> rows;
    Row row;
    std::size_t at = 0;
    const auto refuse = [&](const std::string& what) {
        throw std::runtime_error(
            "line " +
            std::to_string(1 + std::count(text.begin(), text.begin() + static_cast<long>(at), '\n')) + ": " +
            what);
    };
    while (at < text.size()) {
        std::string cell;
        if (text[at] == '"') {
            for (++at;; ++at) {
                if (at >= text.size()) refuse("a quote is opened and never closed");
                if (text[at] != '"')
                    cell += text[at];
                else if (at + 1 < text.size() && text[at + 1] == '"')
                    cell += text[at++];
                else
                    break;
            }
            ++at;
        } else {
            for (; at < text.size() && text[at] != ',' && text[at] != '\n'; ++at) {
                if (text[at] == '"') refuse("a quote inside an unquoted cell");
                cell += text[at];
            }
        }
        row.push_back(cell);
        if (at < text.size() && text[at] == ',') {
            ++at;
            continue;
        }
        if (at < text.size() && text[at] != '\n') refuse("text after a closing quote");
        ++at;
        rows.push_back(row);
        row.clear();
    }
    return rows;
}

std::string trimmed(const std::string& text) {
    const std::size_t from = text.find_first_not_of(' ');
    return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(' ') - from + 1);
}

/// The text of all files below `folder` whose path matches, joined.
std::string sources(const fs::path& folder, const std::string& pattern) {
    std::string all;
    if (!fs::exists(folder)) return all;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && std::regex_match(entry.path().generic_string(), std::regex(pattern)))
            all += read_text(entry.path());
    return all;
}

const fs::path project = PROJECT_DIR;

const std::vector<Row>& rows() {
    static const std::vector<Row> all = parse_csv(read_text(project / "book/errata.csv"));
    return all;
}

/// The pieces of the last cell, split at semicolons.
std::vector<std::string> lives(const Row& row) {
    std::vector<std::string> out;
    std::istringstream cell(row.at(5));
    for (std::string item; std::getline(cell, item, ';');) out.push_back(trimmed(item));
    return out;
}

/// Why `item` ("test: NAME" and so on) is not true of this project; empty if it is.
std::string objection(const std::string& item) {
    static const std::string tests = sources(project / "tests", R"(.*\.(cpp|hpp|sh|cjs))");
    static const std::string exercises = sources(project / "chapters", R"(.*/chapters/[^/]*/exercises/.*)");
    static const std::regex planned("planned: chapter [1-7]");
    if (item == "wording" || std::regex_match(item, planned)) return "";
    const std::size_t colon = item.find(": ");
    if (colon == std::string::npos) return "says nothing known";
    const std::string kind = item.substr(0, colon), name = item.substr(colon + 2);
    if (kind == "test") {
        if (name.find('/') != std::string::npos && fs::is_regular_file(project / name)) return "";
        return tests.find("TEST_CASE(\"" + name + "\"") != std::string::npos
                   ? ""
                   : "names no test case (or file) of tests/";
    }
    if (kind == "mistake")
        return exercises.find("\"" + name + "\"") != std::string::npos
                   ? ""
                   : "names no mistake of chapters/*/exercises";
    if (kind == "page") {
        const std::size_t hash = name.find('#');
        const fs::path page = project / "book" / (name.substr(0, hash) + ".md");
        if (!fs::is_regular_file(page)) return "names no page of book/";
        if (hash == std::string::npos) return "";
        return read_text(page).find("#" + name.substr(hash + 1)) != std::string::npos
                   ? ""
                   : "names an anchor its page does not have";
    }
    return "says nothing known";
}

}  // namespace

TEST_CASE("errata.csv has 80 rows, E01 to E80, six cells each and none empty") {
    REQUIRE(rows().size() == 81);
    CHECK(rows()[0] == Row{"id", "where", "printed", "correct", "severity", "lives"});
    const std::set<std::string> severities = {"wording",
                                              "inaccurate",
                                              "unsafe",
                                              "breaks physics",
                                              "breaks physics in 3-D",
                                              "unsafe, breaks physics",
                                              "does not compile"};
    for (std::size_t i = 1; i < rows().size(); ++i) {
        const Row& row = rows()[i];
        const std::string number = std::to_string(i);
        INFO("row " << i);
        REQUIRE(row.size() == 6);
        CHECK(row[0] == (number.size() == 1 ? "E0" : "E") + number);
        for (const std::string& cell : row) CHECK(!trimmed(cell).empty());
        CHECK(severities.count(row[4]) == 1);
    }
}

TEST_CASE("each erratum lives where errata.csv says, and only wording lives as wording alone") {
    for (std::size_t i = 1; i < rows().size(); ++i) {
        const Row& row = rows()[i];
        INFO(row.at(0) << ": " << row.at(5));
        REQUIRE(!lives(row).empty());
        for (const std::string& item : lives(row)) {
            INFO("the entry '" << item << "' " << objection(item));
            CHECK(objection(item).empty());
        }
        if (row.at(4) != "wording") CHECK(lives(row) != std::vector<std::string>{"wording"});
    }
}

TEST_CASE("the check of errata.csv refuses what is not there") {
    CHECK(objection("test: errata.csv has 80 rows, E01 to E80, six cells each and none empty").empty());
    CHECK(objection("test: tests/book/errata_test.cpp").empty());
    CHECK(objection("page: notation#symbols").empty());
    for (const char* wrong : {"test: no such test", "test: tests/book/lost.cpp", "mistake: no such mistake",
                              "page: notation#nowhere", "page: nowhere#symbols", "planned: some day",
                              "planned: chapter 8", "elsewhere", "word: x", ""}) {
        INFO(wrong);
        CHECK(!objection(wrong).empty());
    }
    CHECK_THROWS(parse_csv("a,\"b\n"));
    CHECK_THROWS(parse_csv("a,b\"c\n"));
    CHECK_THROWS(parse_csv("\"a\"b,c\n"));
    CHECK(parse_csv("a,\"b \"\"c\"\", d\"\n") == std::vector<Row>{{"a", "b \"c\", d"}});
}
