// Exercise 0.6: growth and decay.
#pragma once
#include <nutshell/toolbox.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct Grown {
    static constexpr const char *id = "0.6", *function = "grown";
    static constexpr auto subject = NUTSHELL_CALL(grown);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const auto& [y, rate, t] : {std::tuple{3.0, -0.7, 0.6},
                                         {3.0, -0.7, 2.3},
                                         {3.0, 0.4, 0.6},
                                         {3.0, 0.4, 2.3},
                                         {-1.8, 0.4, 2.3},
                                         {8.5, -0.7, 0.6}}) {
            paper.input("y", y, "rate", rate, "t", t);
            const double left = answer(y, rate, t);
            paper.output("what is there after t", left, y * std::exp(std::abs(rate) * t));
        }
    }

#ifndef NUTSHELL_SHEET
    static About<Grown> about() {
        return {
            .title = "What is left?",
            .hints = {"It changes all the time in proportion to what there is. Which function "
                      "does that?",
                      "The exponential of what? Of a number without unit: a rate times a time.",
                      "Start from y and multiply it by std::exp of rate times t."},
            .picture = "growth.svg",
            .mistakes =
                {{"one straight step", "classic: Euler's method in one step",
                  "In a slow frame the speed turns round.",
                  "You make one step with the change at the start. What is there changes "
                  "on the way, and its change with it.",
                  [](double y, double rate, double t) -> double { return y * (1 + rate * t); }},
                 {"the wrong sign", "classic: a sign", "What should fade explodes.",
                  "A negative rate is already a decay; do not turn its sign once more.",
                  [](double y, double rate, double t) -> double {
                      return y * std::exp(-rate * t);
                  }},
                 {"the time forgotten", "classic: a factor per frame",
                  "The drag depends on the frame rate.",
                  "Your factor does not depend on the time. The exponent is the rate "
                  "times the time.",
                  [](double y, double rate, double t) -> double {
                      return y * std::exp(rate) + 0 * t;
                  }},
                 {"powers of two", "classic: half-life", "Everything fades too slowly.",
                  "You count in doublings. The rate belongs to e; for doublings it would "
                  "have to be divided by ln 2.",
                  [](double y, double rate, double t) -> double {
                      return y * std::exp2(rate * t);
                  }},
                 {"interest once a second", "classic", "It decays too fast and grows too slowly.",
                  "(1 + rate)^t adds the interest once a second. It changes at every moment: "
                  "e^(rate t).",
                  [](double y, double rate, double t) -> double {
                      return y * std::pow(1 + rate, t);
                  }},
                 {"added, not multiplied", "classic",
                  "Large things lose as little as small ones.",
                  "You add the exponential to y. It is the factor by which y changes.",
                  [](double y, double rate, double t) -> double {
                      return y + std::exp(rate * t);
                  }},
                 {"the start forgotten", "classic", "It always begins at 1.",
                  "You return the factor alone. What is there after t is y times that.",
                  [](double y, double rate, double t) -> double {
                      return std::exp(rate * t) + 0 * y;
                  }},
                 {"what is gone, not what is left", "classic", "What fades seems to grow.",
                  "You return how much has been lost. What is left is y times the exponential.",
                  [](double y, double rate, double t) -> double {
                      return y * (1 - std::exp(rate * t));
                  }},
                 {"one implicit step", "classic", "It never goes below zero, and yet is wrong.",
                  "y / (1 - rate t) is one step with the change at its end. It changes at every "
                  "moment: the exponential.",
                  [](double y, double rate, double t) -> double { return y / (1 - rate * t); }},
                 {"the time outside the exponent", "classic", "After no time nothing is left.",
                  "You multiply by t outside. The exponent is rate times t.",
                  [](double y, double rate, double t) -> double {
                      return y * std::exp(rate) * t;
                  }},
                 {"y in the exponent", "classic", "Twice as much fades more than twice as fast.",
                  "y stands in the exponent. What is there is y times the exponential of rate "
                  "times t.",
                  [](double y, double rate, double t) -> double {
                      return std::exp(y * rate * t);
                  }},
                 {"powers of ten", "classic: the other logarithm's base",
                  "Everything fades too fast.",
                  "You count in powers of ten. The base is e: std::exp(rate * t).",
                  [](double y, double rate, double t) -> double {
                      return y * std::pow(10, rate * t);
                  }},
                 {"a constant added", "classic: y = e^x + C",
                  "Large things lose as little as small ones.",
                  "You add a constant to the exponential so that it begins at y. Then it does "
                  "not change by rate times what is there: y multiplies the exponential.",
                  [](double y, double rate, double t) -> double {
                      return std::exp(rate * t) + y - 1;
                  }}},
            .alternatives = {{"a power of e",
                              [](double y, double rate, double t) -> double {
                                  return y * std::pow(std::exp(1.0), rate * t);
                              }},
                             {"in two halves",
                              [](double y, double rate, double t) -> double {
                                  const double half = std::exp(rate * t / 2);
                                  return y * half * half;
                              }}},
        };
    }
#endif
};

inline const bool grown_entered = enter<Grown>();

}  // namespace nutshell::exercises
