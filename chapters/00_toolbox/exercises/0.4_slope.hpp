// Exercise 0.4: the slope of a function.
#pragma once
#include <nutshell/toolbox.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct Slope {
    static constexpr const char *id = "0.4", *function = "slope";
    static constexpr auto subject = NUTSHELL_CALL(slope);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const double h = paper.step(0.1);
        for (const auto& [slant, x] : {std::pair{2.0, 1.3}, {2.0, -0.6}, {-0.9, 1.3}}) {
            const auto cubic = [c = slant](double at) {
                return at * at * at - c * at * at + 0.7;
            };
            paper.input("f", "x^3 - c x^2 + 0.7", "c", slant, "x", x, "h", h);
            const double found = answer(cubic, x, h);
            paper.output("the slope", found, 1 / h);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<Slope> about() {
        return {
            .title = "The slope of anything",
            .hints = {"By how much does f change between two places, and how far are they apart?",
                      "The two places are x + h and x - h.", "Their distance is 2 h, not h."},
            .picture = "slope.svg",
            .mistakes =
                {{"on one side", "classic: the forward difference",
                  "Energies drift that should be kept.",
                  "You look only to the right. The curve bends away on both sides; "
                  "looking at x - h as well cancels most of that.",
                  [](const auto& f, double x, double h) -> double {
                      return (f(x + h) - f(x)) / h;
                  }},
                 {"divided by h", "classic", "Every slope is twice too steep.",
                  "The two places are 2 h apart, and you divide by h.",
                  [](const auto& f, double x, double h) -> double {
                      return (f(x + h) - f(x - h)) / h;
                  }},
                 {"backwards", "classic: a sign", "Balls roll uphill.",
                  "You subtract the value on the right from that on the left.",
                  [](const auto& f, double x, double h) -> double {
                      return (f(x - h) - f(x + h)) / (2 * h);
                  }},
                 {"not divided", "classic", "The finer you look, the flatter the world.",
                  "You return the change of f. A slope is that change per distance.",
                  [](const auto& f, double x, double h) -> double {
                      return f(x + h) - f(x - h);
                  }},
                 {"on the other side", "classic", "Energies drift that should be kept.",
                  "You look only to the left. The curve bends away on both sides; looking at x + "
                  "h as well cancels most of that.",
                  [](const auto& f, double x, double h) -> double {
                      return (f(x) - f(x - h)) / h;
                  }},
                 {"half as far to either side", "classic",
                  "None: it is as good, but it is not the slope that was asked for.",
                  "You look half of h to either side. The two places are x + h and x - h.",
                  [](const auto& f, double x, double h) -> double {
                      return (f(x + h / 2) - f(x - h / 2)) / h;
                  }},
                 {"the bend, not the slope", "classic", "Balls roll towards the sharpest bend.",
                  "That is the second difference, which tells how the slope changes. The slope "
                  "needs the two outer values only.",
                  [](const auto& f, double x, double h) -> double {
                      return (f(x + h) - 2 * f(x) + f(x - h)) / (h * h);
                  }},
                 {"only the second value divided", "classic",
                  "Slopes are as large as the heights themselves.",
                  "Division goes before subtraction: brackets belong round the difference.",
                  [](const auto& f, double x, double h) -> double {
                      return f(x + h) - f(x - h) / (2 * h);
                  }},
                 {"the sum, not the difference", "classic", "Every hill seems endlessly steep.",
                  "You add the two values. The slope is about their difference.",
                  [](const auto& f, double x, double h) -> double {
                      return (f(x + h) + f(x - h)) / (2 * h);
                  }},
                 {"to one side, but over both steps", "classic", "Every slope is half as steep.",
                  "You look to one side only and divide by 2 h. The second place is x - h.",
                  [](const auto& f, double x, double h) -> double {
                      return (f(x + h) - f(x)) / (2 * h);
                  }}},
            .alternatives = {{"the mean of two slopes",
                              [](const auto& f, double x, double h) -> double {
                                  return ((f(x + h) - f(x)) / h + (f(x) - f(x - h)) / h) / 2;
                              }},
                             {"half and half",
                              [](const auto& f, double x, double h) -> double {
                                  return 0.5 / h * f(x + h) - 0.5 / h * f(x - h);
                              }}},
        };
    }
#endif
};

inline const bool slope_entered = enter<Slope>();

}  // namespace nutshell::exercises
