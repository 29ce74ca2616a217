// Compiles a learner's answers into a sheet and lets it answer: the only place where a learner's code is
// compiled and run.
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "process.hpp"
#include "rooms.hpp"

namespace nutshell::judge {

/// Why a sheet could not be compiled, in words for the learner.
struct CompileProblem {
    std::string
        where;  ///< "answers/01_newton/nutshell/newton.hpp:58", or empty if it is no line of the learner
    std::optional<Number> number;  ///< the exercise whose body the line is in
    std::string message;           ///< what to know, one or two sentences
    std::string line;              ///< the learner's line itself
    std::string compiler;          ///< the compiler's own first words on it
    bool point_mass_only = false;  ///< the step names members that other states do not have
};

struct Sheet {
    std::filesystem::path program;
    std::optional<CompileProblem> problem;
    std::vector<std::string>
        warnings;           ///< on the learner's own lines: "newton.hpp:58: 'x' is used uninitialized"
    bool compiled = false;  ///< false: it was up to date
};

/// What came out of a sheet's pipe.
struct SheetAnswer {
    Ran ran;
    std::vector<std::vector<double>> outputs;
    std::optional<Number> unanswered;  ///< the exercise whose body is still the skeleton's
    std::optional<std::string> threw;  ///< what() of an exception
    bool ended = false;                ///< it came to its end in good order
};

/// The compiler, its flags and folders for one learner's chapter.
class Sheets {
  public:
    /// @param overlay  a folder whose headers go before the learner's, if not empty
    Sheets(const Rooms& rooms, const Chapter& chapter, const std::filesystem::path& overlay = {})
        : rooms_(rooms), chapter_(chapter), overlay_(overlay) {}

    /// One program for these exercises; compiled only if something it was made from has changed.
    /// @param one_state  leaves out the questions about states of other types
    Sheet compile(const std::vector<Number>& numbers, bool one_state = false) const;
    SheetAnswer ask(const Sheet& sheet, Number number) const;
    /// Turns what the compiler says into words. Public for the chapter's program on the learner's engine.
    CompileProblem explain(const std::string& said, const std::vector<Number>& numbers) const;

    /// Makes the precompiled header if it is missing or out of date. @return whether it had to
    static bool prepare(const Rooms& rooms);

    /// A file of the learner as they would name it: answers/01_newton/nutshell/newton.hpp
    std::string named(const std::string& file) const;

  private:
    Rooms rooms_;
    Chapter chapter_;
    std::filesystem::path overlay_;
};

}  // namespace nutshell::judge
