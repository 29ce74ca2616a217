// Signatures of what stands in the right place but is another thing: what was handed in, nothing, the other
// result, the right direction or size alone.
#include <algorithm>
#include <cmath>
#include <map>
#include <nutshell/vector.hpp>
#include <set>
#include "signatures.hpp"

namespace nutshell::judge {

using exercises::Output;

namespace {

bool none(const Output& output, const Values& values) {
    return std::all_of(values.begin(), values.end(),
                       [&](double value) { return std::abs(value) <= 1e-12 * output.scale; });
}

/// What an output is compared by: its values, or how they differ from the start.
Values change(const Output& output, Values values) {
    for (std::size_t k = 0; k < output.start.size() && k < values.size(); ++k) values[k] -= output.start[k];
    return values;
}

/// The wrong ones of the first wrong name, runs left out.
std::vector<std::size_t> wrong_of_first_name(const Evidence& evidence) {
    std::vector<std::size_t> all;
    for (const std::size_t i : of_first_wrong_name(evidence))
        if (std::count(evidence.wrong.begin(), evidence.wrong.end(), i)) all.push_back(i);
    return all;
}

std::string name_of(const Evidence& evidence, std::size_t output) {
    return without_unit(evidence.reference.outputs[output].name);
}

}  // namespace

std::optional<Finding> nothing_changed(const Evidence& evidence) {
    const auto& inputs = evidence.reference.inputs;
    const auto& outputs = evidence.reference.outputs;
    const auto wrong = wrong_of_first_name(evidence);
    if (wrong.empty()) return std::nullopt;
    const std::string why =
        " Is a copy changed instead of the thing itself (a missing &), or is what was computed never stored?";
    const auto stays = [&](std::size_t i) {
        return !outputs[i].start.empty() && evidence.yours[i] == outputs[i].start;
    };
    if (std::all_of(evidence.wrong.begin(), evidence.wrong.end(),
                    [&](std::size_t i) { return stays(i) || !outputs[i].exact.empty(); })) {
        const bool all = std::none_of(outputs.begin(), outputs.end(), [&](const Output& output) {
            const auto i = static_cast<std::size_t>(&output - outputs.data());
            return !output.start.empty() && !stays(i);
        });
        return {{all ? "nothing changes" : name_of(evidence, wrong.front()) + " does not change",
                 {(all ? "Everything comes out as it went in."
                       : capital(name_of(evidence, wrong.front())) +
                             " comes out as it went in, where it should change.") +
                  why}}};
    }
    for (const auto& [name, unused] : inputs[outputs[wrong.front()].input].values)
        if (std::all_of(wrong.begin(), wrong.end(), [&, name = name](std::size_t i) {
                const auto& values = inputs[outputs[i].input].values;
                const auto found = std::find_if(values.begin(), values.end(),
                                                [&](const auto& each) { return each.first == name; });
                return found != values.end() && found->second.size() > 1 &&
                       apart(outputs[i], found->second, evidence.yours[i]) <= 1e-12;
            }))
            return {{name + " comes back unchanged",
                     {capital(name_of(evidence, wrong.front())) + " comes out as " + name +
                      ", just as it was handed in." + why}}};
    return std::nullopt;
}

std::optional<Finding> something_and_nothing_exchanged(const Evidence& evidence) {
    std::size_t something = 0, nothing = 0;
    for (const std::size_t i : of_first_wrong_name(evidence)) {
        const Output& output = evidence.reference.outputs[i];
        const bool is_none = none(output, change(output, output.values));
        if (is_none == none(output, change(output, evidence.yours[i]))) return std::nullopt;
        ++(is_none ? nothing : something);
    }
    if (something == 0 || nothing == 0) return std::nullopt;
    const std::size_t i = evidence.wrong.front();
    return {{"the condition the wrong way round",
             {"Where there should be something there is nothing, and the other way round: " +
              name_of(evidence, i) + ". A comparison, or a test, is the wrong way round."}}};
}

std::optional<Finding> made_of_length_one(const Evidence& evidence) {
    const Values zero4(4, 0);
    for (const std::size_t i : evidence.wrong) {
        const Output& output = evidence.reference.outputs[i];
        const double length = distance(output.values, Values(output.values.size(), 0.0));
        if (!output.exact.empty()) continue;
        Values scaled = output.values;
        for (double& value : scaled) value /= length;
        if (scaled.size() < 2 || !(length > 0) || apart(output, scaled, evidence.yours[i]) > 1e-12)
            return std::nullopt;
    }
    const std::size_t i = evidence.wrong.front();
    return {{"made of length one",
             {capital(name_of(evidence, i)) +
              " has the right direction, but was made as long as one: leave that out, its length is part "
              "of the answer."}}};
}

std::optional<Finding> right_direction(const Evidence& evidence) {
    double least = 1e300, most = 0;
    std::set<double> factors;
    const auto wrong = wrong_of_first_name(evidence);
    for (const std::size_t i : wrong) {
        const Output& output = evidence.reference.outputs[i];
        const Values right = change(output, output.values), yours = change(output, evidence.yours[i]);
        double up = 0, down = 0;
        for (std::size_t k = 0; k < right.size(); ++k) up += yours[k] * right[k], down += right[k] * right[k];
        if (right.size() < 2 || right.size() > 4 || !(down > 0) || !(up > 0)) return std::nullopt;
        for (std::size_t k = 0; k < right.size(); ++k)
            if (std::abs(yours[k] - up / down * right[k]) > 1e-8 * output.scale * std::max(1.0, up / down))
                return std::nullopt;
        least = std::min(least, up / down), most = std::max(most, up / down);
    }
    if (wrong.size() < 2) return std::nullopt;
    const Output& first = evidence.reference.outputs[wrong.front()];
    return {{"right direction, wrong size",
             {(first.start.empty() ? "" : "The change of ") + name_of(evidence, wrong.front()) +
              " has the right direction; its size is wrong, from " + digits(least, "%.3g") + " to " +
              digits(most, "%.3g") +
              " times what it should be. The factor before the vector is to be looked at."}}};
}

std::optional<Finding> exchanged_outputs(const Evidence& evidence) {
    const auto& outputs = evidence.reference.outputs;
    std::map<std::string, std::string> for_name;
    for (const std::size_t i : evidence.wrong) {
        if (!outputs[i].exact.empty()) continue;
        std::string other;
        for (std::size_t j = 0; j < outputs.size() && other.empty(); ++j)
            if (outputs[j].input == outputs[i].input && outputs[j].name != outputs[i].name &&
                outputs[j].values.size() == outputs[i].values.size() &&
                apart(outputs[i], outputs[j].values, evidence.yours[i]) <= tolerance)
                other = outputs[j].name;
        const auto known = for_name.emplace(outputs[i].name, other).first;
        if (other.empty() || known->second != other) return std::nullopt;
    }
    if (for_name.empty() || evidence.wrong.size() < 2) return std::nullopt;
    const auto& [here, there] = *for_name.begin();
    const bool both = for_name.size() == 2 && for_name.count(there) && for_name[there] == here;
    return {{both ? "two results exchanged" : "the other result",
             {both ? capital(without_unit(here)) + " and " + without_unit(there) +
                         " have changed places: both numbers are right."
                   : capital(without_unit(here)) + " has the value that " + without_unit(there) +
                         " should have."}}};
}

std::optional<Finding> wrong_sign_somewhere(const Evidence& evidence) {
    const auto wrong = wrong_of_first_name(evidence), all = of_first_wrong_name(evidence);
    if (wrong.empty() || wrong.size() == all.size()) return std::nullopt;
    for (const std::size_t i : wrong) {
        const Output& output = evidence.reference.outputs[i];
        Values opposite = change(output, output.values);
        for (double& value : opposite) value = -value;
        if (apart(output, opposite, change(output, evidence.yours[i])) > tolerance) return std::nullopt;
    }
    return {{"a wrong sign for some inputs",
             {capital(name_of(evidence, wrong.front())) +
              " has the right size everywhere, and the wrong sign for " + std::to_string(wrong.size()) +
              " of " + std::to_string(all.size()) + " inputs."}}};
}

std::vector<std::string> where_and_along(const Evidence& evidence) {
    const auto& inputs = evidence.reference.inputs;
    const auto& outputs = evidence.reference.outputs;
    const auto wrong = wrong_of_first_name(evidence), all = of_first_wrong_name(evidence);
    std::vector<std::string> words;
    if (wrong.empty()) return words;
    const auto is_none = [&](std::size_t i) {
        return none(outputs[i], change(outputs[i], outputs[i].values));
    };
    const bool changes = !outputs[wrong.front()].start.empty();
    const auto wrong_none = std::count_if(wrong.begin(), wrong.end(), is_none),
               all_none = std::count_if(all.begin(), all.end(), is_none);
    const auto right = static_cast<std::ptrdiff_t>(all.size() - wrong.size());
    if (wrong_none == 0 && right > 0 && right == all_none)
        words.push_back(std::string("It is right only where ") +
                        (changes ? "nothing should change." : "zero should come out."));
    if (wrong_none == static_cast<std::ptrdiff_t>(wrong.size()) && right > 0)
        words.push_back(std::string("It is wrong only where ") +
                        (changes ? "nothing should change" : "zero should come out") +
                        ": is a case, or a guard, missing?");
    if (outputs[wrong.front()].matrix) {
        const auto uneven = [](const Values& m) {
            return std::max({std::abs(m[1] - m[3]), std::abs(m[2] - m[6]), std::abs(m[5] - m[7])});
        };
        if (std::all_of(wrong.begin(), wrong.end(), [&](std::size_t i) {
                return uneven(outputs[i].values) <= 1e-9 * outputs[i].scale &&
                       uneven(evidence.yours[i]) > 1e-9 * outputs[i].scale;
            }))
            words.emplace_back("The right matrix is symmetric, yours is not.");
    }
    if (outputs[wrong.front()].values.size() != 3 || wrong.size() < 2) return words;
    for (const auto& [name, unused] : inputs[outputs[wrong.front()].input].values) {
        bool along = true, across = true;
        for (const std::size_t i : wrong) {
            const auto& values = inputs[outputs[i].input].values;
            const auto found = std::find_if(values.begin(), values.end(), [&, name = name](const auto& each) {
                return each.first == name;
            });
            if (found == values.end() || found->second.size() != 3) return words;
            const Vector3 n(found->second.data());
            const Vector3 off = Vector3(evidence.yours[i].data()) - Vector3(outputs[i].values.data());
            along = along && n.cross(off).norm() <= 1e-8 * n.norm() * off.norm();
            across = across && std::abs(n.dot(off)) <= 1e-8 * n.norm() * off.norm();
        }
        if (along) words.push_back("Only its part along " + name + " is wrong.");
        if (across)
            words.push_back("Its part along " + name + " is right; what is across " + name + " is not.");
        if (along || across) break;
    }
    return words;
}

}  // namespace nutshell::judge
