#include "check.hpp"
#include <algorithm>
#include <map>
#include "clues.hpp"
#include "conduct.hpp"
#include "diagnosis.hpp"
#include "own_headers.hpp"
#include "slips.hpp"
#include "text.hpp"

namespace nutshell::judge {

namespace fs = std::filesystem;

namespace {

std::string compile_words(const CompileProblem& problem) {
    std::string words;
    if (!problem.where.empty()) {
        words += "  " + problem.where +
                 (problem.number ? "  (exercise " + problem.number->text() + ")" : "") + "\n";
        if (!problem.line.empty()) words += "    " + problem.line + "\n";
    }
    words += folded(problem.message, 2);
    if (!problem.where.empty() && !problem.compiler.empty())
        words += folded("The compiler says: " + problem.compiler, 2);
    return words;
}

/// One check of some exercises of a chapter, step by step.
class Check {
  public:
    Check(const Rooms& rooms, const Chapter& chapter, const std::vector<Number>& numbers, bool for_a_grader)
        : rooms_(rooms),
          chapter_(chapter),
          numbers_(numbers),
          for_a_grader_(for_a_grader),
          own_(rooms, chapter) {}

    std::vector<Verdict> verdicts() {
        for (const Number number : numbers_) read(number);
        ask_all();
        std::vector<Verdict> all;
        for (const Number number : numbers_) all.push_back(verdicts_[number]);
        return all;
    }

  private:
    /// What the text alone tells of an exercise. What it cannot tell is asked.
    void read(Number number) {
        const auto& file = own_.file_of(number);
        const std::string name = named(rooms_, file.path), id = number.text();
        Verdict& verdict = verdicts_[number] = {number, Outcome::not_judged, "not judged", "", {}};
        const Body* body = file.source.body(number);
        if (!file.text) {
            verdict.name = "file missing";
            verdict.words =
                folded(name + " is missing. ./course start makes it anew, and touches no other file.", 2);
            return;
        }
        if (const std::string out = leads_out(rooms_, file.path); !out.empty()) {
            verdict.name = "a link out of answers/";
            verdict.words =
                folded(name + " is a link to " + out + ": links are followed inside answers/ only.", 2);
            return;
        }
        if (trimmed(*file.text).empty()) {
            verdict.name = "file empty";
            verdict.words = folded(name + " is empty. ./course reset " + id + " writes it anew.", 2);
            return;
        }
        if (const std::string why = body && for_a_grader_ ? not_a_body(body->text) : ""; !why.empty()) {
            verdict.name = "refused";
            verdict.words = folded("The answer to " + id + " " + why, 2);
            return;
        }
        if (body && is_unanswered(*body))
            verdict.outcome = Outcome::unanswered, verdict.name = "not answered yet";
        else
            asked_.push_back(number);
        const auto complaint = file.source.complaints.find(number);
        if (complaint != file.source.complaints.end())
            verdict.notes.push_back("in " + name + " " + complaint->second + " (./course reset " + id +
                                    " and run --mine need it)");
        else if (!body)
            verdict.notes.push_back("in " + name + " the marks `// exercise " + id + "` and `// end " + id +
                                    "` are gone: put them back on lines of their own round the body "
                                    "(./course reset " +
                                    id + " and run --mine need them)");
    }

    /// Compiles what is asked and hears the answers. What does not compile is left out, if a grader asks.
    void ask_all() {
        bool beyond = true;
        while (!asked_.empty()) {
            std::vector<Number> compiled = asked_;  // with those they call, so that the true cause is named
            for (std::size_t i = 0; i < compiled.size(); ++i)
                for (const Number other : own_.called_by(compiled[i]))
                    if (!among(compiled, other)) compiled.push_back(other);
            std::sort(compiled.begin(), compiled.end());

            const Sheets sheets(rooms_, chapter_, own_.overlay(broken_, for_a_grader_));
            const Sheet sheet = sheets.compile(compiled, beyond);
            if (sheet.problem && sheet.problem->beyond && beyond) {
                beyond = false;
                continue;
            }
            if (!sheet.problem) return hear(sheets, sheet, beyond);
            if (!leave_out(*sheet.problem)) return;
        }
    }

    /// The verdicts on all that compiled.
    void hear(const Sheets& sheets, const Sheet& sheet, bool beyond) {
        for (const Number number : asked_) {
            Verdict verdict = heard(sheets, sheet, number, beyond);
            if (verdict.outcome == Outcome::wrong || verdict.outcome == Outcome::failed)
                for (const Number other : own_.called_by(number)) {
                    const Verdict& cause = heard(sheets, sheet, other, beyond);
                    if (cause.outcome == Outcome::passed) continue;
                    verdict.outcome = Outcome::blocked, verdict.name = "blocked by " + other.text();
                    verdict.words =
                        folded("Your answer to " + number.text() + " calls " + exercise_of(other).function +
                                   ", exercise " + other.text() + ", which is not right yet (" + cause.name +
                                   "). Once that is, this may be right too: ./course check " + other.text(),
                               2);
                    break;
                }
            if (verdict.outcome == Outcome::wrong || verdict.outcome == Outcome::failed)
                if (const std::string line = own_.changed_line(number); !line.empty())
                    verdict.notes.push_back(
                        "outside the exercises, a line that the course gave is changed or gone in " +
                        named(rooms_, own_.file_of(number).path) + ":  " + line +
                        "  Is it that, and not your answer?");
            const auto& notes = verdicts_[number].notes;
            verdict.notes.insert(verdict.notes.begin(), notes.begin(), notes.end());
            if (!beyond && verdict.outcome == Outcome::passed && !exercise_of(number).beyond.empty())
                verdict.notes.push_back(number.text() + " " + exercise_of(number).beyond);
            verdicts_[number] = verdict;
        }
    }

    const Verdict& heard(const Sheets& sheets, const Sheet& sheet, Number number, bool beyond) {
        const auto known = heard_.find(number);
        if (known != heard_.end()) return known->second;
        const exercises::Record reference = record_of(exercise_of(number).reference, beyond);
        const SheetAnswer answer = sheets.ask(sheet, number);
        Verdict verdict{number, Outcome::failed, "", "", {}};
        if (own_.reference_among(sheet.sources, number))
            verdict.name = "the course's own header",
            verdict.words = folded(
                "The file reads the course's own header, so it would be that which is judged: "
                "take the line out that includes it.",
                2);
        else if (answer.unanswered)
            verdict = unanswered_verdict(number, *answer.unanswered);
        else if (const Conduct conduct = conduct_of(answer, reference); !conduct.name.empty())
            verdict = misbehaved(number, reference, sheet, answer, beyond, conduct);
        else
            verdict = compared(number, reference, sheet, answer, beyond);
        const std::string printed = quote_printed(answer.ran);
        if (verdict.outcome == Outcome::passed && !printed.empty())
            verdict.notes.push_back(number.text() + " printed something; that does no harm here.");
        else if (verdict.outcome == Outcome::wrong || verdict.outcome == Outcome::failed)
            verdict.words += printed;
        return heard_[number] = verdict;
    }

    /// Crashed, stopped or without end: but what it answered before says more, if that is wrong already.
    Verdict misbehaved(Number number, exercises::Record reference, const Sheet& sheet,
                       const SheetAnswer& answer, bool beyond, const Conduct& conduct) const {
        reference.outputs.resize(std::min(reference.outputs.size(), answer.outputs.size()));
        if (agrees(reference, answer.outputs))
            return {number, Outcome::failed, conduct.name, conduct.words, {}};
        Verdict verdict = compared(number, reference, sheet, answer, beyond);
        verdict.words +=
            folded("And later on, it does not come to its end: " + conduct.name + ".", 2) + conduct.words;
        return verdict;
    }

    Verdict unanswered_verdict(Number number, Number missing) const {
        if (missing == number) return {number, Outcome::unanswered, "not answered yet", "", {}};
        return {number,
                Outcome::blocked,
                "blocked by " + missing.text(),
                folded("Your answer to " + number.text() + " calls " + exercise_of(missing).function +
                           ", which is exercise " + missing.text() +
                           (among(broken_, missing) ? " and does not compile. Mend that one first."
                                                    : " and not answered yet. Answer that one first."),
                       2),
                {}};
    }

    /// What its text, or asking twice, tells better than its numbers.
    std::optional<Clue> clue_of(Number number, const Sheet& sheet, const SheetAnswer& answer,
                                const Diagnosis& diagnosis) const {
        const Body* body = own_.body_of(number);
        if (body)
            if (auto clue = whole_division(body->text)) return clue;
        if (body)
            if (auto clue = comma_between(warnings_in(number, sheet), own_.file_of(number).source))
                return clue;
        const auto twice = two_answers(answer);
        if (body && (twice || diagnosis.origin.empty()) && names(bare_code(body->text), "auto"))
            if (auto clue = dangling_auto(rooms_, chapter_, number)) return clue;
        if (twice) return twice;
        if (body && diagnosis.origin.empty())
            if (auto clue = lost_fraction(warnings_in(number, sheet), own_.file_of(number).source))
                return clue;
        return std::nullopt;
    }

    /// Those of the compiler's notes that are about this body.
    std::vector<Warning> warnings_in(Number number, const Sheet& sheet) const {
        const Body* body = own_.body_of(number);
        const std::string file = own_.file_of(number).path.filename().string() + ":";
        std::vector<Warning> all;
        for (const Warning& warning : sheet.warnings) {
            if (!body || !starts_with(warning.where, file)) continue;
            const std::size_t line = std::stoul(warning.where.substr(file.size()));
            if (body->begin + 2 <= line && line <= body->end) all.push_back(warning);
        }
        return all;
    }

    /// The verdict on an answer that came to its end.
    Verdict compared(Number number, const exercises::Record& reference, const Sheet& sheet,
                     const SheetAnswer& answer, bool beyond) const {
        const auto& exercise = exercise_of(number);
        Diagnosis diagnosis = diagnose(exercise, reference, answer.outputs, beyond);
        if (diagnosis.right && !remembers(answer)) return {number, Outcome::passed, "passed", "", {}};
        if (const auto clue = clue_of(number, sheet, answer, diagnosis))
            diagnosis.name = clue->first, diagnosis.words = {clue->second};
        Verdict verdict{number, Outcome::wrong, "wrong: " + diagnosis.name, "", {}};
        std::string& words = verdict.words;
        for (const auto& sentence : diagnosis.words) words += folded(sentence, 2);
        if (!diagnosis.right) {
            words += folded("Seen with " + diagnosis.seen + ":", 2);
            words += "    " + diagnosis.output + "\n      yours     " + diagnosis.yours +
                     "\n      expected  " + diagnosis.expected + "\n";
        }
        for (const auto& warning : warnings_in(number, sheet))
            words += folded("The compiler notes: " + warning.where + ": " + warning.words, 2);
        if (const Body* body = own_.body_of(number))
            words += "  Where: " + named(rooms_, own_.file_of(number).path) + ":" +
                     std::to_string(body->begin + 2) + "\n";
        if (!exercise.picture.empty())
            words += folded("A picture says more: ./course run " + std::to_string(chapter_.number) +
                                " --mine draws yours, out/mine/" + chapter_.folder + "/" + exercise.picture,
                            2);
        return verdict;
    }

    /// Says what does not compile. @return whether the others can be judged without it
    bool leave_out(const CompileProblem& problem) {
        const auto culprit = problem.number;
        const bool apart = for_a_grader_ && culprit && own_.body_of(*culprit) && !among(broken_, *culprit);
        for (const Number number : asked_) {
            Verdict& verdict = verdicts_[number];
            if (!culprit || *culprit == number || asked_.size() == 1) {
                verdict.outcome = Outcome::not_compiled;
                verdict.name = culprit && *culprit != number ? culprit->text() + " does not compile"
                                                             : "does not compile";
                verdict.words = compile_words(problem);
            } else if (!apart) {
                verdict.name = "not judged: " + culprit->text() + " does not compile";
            }
        }
        if (!apart) return false;
        broken_.push_back(*culprit);
        std::erase(asked_, *culprit);
        return true;
    }

    const Rooms& rooms_;
    const Chapter& chapter_;
    std::vector<Number> numbers_;
    bool for_a_grader_;
    OwnHeaders own_;
    std::vector<Number> asked_, broken_;  ///< still to be asked; left out, for they do not compile
    std::map<Number, Verdict> verdicts_, heard_;
};

}  // namespace

std::vector<Verdict> check(const Rooms& rooms, const Chapter& chapter, const std::vector<Number>& numbers,
                           bool for_a_grader) {
    return Check(rooms, chapter, numbers, for_a_grader).verdicts();
}

}  // namespace nutshell::judge
