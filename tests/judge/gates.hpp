// The gate that every exercise must pass: no half-right answer passes its questions. Mutants of the
// reference's body are compiled together, as a learner's answers are, and asked one by one.
#pragma once
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>
#include "mutants.hpp"
#include "rooms.hpp"
#include "sheets.hpp"

namespace nutshell::judge {

/// Several bodies of each exercise of a chapter in one program.
struct Herd {
    std::map<Number, std::vector<Mutant>> mutants;
    std::set<std::pair<Number, std::size_t>> do_not_compile = {};
    double budget = 0;   ///< of processor time [s], to compile (quickly, not optimised) and to run; 0: any
    double seconds = 0;  ///< used so far

    /// Compiles them in place of the bodies of `sources` (one for each of the chapter's headers), in a folder
    /// `name` in rooms.work, and hands each one's answer to `hear`: its exercise, its place, its answer.
    void ask(const Rooms& rooms, const Chapter& chapter, const std::vector<Marked>& sources,
             const std::string& name,
             const std::function<void(Number, std::size_t, const SheetAnswer&)>& hear);
};
/// Whether an answer is right, and the same when asked once more.
bool passes(const exercises::Record& reference, const SheetAnswer& answer);

/// What became of an exercise's mutants.
struct Gate {
    Number number;
    std::size_t made = 0, failed = 0, equal = 0;
    std::vector<std::string> passed;  ///< that should not: neither failed nor argued in the exercise's file
    std::vector<std::string> stale;   ///< argued there, but failed or not made
};
std::vector<Gate> gates_of(const Rooms& rooms, const Chapter& chapter);

/// `judge gates [N[.M]]`: prints the counts. @return the exit code, 0 if every mutant is accounted for
int verb_gates(const Rooms& rooms, const std::string& which);

}  // namespace nutshell::judge
