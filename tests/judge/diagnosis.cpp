#include "diagnosis.hpp"
#include <algorithm>
#include "rooms.hpp"
#include "signatures.hpp"

namespace nutshell::judge {

using exercises::Exercise;
using exercises::Record;

namespace {

std::optional<Finding> known_mistake(const Evidence& evidence, bool beyond, std::string& origin) {
    const Record answer = with_values(evidence.reference, evidence.yours);
    for (const auto& mistake : evidence.exercise.mistakes) {
        if (difference(evidence.reference, answer, record_of(mistake.attempt, beyond)) > tolerance) continue;
        origin = mistake.origin;
        return {{mistake.name, {mistake.sentence, "What a player would see: " + mistake.symptom}}};
    }
    return std::nullopt;
}

/// The first of the signatures that explains it, with what else may be said.
Finding explained(const Evidence& evidence) {
    for (const auto told : {wrong_size, not_finite})
        if (const auto finding = told(evidence)) return *finding;
    for (const auto told : {nothing_changed, wrong_frame, one_factor, exchanged_components, one_offset,
                            ignored_argument, wrong_order})
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
