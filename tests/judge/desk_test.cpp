// The learner's folder and the verbs, tried through the program itself.
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>
#include "../check.hpp"
#include "learner.hpp"

using namespace nutshell::judge;
namespace fs = std::filesystem;

namespace {

const Number first{1, 1};
const std::string right = "    return (next_position - position) / dt;",
                  wrong = "    return (next_position - position) * dt;";

}  // namespace

TEST_CASE("start makes skeletons without a line of the solution, and overwrites nothing") {
    const Learner learner("start");
    const std::string text = learner.text(first);
    CHECK_THAT(text, ContainsSubstring("// exercise 1.1\n    throw Unanswered{\"1.1\"};\n    // end 1.1\n"));
    CHECK_THAT(text, ContainsSubstring("#include <nutshell/unanswered.hpp>\n"));
    CHECK_FALSE(contains(text, "(next_position - position)"));
    CHECK_THAT(text, ContainsSubstring(
                         "inline void drift(PointMass& body, double dt) {"));  // what is no exercise stays
    learner.answer(first, right);
    const std::string mine = learner.text(first);
    fs::remove(learner.file({1, 8}));
    const Ran ran = learner.judge({"start"});
    CHECK(ran.exit_code == 0);
    CHECK_THAT(ran.out, ContainsSubstring("made answers/01_newton/nutshell/game_loop.hpp"));
    CHECK_THAT(ran.out, ContainsSubstring("yours already and left as"));
    CHECK(learner.text(first) == mine);
    CHECK_THAT(learner.judge({"start"}).out, ContainsSubstring("Nothing to do"));
}

TEST_CASE("check: the first thing to do, then verdicts, then progress that stays") {
    const Learner learner("check");
    Ran ran = learner.judge({"check", "1"});
    CHECK(ran.exit_code == 1);
    CHECK_THAT(ran.out, ContainsSubstring("1.8   How many steps a frame owes             not answered yet"));
    CHECK_THAT(ran.out,
               ContainsSubstring(
                   "Next: 1.1 Velocity from two positions, in\n  answers/01_newton/nutshell/newton.hpp:"));
    learner.answer(first, wrong);
    ran = learner.judge({"check", "1.1"});
    CHECK(ran.exit_code == 1);
    CHECK_THAT(ran.out, ContainsSubstring("wrong: multiplied by dt"));
    CHECK_THAT(ran.out, ContainsSubstring("What a player would see"));
    CHECK_THAT(ran.out, ContainsSubstring("expected  (1.25, 9, -6.75)"));
    learner.answer(first, right);
    ran = learner.judge({"check", "1.1"});
    CHECK(ran.exit_code == 0);
    CHECK_THAT(ran.out, ContainsSubstring("passed"));
    CHECK_THAT(learner.judge({"check", "1"}).out,
               ContainsSubstring("1 of " + std::to_string(chapter_of(learner.rooms, first).exercises.size()) +
                                 " passed. Next: 1.2"));
    CHECK(Progress::read(learner.rooms).entries[first].passed);
    learner.answer(first, wrong);
    CHECK(learner.judge({"check", "1.1"}).exit_code == 1);
    CHECK(Progress::read(learner.rooms).entries[first].passed);  // it did pass once
}

TEST_CASE("An edit while nothing else changes is seen, and without an edit nothing is compiled") {
    const Learner learner("freshness");
    const Chapter chapter = chapter_of(learner.rooms, first);
    const Sheets sheets(learner.rooms, chapter);
    learner.answer(first, right);
    CHECK(sheets.compile({first}).compiled);
    CHECK_FALSE(sheets.compile({first}).compiled);
    learner.answer(first, wrong);
    CHECK(sheets.compile({first}).compiled);
    CHECK(learner.check_one(first).outcome == Outcome::wrong);
    CHECK_FALSE(sheets.compile({first}).compiled);
    learner.answer(first, "    return nothing;");
    CHECK(sheets.compile({first}).problem);
    CHECK(sheets.compile({first}).problem);  // an error is not taken for a product
}

TEST_CASE("hint gives three, one at a time, and solution waits for a pass or for giving up") {
    const Learner learner("hints");
    const auto& hints = exercise_of(first).hints;
    for (std::size_t i = 0; i < 3; ++i) {
        const Ran ran = learner.judge({"hint", "1.1"});
        CHECK_THAT(ran.out, ContainsSubstring("Hint " + std::to_string(i + 1) + " of 3"));
        CHECK_THAT(replaced(ran.out, "\n ", ""), ContainsSubstring(hints[i].substr(0, 40)));
        if (i < 2) CHECK_FALSE(contains(ran.out, hints[i + 1].substr(0, 30)));
    }
    CHECK_THAT(learner.judge({"hint", "1.1"}).out,
               ContainsSubstring("There are no more. The solution: ./course solution 1.1 --give-up"));
    Ran ran = learner.judge({"solution", "1.1"});
    CHECK(ran.exit_code == 1);
    CHECK_THAT(ran.err, ContainsSubstring("has not passed yet"));
    CHECK_THAT(ran.err, ContainsSubstring("--give-up"));
    CHECK_THAT(learner.judge({"solution", "1.1", "--give-up"}).out,
               ContainsSubstring("return (next_position - position) / dt;"));
    learner.answer(first, "    return next_position / dt - position / dt;");
    CHECK(learner.judge({"check", "1.1"}).exit_code == 0);
    ran = learner.judge({"solution", "1.1"});
    CHECK(ran.exit_code == 0);
    CHECK_THAT(ran.out, ContainsSubstring(
                            "Vector3 velocity_between(const Vector3& position, const Vector3& next_position, "
                            "double dt) {\n    return (next_position - position) / dt;\n}"));
}

TEST_CASE("reset puts one body back, keeps the rest, and saves what was there under a new name each time") {
    const Learner learner("reset");
    const std::string fresh = learner.text(first);
    CHECK_THAT(learner.judge({"reset", "1.1"}).out, ContainsSubstring("nothing to put back"));
    learner.answer({1, 2}, "    // mine\n    return before;");
    const std::string with_second = learner.text(first);
    for (const std::string which : {"1", "2"}) {
        learner.answer(first, "    // attempt " + which + "\n" + wrong);
        const Ran ran = learner.judge({"reset", "1.1"});
        CHECK(ran.exit_code == 0);
        CHECK_THAT(ran.out, ContainsSubstring("Your old answer is in answers/saved/1.1_" + which + ".hpp"));
        CHECK(learner.text(first) == with_second);
        CHECK_THAT(read_text(learner.rooms.answers / ("saved/1.1_" + which + ".hpp")),
                   ContainsSubstring("// attempt " + which + "\n" + wrong));
    }
    // with its marks gone, the whole file is saved and made anew, and the other answers are carried over
    learner.replace(first, "    // end 1.1\n", "    // a note of mine\n");
    const std::string broken = learner.text(first);
    CHECK_THAT(learner.judge({"reset", "1.1"}).out, ContainsSubstring("answers/saved/newton_1.hpp"));
    CHECK(read_text(learner.rooms.answers / "saved/newton_1.hpp") == broken);
    CHECK(learner.text(first) == with_second);
}

TEST_CASE("Every verb answers bad arguments with one line and a code") {
    const Learner learner("usage");
    for (const auto& words : std::vector<std::vector<std::string>>{{"check", "9.9"},
                                                                   {"check", "newton"},
                                                                   {"hint"},
                                                                   {"hint", "one"},
                                                                   {"reset", "1"},
                                                                   {"run", "1.1", "--mine"},
                                                                   {"run", "8", "--mine"},
                                                                   {"check", "1", "2"},
                                                                   {"check", "--loud"},
                                                                   {"check", "--junit"}}) {
        const Ran ran = learner.judge(words);
        INFO(joined(words, " ") << ": " << ran.err);
        if (words.back() == "--junit") continue;  // the next word is taken for its name
        CHECK(ran.exit_code == 2);
        CHECK(lines_of(ran.err).size() == 1);
        CHECK_THAT(ran.err, ContainsSubstring("course: "));
    }
    for (const auto& verb : {"hint", "reset", "solution"})
        CHECK(learner.judge({verb, "1.99"}).exit_code == 1);
    fs::remove_all(learner.rooms.answers);
    for (const auto& words :
         std::vector<std::vector<std::string>>{{"check"}, {"hint", "1.1"}, {"reset", "1.1"}, {"watch"}}) {
        const Ran ran = learner.judge(words);
        CHECK(ran.exit_code == 1);
        CHECK_THAT(ran.err, ContainsSubstring("./course start"));
    }
}

TEST_CASE("A grader's report, --junit, holds every exercise") {
    const Learner learner("junit");
    learner.answer(first, right);
    learner.answer({1, 2}, "    return Vector3::Zero();");
    const fs::path file = learner.folder / "report.xml";
    CHECK(learner.judge({"check", "1", "--junit", file.string()}).exit_code == 1);
    const std::string text = read_text(file);
    const auto count = chapter_of(learner.rooms, first).exercises.size();
    CHECK_THAT(text, ContainsSubstring("<testsuite name=\"01_newton\" tests=\"" + std::to_string(count) +
                                       "\" failures=\"" + std::to_string(count - 1) + "\">"));
    CHECK_THAT(text, ContainsSubstring("name=\"1.1 Velocity from two positions\"/>"));
    CHECK_THAT(text, ContainsSubstring("<failure message=\"wrong: always zero\">"));
    CHECK_THAT(text, ContainsSubstring("<failure message=\"not answered yet\">"));
}

TEST_CASE("A grader's report judges the others when one answer does not compile") {
    const Learner learner("isolation");
    learner.answer(first, right);
    learner.answer({1, 2}, "    return nothing_at_all;");
    learner.answer({1, 6}, "    return Vector3::Zero();");
    const fs::path file = learner.folder / "report.xml";
    learner.judge({"check", "1", "--junit", file.string()});
    const std::string text = read_text(file);
    CHECK_THAT(text, ContainsSubstring("name=\"1.1 Velocity from two positions\"/>"));
    CHECK_THAT(text, ContainsSubstring("<failure message=\"does not compile\">"));
    CHECK_THAT(text, ContainsSubstring("<failure message=\"wrong: no error at all\">"));
    CHECK_THAT(learner.judge({"check", "1"}).out,
               ContainsSubstring("not judged: 1.2 does not compile"));  // the learner mends it first
}

TEST_CASE("watch checks again on every save") {
    const Learner learner("watch");
    const fs::path said = learner.folder / "said";
    const pid_t child = fork();
    if (child == 0) {
        std::freopen(said.c_str(), "w", stdout);
        const std::string judge = std::string(CONFIG_BIN) + "/judge", answers = learner.rooms.answers,
                          work = learner.rooms.work;
        execl(judge.c_str(), "judge", "watch", "1.1", "--answers", answers.c_str(), "--work", work.c_str(),
              nullptr);
        _exit(127);
    }
    const auto waits_for = [&](const std::string& words) {
        for (int i = 0; i < 600; ++i) {
            if (fs::exists(said) && contains(read_text(said), words)) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
        return false;
    };
    CHECK(waits_for("not answered yet"));
    CHECK(waits_for("save a file to check again"));
    learner.answer(first, wrong);
    CHECK(waits_for("wrong: multiplied by dt"));
    learner.answer(first, right);
    CHECK(waits_for("passed"));
    kill(child, SIGINT);
    int status = 0;
    waitpid(child, &status, 0);
}
