// What is the machine's fault and not the learner's: said as what it is, with exit status 3.
#include <sys/stat.h>
#include <cstdlib>
#include "../check.hpp"
#include "learner.hpp"
#include "product.hpp"

using namespace nutshell::judge;
namespace fs = std::filesystem;

namespace {

const Number first{1, 1};
const std::string right = "    return (next_position - position) / dt;";

}  // namespace

TEST_CASE("Faults: a header that is a FIFO, a folder or no text") {
    const Learner learner("odd files");
    const fs::path file = learner.file(first);
    const auto said = [&](const std::string& words) {
        const Ran ran = learner.judge({"check", "1.1"});
        INFO(ran.out << ran.err);
        CHECK(ran.exit_code == 3);
        CHECK_THAT(ran.err, ContainsSubstring(words));
        fs::remove_all(file);
    };
    fs::remove(file);
    REQUIRE(mkfifo(file.c_str(), 0600) == 0);
    said("is no file that can be read, but a FIFO");
    fs::create_directory(file);
    said("but a folder");
    fs::create_symlink("/dev/zero", file);
    said("but a device");
    write_text(file, std::string("in\0t", 4));
    said("is no text");
}

TEST_CASE("Faults: folders that cannot be written to, a tool that is missing, a disk that is full") {
    const Learner learner("faults");
    learner.answer(first, right);
    Rooms nowhere = learner.rooms;
    nowhere.work = "/dev/null/work";
    CHECK_THROWS_AS(check(nowhere, chapter_of(nowhere, first), {first}), MachineFault);
    Ran ran = run({std::string(CONFIG_BIN) + "/judge", "check", "1.1", "--answers",
                   learner.rooms.answers.string(), "--work", "/dev/null/work"},
                  {.wall_seconds = 60});
    CHECK(ran.exit_code == 3);
    CHECK_THAT(ran.err, ContainsSubstring("cannot write to /dev/null/work"));
    CHECK_THROWS_AS(write_text("/dev/null/answers/x", "x"), MachineFault);
    CHECK_THROWS_AS(run({"no-such-compiler"}, {.wall_seconds = 5}), MachineFault);
    CHECK(fault_in("/tmp/cc1.s: fatal error: error writing to /tmp/cc1.s: No space left on device") != "");
    CHECK(fault_in("newton.hpp:3:1: error: 'space' was not declared") == "");
    CHECK(fault_in("g++: fatal error: Killed signal terminated program cc1plus") != "");
    CHECK(fault_in("g++: fatal error: Terminated signal terminated program cc1plus") != "");
    // of templates without end, most likely
    CHECK(fault_in("g++: fatal error: CPU time limit exceeded signal terminated program cc1plus") == "");
    for (const auto* ends : {"kill -9 $$", "kill -11 $$", "sleep 5"}) {
        const Product compiler{
            learner.folder / "product", {"sh", "-c", ends}, {.wall_seconds = 1, .cpu_seconds = 1}};
        CHECK_THROWS_AS(compiler.make(), MachineFault);
    }
    const Product busy{learner.folder / "product",
                       {"sh", "-c", "while :; do :; done"},
                       {.wall_seconds = 60, .cpu_seconds = 1}};
    CHECK(busy.make().out_of_time);
    setenv("TMPDIR", "/dev/null", 1);  // the compiler's own folder for temporary files
    ran = learner.judge({"check", "1.1"});
    unsetenv("TMPDIR");
    CHECK((ran.exit_code == 0 || ran.exit_code == 3));  // it takes another folder, or says what is wrong
}

TEST_CASE("Faults: a line of 100 000 characters and a main of one's own do not end the judge") {
    const Learner learner("long lines");
    for (const char letter : {'x', '(', '"'}) {
        learner.answer(first, "    return next_position" + std::string(100000, letter) + ";");
        const Ran ran = learner.judge({"check", "1.1"});
        CHECK(ran.signal == 0);
        CHECK(ran.exit_code == 1);
        CHECK(ran.out.size() < 5000);
        CHECK_THAT(ran.out, ContainsSubstring("1.1 does not compile"));
    }
    learner.answer(first, right);
    write_text(learner.file(first), learner.text(first) + "int main() { return 0; }\n");
    const Ran ran = learner.judge({"check", "1.1"});
    CHECK(ran.exit_code == 1);
    CHECK_THAT(ran.out, ContainsSubstring("main"));
}

TEST_CASE("A second check at the same time waits and says so") {
    const Learner learner("two at once");
    learner.answer(first, right);
    Ran second;
    {
        const Lock busy(learner.rooms.work);
        second = run({"timeout", "1", std::string(CONFIG_BIN) + "/judge", "check", "1.1", "--answers",
                      learner.rooms.answers.string(), "--work", learner.rooms.work.string()},
                     {.wall_seconds = 20});
    }
    CHECK_THAT(second.err, ContainsSubstring("another check is at work here: waiting for it"));
    CHECK(learner.judge({"check", "1.1"}).exit_code == 0);
}

TEST_CASE(
    "The learner's place: flags for editors, progress, giving up is remembered, help after a verb, keys, "
    "gdb") {
    const Learner learner("place");
    const auto flags = lines_of(read_text(learner.rooms.answers / "01_newton/compile_flags.txt"));
    std::vector<std::string> words{CONFIG_COMPILER};
    words.insert(words.end(), flags.begin(), flags.end());
    words.insert(words.end(), {"-fsyntax-only", "-Wno-unknown-warning-option", learner.file(first).string()});
    Ran ran = run(words, {.wall_seconds = 120});
    INFO(ran.err);
    CHECK(ran.exit_code == 0);
    CHECK_FALSE(contains(ran.err, "error"));

    learner.answer(first, right);
    learner.judge({"check", "1.1"});
    CHECK(learner.judge({"solution", "1.2"}).exit_code == 1);
    CHECK(learner.judge({"solution", "1.2", "--give-up"}).exit_code == 0);
    CHECK(learner.judge({"solution", "1.2"}).exit_code == 0);
    ran = learner.judge({"progress"});
    CHECK_THAT(ran.out, ContainsSubstring("Chapter 1 · Newton\n  ■□"));
    CHECK_THAT(ran.out, ContainsSubstring("solution seen: 1.2"));
    Progress all = Progress::read(learner.rooms);
    const Chapter chapter = chapter_of(learner.rooms, first);
    CHECK(celebration(chapter, all).empty());
    for (const Number number : chapter.exercises) all.entries[number].passed = true;
    CHECK_THAT(celebration(chapter, all), ContainsSubstring("then open out/mine/01_newton/"));

    ran = learner.judge({"check", "--help"});
    CHECK(ran.exit_code == 0);
    CHECK_THAT(ran.out, ContainsSubstring("./course check [N[.M]] [--junit FILE]"));

    const std::string judge = std::string(CONFIG_BIN) + "/judge",
                      folders = " --answers '" + learner.rooms.answers.string() + "' --work '" +
                                learner.rooms.work.string() + "'";
    ran = run({"sh", "-c", "printf 'hnq' | '" + judge + "' watch 1.1" + folders}, {.wall_seconds = 120});
    CHECK(ran.exit_code == 0);
    CHECK_THAT(ran.out, ContainsSubstring("Hint 1 of 3 for 1.1"));
    CHECK_THAT(ran.out, ContainsSubstring("1.2   Acceleration"));

    learner.replace(first, "body.position += body.velocity * dt;", "body.position -= body.velocity * dt;");
    learner.solve({1, 4});
    const Verdict verdict = learner.check_one({1, 4});
    REQUIRE(verdict.outcome == Outcome::wrong);
    REQUIRE(!verdict.notes.empty());
    CHECK_THAT(verdict.notes.back(), ContainsSubstring("body.position += body.velocity * dt;"));

    learner.answer(first, "    return (next_position - position) * dt;");
    ran = run({"sh", "-c", "'" + judge + "' debug 1.1" + folders + " </dev/null"},
              {.wall_seconds = 120, .printed = 1 << 20});
    CHECK_THAT(ran.out, ContainsSubstring("first goes wrong with position (1.2, -0.7, 2.1)"));
    if (contains(ran.out, "(gdb)") || contains(ran.out, "Breakpoint"))
        CHECK_THAT(ran.out, ContainsSubstring("nutshell::velocity_between"));
    else
        CHECK_THAT(ran.err, ContainsSubstring("gdb could not be started"));
}
