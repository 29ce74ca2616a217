#include "check.hpp"
#include <algorithm>
#include <csignal>
#include <cstring>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include "diagnosis.hpp"
#include "text.hpp"

namespace nutshell::judge {

namespace fs = std::filesystem;

namespace {

/// A chapter's headers as the learner has them.
struct Own {
    struct File {
        fs::path path;
        std::optional<std::string> text;
        Marked source;
    };
    std::vector<File> files;

    const File& of(const Chapter& chapter, Number number) const {
        for (std::size_t i = 0; i < files.size(); ++i)
            if (chapter.headers[i].reference.body(number)) return files[i];
        throw std::logic_error("no header");
    }
};

Own read_own(const Rooms& rooms, const Chapter& chapter) {
    Own own;
    for (const auto& header : chapter.headers) {
        auto text = own_text(rooms, chapter, header);
        own.files.push_back({own_path(rooms, chapter, header), text, marked(text.value_or(""))});
    }
    return own;
}

/// The exercises of this chapter that the learner's body of `number` calls.
std::vector<Number> called_by(const Chapter& chapter, const Own& own, Number number) {
    std::vector<Number> called;
    const Body* body = own.of(chapter, number).source.body(number);
    if (!body) return called;
    const std::string code = bare_code(body->text);
    for (const Number other : chapter.exercises)
        if (other != number && calls(code, exercise_of(other).function)) called.push_back(other);
    return called;
}

std::string quote_printed(const Ran& ran) {
    std::string text;
    for (const auto& [stream, printed] :
         {std::pair{"standard output", &ran.out}, {"standard error", &ran.err}}) {
        if (printed->empty()) continue;
        text += std::string("  It printed on ") + stream + ":\n";
        for (const auto& line : excerpt(*printed)) {
            const auto assertion = line.find("Assertion `");  // without the library's own place
            text += "    | " + (assertion == std::string::npos ? line : line.substr(assertion)) + "\n";
        }
    }
    return text;
}

/// Verdict on one exercise that compiled.
/// @param broken  those that were left out because they do not compile
/// @param other_states  whether the sheet asks about states of other types
Verdict judge(const Chapter& chapter, const Sheets& sheets, const Sheet& sheet, Number number,
              const std::string& where, const std::vector<Number>& broken, bool other_states) {
    const auto& exercise = exercise_of(number);
    const exercises::Record reference = record_of(exercise.reference, other_states);
    const SheetAnswer answer = sheets.ask(sheet, number);
    const Ran& ran = answer.ran;
    Verdict verdict{number, Outcome::failed, "", "", {}};
    std::string words;
    const auto say = [&](const std::string& sentence) { words += folded(sentence, 2); };
    std::string input;  // the one it was working on
    if (answer.outputs.size() < reference.outputs.size())
        input = reference.inputs[reference.outputs[answer.outputs.size()].input];

    if (answer.unanswered == number) {
        verdict.outcome = Outcome::unanswered, verdict.name = "not answered yet";
        return verdict;
    }
    if (answer.unanswered) {
        verdict.outcome = Outcome::blocked, verdict.name = "blocked by " + answer.unanswered->text();
        const bool is_broken = std::find(broken.begin(), broken.end(), *answer.unanswered) != broken.end();
        verdict.words =
            folded("Your answer to " + number.text() + " calls " + exercise_of(*answer.unanswered).function +
                       ", which is exercise " + answer.unanswered->text() +
                       (is_broken ? " and does not compile. Mend that one first."
                                  : " and not answered yet. Answer that one first."),
                   2);
        return verdict;
    }
    if (answer.threw) {
        if (contains(*answer.threw, "bad_alloc") || contains(*answer.threw, "length_error") ||
            contains(*answer.threw, "_M_")) {
            verdict.name = "too much memory";
            say("It asks for more memory than there is for it (256 MB): does something grow in a loop "
                "without "
                "end? (" +
                *answer.threw + ")");
        } else {
            verdict.name = "throws";
            say("It throws an exception: " + *answer.threw);
        }
    } else if (ran.out_of_time) {
        verdict.name = "endless loop";
        say("It does not come to an end: stopped after 2 seconds of work (or 5 of waiting). An endless loop? "
            "Look at the condition and at what changes in the loop.");
    } else if (ran.printed_too_much) {
        verdict.name = "prints without end";
        say("It prints without end: stopped. Is there a print in a loop that does not end?");
    } else if (ran.signal == SIGABRT && contains(ran.err, "Assertion")) {
        verdict.name = "stopped by an assertion";
        const bool index = contains(ran.err, "index >=") || contains(ran.err, "row >=");
        say(index ? "It asks for an element that a vector or matrix does not have: components are counted "
                    "from 0."
                  : "A check inside a library stopped it; its words are below.");
    } else if (ran.signal == SIGABRT) {
        verdict.name = "aborts";
        say("It called abort(), or an exception was thrown where none may leave.");
    } else if (ran.signal == SIGFPE) {
        verdict.name = "crash";
        say("It crashed: a division of whole numbers by zero.");
    } else if (ran.signal) {
        verdict.name = "crash";
        say("It crashed (signal " + std::to_string(ran.signal) + ", " + strsignal(ran.signal) +
            "): an index out of range, a pointer to nothing, or a function that calls itself without end.");
    } else if (!answer.ended) {
        verdict.name = "ends the program";
        say("It ended the program by itself (exit code " + std::to_string(ran.exit_code) +
            ") instead of returning: no exit() in an answer, only return.");
    }
    if (!verdict.name.empty()) {
        if (!input.empty()) say("The input: " + input);
        verdict.words = words + quote_printed(ran);
        return verdict;
    }

    const Diagnosis diagnosis = diagnose(exercise, reference, answer.outputs, other_states);
    if (diagnosis.right) {
        verdict.outcome = Outcome::passed, verdict.name = "passed";
        if (const std::string printed = quote_printed(ran); !printed.empty())
            verdict.notes.push_back(number.text() + " printed something; that does no harm here.");
        return verdict;
    }
    verdict.outcome = Outcome::wrong, verdict.name = "wrong: " + diagnosis.name;
    for (const auto& sentence : diagnosis.words) say(sentence);
    words += folded("Seen with " + diagnosis.seen + ":", 2);
    const std::string what = diagnosis.output;
    words += "    " + what + "\n      yours     " + diagnosis.yours + "\n      expected  " +
             diagnosis.expected + "\n";
    for (const auto& warning : sheet.warnings) say("The compiler notes: " + warning);
    if (!where.empty()) words += "  Where: " + where + "\n";
    if (!exercise.picture.empty())
        say("A picture says more: ./course run " + std::to_string(chapter.number) +
            " --mine draws yours, out/mine/" + chapter.folder + "/" + exercise.picture);
    verdict.words = words + quote_printed(ran);
    return verdict;
}

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

}  // namespace

std::vector<Verdict> check(const Rooms& rooms, const Chapter& chapter, const std::vector<Number>& numbers,
                           bool isolate) {
    const Own own = read_own(rooms, chapter);
    std::map<Number, Verdict> verdicts;
    const auto where = [&](Number number) {
        const auto& file = own.of(chapter, number);
        const Body* body = file.source.body(number);
        return body ? named(rooms, file.path) + ":" + std::to_string(body->begin + 2) : "";
    };

    // what the text alone tells
    std::vector<Number> asked;
    for (const Number number : numbers) {
        const auto& file = own.of(chapter, number);
        Verdict& verdict = verdicts[number] = {number, Outcome::not_judged, "not judged", "", {}};
        if (!file.text) {
            verdict.name = "file missing";
            verdict.words =
                folded(named(rooms, file.path) +
                           " is missing. ./course start makes it anew, and touches no other file.",
                       2);
        } else if (trimmed(*file.text).empty()) {
            verdict.name = "file empty";
            verdict.words = folded(
                named(rooms, file.path) + " is empty. ./course reset " + number.text() + " writes it anew.",
                2);
        } else if (const Body* body = file.source.body(number); body && is_unanswered(*body)) {
            verdict.outcome = Outcome::unanswered, verdict.name = "not answered yet";
        } else {
            asked.push_back(number);
        }
        if (const auto complaint = file.source.complaints.find(number);
            complaint != file.source.complaints.end())
            verdict.notes.push_back("in " + named(rooms, file.path) + " " + complaint->second +
                                    " (./course reset " + number.text() + " and run --mine need it)");
        else if (file.text && !trimmed(*file.text).empty() && !file.source.body(number))
            verdict.notes.push_back(
                "in " + named(rooms, file.path) + " the marks `// exercise " + number.text() +
                "` and `// end " + number.text() +
                "` are gone: put them back on lines of their own round the body (./course reset " +
                number.text() + " and run --mine need them)");
    }

    // with those they call, so that the true cause can be named
    std::vector<Number> compiled = asked;
    for (std::size_t i = 0; i < compiled.size(); ++i)
        for (const Number other : called_by(chapter, own, compiled[i]))
            if (std::find(compiled.begin(), compiled.end(), other) == compiled.end())
                compiled.push_back(other);
    std::sort(compiled.begin(), compiled.end());

    bool one_state = false;
    std::vector<Number> broken;  // left out by `isolate`
    while (!asked.empty()) {
        const Sheets sheets(rooms, chapter, broken.empty() ? fs::path() : rooms.work / "overlay");
        Sheet sheet = sheets.compile(compiled, one_state);
        if (sheet.problem && sheet.problem->point_mass_only && !one_state) {
            one_state = true;
            continue;
        }
        if (!sheet.problem) {
            std::map<Number, Verdict> seen;
            const std::function<const Verdict&(Number)> judged = [&](Number number) -> const Verdict& {
                if (!seen.count(number))
                    seen[number] = judge(chapter, sheets, sheet, number, where(number), broken, !one_state);
                return seen[number];
            };
            for (const Number number : asked) {
                Verdict verdict = judged(number);
                if (verdict.outcome == Outcome::wrong || verdict.outcome == Outcome::failed)
                    for (const Number other : called_by(chapter, own, number)) {
                        if (judged(other).outcome == Outcome::passed) continue;
                        verdict.outcome = Outcome::blocked, verdict.name = "blocked by " + other.text();
                        verdict.words = folded(
                            "Your answer to " + number.text() + " calls " + exercise_of(other).function +
                                ", exercise " + other.text() + ", which is not right yet (" +
                                judged(other).name +
                                "). Once that is, this may be right too: ./course check " + other.text(),
                            2);
                        break;
                    }
                verdict.notes.insert(verdict.notes.begin(), verdicts[number].notes.begin(),
                                     verdicts[number].notes.end());
                if (const Body* body = own.of(chapter, number).source.body(number);
                    one_state && verdict.outcome == Outcome::passed && body &&
                    (names(bare_code(body->text), "velocity") || names(bare_code(body->text), "PointMass")))
                    verdict.notes.push_back(number.text() +
                                            " moves a PointMass only, for it names its members. Said with "
                                            "drift and kick, the same lines will move "
                                            "the states of later chapters too, which have no velocity.");
                verdicts[number] = verdict;
            }
            break;
        }
        const auto culprit = sheet.problem->number;
        const std::string words = compile_words(*sheet.problem);
        const bool apart = isolate && culprit && own.of(chapter, *culprit).source.body(*culprit) &&
                           std::find(broken.begin(), broken.end(), *culprit) == broken.end();
        for (const Number number : asked) {
            Verdict& verdict = verdicts[number];
            if (!culprit || *culprit == number || asked.size() == 1) {
                verdict.outcome = Outcome::not_compiled;
                verdict.name = culprit && *culprit != number ? culprit->text() + " does not compile"
                                                             : "does not compile";
                verdict.words = words;
            } else if (!apart) {
                verdict.name = "not judged: " + culprit->text() + " does not compile";
            }
        }
        if (!apart) break;
        broken.push_back(*culprit);
        std::erase(asked, *culprit);
        std::map<Number, std::string> bodies;
        for (const Number number : broken) bodies[number] = unanswered(number) + "\n";
        for (std::size_t i = 0; i < own.files.size(); ++i)
            if (own.files[i].text)
                write_text(rooms.work / "overlay" / chapter.headers[i].path,
                           with_stand_ins(own.files[i].source, bodies, own.files[i].path.string()));
    }

    std::vector<Verdict> all;
    for (const Number number : numbers) all.push_back(verdicts[number]);
    return all;
}

}  // namespace nutshell::judge
