// The checker on answers of every kind, each with the words a learner needs.
#include <algorithm>
#include "../check.hpp"
#include "answers_file.hpp"
#include "learner.hpp"

using namespace nutshell::judge;

TEST_CASE("An answer that misbehaves is stopped, and the judge says how it did") {
    const Learner learner("behaviour");
    struct Case {
        std::string body, name, words;
    };
    const std::string right = "    return (next_position - position) / dt;";
    for (const Case& each : {
             Case{"    double t = 0;\n    while (t < 1) t *= 2;\n" + right, "endless loop",
                  "It does not come to an end"},
             Case{"    int* nowhere = nullptr;\n    *nowhere = 1;\n" + right, "crash", "It crashed"},
             Case{"    return Vector3(position[3], 0, 0);", "stopped by an assertion",
                  "components are counted from 0"},
             Case{"    throw std::runtime_error(\"I give up\");", "throws",
                  "It throws an exception: I give up"},
             Case{"    std::exit(0);", "ends the program", "no exit() in an answer"},
             Case{"    std::vector<std::vector<double>> all;\n    for (;;) all.emplace_back(1000000, 1.0);",
                  "too much memory", "more memory than there is for it"},
             Case{"    for (;;) std::puts(\"still here\");", "prints without end", "It prints without end"},
             Case{"    return (next_position - position) / dt * (0.0 / (dt - dt));", "wrong: NaN",
                  "is NaN, which is no number, born at the input below"},
             Case{"    return (next_position - position) / (dt - dt);", "wrong: infinite",
                  "division by zero"},
             Case{"    Vector3 velocity;\n    return velocity;", "wrong: NaN",
                  "a vector that was never given a value"},
         }) {
        const Verdict verdict = on_first(learner, each.body);
        INFO(each.body << "\n" << verdict.words);
        CHECK(verdict.outcome != Outcome::passed);
        CHECK(verdict.name == each.name);
        CHECK_THAT(flat(verdict.words), ContainsSubstring(each.words));
        CHECK_THAT(flat(verdict.words), ContainsSubstring("next_position"));  // the input it happened on
        is_plain(verdict);
    }
}

TEST_CASE("Prints disturb nothing and are quoted back, a few lines of them") {
    const Learner learner("prints");
    const std::string print =
        "    for (int i = 0; i < 40; ++i) std::printf(\"out %d\\n\", i), std::fprintf(stderr, \"err %d\\n\", "
        "i);\n";
    const Verdict wrong = on_first(learner, print + "    return (next_position - position) * dt;");
    INFO(wrong.words);
    CHECK(wrong.name == "wrong: multiplied by dt");
    CHECK_THAT(wrong.words, ContainsSubstring("It printed on standard output:\n    | out 0\n    | out 1\n    "
                                              "| out 2\n    | out 3\n    | out 4\n    | ...\n"));
    CHECK_THAT(wrong.words, ContainsSubstring("It printed on standard error:\n    | err 0\n"));
    CHECK_FALSE(contains(wrong.words, "out 5"));
    const Verdict right = on_first(learner, print + "    return (next_position - position) / dt;");
    CHECK(right.outcome == Outcome::passed);
}

TEST_CASE("What is no known mistake is told by its signature") {
    const Learner learner("signatures");
    struct Case {
        Number number;
        std::string body, name, words;
    };
    // one body for each exercise: they are compiled together
    const std::vector<Case> cases{
        {{1, 1},
         "    return (next_position - position) / dt * 180 / pi;",
         "wrong: wrong unit",
         "degrees stand where radians belong"},
        {{1, 2},
         "    return (before - 2 * here + after) / (dt * dt * dt);",
         "wrong: a wrong power of dt",
         "divided by once too often"},
        {{1, 3},
         "    const auto push = forces(state, t);\n    drift(state, dt);\n    kick(state, -push, dt);\n    "
         "return state;",
         "wrong: wrong sign",
         "The change of the velocity comes out with the wrong sign"},
        {{1, 4},
         "    drift(state, dt / 2);\n    kick(state, forces(state, t), dt);\n    drift(state, dt / 2);\n    "
         "return state;",
         "wrong: another scheme",
         "not the one asked for"},
        {{1, 5},
         "    kick(state, forces(state, t), dt / 3);\n    drift(state, dt);\n    kick(state, forces(state, t "
         "+ dt), 2 * dt / 3);\n    return state;",
         "wrong: wrong order",
         "where this method has dt^2"},
        {{1, 6},
         "    if (kicked == Kicked::half_and_half) return Vector3::Zero();\n    return (kicked == "
         "Kicked::after_drift ? "
         "-3 : 3) * acceleration * duration * dt / 2;",
         "wrong: wrong factor",
         "3 times what it should be"},
        {{1, 7},
         "    return acceleration.norm() > 0 ? duration / std::ceil(acceleration.squaredNorm() * duration * "
         "duration / (2 * tolerance)) : duration;",
         "wrong: wrong formula",
         "inputs: what is special about"},
        {{1, 8},
         "    clock.owed += frame_time;\n    const int due = static_cast<int>(clock.owed / clock.step);\n    "
         "clock.owed -= due * clock.step;\n    return due > 3 ? 3 : due;",
         "wrong: wrong formula",
         "It is right for"},
    };
    for (const Case& each : cases) learner.answer(each.number, each.body);
    const auto verdicts = learner.check_chapter(1);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        INFO(cases[i].number.text() << "\n" << verdicts[i].words);
        CHECK(verdicts[i].name == cases[i].name);
        CHECK_THAT(flat(verdicts[i].words), ContainsSubstring(cases[i].words));
        is_plain(verdicts[i]);
    }
}

TEST_CASE(
    "A slip that only some forces show is not called a right method, and a wrong sum is looked at where it "
    "is "
    "first wrong") {
    const Learner learner("more signatures");
    learner.answer({1, 5},
                   "    kick(state, forces(state, t), dt / 2);\n    drift(state, dt);\n    kick(state, "
                   "forces(state, t + dt / 3), dt / 2);\n    return state;");
    learner.answer({1, 7}, "    return 3 * tolerance / (acceleration.norm() * duration);");
    const auto verdicts = learner.check_chapter(1);
    CHECK(verdicts[4].name == "wrong: wrong order");
    CHECK_THAT(flat(verdicts[4].words),
               ContainsSubstring("goes like dt^2; for a method of order 2 it must be dt^3"));
    CHECK(verdicts[6].name == "wrong: wrong formula");
    CHECK_THAT(flat(verdicts[6].words),
               ContainsSubstring(
                   "Later on: The step is no finite number for tolerance 0.1, acceleration (0, 0, 0)"));
    CHECK_THAT(flat(verdicts[6].words), ContainsSubstring("Seen with tolerance 0.6,"));
}

TEST_CASE("A solution changed in the ninth digit fails, and the same function written otherwise passes") {
    const Learner learner("nearly right");
    for (const auto& [number, body] : std::vector<std::pair<Number, std::string>>{
             {{1, 1}, "    return (next_position - position) / (dt * (1 + 4e-9));"},
             {{1, 2}, "    return (before - (2 + 4e-9) * here + after) / (dt * dt);"},
             {{1, 3},
              "    const auto push = forces(state, t + 1e-7 * dt);\n    drift(state, dt);\n    kick(state, "
              "push, dt);\n    return state;"},
             {{1, 4},
              "    kick(state, forces(state, t), dt);\n    drift(state, (1 + 1e-8) * dt);\n    return "
              "state;"},
             {{1, 5},
              "    kick(state, forces(state, t), dt / 2);\n    drift(state, dt);\n    kick(state, "
              "forces(state, t + dt), (0.5 + 1e-8) * dt);\n    return state;"},
             {{1, 6},
              "    const Vector3 lag = acceleration * duration * dt / 2;\n    return kicked == "
              "Kicked::after_drift "
              "? Vector3(-lag) : kicked == Kicked::half_and_half ? Vector3(4e-9 * lag) : lag;"},
             {{1, 7},
              "    const double largest = 2 * tolerance / (acceleration.norm() * duration);\n    return "
              "duration / std::max(1.0, std::ceil(duration / largest)) * (1 + 4e-9);"},
             {{1, 8},
              "    clock.owed += frame_time;\n    const double due = std::floor(clock.owed / clock.step);\n  "
              "  clock.owed -= due * clock.step * (1 + 4e-9);\n"
              "    return static_cast<int>(std::min(due, 1.0 * clock.most_steps));"}})
        learner.answer(number, body);
    for (const Verdict& verdict : learner.check_chapter(1)) {
        INFO(verdict.number.text() << " " << verdict.name);
        CHECK(verdict.outcome == Outcome::wrong);
    }
    for (const auto& [number, body] : std::vector<std::pair<Number, std::string>>{
             {{1, 1}, "    return next_position / dt - position / dt;"},
             {{1, 2},
              "    const Vector3 first = velocity_between(before, here, dt);\n    const Vector3 second = "
              "velocity_between(here, after, dt);\n    return second / dt - first / dt;"},
             {{1, 3},
              "    State next = state;\n    kick(next, forces(state, t), dt);\n    drift(state, dt);\n    "
              "next.position = state.position;\n    return next;"},
             {{1, 4},
              "    const Vector3 push = forces(state, t);\n    kick(state, push, 0.5 * dt);\n    kick(state, "
              "0.5 * push, dt);\n    drift(state, dt);\n    return state;"},
             {{1, 5},
              "    const double half = 0.5 * dt;\n    const auto before = forces(state, t);\n    kick(state, "
              "before, half);\n    drift(state, half);\n    drift(state, half);\n"
              "    const auto after = forces(state, half + t + half);\n    kick(state, after, half);\n    "
              "return state;"},
             {{1, 6},
              "    switch (kicked) {\n        case Kicked::after_drift: return -0.5 * dt * duration * "
              "acceleration;\n        case Kicked::before_drift: return 0.5 * dt * duration * "
              "acceleration;\n"
              "        default: return {0, 0, 0};\n    }"},
             {{1, 7},
              "    const double steps = std::ceil(acceleration.norm() * duration * duration / 2 / "
              "tolerance);\n    return steps < 1 ? duration : duration / steps;"},
             {{1, 8},
              "    double left = clock.owed + frame_time;\n    int steps = 0;\n    while (left >= clock.step "
              "&& steps < clock.most_steps) left -= clock.step, ++steps;\n    clock.owed = left - clock.step "
              "* "
              "std::floor(left / clock.step);\n    return steps;"}})
        learner.answer(number, body);
    for (const Verdict& verdict : learner.check_chapter(1)) {
        INFO(verdict.number.text() << " " << verdict.name << "\n" << verdict.words);
        CHECK(verdict.outcome == Outcome::passed);
    }
}

TEST_CASE("Wrong answers as learners write them are told by what is wrong with them") {
    const Learner learner("wrong answers");
    auto left = answers_in(std::filesystem::path(CONFIG_COURSE) / "tests/judge/wrong_answers.txt");
    while (!left.empty()) {  // those of one chapter are compiled together, one of each exercise
        std::vector<WrittenAnswer> now, later;
        const int chapter = left.front().number.chapter;
        for (auto& each : left) {
            const bool taken = each.number.chapter != chapter ||
                               std::any_of(now.begin(), now.end(),
                                           [&](const auto& other) { return other.number == each.number; });
            (taken ? later : now).push_back(std::move(each));
        }
        for (const auto& each : now) learner.answer(each.number, each.body);
        for (const Verdict& verdict : learner.check_chapter(chapter))
            for (const auto& each : now) {
                if (verdict.number != each.number) continue;
                INFO(each.number.text() << "\n" << each.body << verdict.name << "\n" << verdict.words);
                CHECK((verdict.outcome == Outcome::wrong || verdict.outcome == Outcome::failed));
                CHECK_THAT(verdict.name + " " + flat(verdict.words), ContainsSubstring(each.expected));
            }
        for (const auto& each : now)
            learner.answer(each.number, "    throw Unanswered{\"" + each.number.text() + "\"};");
        left = std::move(later);
    }
}

TEST_CASE("An exercise that builds on another one is blocked by it, not wrong") {
    const Learner learner("blocked");
    const Number first{1, 1}, second{1, 2};
    learner.solve(second);
    Verdict verdict = learner.check_one(second);
    CHECK(verdict.outcome == Outcome::blocked);
    CHECK(verdict.name == "blocked by 1.1");
    CHECK_THAT(flat(verdict.words), ContainsSubstring("not answered yet. Answer that one first"));
    learner.answer(first, "    return (next_position - position) * dt;");
    verdict = learner.check_one(second);
    CHECK(verdict.name == "blocked by 1.1");
    CHECK_THAT(flat(verdict.words), ContainsSubstring("multiplied by dt"));
    learner.answer(
        second, "    // velocity_between is of no help here\n    return (before - 2 * here + after) / dt;");
    CHECK(learner.check_one(second).outcome == Outcome::wrong);
    learner.solve(first);
    learner.solve(second);
    CHECK(learner.check_one(second).outcome == Outcome::passed);
}

TEST_CASE("A step written for a PointMass passes, with a word on what it cannot do") {
    const Learner learner("point mass");
    learner.answer({1, 3},
                   "    const Vector3 a = forces(state, t) / state.mass;\n    state.position += "
                   "state.velocity * dt;\n    state.velocity += a * dt;\n    return state;");
    const Verdict verdict = learner.check_one({1, 3});
    INFO(verdict.words);
    CHECK(verdict.outcome == Outcome::passed);
    REQUIRE(verdict.notes.size() == 1);
    CHECK_THAT(verdict.notes.front(), ContainsSubstring("Said with drift and kick"));
    learner.answer({1, 3},
                   "    state.velocity += forces(state, t) / state.mass * dt;\n    state.position += "
                   "state.velocity * dt;\n    return state;");
    CHECK_THAT(learner.check_one({1, 3}).name, ContainsSubstring("kicks before it drifts"));
}

TEST_CASE("Marks that were deleted or doubled are reported, and the answer is judged all the same") {
    const Learner learner("marks");
    const Number first{1, 1};
    learner.solve(first);
    const std::string solved = learner.text(first);
    learner.replace(first, "    // end 1.1\n", "");
    Verdict verdict = learner.check_one(first);
    CHECK(verdict.outcome == Outcome::passed);
    REQUIRE(verdict.notes.size() == 1);
    CHECK_THAT(verdict.notes.front(), ContainsSubstring("the mark `// end 1.1` is gone: put it back"));
    learner.write(first, replaced(solved, "// exercise 1.1\n", "// exercise 1.1\n// exercise 1.1\n"));
    CHECK_THAT(learner.check_one(first).notes.at(0), ContainsSubstring("stands 2 times"));
    learner.write(first, replaced(replaced(solved, "    // exercise 1.1\n", ""), "    // end 1.1\n", ""));
    verdict = learner.check_one(first);
    CHECK(verdict.outcome == Outcome::passed);
    CHECK_THAT(verdict.notes.at(0), ContainsSubstring("are gone: put them back"));
}
