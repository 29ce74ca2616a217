// ./course debug N.M: the learner's answer under gdb, stopped in it at the input that fails.
#include <unistd.h>
#include <algorithm>
#include <iostream>
#include "check.hpp"
#include "compare.hpp"
#include "text.hpp"

namespace nutshell::judge {

namespace {

/// How many outputs come before the first input that is wrong; all if none is.
std::size_t right_ones(const exercises::Record& reference, const SheetAnswer& answer) {
    const auto& outputs = reference.outputs;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (i < answer.outputs.size() && apart(outputs[i], outputs[i].values, answer.outputs[i]) <= tolerance)
            continue;
        while (i > 0 && outputs[i - 1].input == outputs[i].input) --i;  // back to where its input begins
        return i;
    }
    return outputs.size();
}

}  // namespace

int verb_debug(const Rooms& rooms, Number number) {
    const Chapter chapter = chapter_of(rooms, number);
    const Sheets sheets(rooms, chapter);
    const Sheet sheet = sheets.compile_for_debugging(number);
    if (sheet.problem) throw std::runtime_error("it does not compile yet: ./course check " + number.text());
    const exercises::Record reference = record_of(exercise_of(number).reference);
    const std::size_t right = right_ones(reference, sheets.ask(sheet, number));
    if (right == reference.outputs.size()) {
        std::cout << number.text() << " answers every question right: there is nothing to look for.\n";
        return 0;
    }
    const std::string& function = exercise_of(number).function;
    std::cout << folded(number.text() + " first goes wrong with " +
                            reference.inputs[reference.outputs[right].input].words + ". gdb stops in " +
                            function +
                            " for that input: `info args` and `p name` show, `next` goes on, `quit` ends.",
                        0)
              << std::flush;
    const std::vector<std::string> words{"gdb",
                                         "-q",
                                         "-nx",
                                         "-ex",
                                         "set breakpoint pending on",
                                         "-ex",
                                         "set confirm off",
                                         "-ex",
                                         "break failing_input_is_next",
                                         "-ex",
                                         "run",
                                         "-ex",
                                         "delete",
                                         "-ex",
                                         "rbreak ^.*nutshell::" + function + "[<(]",
                                         "-ex",
                                         "continue",
                                         "--args",
                                         sheet.program.string(),
                                         number.text(),
                                         "debug",
                                         std::to_string(right)};
    std::vector<char*> arguments;
    for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp("gdb", arguments.data());
    throw MachineFault("gdb could not be started; is it installed? apt-get install gdb");
}

}  // namespace nutshell::judge
