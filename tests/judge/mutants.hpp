// Small changes of an exercise's body, made from its text: what a slip of the pen or of the mind would give.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace nutshell::judge {

struct Mutant {
    std::string name;  ///< "dt frozen", "w.x zeroed", "< to <=, 2": unique in its body
    std::string body;
    std::size_t at;             ///< where in the body the change is; 0 if it is in no one place
    bool proved_equal = false;  ///< two statements swapped that have nothing to do with each other
};

/// Slips of the pen, each in one place: a comparison's border shifted or made strict, a literal changed, an
/// operator, a sign or a function exchanged, a name taken for its neighbour, two statements swapped or one
/// left out, a fraction cut off.
std::vector<Mutant> slips_of(std::string_view body, std::string_view signature);

/// More of them, such as a learner's body may have and the reference's mutants cannot: something lost or
/// added.
std::vector<Mutant> more_slips_of(std::string_view body, std::string_view signature);

/// Half-right answers: an argument or a member that is read once and for all, a component that is lost or
/// taken for another, forces beyond the third, a result without its fraction.
std::vector<Mutant> half_answers_of(std::string_view body, std::string_view signature);

/// What the bodies of mutants need to compile; goes before everything else.
extern const char* const mutants_prelude;

}  // namespace nutshell::judge
