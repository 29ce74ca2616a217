#include "diagnosis.hpp"
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
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

/// Whether an answer is a mistake's times one number, or with another sign here and there; and the words for
/// it. Not of a mistake that is a multiple of the truth itself.
std::optional<std::string> scaled(const Evidence& evidence, const Record& mistake) {
    const auto& outputs = evidence.reference.outputs;
    std::set<long long> factors, of_truth;  // in parts of a billion
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (i >= mistake.outputs.size() || outputs[i].values.size() != evidence.yours[i].size()) return {};
        double up = 0, down = 0, truth = 0;
        const Values& wrong = mistake.outputs[i].values;
        for (std::size_t k = 0; k < wrong.size(); ++k) {
            up += wrong[k] * evidence.yours[i][k], down += wrong[k] * wrong[k];
            truth += wrong[k] * outputs[i].values[k];
        }
        Values same = wrong;
        for (double& value : same) value *= down > 0 ? up / down : 1;
        if (!(std::abs(up) < 1e3 * down + 1) || !(apart(outputs[i], same, evidence.yours[i]) <= tolerance))
            return {};
        if (!(down > 0)) continue;
        if (apart(outputs[i], outputs[i].values, evidence.yours[i]) <= tolerance)
            return {};  // right in a case
        factors.insert(std::llround(1e9 * up / down)), of_truth.insert(std::llround(1e9 * truth / down));
    }
    if (of_truth.size() < 2 || factors.empty() || factors.count(0)) return {};
    if (factors == std::set<long long>{-1000000000, 1000000000})
        return "Besides, its sign is wrong for some inputs.";
    if (factors.size() > 1) return {};
    const double c = 1e-9 * static_cast<double>(*factors.begin());
    return c == -1 ? "Besides, it has the wrong sign."
                   : "Besides, it is " + digits(c, "%.4g") + " times as large.";
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
        } else if (const auto besides = scaled(evidence, record); besides && !close) {
            finding.words.push_back(*besides);
            close = finding, close_from = mistake.origin;
        } else if (same_under_that_name(evidence, record)) {
            const auto left = std::find_if(evidence.wrong.begin(), evidence.wrong.end(), [&](std::size_t i) {
                return !(apart(outputs[i], record.outputs[i].values, evidence.yours[i]) <= tolerance);
            });
            if (left != evidence.wrong.end())
                finding.words.push_back("Besides, there is something else: that does not explain " +
                                        without_unit(outputs[*left].name) + ".");
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
    for (const auto told : {wrong_size, not_finite, made_of_length_one, nearly_right})
        if (const auto finding = told(evidence)) return *finding;
    const auto in_part_by_name = [&](const Evidence&) { return in_part; };
    for (const Signature& told :
         {Signature(nothing_changed), Signature(something_and_nothing_exchanged), Signature(wrong_frame),
          Signature(one_factor), Signature(exchanged_components), Signature(exchanged_outputs),
          Signature(right_direction), Signature(one_offset), Signature(wrong_sign_somewhere),
          Signature(ignored_argument), Signature(in_part_by_name), Signature(wrong_order)})
        if (auto finding = told(evidence)) {
            for (auto& more : what_is_right(evidence, true)) finding->words.push_back(std::move(more));
            return *finding;
        }
    for (const auto told : {wrong_somewhere, special_inputs}) {
        auto finding = told(evidence);
        if (!finding) continue;
        auto more = what_is_right(evidence, true);
        std::set<std::string> names, wrong;
        for (const auto& output : evidence.reference.outputs) names.insert(output.name);
        for (const std::size_t i : evidence.wrong) wrong.insert(evidence.reference.outputs[i].name);
        if (names.size() > 1 && wrong.size() == 1) {  // that says more than where
            finding->name = "wrong in " + without_unit(*wrong.begin()) + " only";
            std::swap(finding->words, more);
        }
        for (auto& words : more) finding->words.push_back(std::move(words));
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
    diagnosis.yours = shown(yours[shows], outputs[shows].values, outputs[shows].matrix);
    diagnosis.expected = shown(outputs[shows].values, yours[shows], outputs[shows].matrix);
    return diagnosis;
}

}  // namespace nutshell::judge
