#include "diagnosis.hpp"
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include "rooms.hpp"
#include "text.hpp"

namespace nutshell::judge {

using exercises::Exercise;
using exercises::Output;
using exercises::Record;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Values = std::vector<double>;

double apart(double a, double b, double scale) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    if (!std::isfinite(a) || !std::isfinite(b)) return infinity;
    return scale > 0 ? std::abs(a - b) / scale : infinity;
}
double apart(const Values& a, const Values& b, double scale) {
    if (a.size() != b.size()) return infinity;
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, apart(a[i], b[i], scale));
    return most;
}
bool finite(const Values& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}
double distance(const Values& a, const Values& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
}
std::string digits(double value, const char* format = "%.9g") {
    char text[40];
    std::snprintf(text, sizeof text, format, value == 0 ? 0 : value);  // no "-0"
    return text;
}
std::string shown(const Values& values) {
    if (values.size() == 1) return digits(values[0]);
    std::string text = "(";
    for (std::size_t i = 0; i < values.size() && i < 9; ++i) text += (i ? ", " : "") + digits(values[i]);
    return text + (values.size() > 9 ? ", ...)" : ")");
}

/// The number c with yours = c * right, if there is one for all of these pairs.
struct Factor {
    double value = 0, error = infinity;
    bool fits() const { return error < 1e-7; }
};
Factor factor(const std::vector<std::pair<double, double>>& yours_and_right) {
    double up = 0, down = 0, worst = 0, largest = 0;
    for (const auto& [yours, right] : yours_and_right) up += yours * right, down += right * right;
    if (!(down > 0) || !std::isfinite(up)) return {};
    const double value = up / down;
    for (const auto& [yours, right] : yours_and_right) {
        worst = std::max(worst, std::abs(yours - value * right));
        largest = std::max({largest, std::abs(yours), std::abs(value * right)});
    }
    return {value, largest > 0 ? worst / largest : 0};
}

/// What a factor means, as "<subject> comes out ..."; name is for the table.
std::pair<std::string, std::string> meaning(double c, const std::string& what) {
    const auto near = [&](double value) { return std::abs(c - value) < 1e-6 * std::abs(value); };
    const std::string comes = what + " comes out ";
    constexpr double degrees = 180 / 3.14159265358979323846;
    if (std::abs(c) < 1e-12) return {"nothing changes", comes + "as zero whatever the input."};
    if (near(-1))
        return {"wrong sign", comes +
                                  "with the wrong sign: the size is right, the direction is opposite. Is a "
                                  "difference taken the wrong way round?"};
    if (near(degrees))
        return {"wrong unit", comes + "180/pi times too large: degrees stand where radians belong."};
    if (near(1 / degrees))
        return {"wrong unit", comes + "180/pi times too small: an angle is turned into radians twice."};
    for (const double unit : {1e3, 1e-3, 1e2, 1e-2, 60.0, 1 / 60.0, 3.6, 1 / 3.6, 1e6, 1e-6})
        if (near(unit))
            return {
                "wrong unit",
                comes + digits(c, "%.4g") +
                    " times what it should be: that looks like another unit (milli-, kilo-, minutes, km/h)."};
    if (near(2))
        return {"twice too much",
                comes + "twice as large as it should be: a half is lost, or something is counted twice."};
    if (near(0.5))
        return {"half of it",
                comes + "half as large as it should be: a half too many, or one of two parts is missing."};
    return {"wrong factor",
            comes + digits(c, "%.6g") +
                " times what it should be, for every input alike: a constant factor is wrong."};
}

/// Looks for one factor behind everything that is wrong: of the values, or of their change from where they
/// start.
std::optional<std::pair<std::string, std::string>> factor_signature(
    const std::vector<std::pair<const Output*, const Values*>>& wrong, bool of_change,
    const std::string& what) {
    Factor at[3];
    bool level_seen[3] = {};
    for (int level = 0; level < 3; ++level) {
        std::vector<std::pair<double, double>> pairs;
        for (const auto& [right, yours] : wrong) {
            if (right->level != level || !right->exact.empty()) continue;
            if (of_change && right->start.size() != right->values.size()) return std::nullopt;
            for (std::size_t i = 0; i < yours->size(); ++i) {
                const double start = of_change ? right->start[i] : 0;
                pairs.emplace_back((*yours)[i] - start, right->values[i] - start);
            }
        }
        if (pairs.size() < 2) continue;
        level_seen[level] = true;
        at[level] = factor(pairs);
        if (!at[level].fits()) return std::nullopt;
    }
    if (!level_seen[0]) return std::nullopt;
    const std::string subject = of_change ? "The change of " + what : what;
    if (level_seen[1] && level_seen[2]) {
        const double power = std::log2(std::abs(at[0].value / at[1].value)),
                     again = std::log2(std::abs(at[1].value / at[2].value));
        if (std::abs(power - std::round(power)) < 1e-6 && std::abs(power - again) < 1e-6 &&
            std::round(power) != 0)
            return {{"a wrong power of dt",
                     subject + " is wrong by a factor that goes with dt" +
                         (std::round(power) == 1 ? "" : "^" + digits(std::round(power), "%.0f")) +
                         ": dt is " +
                         (power > 0 ? "multiplied in once too often, or left out below the line"
                                    : "divided by once too often, or left out") +
                         ". Check the units: metres, seconds, metres per second."}};
        if (std::abs(at[1].value - at[0].value) > 1e-6 * std::abs(at[0].value)) return std::nullopt;
    }
    if (std::abs(at[0].value - 1) < 1e-6) return std::nullopt;
    return meaning(at[0].value, subject);
}

/// From the runs at h, h/2 and h/4: does the error against the exact solution shrink, and how fast?
/// @param local  the power of dt with which one step differs from the right one, if it has one
std::optional<std::pair<std::string, std::string>> order_signature(const Exercise& exercise,
                                                                   const Record& reference,
                                                                   const std::vector<Values>& yours,
                                                                   std::optional<double> local) {
    if (exercise.order == 0) return std::nullopt;
    double error[3] = {-1, -1, -1}, right[3] = {};
    std::string what;
    for (std::size_t i = 0; i < reference.outputs.size(); ++i) {
        const Output& output = reference.outputs[i];
        if (output.exact.size() != yours[i].size() || output.exact.empty() || !finite(yours[i])) continue;
        if (error[output.level] >= 0) continue;
        error[output.level] = distance(yours[i], output.exact);
        right[output.level] = distance(output.values, output.exact);
        what = output.name;
    }
    if (error[0] < 0 || error[1] < 0 || error[2] < 0) return std::nullopt;
    const std::string table = "Distance of " + what +
                              " from the exact one, for steps of h, h/2, h/4: yours " +
                              digits(error[0], "%.2g") + ", " + digits(error[1], "%.2g") + ", " +
                              digits(error[2], "%.2g") + "; the right method's " + digits(right[0], "%.2g") +
                              ", " + digits(right[1], "%.2g") + ", " + digits(right[2], "%.2g") + ".";
    if (error[2] > 0.75 * error[0])
        return {{"wrong formula",
                 "The error does not shrink with the step: this is a wrong formula, not a coarse step. " +
                     table}};
    const double order = std::log2(error[1] / error[2]);
    if (order < exercise.order - 0.4)
        return {{"wrong order", "The error shrinks, but like dt^" + digits(order, "%.1f") +
                                    " where this method has dt^" + std::to_string(exercise.order) +
                                    ": the formula is right in the limit, but something is taken at the "
                                    "wrong time or place in the step. " +
                                    table}};
    if (local && *local < exercise.order + 0.6)
        return {{"wrong order", "One step differs from the right one by an amount that goes like dt^" +
                                    digits(std::round(*local), "%.0f") + "; for a method of order " +
                                    std::to_string(exercise.order) + " it must be dt^" +
                                    std::to_string(exercise.order + 1) +
                                    " at most. Something is taken at the wrong time or place in the step, "
                                    "and not every force shows it."}};
    return {
        {"another scheme",
         "The error shrinks as fast as it should, so this is a right method, but not the one asked for. " +
             table}};
}

/// The power of dt with which the difference of single steps shrinks, the least of all outputs.
std::optional<double> local_power(const Record& reference, const std::vector<Values>& yours) {
    std::map<std::pair<std::string, std::size_t>, std::array<double, 3>>
        apart_at;  // by name and its place among inputs of one level
    std::array<std::size_t, 3> first_input{};
    for (const Output& output : reference.outputs) {
        const auto level = static_cast<std::size_t>(output.level);
        if (level > 0 && first_input[level] == 0) first_input[level] = output.input;
    }
    for (std::size_t i = 0; i < reference.outputs.size(); ++i) {
        const Output& output = reference.outputs[i];
        if (!output.exact.empty() || yours[i].size() != output.values.size() || !finite(yours[i])) continue;
        const auto level = static_cast<std::size_t>(output.level);
        auto& at = apart_at
                       .try_emplace({output.name, output.input - first_input[level]},
                                    std::array<double, 3>{-1, -1, -1})
                       .first->second;
        at[level] = distance(yours[i], output.values) / output.scale;
    }
    std::optional<double> least;
    for (const auto& [key, at] : apart_at) {
        if (!(at[1] > tolerance && at[2] > tolerance)) continue;
        const double power = std::log2(at[1] / at[2]);
        if (!least || power < *least) least = power;
    }
    return least;
}

std::string list(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
}
std::string capital(std::string text) {
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}
std::string without_unit(const std::string& name) {
    return trimmed(name.substr(0, name.find('[')));
}

}  // namespace

double difference(const Record& reference, const Record& a, const Record& b) {
    if (a.outputs.size() != reference.outputs.size() || b.outputs.size() != reference.outputs.size())
        return infinity;
    double most = 0;
    for (std::size_t i = 0; i < reference.outputs.size(); ++i)
        most = std::max(most, apart(a.outputs[i].values, b.outputs[i].values, reference.outputs[i].scale));
    return most;
}

Record with_values(Record reference, const std::vector<Values>& values) {
    for (std::size_t i = 0; i < reference.outputs.size() && i < values.size(); ++i)
        reference.outputs[i].values = values[i];
    return reference;
}

Diagnosis diagnose(const Exercise& exercise, const Record& reference, const std::vector<Values>& yours,
                   bool other_states) {
    Diagnosis diagnosis;
    const auto& outputs = reference.outputs;
    const std::size_t count = std::min(outputs.size(), yours.size());
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < count; ++i)
        if (!(apart(outputs[i].values, yours[i], outputs[i].scale) <= tolerance)) wrong.push_back(i);
    if (wrong.empty()) {
        diagnosis.right = true;
        return diagnosis;
    }

    const auto show = [&](std::size_t i) {
        diagnosis.seen = reference.inputs[outputs[i].input];
        diagnosis.output = outputs[i].name;
        diagnosis.yours = shown(yours[i]);
        diagnosis.expected = shown(outputs[i].values);
    };
    show(wrong.front());

    // 1. a mistake that is known by name
    if (count == outputs.size()) {
        const Record answer = with_values(reference, yours);
        for (const auto& mistake : exercise.mistakes) {
            if (difference(reference, answer, record_of(mistake.attempt, other_states)) > tolerance) continue;
            diagnosis.name = mistake.name;
            diagnosis.origin = mistake.origin;
            diagnosis.words = {mistake.sentence, "What a player would see: " + mistake.symptom};
            return diagnosis;
        }
    }

    // 2. sizes, and numbers that are none
    for (const std::size_t i : wrong) {
        if (outputs[i].values.size() == yours[i].size()) continue;
        diagnosis.name = "wrong size";
        diagnosis.words = {capital(without_unit(outputs[i].name)) + " has " +
                           std::to_string(yours[i].size()) + " numbers; there should be " +
                           std::to_string(outputs[i].values.size()) + "."};
        show(i);
        return diagnosis;
    }
    const auto lost = std::find_if(wrong.begin(), wrong.end(), [&](std::size_t i) {
        return !finite(yours[i]) && finite(outputs[i].values);
    });
    std::string born;
    if (lost != wrong.end()) {
        const bool nan = std::any_of(yours[*lost].begin(), yours[*lost].end(),
                                     [](double value) { return std::isnan(value); });
        const std::string what = capital(without_unit(outputs[*lost].name)) +
                                 (nan ? " is NaN, which is no number" : " is infinite");
        born = what + ", for " + reference.inputs[outputs[*lost].input] + ".";
        if (lost == wrong.begin()) {
            diagnosis.name = nan ? "NaN" : "infinite";
            diagnosis.words = {
                what + ", born at the input below" +
                    (*lost > 0 ? "; everything asked before it was right." : ", the first one asked."),
                nan ? "NaN comes from 0/0, from the root of a negative number, from infinity less infinity, "
                      "or from a vector that was never given a value."
                    : "That comes from a division by zero, or from numbers that grow without limit."};
            return diagnosis;
        }
    }

    // 3. which outputs are right, and on which inputs
    std::vector<std::string> right_names, wrong_names;
    std::set<std::string> wrong_set;
    std::set<std::size_t> wrong_inputs;
    for (const std::size_t i : wrong)
        wrong_set.insert(outputs[i].name), wrong_inputs.insert(outputs[i].input);
    for (std::size_t i = 0; i < count; ++i) {
        if (outputs[i].level > 0 || !outputs[i].exact.empty()) continue;
        auto& names = wrong_set.count(outputs[i].name) ? wrong_names : right_names;
        if (const std::string name = without_unit(outputs[i].name);
            std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(name);
    }
    std::string partly;
    if (!right_names.empty() && !wrong_names.empty() && wrong_names.size() <= 3)
        partly = capital(list(right_names)) + (right_names.size() > 1 ? " are" : " is") + " right; " +
                 list(wrong_names) + (wrong_names.size() > 1 ? " are" : " is") + " not.";

    // 4. signatures: a factor, then the runs' order
    const std::string first_wrong =
        wrong_names.empty() ? without_unit(outputs[wrong.front()].name) : wrong_names.front();
    std::vector<std::pair<const Output*, const Values*>>
        pairs;  // all answers for the first name that is wrong
    for (std::size_t i = 0; i < count; ++i)
        if (without_unit(outputs[i].name) == first_wrong) pairs.emplace_back(&outputs[i], &yours[i]);
    auto signature = factor_signature(pairs, false, capital(first_wrong));
    if (!signature && exercise.order > 0) signature = factor_signature(pairs, true, first_wrong);
    const auto order =
        signature ? std::nullopt : order_signature(exercise, reference, yours, local_power(reference, yours));
    if (signature) {
        diagnosis.name = signature->first;
        diagnosis.words = {signature->second};
    } else if (order) {
        diagnosis.name = order->first;
    } else {
        diagnosis.name = "wrong formula";
    }
    if (!partly.empty()) diagnosis.words.push_back(partly);
    if (order) diagnosis.words.push_back(order->second);

    // 5. right on some inputs, or in some components
    std::size_t asked = 0;
    for (std::size_t i = 0; i < count; ++i) asked = std::max(asked, outputs[i].input + 1);
    if (!signature && !order && wrong_inputs.size() < asked)
        diagnosis.words.push_back("It is right for " + std::to_string(asked - wrong_inputs.size()) + " of " +
                                  std::to_string(asked) + " inputs: what is special about " +
                                  (2 * wrong_inputs.size() > asked ? "those?" : "the one below?"));
    std::set<std::size_t> components;
    std::size_t size = 0;
    for (const std::size_t i : wrong) {
        size = std::max(size, yours[i].size());
        for (std::size_t k = 0; k < yours[i].size(); ++k)
            if (!(apart(yours[i][k], outputs[i].values[k], outputs[i].scale) <= tolerance))
                components.insert(k);
    }
    if (!signature && size == 3 && components.size() == 1)
        diagnosis.words.push_back(std::string("Only its ") + "xyz"[*components.begin()] +
                                  " component is wrong.");
    if (!born.empty()) diagnosis.words.push_back("Later on: " + born);
    if (diagnosis.words.empty())
        diagnosis.words.push_back(
            "This is no slip known by name: the formula gives other numbers than it should.");
    return diagnosis;
}

}  // namespace nutshell::judge
