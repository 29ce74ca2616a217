// Signatures of where an answer is right: what the inputs have in common for which it is wrong.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include "signatures.hpp"

namespace nutshell::judge {

namespace {

using exercises::Input;

/// A number of every input: an argument, or a component of one.
struct Number {
    std::string name;
    bool whole;  ///< an argument by itself
    std::vector<double> of_input;
};

std::vector<Number> numbers_of(const std::vector<Input>& inputs) {
    std::vector<Number> all;
    for (const auto& [name, first] : inputs.front().values)
        for (std::size_t k = 0; k < first.size() && first.size() <= 4; ++k) {
            Number number{first.size() == 1 ? name : name + "." + "xyzw"[k], first.size() == 1, {}};
            for (const Input& input : inputs)
                for (const auto& [other, values] : input.values)
                    if (other == name && values.size() == first.size()) number.of_input.push_back(values[k]);
            if (number.of_input.size() == inputs.size()) all.push_back(std::move(number));
        }
    return all;
}

/// What may be special about a number, in the order in which it is told.
struct Property {
    const char* words;
    bool (*holds)(double);
};
constexpr Property properties[] = {{"zero", [](double x) { return x == 0; }},
                                   {"negative", [](double x) { return x < 0; }},
                                   {"positive", [](double x) { return x > 0; }},
                                   {"one", [](double x) { return x == 1; }},
                                   {"zero or one", [](double x) { return x == 0 || x == 1; }}};

/// The chance that `few` inputs out of `all` all fall among `some`, drawn blindly.
double chance(std::size_t few, std::size_t some, std::size_t all) {
    double product = 1;
    for (std::size_t i = 0; i < few; ++i)
        product *= (static_cast<double>(some) - static_cast<double>(i)) /
                   (static_cast<double>(all) - static_cast<double>(i));
    return product;
}

/// A property, and how many of the inputs that are wrong and right have it.
struct Found {
    std::string where;
    std::size_t bad, good;
};

}  // namespace

std::optional<Finding> special_inputs(const Evidence& evidence) {
    const auto& inputs = evidence.reference.inputs;
    std::set<std::size_t> wrong;
    for (const std::size_t i : evidence.wrong) wrong.insert(evidence.reference.outputs[i].input);
    const std::size_t total = inputs.size(), bad = wrong.size(), good = total - bad;
    if (total < 5 || good == 0) return std::nullopt;  // of a few inputs much is true by chance
    double tries = 0, least = 1;
    std::optional<Finding> best, by_itself;
    const auto numbers = numbers_of(inputs);
    for (const Number& number : numbers)
        for (const Property& property : properties) {
            Found with{number.name + " is " + property.words, 0, 0};
            for (std::size_t i = 0; i < total; ++i)
                if (property.holds(number.of_input[i])) ++(wrong.count(i) ? with.bad : with.good);
            const std::size_t holds = with.bad + with.good;
            if (holds == 0 || holds == total) continue;
            ++tries;
            const std::string of_those = "for " + std::to_string(with.bad) + " of the " +
                                         std::to_string(holds) + " inputs of that kind.";
            const bool rare = 3 * holds <= 2 * total;  // what most inputs have tells little
            if (with.bad == bad && (rare || with.good == 0) && chance(bad, holds, total) < least)
                least = chance(bad, holds, total),
                best = {"wrong only where " + with.where,
                        {with.good == 0
                             ? "Your answer is right for every input but those where " + with.where + "."
                             : "It is wrong only where " + with.where + ": " + of_those}};
            if (with.good == good && (rare || with.bad == 0) && chance(good, holds, total) < least)
                least = chance(good, holds, total),
                best = {"right only where " + with.where,
                        {with.bad == 0 ? "Your answer is right where " + with.where + ", and nowhere else."
                                       : "It is right only where " + with.where + ", and wrong " + of_those}};
            if (number.whole && with.bad == bad && with.good == 0 && !by_itself) by_itself = best;
        }
    if (by_itself) return by_itself;
    if (best && least * tries < 0.25) return best;
    if (numbers.size() != 2 || std::min(bad, good) < 3) return std::nullopt;  // of more, too many pairs
    const auto &x = numbers[0].of_input, &y = numbers[1].of_input;
    for (const auto& [what, size_of] :
         {std::pair{numbers[0].name + " over " + numbers[1].name,
                    +[](double first, double second) { return std::abs(first / second); }},
          std::pair{numbers[1].name + " over " + numbers[0].name,
                    +[](double first, double second) { return std::abs(second / first); }},
          std::pair{numbers[0].name + " times " + numbers[1].name,
                    +[](double first, double second) { return std::abs(first * second); }}}) {
        double right_up_to = 0, wrong_from = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < total; ++i) {
            const double size = size_of(x[i], y[i]);
            if (wrong.count(i) || std::isnan(size))
                wrong_from = std::isnan(size) ? 0 : std::min(wrong_from, size);
            else
                right_up_to = std::max(right_up_to, size);
        }
        if (right_up_to < wrong_from)
            return {{"wrong where " + what + " is large",
                     {"It depends on " + what + ": up to " + digits(right_up_to, "%.4g") +
                      " your answer is right, from " + digits(wrong_from, "%.4g") + " on it is wrong."}}};
    }
    return std::nullopt;
}

}  // namespace nutshell::judge
