// run N --mine: the program's output follows the learner's answers.
#include <map>
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

TEST_CASE("run --mine: the numbers follow the answer, and the reference stands in for the rest") {
    const Learner learner("mine");
    const auto run_mine = [&] {
        return learner.judge({"run", "1", "--mine", "--out", (learner.folder / "out").string()});
    };

    // an answer that would hang it is left out, and it says so
    learner.answer({1, 7}, "    while (duration > 0) tolerance += 1;\n    return tolerance;");

    // semi-implicit Euler in place of Euler, with a header of the learner's own: where Euler is g T dt/2 too
    // high, it is as much too low
    write_text(learner.file({1, 3}).parent_path() / "my_step.hpp",
               "#pragma once\ntemplate <class State>\nvoid my_drift(State& state, double dt) {\n"
               "    drift(state, dt);\n}\n");
    learner.replace({1, 3}, "// [euler]\n",
                    "}\n#include <nutshell/my_step.hpp>\nnamespace nutshell {\n// [euler]\n");
    learner.answer({1, 3},
                   "    kick(state, forces(state, t), dt);\n    my_drift(state, dt);\n    return state;");
    const Ran ran = run_mine();
    INFO(ran.out << ran.err);
    REQUIRE(ran.exit_code == 0);
    CHECK_THAT(ran.out,
               ContainsSubstring(
                   "Yours: 1.3. The reference stands in for 1.1, 1.2, 1.4 to 1.6, 1.8, not answered yet."));
    CHECK_THAT(flat(ran.out),
               ContainsSubstring("Your answer to 1.7 cannot be run (endless loop; ./course check 1.7 "
                                 "says more): the reference stands in for it."));
    CHECK_THAT(ran.out, ContainsSubstring(
                            "Not right yet, so look at what it does: 1.3 (wrong: kicks before it drifts)"));
    auto numbers = numbers_in(learner.folder / "out");
    const auto value = [&](const std::string& name) {
        REQUIRE(numbers.count(name) == 1);
        return std::stod(numbers[name].substr(name.size() + 1));
    };
    CHECK(std::abs(value("frame_rate.euler.60") + 9.81 * 3 / 60 / 2) < 1e-9);
    CHECK(std::abs(value("frame_rate.verlet.60")) < 1e-9);

    // a second answer: only the parts that run it are made anew, and what the others found stays
    learner.answer({1, 6}, "    return 2 * acceleration * duration * dt;");
    const Ran again = run_mine();
    INFO(again.out << again.err);
    REQUIRE(again.exit_code == 0);
    CHECK_THAT(again.out, ContainsSubstring("Only what runs the changed answer is made anew: "));
    CHECK_THAT(again.out, ContainsSubstring("Thrown ball"));
    CHECK_FALSE(contains(again.out, "Planet"));
    const auto before = numbers;
    numbers = numbers_in(learner.folder / "out");
    CHECK(numbers["planet.verlet.energy_change"] == before.at("planet.verlet.energy_change"));
    CHECK(value("throw.verlet.off_the_law") > 0.1);
    CHECK(std::stod(before.at("throw.verlet.off_the_law").substr(25)) < 1e-9);
    CHECK(numbers.size() == before.size());
}
