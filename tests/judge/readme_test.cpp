// The learner's first ten minutes in README.md, typed as they stand there.
#include <algorithm>
#include <regex>
#include <sstream>
#include "../check.hpp"
#include "learner.hpp"

using namespace nutshell::judge;

namespace {

/// Whether the lines printed are those shown, where a line of "..." stands for any lines.
bool as_shown(const std::vector<std::string>& shown, const std::vector<std::string>& printed,
              std::size_t s = 0, std::size_t p = 0) {
    if (s == shown.size()) return p == printed.size();
    if (shown[s] != "...")
        return p < printed.size() && printed[p] == shown[s] && as_shown(shown, printed, s + 1, p + 1);
    for (std::size_t next = p; next <= printed.size(); ++next)
        if (as_shown(shown, printed, s + 1, next)) return true;
    return false;
}

/// Line numbers of the headers move when these are edited, and a chapter gets more exercises: they are no
/// part of what is compared.
std::string without_counts(const std::string& text) {
    return std::regex_replace(std::regex_replace(text, std::regex(R"((\.hpp):\d+)"), "$1"),
                              std::regex(R"((\d+) of \d+ passed)"), "$1 passed");
}

}  // namespace

TEST_CASE("The learner's first ten minutes in the README are what happens") {
    const auto readme = lines_of(read_text(std::filesystem::path(CONFIG_COURSE) / "README.md"));
    const auto title = std::find(readme.begin(), readme.end(), "## The learner's first ten minutes");
    REQUIRE(title != readme.end());
    const Learner learner("readme");
    std::filesystem::remove_all(learner.rooms.answers);  // ./course start makes it

    static const std::regex exercise(R"(xercise (\d+\.\d+))"), command(R"(\$ \./course (.*))");
    std::optional<Number> number;
    std::string block, body;
    std::vector<std::string> words, shown;
    std::size_t commands = 0, answers = 0;
    const auto play = [&] {
        if (words.empty()) return;
        ++commands;
        if (words.front() == "run" || words.front() == "watch")
            return words.clear();  // have tests of their own
        const Ran ran = learner.judge(words);
        INFO("./course " << joined(words, " ") << "\n" << ran.out << ran.err);
        CHECK(as_shown(shown, lines_of(without_counts(ran.out))));
        CHECK(ran.err.empty());
        words.clear();
    };
    for (auto line = title + 1; line != readme.end() && !starts_with(*line, "## "); ++line) {
        std::smatch found;
        if (starts_with(*line, "```")) {
            if (block == "console") play();
            if (block == "cpp") {
                REQUIRE(number);
                learner.answer(*number, body.substr(0, body.size() - 1));
                body.clear(), ++answers;
            }
            block = line->substr(3);
        } else if (block == "console" && std::regex_match(*line, found, command)) {
            play();
            shown.clear();
            std::istringstream stream(found[1].str());
            for (std::string word; stream >> word;) words.push_back(word);
        } else if (block == "console") {
            shown.push_back(without_counts(*line));
        } else if (block == "cpp") {
            body += "    " + *line + "\n";
        } else {
            for (std::string rest = *line; std::regex_search(rest, found, exercise); rest = found.suffix())
                number = number_of(found[1].str());
        }
    }
    CHECK(commands >= 6);
    CHECK(answers >= 3);
}
