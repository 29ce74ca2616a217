#include "conduct.hpp"
#include <csignal>
#include <cstring>
#include <utility>
#include "text.hpp"

namespace nutshell::judge {

namespace {

/// {name, sentence}
std::pair<std::string, std::string> described(const SheetAnswer& answer, std::size_t asked) {
    const Ran& ran = answer.ran;
    if (answer.threw) {
        if (contains(*answer.threw, "bad_alloc") || contains(*answer.threw, "length_error") ||
            contains(*answer.threw, "_M_"))
            return {"too much memory",
                    "It asks for more memory than there is for it (256 MB): does something grow in a loop "
                    "without end? (" +
                        *answer.threw + ")"};
        return {"throws", "It throws an exception: " + *answer.threw};
    }
    if (ran.out_of_time)
        return answer.outputs.empty()
                   ? std::pair<
                         std::string,
                         std::string>{"endless loop",
                                      "It does not come to an end: stopped after 2 seconds of work (or 5 of "
                                      "waiting). An "
                                      "endless loop? Look at the condition and at what changes in the loop."}
                   : std::pair<std::string, std::string>{
                         "too long, or without end",
                         "It answered what was asked before, but comes to no end for the input below: "
                         "stopped after 2 seconds of work (or 5 of waiting). A loop whose condition "
                         "never fails there, or one that takes a turn for each step, however many there are? "
                         "A "
                         "division gives their number at once: std::floor(a / b)."};
    if (ran.printed_too_much)
        return {"prints without end",
                "It prints without end: stopped. Is there a print in a loop that does not end?"};
    if (ran.signal == SIGABRT && contains(ran.err, "Assertion")) {
        const bool index = contains(ran.err, "index >=") || contains(ran.err, "row >=");
        return {"stopped by an assertion",
                index ? "It asks for an element that a vector or matrix does not have: components are "
                        "counted from 0."
                      : "A check inside a library stopped it; its words are below."};
    }
    if (ran.signal == SIGABRT)
        return {"aborts", "It called abort(), or an exception was thrown where none may leave."};
    if (ran.signal == SIGFPE) return {"crash", "It crashed: a division of whole numbers by zero."};
    if (ran.signal)
        return {"crash", "It crashed (signal " + std::to_string(ran.signal) + ", " + strsignal(ran.signal) +
                             "): an index out of range, a pointer to nothing, or a function that calls "
                             "itself without end."};
    if (!answer.ended || answer.outputs.size() < asked)
        return {"ends the program", "It ended the program by itself (exit code " +
                                        std::to_string(ran.exit_code) +
                                        ") instead of returning: no exit() in an answer, only return."};
    return {};
}

}  // namespace

Conduct conduct_of(const SheetAnswer& answer, const exercises::Record& reference) {
    const auto [name, sentence] = described(answer, reference.outputs.size());
    if (name.empty()) return {};
    std::string words = folded(sentence, 2);
    if (const std::size_t at = answer.outputs.size(); at < reference.outputs.size())
        words += folded("The input: " + reference.inputs[reference.outputs[at].input].words, 2);
    return {name, words};
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

}  // namespace nutshell::judge
