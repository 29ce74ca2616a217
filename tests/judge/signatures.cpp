#include "signatures.hpp"
#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include "text.hpp"

namespace nutshell::judge {

using exercises::Input;
using exercises::Output;

namespace {

/// The number c with yours = c * right for all numbers of one output; nothing if there is none.
std::optional<double> factor(const Values& yours, const Values& right, double scale) {
    double up = 0, down = 0;
    for (std::size_t k = 0; k < yours.size(); ++k) up += yours[k] * right[k], down += right[k] * right[k];
    if (!(down > 0) || !std::isfinite(up)) return std::nullopt;
    const double c = up / down;
    for (std::size_t k = 0; k < yours.size(); ++k)
        if (std::abs(yours[k] - c * right[k]) > 1e-8 * scale * std::max(1.0, std::abs(c)))
            return std::nullopt;
    return c;
}
bool near(double a, double b) {
    return std::abs(a - b) < 1e-6 * std::abs(b);
}

/// What a factor that is the same for every input means.
Finding meaning(double c, const std::string& what) {
    const std::string comes = what + " comes out ";
    constexpr double degrees = 180 / 3.14159265358979323846;
    if (std::abs(c) < 1e-12) return {"always zero", {comes + "as zero whatever the input."}};
    if (near(c, -1))
        return {"wrong sign",
                {comes + "with the wrong sign: the size is right, the direction is opposite. Is a difference "
                         "taken the wrong way round?"}};
    if (near(c, degrees))
        return {"wrong unit", {comes + "180/pi times too large: degrees stand where radians belong."}};
    if (near(c, 1 / degrees))
        return {"wrong unit", {comes + "180/pi times too small: an angle is turned into radians twice."}};
    for (const double unit : {1e3, 1e-3, 1e2, 1e-2, 60.0, 1 / 60.0, 3.6, 1 / 3.6, 1e6, 1e-6})
        if (near(c, unit))
            return {"wrong unit",
                    {comes + digits(c, "%.4g") +
                     " times what it should be: that looks like another unit (milli-, kilo-, minutes, "
                     "km/h)."}};
    if (near(c, 2))
        return {"twice too much",
                {comes + "twice as large as it should be: a half is lost, or something is counted twice."}};
    if (near(c, 0.5))
        return {"half of it",
                {comes + "half as large as it should be: a half too many, or one of two parts is missing."}};
    return {"wrong factor", {comes + digits(c, "%.6g") + " times what it should be, for every input alike."}};
}

struct Scaled {
    std::size_t input;
    double factor;
};

/// A factor that is a power of one of the arguments, or its cosine or sine.
std::optional<Finding> power_of_argument(const Evidence& evidence, const std::vector<Scaled>& all,
                                         const std::string& subject) {
    const auto& inputs = evidence.reference.inputs;
    struct Kind {
        const char *before, *after;
        double power;  ///< its sign says whether it is multiplied or divided
        double (*of)(double);
    };
    constexpr auto as_it_is = [](double x) { return std::abs(x); };
    constexpr auto cosine = [](double x) { return std::cos(x); };
    constexpr auto sine = [](double x) { return std::sin(x); };
    constexpr Kind kinds[] = {{"", "", 1, as_it_is},
                              {"", "", -1, as_it_is},
                              {"", "^2", 2, as_it_is},
                              {"", "^2", -2, as_it_is},
                              {"", "^3", 3, as_it_is},
                              {"", "^3", -3, as_it_is},
                              {"", "^(1/2)", 0.5, as_it_is},
                              {"", "^(1/2)", -0.5, as_it_is},
                              {"the cosine of ", "", 1, cosine},
                              {"the cosine of ", "", -1, cosine},
                              {"the sine of ", "", 1, sine},
                              {"the sine of ", "", -1, sine}};
    for (const auto& [name, unused] : inputs[all.front().input].values)
        for (const auto& [before, after, power, of] : kinds) {
            std::set<double> seen;
            std::optional<double> rest;  // a constant factor besides
            bool fits = true;
            for (const auto& [input, c] : all) {
                const auto& values = inputs[input].values;
                const auto found =
                    std::find_if(values.begin(), values.end(),
                                 [&, name = name](const auto& value) { return value.first == name; });
                fits = fits && found != values.end() && found->second.size() == 1 && found->second[0] != 0;
                if (!fits) break;
                const double constant = c / std::pow(of(found->second[0]), power);
                fits = near(constant, rest.value_or(constant));
                rest = constant;
                if (fits) seen.insert(found->second[0]);
            }
            if (!fits || seen.size() < 2) continue;
            const std::string what = before + name + after;
            return {
                {before[0] ? what + " left out or too much" : "a wrong power of " + name,
                 {subject + " is wrong by a factor of " + what + ": " + what + " is " +
                  (power > 0 ? "multiplied in once too often, or left out below the line"
                             : "divided by once too often, or left out above it") +
                  (near(*rest, 1) ? "" : ", and a factor of " + digits(*rest, "%.4g") + " is wrong besides") +
                  (before[0] ? "." : ". Check the units: metres, seconds, kilograms.")}}};
        }
    return std::nullopt;
}

/// One factor behind all answers of a name: of the values, or of their change from where they start.
std::optional<Finding> factor_of(const Evidence& evidence, const std::vector<std::size_t>& places,
                                 bool of_change) {
    std::vector<Scaled> all;
    std::set<Values> truths;
    for (const std::size_t i : places) {
        const Output& output = evidence.reference.outputs[i];
        Values yours = evidence.yours[i], right = output.values;
        if (of_change && output.start.empty()) return std::nullopt;
        for (std::size_t k = 0; of_change && k < right.size(); ++k)
            yours[k] -= output.start[k], right[k] -= output.start[k];
        const double none = 1e-12 * output.scale;
        const auto zero = [&](double value) { return std::abs(value) <= none; };
        if (std::all_of(right.begin(), right.end(), zero)) {
            if (!std::all_of(yours.begin(), yours.end(), zero)) return std::nullopt;
            continue;
        }
        const auto c = factor(yours, right, output.scale);
        if (!c) return std::nullopt;
        all.push_back({output.input, *c});
        truths.insert(right);
    }
    if (all.empty() || (truths.size() < 2 && truths.begin()->size() < 2)) return std::nullopt;
    const std::string name = without_unit(evidence.reference.outputs[places.front()].name),
                      subject = of_change ? "The change of " + name : capital(name);
    const double c = all.front().factor;
    if (std::all_of(all.begin(), all.end(),
                    [&](const Scaled& each) { return std::abs(each.factor - c) <= 1e-6 * std::abs(c); })) {
        if (near(c, 1)) return std::nullopt;
        const Output& here = evidence.reference.outputs[places.front()];
        if (near(c, -1) && !of_change)
            for (std::size_t i = 0; i < evidence.yours.size(); ++i)
                if (const Output& other = evidence.reference.outputs[i];
                    other.name != here.name && other.values.size() == here.values.size() &&
                    distance(other.values, Values(other.values.size(), 0.0)) > 0 &&
                    apart(other, other.values, evidence.yours[i]) <= tolerance)
                    return {{"right in one case, not in another",
                             {subject + " has the right size and the wrong sign. " +
                              capital(without_unit(other.name)) + " is right: each case has its own sign."}}};
        return meaning(c, subject);
    }
    return power_of_argument(evidence, all, subject);
}

}  // namespace

std::string without_unit(const std::string& name) {
    return trimmed(name.substr(0, name.find('[')));
}
std::string capital(std::string text) {
    const bool identifier = text.substr(0, text.find(' ')).find_first_of("._") != std::string::npos;
    if (!text.empty() && !identifier)
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

std::vector<std::size_t> of_first_wrong_name(const Evidence& evidence) {
    const auto& outputs = evidence.reference.outputs;
    std::string name;
    for (const std::size_t i : evidence.wrong)
        if (name.empty() && outputs[i].exact.empty()) name = outputs[i].name;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < outputs.size(); ++i)
        if (outputs[i].name == name) places.push_back(i);
    return places;
}

std::optional<Finding> wrong_size(const Evidence& evidence) {
    for (const std::size_t i : evidence.wrong) {
        const auto& output = evidence.reference.outputs[i];
        if (output.values.size() != evidence.yours[i].size())
            return {
                {"wrong size",
                 {capital(without_unit(output.name)) + " has " + std::to_string(evidence.yours[i].size()) +
                  " numbers; there should be " + std::to_string(output.values.size()) + "."},
                 i}};
    }
    return std::nullopt;
}

std::optional<Finding> not_finite(const Evidence& evidence) {
    const std::size_t first = evidence.wrong.front();
    const Values& yours = evidence.yours[first];
    const auto& output = evidence.reference.outputs[first];
    if (finite(yours) || !finite(output.values)) return std::nullopt;
    const bool nan = std::any_of(yours.begin(), yours.end(), [](double value) { return std::isnan(value); });
    return {{nan ? "NaN" : "infinite",
             {capital(without_unit(output.name)) + (nan ? " is NaN, which is no number" : " is infinite") +
                  ", born at the input below" +
                  (first > 0 ? "; everything asked before it was right." : ", the first one asked."),
              nan ? "NaN comes from 0/0, from the root of a negative number, from infinity less or over "
                    "infinity, or from a vector that was never given a value."
                  : "That comes from a division by zero, or from numbers that grow without limit."}}};
}

std::optional<Finding> nearly_right(const Evidence& evidence) {
    constexpr double nearly = 1e-5;  // a float has seven digits, pi as 3.14159 six
    std::size_t count = 0;
    double largest = 0;
    for (const std::size_t i : evidence.wrong) {
        const double away =
            apart(evidence.reference.outputs[i], evidence.reference.outputs[i].values, evidence.yours[i]);
        if (away < nearly) ++count, largest = std::max(largest, away);
    }
    if (3 * count < 2 * evidence.wrong.size()) return std::nullopt;
    return {{"nearly right",
             {(count == evidence.wrong.size() ? "It is right" : "Nearly everywhere it is right") +
              std::string(" to a part in ") + digits(1 / largest, "%.1g") +
              ", and the judge wants all digits of a double. Is there a float in it, a constant with few "
              "digits, or a little something added against a division by zero?"}}};
}

std::optional<Finding> one_factor(const Evidence& evidence) {
    const auto places = of_first_wrong_name(evidence);
    if (places.empty()) return std::nullopt;
    if (auto finding = factor_of(evidence, places, false)) return finding;
    return factor_of(evidence, places, true);
}

std::optional<Finding> one_offset(const Evidence& evidence) {
    const auto places = of_first_wrong_name(evidence);
    std::set<Values> truths;
    std::optional<Values> offset;
    for (const std::size_t i : places) {
        const Output& output = evidence.reference.outputs[i];
        Values here(output.values.size());
        for (std::size_t k = 0; k < here.size(); ++k) here[k] = evidence.yours[i][k] - output.values[k];
        if (!offset) offset = here;
        if (apart(output, *offset, here) > tolerance) return std::nullopt;
        truths.insert(output.values);
    }
    if (truths.size() < 2) return std::nullopt;
    return {
        {"always off by " + shown(*offset),
         {capital(without_unit(evidence.reference.outputs[places.front()].name)) + " is off by the same " +
          shown(*offset) + " for every input: something is added that does not belong, or left out."}}};
}

}  // namespace nutshell::judge
