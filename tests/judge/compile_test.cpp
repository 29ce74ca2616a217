// Answers that do not compile: what the judge says of a compiler's message.
#include "../check.hpp"
#include "answers_file.hpp"
#include "learner.hpp"

using namespace nutshell::judge;

TEST_CASE("An answer that does not compile: the learner's own line first, in plain words") {
    const Learner learner("compile errors");
    struct Case {
        std::string body, line, words;
    };
    for (const Case& each : {
             Case{"    return (next_position - positoin) / dt;", "return (next_position - positoin) / dt;",
                  "Do you mean position?"},
             Case{"    const Vector3 way = next_position - position\n    return way / dt;",
                  "way = next_position - position", "A semicolon is missing"},
             Case{"    return dt / (next_position - position);", "return dt / (next_position - position);",
                  "cannot be joined like this"},
             Case{"    return (next_position - position).norm() / dt;", "norm() / dt",
                  "A value of type double stands where a Vector3 is needed"},
             Case{"    const Vector3 way = next_position - position;", "", "a return is missing"},
             Case{"    std::deque<double> all;\n    return (next_position - position) / dt;", "std::deque",
                  "needs the line #include <deque>"},
             Case{"    if (dt > 0) {\n    return (next_position - position) / dt;", "if (dt > 0) {",
                  "opens 1 braces { and closes 0"},
             Case{"    return velocity_between(position, next_position);",
                  "return velocity_between(position, next_position);", "too few values"},
             Case{"    next_position -= position;\n    return next_position / dt;",
                  "next_position -= position;", "it is const"},
         }) {
        const Verdict verdict = on_first(learner, each.body);
        INFO(each.body << "\n" << verdict.words);
        CHECK(verdict.outcome == Outcome::not_compiled);
        CHECK(verdict.name == "does not compile");
        const auto lines = lines_of(verdict.words);
        REQUIRE(lines.size() >= 3);
        CHECK_THAT(lines[0], ContainsSubstring("answers/01_newton/nutshell/newton.hpp:"));
        CHECK_THAT(lines[1], ContainsSubstring(each.line));
        CHECK_THAT(flat(verdict.words), ContainsSubstring(each.words));
        CHECK(lines.size() <= 5);
        is_plain(verdict);
    }
}

TEST_CASE("An error inside a step that other code calls still points at the learner's line") {
    const Learner learner("errors in templates");
    learner.answer({1, 3},
                   "    const Vector3 push = forces(state, t).dot(state.position);\n    drift(state, dt);\n  "
                   "  kick(state, push, dt);\n    return state;");
    const Verdict verdict = learner.check_one({1, 3});
    INFO(verdict.words);
    CHECK(verdict.outcome == Outcome::not_compiled);
    CHECK_THAT(lines_of(verdict.words).at(1), ContainsSubstring("forces(state, t).dot(state.position)"));
    is_plain(verdict);
}

TEST_CASE("A changed signature, a deleted function, a missing include, an empty file") {
    const Learner learner("headers");
    const Number first{1, 1};
    const std::string whole = learner.text(first);
    learner.solve(first);
    const std::string solved = learner.text(first);

    learner.replace(first, "velocity_between(const Vector3& position,",
                    "velocity_between(int step, const Vector3& position,");
    Verdict verdict = learner.check_one(first);
    INFO(verdict.words);
    CHECK(verdict.outcome == Outcome::not_compiled);
    CHECK_THAT(
        flat(verdict.words),
        ContainsSubstring(
            "velocity_between cannot be called as the chapter calls it. Its first line must stay as it was"));
    CHECK_THAT(flat(verdict.words), ContainsSubstring("Vector3 velocity_between(const Vector3& position"));
    is_plain(verdict);

    learner.write(first,
                  replaced(solved, "inline Vector3 velocity_between", "inline double velocity_between"));
    verdict = learner.check_one(first);
    CHECK(verdict.outcome == Outcome::not_compiled);
    is_plain(verdict);

    learner.write(first, replaced(solved, "velocity_between", "speed_between"));
    verdict = learner.check_one(first);
    CHECK(verdict.outcome == Outcome::not_compiled);
    CHECK_THAT(flat(verdict.words),
               ContainsSubstring("velocity_between cannot be called as the chapter calls it"));

    learner.write(first, replaced(solved, "// end 1.1", "#include <no_such_thing.hpp>\n    // end 1.1"));
    verdict = learner.check_one(first);
    CHECK(verdict.outcome == Outcome::not_compiled);
    CHECK_THAT(flat(verdict.words), ContainsSubstring("There is no file no_such_thing.hpp to include"));

    learner.write(first, "");
    verdict = learner.check_one(first);
    CHECK(verdict.name == "file empty");
    CHECK_THAT(flat(verdict.words),
               ContainsSubstring("newton.hpp is empty. ./course reset 1.1 writes it anew"));
    CHECK_THAT(reset(learner.rooms, first), ContainsSubstring("is made anew"));
    CHECK(learner.text(first) == whole);

    std::filesystem::remove(learner.file(first));
    CHECK_THAT(learner.check_one(first).words, ContainsSubstring("is missing. ./course start makes it anew"));

    const Number last{1, 8};
    learner.write(first, solved);
    learner.solve(last);
    learner.replace(last, "#include <nutshell/newton.hpp>\n", "");
    verdict = learner.check_one(last);
    INFO(verdict.words);
    CHECK(verdict.outcome == Outcome::not_compiled);
    CHECK_THAT(flat(verdict.words), ContainsSubstring("The line #include <nutshell/newton.hpp> is missing in "
                                                      "answers/01_newton/nutshell/game_loop.hpp"));
}

TEST_CASE("First errors of beginners are explained") {
    const Learner learner("beginners");
    for (const auto& [number, expected, body] :
         answers_in(std::filesystem::path(CONFIG_COURSE) / "tests/judge/compile_errors.txt")) {
        const std::string before = learner.text(number);
        learner.write(number, with_bodies(marked(before), {{number, body}}));
        const Verdict verdict = learner.check_one(number);
        learner.write(number, before);
        INFO(number.text() << "\n" << body << verdict.words);
        CHECK(verdict.outcome == Outcome::not_compiled);
        CHECK_THAT(flat(verdict.words), ContainsSubstring(expected));
        is_plain(verdict);
    }
}
