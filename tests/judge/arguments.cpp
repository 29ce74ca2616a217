// Signatures of what an answer takes in: an argument that is not used; and what is right of it.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include "signatures.hpp"
#include "text.hpp"

namespace nutshell::judge {

using exercises::Input;
using exercises::Output;

std::optional<Finding> ignored_argument(const Evidence& evidence) {
    const auto& inputs = evidence.reference.inputs;
    const auto& outputs = evidence.reference.outputs;
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
                const auto nothing = [&](std::size_t place) {
                    const Values none(outputs[place].values.size(), 0);
                    return evidence.yours[place] == none || evidence.yours[place] == outputs[place].start;
                };
                if (nothing(i) && nothing(j)) continue;  // where nothing happens nothing makes a difference
                const bool should = apart(outputs[i], outputs[i].values, outputs[j].values) > 1e-6,
                           does = apart(outputs[i], evidence.yours[i], evidence.yours[j]) > 1e-12;
                if (does || should) (does ? used : ignored).push_back(differ[0]);
            }
        }
    for (const auto& name : ignored)
        if (std::find(used.begin(), used.end(), name) == used.end())
            return {{name + " makes no difference",
                     {"Where only " + name + " differs, your answer stays the same: how should " + name +
                      " enter?"}}};
    return std::nullopt;
}

namespace {

/// Which components of a vector, a 4-vector or a matrix are wrong, where some are not.
std::vector<std::string> parts(std::size_t size, const std::set<std::size_t>& wrong) {
    if (wrong.empty() || wrong.size() >= size) return {};
    const auto letter = [](std::size_t k) { return std::string(1, "xyzw"[k]); };
    const auto is = [&](std::initializer_list<std::size_t> all) {
        return wrong == std::set<std::size_t>(all);
    };
    if (size <= 4) {
        if (wrong.size() == 1) return {"Only its " + letter(*wrong.begin()) + " component is wrong."};
        if (size == 4 && is({0, 1, 2})) return {"Only its vector part is wrong; w is right."};
        for (std::size_t k = 0; k < size; ++k)
            if (wrong.size() + 1 == size && !wrong.count(k))
                return {"Only its " + letter(k) + " component is right."};
        return {};
    }
    if (size != 9) return {};
    if (std::all_of(wrong.begin(), wrong.end(), [](std::size_t k) { return k % 4 == 0; }))
        return {wrong.size() == 3 ? "Only the diagonal is wrong."
                                  : "Only entries of the diagonal are wrong."};
    if (std::none_of(wrong.begin(), wrong.end(), [](std::size_t k) { return k % 4 == 0; }) &&
        wrong.size() == 6)
        return {"The diagonal is right; all that stands beside it is wrong."};
    if (wrong.size() > 4) return {};
    std::string text;
    for (const std::size_t k : wrong)
        text += (text.empty() ? "" : ", ") + std::string("(") + std::to_string(k % 3) + ", " +
                std::to_string(k / 3) + ")";
    return {"Of the nine entries only " + text + (wrong.size() > 1 ? " are wrong" : " is wrong") +
            " (row and column counted from 0)."};
}

}  // namespace

std::optional<Finding> wrong_somewhere(const Evidence& evidence) {
    const auto& inputs = evidence.reference.inputs;
    const auto& outputs = evidence.reference.outputs;
    std::set<std::size_t> wrong;
    for (const std::size_t i : evidence.wrong) wrong.insert(outputs[i].input);
    std::vector<std::string> names;
    for (const Input& input : inputs)
        for (const auto& [name, values] : input.values)
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    for (const auto& name : names) {
        struct Side {
            double least = 1e300, largest = -1e300;  ///< of sizes
            std::size_t count = 0, zeros = 0, below = 0;
            std::size_t ones = 0;                   ///< vectors of length one
            std::array<std::size_t, 4> negative{};  ///< of each component
            std::vector<double> sizes = {};
        } bad, good;
        bool everywhere = true, numbers = true;
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            const auto& all = inputs[i].values;
            const auto found =
                std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.first == name; });
            everywhere = everywhere && found != all.end() && !found->second.empty();
            if (!everywhere) break;
            const Values& values = found->second;
            numbers = numbers && values.size() == 1;
            double size = 0;  // of numbers that may be as large as they can be
            for (const double value : values) size = std::hypot(size, value);
            Side& side = wrong.count(i) ? bad : good;
            if (size > 1e-100) side.least = std::min(side.least, size);  // zero is a case of its own
            side.largest = std::max(side.largest, size);
            ++side.count, side.zeros += size == 0, side.below += values[0] < 0;
            side.sizes.push_back(size);
            side.ones += values.size() > 1 && std::abs(size - 1) < 1e-9;
            for (std::size_t k = 0; k < std::min<std::size_t>(values.size(), 4); ++k)
                side.negative[k] += values[k] < 0;
        }
        if (!everywhere || bad.count == 0 || good.count == 0) continue;
        const std::string also = "Your answer is right for every input but those where ";
        if (bad.zeros == bad.count && good.zeros == 0)
            return {
                {"wrong where " + name + " is zero", {also + name + " is zero: that needs another look."}}};
        if (numbers && bad.count + good.count > 2) {
            if (bad.below == bad.count && good.below == 0)
                return {{"wrong where " + name + " is negative", {also + name + " is negative."}}};
            if (bad.below == 0 && good.below == good.count)
                return {
                    {"wrong where " + name + " is not negative", {also + name + " is zero or positive."}}};
        }
        if (!numbers && bad.count > 2 && good.count > 2)
            for (std::size_t k = 0; k < 4; ++k)
                if (bad.negative[k] == bad.count && good.negative[k] == 0) {
                    const std::string part = name + "." + "xyzw"[k];
                    return {{"wrong where " + part + " is negative", {also + part + " is negative."}}};
                }
        if (bad.ones == 0 && good.ones > 1)
            return {{"wrong where " + name + " is not of length one",
                     {"Your answer is right where " + name + " has the length one, and wrong where it has " +
                      "another: is it to be made so first?"}}};
        const std::string size = !numbers                 ? "the length of " + name
                                 : bad.below + good.below ? "the size of " + name
                                                          : name;
        const bool many = bad.count > 1 && good.count > 1, only_absurd = good.least > 1e50;
        if (bad.zeros == 0 && !only_absurd && bad.largest < good.least &&
            (many || 100 * bad.largest < good.least))
            return {{"wrong where " + name + " is small",
                     {also + size + " is small: wrong up to " + digits(bad.largest, "%.4g") +
                      ", right from " + digits(good.least, "%.4g") + " on."}}};
        if (good.zeros == good.count && bad.zeros == 0)
            return {{"right only where " + name + " is zero",
                     {"Your answer is right where " + name + " is zero, and nowhere else."}}};
        if (good.zeros > 0 && bad.zeros == 0 && bad.least > 100 * good.largest)
            return {{"right only where " + name + " is zero",
                     {"Your answer is right where " + name + " is zero or next to nothing (up to " +
                      digits(good.largest, "%.1g") + "), and nowhere else."}}};
        if (bad.zeros == 0 && bad.least > good.largest && (many || bad.least > 100 * good.largest))
            return {{"wrong where " + name + " is large",
                     {also + size + " is large: right up to " + digits(good.largest, "%.4g") +
                      ", wrong from " + digits(bad.least, "%.4g") + " on."}}};
        if (bad.zeros == 0 && 3 * bad.least < good.least && bad.largest > 3 * good.largest &&
            std::none_of(bad.sizes.begin(), bad.sizes.end(),
                         [&](double each) { return each >= good.least && each <= good.largest; }))
            return {{"wrong where " + name + " is very small or very large",
                     {also + size + " is very small (" + digits(bad.least, "%.2g") + ") or very large (" +
                      digits(bad.largest, "%.2g") + "): between " + digits(good.least, "%.2g") + " and " +
                      digits(good.largest, "%.2g") + " it is right."}}};
    }
    return std::nullopt;
}

std::vector<std::string> what_is_right(const Evidence& evidence, bool explained) {
    const auto& inputs = evidence.reference.inputs;
    const auto& outputs = evidence.reference.outputs;
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
        return text;
    };
    if (!right.empty() && !wrong.empty() && wrong.size() <= 3)
        words.push_back("Right: " + list(right) + ". Wrong: " + list(wrong) + ".");
    for (auto& part : parts(size, components)) words.push_back(std::move(part));
    const auto where = explained ? std::vector<std::string>{} : where_and_along(evidence);
    words.insert(words.end(), where.begin(), where.end());
    if (wrong_inputs.size() == 1 && inputs.size() > 2)
        words.push_back("It is wrong for one of " + std::to_string(inputs.size()) +
                        " inputs only, the one below.");
    else if (!explained && where.empty() && wrong_inputs.size() < inputs.size())
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
