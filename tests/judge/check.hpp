// From answers to verdicts.
#pragma once
#include <string>
#include <vector>
#include "desk.hpp"
#include "sheets.hpp"

namespace nutshell::judge {

enum class Outcome { passed, unanswered, blocked, wrong, failed, not_compiled, not_judged };

struct Verdict {
    Number number;
    Outcome outcome = Outcome::not_judged;
    std::string name;   ///< a few words for the table: "passed", "wrong: dt twice", "endless loop"
    std::string words;  ///< all there is to say, ready to print; empty if the name says it
    std::vector<std::string> notes;  ///< what does not change the verdict, such as lost marks
};

/// Judges these exercises of a chapter, in order.
/// @param for_a_grader  where an answer does not compile, leave it out and judge the others all the same
/// (costs a compilation)
std::vector<Verdict> check(const Rooms& rooms, const Chapter& chapter, const std::vector<Number>& numbers,
                           bool for_a_grader = false);

/// ./course check [N[.M]] [--junit FILE]: prints, remembers what passed. @return the exit code, 0 if all
/// passed
int verb_check(const Rooms& rooms, const std::string& which, const std::string& junit);
/// ./course watch [N[.M]]: checks whenever a file of answers/ is saved, until it is interrupted.
[[noreturn]] void verb_watch(const Rooms& rooms, const std::string& which);
/// ./course run N --mine: the chapter's program on the learner's answers, its results in `out`. @return its
/// exit code
int verb_mine(const Rooms& rooms, const std::string& which, const std::filesystem::path& out);

/// The chapters meant by "", "1", "01_newton" or "1.3". @throws std::invalid_argument that says what there is
std::vector<Chapter> meant(const Rooms& rooms, const std::string& which);

}  // namespace nutshell::judge
