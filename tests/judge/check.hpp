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
/// ./course watch [N[.M]]: checks whenever a file of answers/ is saved. Keys: h a hint, n the next exercise,
/// q ends.
int verb_watch(const Rooms& rooms, std::string which);
/// ./course debug N.M: the answer under gdb, at the input that fails. @throws MachineFault if there is no gdb
int verb_debug(const Rooms& rooms, Number number);
/// ./course run N --mine: the chapter's program on the learner's answers, its results in `out`. @return its
/// exit code
int verb_mine(const Rooms& rooms, const std::string& which, const std::filesystem::path& out);

/// What a folder's files are like now: it changes when one is saved.
std::string state_of(const std::filesystem::path& folder);

/// The chapter that `run --mine` or `live --mine` names. @throws std::invalid_argument for anything else
Chapter chapter_of(const Rooms& rooms, const std::string& verb, const std::string& which);
/// Tries the answers under the judge's limits, then puts the learner's headers, the reference's bodies where
/// there is no answer, where the chapter finds them first. The caller holds the lock of CONFIG_MINE.
/// @param broken  what an answer that does not compile, crashes or does not end does: the reference stands in
/// for it, with a sentence, or std::runtime_error is thrown with that sentence
/// @return those that are the learner's
enum class Broken { has_a_stand_in, stops };
std::vector<Number> stock_mine(const Rooms& rooms, const Chapter& chapter, Broken broken);
/// Builds a target on them. @throws std::runtime_error with the compiler's words about the learner's line
void build_mine(const Rooms& rooms, const Chapter& chapter, const std::string& target);
/// ./course live N --mine: a copy of the book in `out`, its moving figures on the learner's answers, made
/// again on every save.
/// @param once  for tests: once, without waiting for a save
int verb_live(const Rooms& rooms, const std::string& which, const std::filesystem::path& book,
              const std::filesystem::path& out, bool once);

/// The chapters meant by "", "1", "01_newton" or "1.3". @throws std::invalid_argument that says what there is
std::vector<Chapter> meant(const Rooms& rooms, const std::string& which);

}  // namespace nutshell::judge
