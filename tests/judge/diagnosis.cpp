#include "diagnosis.hpp"
#include <algorithm>
#include "rooms.hpp"
#include "signatures.hpp"

namespace nutshell::judge {

using exercises::Exercise;
using exercises::Record;

namespace {

/// How many outputs, from the first on, two answers have in common.
std::size_t in_common(const Record& reference, const std::vector<Values>& yours, const Record& mistake) {
    const auto& outputs = reference.outputs;
    std::size_t i = 0;
    while (i < outputs.size() && i < mistake.outputs.size() &&
           apart(outputs[i], mistake.outputs[i].values, yours[i]) <= tolerance)
        ++i;
    return i;
}

/// A mistake that is known by name, if all answers are as it gives them; or, with a word on the rest, if all
/// are up to the last quarter.
std::optional<Finding> known_mistake(const Evidence& evidence, bool beyond, std::string& origin) {
    const auto& outputs = evidence.reference.outputs;
    std::optional<Finding> nearly;
    for (const auto& mistake : evidence.exercise.mistakes) {
        const std::size_t common =
            in_common(evidence.reference, evidence.yours, record_of(mistake.attempt, beyond));
        Finding finding{mistake.name, {mistake.sentence, "What a player would see: " + mistake.symptom}};
        if (common == outputs.size()) {
            origin = mistake.origin;
            return finding;
        }
        if (4 * common < 3 * outputs.size() || common <= evidence.wrong.front()) continue;
        finding.words.push_back("Besides, there is something else, for " +
                                evidence.reference.inputs[outputs[common].input].words + ".");
        if (!nearly) nearly = finding, origin = mistake.origin;
    }
    return nearly;
}

/// The first of the signatures that explains it, with what else may be said.
Finding explained(const Evidence& evidence) {
    for (const auto told : {wrong_size, not_finite, nearly_right})
        if (const auto finding = told(evidence)) return *finding;
    for (const auto told : {nothing_changed, wrong_frame, one_factor, exchanged_components, one_offset,
                            ignored_argument, wrong_order, wrong_somewhere})
        if (auto finding = told(evidence)) {
            for (auto& more : what_is_right(evidence, true)) finding->words.push_back(std::move(more));
            return *finding;
        }
    Finding none{"wrong formula", what_is_right(evidence, false)};
    if (none.words.empty())
        none.words = {"This is no slip known by name: the formula gives other numbers than it should."};
    return none;
}

}  // namespace

Record with_values(Record reference, const std::vector<Values>& values) {
    for (std::size_t i = 0; i < reference.outputs.size() && i < values.size(); ++i)
        reference.outputs[i].values = values[i];
    return reference;
}

Diagnosis diagnose(const Exercise& exercise, const Record& reference, const std::vector<Values>& yours,
                   bool beyond) {
    const auto& outputs = reference.outputs;
    Evidence evidence{exercise, reference, yours, {}};
    for (std::size_t i = 0; i < std::min(outputs.size(), yours.size()); ++i)
        if (!(apart(outputs[i], outputs[i].values, yours[i]) <= tolerance)) evidence.wrong.push_back(i);
    Diagnosis diagnosis;
    diagnosis.right = evidence.wrong.empty() && yours.size() == outputs.size();
    if (evidence.wrong.empty()) return diagnosis;

    const auto mistake = known_mistake(evidence, beyond, diagnosis.origin);
    const Finding finding = mistake ? *mistake : explained(evidence);
    const std::size_t shows = finding.show.value_or(evidence.wrong.front());
    diagnosis.name = finding.name;
    diagnosis.words = finding.words;
    diagnosis.seen = reference.inputs[outputs[shows].input].words;
    diagnosis.output = outputs[shows].name;
    diagnosis.yours = shown(yours[shows], outputs[shows].values);
    diagnosis.expected = shown(outputs[shows].values, yours[shows]);
    return diagnosis;
}

}  // namespace nutshell::judge
