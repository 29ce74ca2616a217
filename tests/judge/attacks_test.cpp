// Answers that mean to pass without being right, or to silence the judge: none does, for a grader or a
// learner.
#include <unistd.h>
#include "../check.hpp"
#include "learner.hpp"

using namespace nutshell::judge;
namespace fs = std::filesystem;

namespace {

const Number first{1, 1};
const std::string wrong = "    return next_position + position;";

/// What a grader's report says of 1.1, after the whole program has come to its end.
std::string graded(const Learner& learner) {
    const fs::path report = learner.folder / "report.xml";
    fs::remove(report);
    const Ran ran = learner.judge({"check", "1.1", "--junit", report.string()});
    REQUIRE(ran.signal == 0);
    REQUIRE(ran.exit_code == 1);
    REQUIRE(fs::exists(report));
    usleep(300000);  // what stayed behind would write by now
    return read_text(report);
}
bool passes(const Learner& learner) {
    const bool alone = learner.check_one(first).outcome == Outcome::passed;
    return !contains(graded(learner), "<failure") || alone;
}

/// A wrong body, with this at the top of the file.
void with_top(const Learner& learner, const std::string& top) {
    learner.answer(first, wrong);
    learner.replace(first, "#pragma once\n", "#pragma once\n" + top + "\n");
}

const std::string records = R"(
#include <unistd.h>
#include <cstdio>
#include <cstring>
static const int taken = [] {
    for (int file = 3; file < 10; ++file) {
        double v[3] = {1.25, 9, -6.75};
        char bytes[1 + 4 + 24] = {'v', 24, 0, 0, 0};
        std::memcpy(bytes + 5, v, 24);
        for (int i = 0; i < 9; ++i) if (write(file, bytes, sizeof bytes) < 0) break;
        if (write(file, "e\0\0\0\0", 5) < 0) continue;
    }
    _exit(0);
    return 0;
}();
)";

}  // namespace

TEST_CASE("Attacks: the course's header by include_next, by its path, by a link, by a name defined away") {
    const Learner learner("borrowers");
    const std::string whole = learner.text(first);
    const fs::path file = learner.file(first),
                   reference = fs::path(CONFIG_COURSE) / "chapters/01_newton/nutshell/newton.hpp";
    learner.write(first, "#pragma once\n#include_next <nutshell/newton.hpp>\n");
    CHECK_FALSE(passes(learner));
    learner.write(first, "#include \"" + reference.string() + "\"\n");
    CHECK_FALSE(passes(learner));
    fs::remove(file);
    fs::create_symlink(reference, file);
    CHECK_FALSE(passes(learner));
    CHECK_THAT(flat(learner.check_one(first).words),
               ContainsSubstring("links are followed inside answers/ only"));
    fs::remove(file);
    learner.write(first, whole);
    with_top(learner, "#define nutshell mine");
    CHECK_FALSE(passes(learner));
    learner.write(first, whole);
    with_top(learner, "#define output(...) input(\"\", 0)");
    CHECK_FALSE(passes(learner));
    learner.write(first, whole);
    learner.answer(first, "#include_next <nutshell/newton.hpp>\n" + wrong);
    CHECK_THAT(graded(learner), ContainsSubstring("begins with #"));
    learner.answer(first, "    return position; }\ninline int other() {\n    return 0;");
    CHECK_THAT(graded(learner), ContainsSubstring("closes a brace"));
}

TEST_CASE("Attacks: records written before main, an end that is no return, a child that stays, a signal") {
    const Learner learner("forgers");
    const std::string whole = learner.text(first);
    with_top(learner, records);
    CHECK_FALSE(passes(learner));
    learner.write(first, whole);
    for (const auto* body : {
             "    extern \"C\" void _exit(int);\n    _exit(0);",
             "    std::exit(0);",
             "    std::quick_exit(0);",
         }) {
        learner.answer(first, std::string(body) + "\n" + wrong);
        CHECK_FALSE(passes(learner));
        learner.write(first, whole);
    }
    const std::string top = "#include <csignal>\n#include <cstdlib>\n#include <unistd.h>\n#include <fstream>";
    const std::string report = (learner.folder / "report.xml").string();
    for (const std::string& body :
         {std::string("    kill(getppid(), SIGKILL);\n"),
          std::string("    kill(-1, SIGCONT), kill(0, SIGKILL);\n"),
          "    if (fork() == 0) { setsid(); for (int i = 0; i < 20; ++i) { usleep(10000); std::ofstream(\"" +
              report + "\") << \"all is well\"; } _exit(0); }\n",
          "    if (std::system(\"(sleep 0.1; echo all is well > '" + report + "') &\")) {}\n"}) {
        with_top(learner, top);
        learner.answer(first, body + wrong);
        CHECK(learner.check_one(first).outcome != Outcome::passed);
        const Ran ran = learner.judge({"check", "1.1"});
        CHECK(ran.signal == 0);
        CHECK(ran.exit_code == 1);
        CHECK_FALSE(passes(learner));
        CHECK(starts_with(graded(learner), "<?xml"));
        learner.write(first, whole);
    }
}

TEST_CASE("For a grader the marked bodies are taken and nothing else, and right ones pass") {
    const Learner learner("graded");
    const fs::path report = learner.folder / "report.xml";
    learner.solve(first);
    learner.replace(first, "#pragma once\n", "#pragma once\n#error not for a grader\n");
    CHECK(learner.check_one(first).outcome == Outcome::not_compiled);
    CHECK(learner.judge({"check", "1.1", "--junit", report.string()}).exit_code == 0);
    CHECK_FALSE(contains(read_text(report), "<failure"));
    learner.answer(first, "    return (next_position - positoin) / dt;");
    learner.judge({"check", "1.1", "--junit", report.string()});
    CHECK_THAT(read_text(report), ContainsSubstring("Do you mean position?"));
    CHECK_THAT(read_text(report), ContainsSubstring("answers/01_newton/nutshell/newton.hpp:"));
}
