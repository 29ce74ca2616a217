// Compiles a learner's answers into a sheet and lets it answer: the only place where a learner's code is
// compiled and run.
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "compiled_ahead.hpp"
#include "explain_line.hpp"
#include "product.hpp"
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
    bool beyond = false;           ///< only a question beyond what the function must do does not compile
};

/// What the compiler notes about a line of the learner's.
struct Warning {
    std::string where;   ///< "newton.hpp:58"
    std::string words;   ///< "'x' is used uninitialized"
    std::string option;  ///< "uninitialized", of -Wuninitialized
};

struct Sheet {
    std::filesystem::path program;
    std::optional<CompileProblem> problem;
    std::vector<Warning> warnings;                    ///< on the learner's own lines
    bool compiled = false;                            ///< false: it was up to date
    std::vector<std::filesystem::path> sources = {};  ///< every file that was read
};

/// What came out of a sheet's pipe.
struct SheetAnswer {
    Ran ran;
    std::vector<std::vector<double>> outputs;
    std::vector<std::vector<double>> once_more;  ///< the answers at h, asked for again at the end
    std::optional<Number> unanswered;            ///< the exercise whose body is still the skeleton's
    std::optional<std::string> threw;            ///< what() of an exception
    bool ended = false;                          ///< it came to its end in good order
};

/// Whether the same questions were answered otherwise when they were asked once more.
bool remembers(const SheetAnswer& answer);

/// Headers that go before the learner's.
struct Overlay {
    std::filesystem::path folder = {};  ///< its own name tells it from others; empty: none
    bool only = false;                  ///< nothing of the learner's folder is read beside it
    std::optional<Ahead> ahead = {};    ///< of its headers, if they are declarations
};

/// The flags with which an editor understands a chapter's answers (compile_flags.txt of clangd).
std::vector<std::string> editor_flags(const Rooms& rooms, const Chapter& chapter);

/// The compiler, its flags and folders for one learner's chapter.
class Sheets {
  public:
    Sheets(const Rooms& rooms, const Chapter& chapter, const Overlay& overlay = {})
        : rooms_(rooms), chapter_(chapter), overlay_(overlay) {}

    /// One program for these exercises; compiled only if something it was made from has changed.
    /// @param beyond  false leaves out the questions that go beyond what a function must do
    Sheet compile(const std::vector<Number>& numbers, bool beyond = true) const;
    /// The same without words for a learner and without warnings.
    /// @param budget  seconds of processor time: not optimised, the essentials only; 0: any
    Ran compile_quietly(const std::vector<Number>& numbers, Sheet& sheet, double budget) const;
    SheetAnswer ask(const Sheet& sheet, Number number, unsigned cpu_seconds = 2) const;
    /// One exercise's sheet as a debugger likes it: unoptimised, with the names of everything.
    Sheet compile_for_debugging(Number number) const;
    /// Turns what the compiler says into words. Public for the chapter's program on the learner's engine.
    CompileProblem explain(const std::string& said, const std::vector<Number>& numbers) const;

    /// A file of the learner as they would name it: answers/01_newton/nutshell/newton.hpp
    std::string named(const std::string& file) const;

  private:
    std::vector<std::string> words_for(const std::vector<std::filesystem::path>& folders,
                                       bool optimised) const;
    std::filesystem::path questions(const std::string& name, const std::string& exercises, bool beyond) const;
    Product product(const std::vector<Number>& numbers, bool beyond, bool optimised = true) const;
    CompileProblem cannot_be_called(const std::vector<std::string>& lines, const std::string& compiler,
                                    std::size_t at, const std::vector<Number>& numbers) const;
    std::string lost_include() const;
    Reach reach_in(const Marked& learner, Number number) const;

    Rooms rooms_;
    Chapter chapter_;
    Overlay overlay_;
};

}  // namespace nutshell::judge
