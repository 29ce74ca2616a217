#include "diagnosis.hpp"
#include <algorithm>
#include <cmath>
#include <functional>
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

/// Whether all answers of the first wrong name are as a mistake gives them.
bool same_under_that_name(const Evidence& evidence, const Record& mistake) {
    const auto& outputs = evidence.reference.outputs;
    const std::string& name = outputs[evidence.wrong.front()].name;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (outputs[i].name != name) continue;
        if (i >= mistake.outputs.size() ||
            !(apart(outputs[i], mistake.outputs[i].values, evidence.yours[i]) <= tolerance))
            return false;
        wrong += apart(outputs[i], outputs[i].values, evidence.yours[i]) > telling;
    }
    return wrong > 1;
}

/// Whether an answer is ten times nearer to a mistake than to the truth, or as far from neither as to tell
/// nothing, for every question.
bool near_by(const Evidence& evidence, const Record& mistake) {
    const auto& outputs = evidence.reference.outputs;
    if (mistake.outputs.size() != outputs.size() || evidence.yours.size() != outputs.size()) return false;
    double most = 0;
    for (std::size_t i = 0; i < outputs.size(); ++i)
        most = std::max(most, apart(outputs[i], outputs[i].values, evidence.yours[i]));
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const double wrong = apart(outputs[i], outputs[i].values, evidence.yours[i]);
        if (!(apart(outputs[i], mistake.outputs[i].values, evidence.yours[i]) <=
              std::max(wrong / 10, most / 100)))
            return false;
    }
    return std::isfinite(most);
}

/// A mistake that is known by name, if all answers are as it gives them; or, with a word on the rest, if all
/// are up to the last quarter, or nearly.
/// @param in_part  set to one that explains all answers of the first wrong name, and only those
std::optional<Finding> known_mistake(const Evidence& evidence, bool beyond, std::string& origin,
                                     std::optional<Finding>& in_part) {
    const auto& outputs = evidence.reference.outputs;
    std::optional<Finding> mostly, close;
    std::size_t names = 0;
    std::string mostly_from, close_from;
    for (const auto& mistake : evidence.exercise.mistakes) {
        const Record record = record_of(mistake.attempt, beyond);
        const std::size_t common = in_common(evidence.reference, evidence.yours, record);
        Finding finding{mistake.name, {mistake.sentence, "What a player would see: " + mistake.symptom}};
        if (common == outputs.size()) {
            origin = mistake.origin;
            return finding;
        }
        if (!mostly && 4 * common >= 3 * outputs.size() && common > evidence.wrong.front()) {
            finding.words.push_back("Besides, there is something else, for " +
                                    evidence.reference.inputs[outputs[common].input].words + ".");
            mostly = finding, mostly_from = mistake.origin;
        } else if (!close && near_by(evidence, record)) {
            finding.words.push_back("Nearly so: besides, there is something else, smaller.");
            close = finding, close_from = mistake.origin;
        } else if (same_under_that_name(evidence, record)) {
            finding.words.push_back("Besides, there is something else: that does not explain " +
                                    without_unit(outputs[common].name) + ".");
            in_part = finding, ++names;
        }
    }
    if (names > 1) in_part.reset();  // which of them?
    origin = mostly ? mostly_from : close ? close_from : "";
    return mostly ? mostly : close;
}

using Signature = std::function<std::optional<Finding>(const Evidence&)>;

/// The first of the signatures that explains it, with what else may be said.
Finding explained(const Evidence& evidence, const std::optional<Finding>& in_part) {
    for (const auto told : {wrong_size, not_finite, nearly_right})
        if (const auto finding = told(evidence)) return *finding;
    const auto in_part_by_name = [&](const Evidence&) { return in_part; };
    for (const Signature& told :
         {Signature(nothing_changed), Signature(wrong_frame), Signature(one_factor),
          Signature(exchanged_components), Signature(one_offset), Signature(ignored_argument),
          Signature(in_part_by_name), Signature(wrong_order), Signature(wrong_somewhere)})
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

    std::optional<Finding> in_part;
    const auto mistake = known_mistake(evidence, beyond, diagnosis.origin, in_part);
    const Finding finding = mistake ? *mistake : explained(evidence, in_part);
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
