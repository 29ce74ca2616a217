// run N --mine: the program's output follows the learner's answers.
#include <sstream>
#include "../check.hpp"
#include "learner.hpp"

using namespace nutshell::judge;

namespace {

/// numbers.csv as name -> value, without its lines on machine and command.
std::map<std::string, std::string> numbers_in(const std::filesystem::path& folder) {
    std::map<std::string, std::string> numbers;
    for (const auto& line : lines_of(read_text(folder / "numbers.csv")))
        if (!starts_with(line, "#")) numbers[line.substr(0, line.find(','))] = line;
    return numbers;
}

}  // namespace

TEST_CASE("run --mine: without answers the reference's numbers, with an answer the numbers follow it") {
    const Learner learner("mine");
    const auto run_mine = [&](const std::string& folder) {
        return learner.judge({"run", "1", "--mine", "--out", (learner.folder / folder).string()});
    };
    Ran ran = run_mine("reference");
    INFO(ran.out << ran.err);
    REQUIRE(ran.exit_code == 0);
    CHECK_THAT(ran.out, ContainsSubstring("None is yours: the reference stands in for 1.1 to 1.8, not answered yet."));

    // semi-implicit Euler in place of Euler: what was Euler's error takes the other's sign
    learner.answer({1, 3}, "    kick(state, forces(state, t), dt);\n    drift(state, dt);\n    return state;");
    ran = run_mine("mine");
    INFO(ran.out << ran.err);
    REQUIRE(ran.exit_code == 0);
    CHECK_THAT(ran.out, ContainsSubstring("Yours: 1.3. The reference stands in for 1.1, 1.2, 1.4 to 1.8, not answered yet."));
    CHECK_THAT(ran.out, ContainsSubstring("Not right yet, so look at what it does: 1.3 (wrong: kicks before it drifts)"));
    auto before = numbers_in(learner.folder / "reference"), after = numbers_in(learner.folder / "mine");
    REQUIRE(before.size() == after.size());
    const auto value = [](const std::string& line) { return std::stod(line.substr(line.find(',') + 1)); };
    const std::string name = "frame_rate.euler.60";
    REQUIRE(before.count(name) == 1);
    CHECK(value(before[name]) > 0.1);
    CHECK(std::abs(value(before[name]) + value(after[name])) < 1e-9);
    CHECK(before["frame_rate.verlet.60"] == after["frame_rate.verlet.60"]);        // what was not answered is the reference's

    // an answer that would hang it is refused with its name
    learner.answer({1, 3}, "    while (dt > 0) drift(state, dt);\n    return state;");
    ran = run_mine("never");
    CHECK(ran.exit_code == 1);
    CHECK_THAT(ran.err, ContainsSubstring("your answer to 1.3 cannot be run: endless loop"));
}
