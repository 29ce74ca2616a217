// Signatures of what an answer takes in: an argument that is not used; and what is right of it.
#include <algorithm>
#include <set>
#include "signatures.hpp"
#include "text.hpp"

namespace nutshell::judge {

using exercises::Output;

std::optional<Finding> ignored_argument(const Evidence& evidence) {
    const auto& [inputs, outputs] = evidence.reference;
    std::vector<std::vector<std::size_t>> of_input(inputs.size());
    for (std::size_t i = 0; i < outputs.size(); ++i) of_input[outputs[i].input].push_back(i);
    std::vector<std::string> ignored, used;
    for (std::size_t a = 0; a < inputs.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const auto &left = inputs[a].values, &right = inputs[b].values;
            if (left.size() != right.size() || of_input[a].size() != of_input[b].size()) continue;
            std::vector<std::string> differ;
            for (std::size_t k = 0; k < left.size(); ++k)
                if (left[k] != right[k])
                    differ.push_back(left[k].first == right[k].first ? left[k].first : "");
            if (differ.size() != 1 || differ[0].empty()) continue;
            for (std::size_t k = 0; k < of_input[a].size(); ++k) {
                const std::size_t i = of_input[a][k], j = of_input[b][k];
                if (outputs[i].name != outputs[j].name ||
                    outputs[i].values.size() != outputs[j].values.size())
                    continue;
                const bool should = apart(outputs[i], outputs[i].values, outputs[j].values) > 1e-6,
                           does = apart(outputs[i], evidence.yours[i], evidence.yours[j]) > 1e-12;
                if (should) (does ? used : ignored).push_back(differ[0]);
            }
        }
    for (const auto& name : ignored)
        if (std::find(used.begin(), used.end(), name) == used.end())
            return {{name + " makes no difference",
                     {"Where only " + name + " differs, your answer stays the same: how should " + name +
                      " enter?"}}};
    return std::nullopt;
}

std::vector<std::string> what_is_right(const Evidence& evidence, bool explained) {
    const auto& [inputs, outputs] = evidence.reference;
    std::set<std::string> wrong_names;
    std::set<std::size_t> wrong_inputs, components;
    std::size_t size = 0;
    for (const std::size_t i : evidence.wrong) {
        wrong_names.insert(without_unit(outputs[i].name));
        wrong_inputs.insert(outputs[i].input);
        size = std::max(size, evidence.yours[i].size());
        for (std::size_t k = 0; k < outputs[i].values.size(); ++k)  // a zero that is zero tells nothing
            if (outputs[i].values[k] == 0 ||
                apart(outputs[i], {outputs[i].values[k]}, {evidence.yours[i][k]}) > tolerance)
                components.insert(k);
    }
    std::vector<std::string> right, wrong, words;
    for (const Output& output : outputs) {
        if (output.level > 0 || !output.exact.empty()) continue;
        auto& names = wrong_names.count(without_unit(output.name)) ? wrong : right;
        if (std::find(names.begin(), names.end(), without_unit(output.name)) == names.end())
            names.push_back(without_unit(output.name));
    }
    const auto list = [](const std::vector<std::string>& names) {
        std::string text;
        for (std::size_t i = 0; i < names.size(); ++i)
            text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
        return text + (names.size() > 1 ? " are" : " is");
    };
    if (!right.empty() && !wrong.empty() && wrong.size() <= 3)
        words.push_back(capital(list(right)) + " right; " + list(wrong) + " not.");
    if (size == 3 && components.size() == 1)
        words.push_back(std::string("Only its ") + "xyz"[*components.begin()] + " component is wrong.");
    if (size == 3 && components.size() == 2)
        words.push_back(std::string("Only its ") + "xyz"[3 - *components.begin() - *components.rbegin()] +
                        " component is right.");
    if (!explained && wrong_inputs.size() < inputs.size())
        words.push_back("It is right for " + std::to_string(inputs.size() - wrong_inputs.size()) + " of " +
                        std::to_string(inputs.size()) + " inputs: what is special about " +
                        (2 * wrong_inputs.size() > inputs.size() ? "those?" : "the one below?"));
    for (const std::size_t i : evidence.wrong)
        if (finite(outputs[i].values) && !finite(evidence.yours[i])) {
            words.push_back("Later on: " + capital(without_unit(outputs[i].name)) +
                            " is no finite number for " + inputs[outputs[i].input].words + ".");
            break;
        }
    return words;
}

}  // namespace nutshell::judge
