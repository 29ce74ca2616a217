// Exercise 3.3: three second-order steps that make a fourth-order one.
#pragma once
#include <nutshell/compositions.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct YoshidaWeights {
    static constexpr const char *id = "3.3", *function = "yoshida_weights";
    static constexpr auto subject = NUTSHELL_CALL(yoshida_weights);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        paper.input("three weights that add up to", 1.0, "and their cubes to", 0.0);
        const std::array<double, 3> w = answer();
        paper.output("the first weight", w[0], 1.0);
        paper.output("the middle weight", w[1], 1.0);
        paper.output("the last weight", w[2], 1.0);
    }

#ifndef NUTSHELL_SHEET
    static About<YoshidaWeights> about() {
        return {
            .title = "Yoshida's weights",
            .hints = {"Call the outer weight w1 and the middle one w0. Two conditions, two "
                      "unknowns: the weights add up to one, and the cubes add up to zero.",
                      "The cubes of two w1 and one w0 add up to zero, so w0 is minus w1 times "
                      "the cube root of two. What does that say about its sign?",
                      "Put w0 = -2^(1/3) w1 into 2 w1 + w0 = 1 and solve for w1. The middle step "
                      "goes back in time."},
            .mistakes =
                {{"three equal steps", "classic",
                  "Three times the work for nine times less error, where ten thousand times less "
                  "was promised.",
                  "Three equal steps are the same method with a smaller step: their cubes add up "
                  "to 1/9, not to zero.",
                  []() -> std::array<double, 3> {
                      return {1. / 3, 1. / 3, 1. / 3};
                  }},
                 {"a square root", "classic: the wrong power",
                  "The method stays at second order.",
                  "You make the squares cancel. Verlet's leading error grows as dt cubed, so it "
                  "is the cubes.",
                  []() -> std::array<double, 3> {
                      const double w1 = 1 / (2 - std::sqrt(2.0));
                      return {w1, 1 - 2 * w1, w1};
                  }},
                 {"no step back", "classic: the sign", "The method stays at second order.",
                  "With a plus in the denominator all three weights are positive, and positive "
                  "cubes cannot add up to zero. One step must go back.",
                  []() -> std::array<double, 3> {
                      const double w1 = 1 / (2 + std::cbrt(2.0));
                      return {w1, 1 - 2 * w1, w1};
                  }},
                 {"not symmetric", "classic",
                  "The method is of third order only, and a run back in time does not return.",
                  "The weights are right and their order is not: the same backwards as forwards, "
                  "with the step back in the middle.",
                  []() -> std::array<double, 3> {
                      const double w1 = 1 / (2 - std::cbrt(2.0));
                      return {1 - 2 * w1, w1, w1};
                  }},
                 {"the fifth root", "classic: the next rung", "The method stays at second order.",
                  "The fifth root lifts a fourth-order method to the sixth. From order two to "
                  "four it is the cube root.",
                  []() -> std::array<double, 3> {
                      const double w1 = 1 / (2 - std::pow(2.0, 0.2));
                      return {w1, 1 - 2 * w1, w1};
                  }},
                 {"the middle one from one weight", "classic", "The steps do not fill the step.",
                  "You take the first weight off once. There are two of it.",
                  []() -> std::array<double, 3> {
                      const double w1 = 1 / (2 - std::cbrt(2.0));
                      return {w1, 1 - w1, w1};
                  }},
                 {"the negative one outside", "classic", "The method drops to second order.",
                  "The negative weight stands in the middle, and only once.",
                  []() -> std::array<double, 3> {
                      const double w1 = 1 / (2 - std::cbrt(2.0)), w0 = 1 - 2 * w1;
                      return {w0, w1, w0};
                  }},
                 {"the middle one positive", "classic", "The method drops to first order.",
                  "The middle weight is negative: with a plus the three add up to more than one.",
                  []() -> std::array<double, 3> {
                      const double r = std::cbrt(2.0), w1 = 1 / (2 - r);
                      return {w1, r * w1, w1};
                  }},
                 {"the weight of five steps", "classic: Suzuki's composition",
                  "The method stays at second order.",
                  "That is Suzuki's weight, 1/(4 - 4^(1/3)), for five steps, four of which have "
                  "it. Here two have it: their cubes and that of the middle one must add up to "
                  "zero.",
                  []() -> std::array<double, 3> {
                      const double w1 = 1 / (4 - std::cbrt(4.0));
                      return {w1, 1 - 2 * w1, w1};
                  }}},
            .alternatives = {{"by Newton's method",
                              []() -> std::array<double, 3> {
                                  double w1 = 1.3;  // 2 w1^3 + (1 - 2 w1)^3 = 0
                                  for (int turn = 0; turn < 20; ++turn) {
                                      const double w0 = 1 - 2 * w1;
                                      w1 -= (2 * w1 * w1 * w1 + w0 * w0 * w0) /
                                            (6 * w1 * w1 - 6 * w0 * w0);
                                  }
                                  return {w1, 1 - 2 * w1, w1};
                              }}},
            .survivors = {{"2.0 without its point", "std::cbrt(2) is that of 2.0"}},
        };
    }
#endif
};

inline const bool yoshida_weights_entered = enter<YoshidaWeights>();

}  // namespace nutshell::exercises
