// Exercise 0.11: a zero by Newton's method.
#pragma once
#include <nutshell/toolbox.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct NewtonRoot {
    static constexpr const char *id = "0.11", *function = "newton_root";
    static constexpr auto subject = NUTSHELL_CALL(newton_root);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const auto& [c, x, turns] : {std::tuple{2.0, 2.6, 0},
                                          {2.0, 2.6, 1},
                                          {2.0, 2.6, 3},
                                          {0.7, 2.6, 3},
                                          {2.0, 9.0, 6},
                                          {0.7, 2.6, 1},
                                          {2.0, 3.4, 1},
                                          {9.0, -1.0, 3}}) {
            const auto f = [c = c](double at) { return at * at * at - c * at - 5; };
            const auto df = [c = c](double at) { return 3 * at * at - c; };
            paper.input("f", "x^3 - c x - 5", "c", c, "x", x, "turns", turns);
            const double root = answer(f, df, x, turns);
            paper.output("the place after the turns", root, x);
        }
        // begins so near that the function is less than a millionth
        const auto f = [](double at) { return at * at * at - 2 * at - 5; };
        const auto df = [](double at) { return 3 * at * at - 2; };
        const double close = 2.0945515;
        paper.input("f", "x^3 - c x - 5", "c", 2.0, "x", close, "turns", 1);
        const double way = answer(f, df, close, 1) - close;
        paper.output("how far it comes in one turn", way, 1e-5);
    }

#ifndef NUTSHELL_SHEET
    static About<NewtonRoot> about() {
        return {
            .title = "Find the zero",
            .hints = {"How far from x does the tangent cross zero, if it stands at f(x) and its "
                      "slope is df(x)?",
                      "The tangent falls f(x) in a way of f(x) / df(x).",
                      "Repeat: subtract f(x) / df(x) from x."},
            .picture = "newton.svg",
            .mistakes =
                {{"uphill", "classic: a sign", "The joint flies apart instead of closing.",
                  "You go away from the zero. Where f and its slope are positive the zero lies "
                  "to the left: subtract.",
                  [](const auto& f, const auto& df, double x, int turns) -> double {
                      for (int i = 0; i < turns; ++i) x += f(x) / df(x);
                      return x;
                  }},
                 {"upside down", "classic", "It jumps about and finds nothing.",
                  "You divide the slope by the value. The way is the value over the slope.",
                  [](const auto& f, const auto& df, double x, int turns) -> double {
                      for (int i = 0; i < turns; ++i) x -= df(x) / f(x);
                      return x;
                  }},
                 {"the slope of the start kept", "classic: one Jacobian for all",
                  "It arrives, but with a few digits a turn.",
                  "You use the slope of the first guess in every turn. That saves work and loses "
                  "the doubling of digits.",
                  [](const auto& f, const auto& df, double x, int turns) -> double {
                      const double k = df(x);
                      for (int i = 0; i < turns; ++i) x -= f(x) / k;
                      return x;
                  }},
                 {"one turn only", "classic: a loop forgotten",
                  "It is only nearly right, whatever the number of turns.",
                  "You make one turn. Repeat it as often as asked, also not at all.",
                  [](const auto& f, const auto& df, double x, int turns) -> double {
                      return turns > 0 ? x - f(x) / df(x) : x;
                  }},
                 {"one turn too few", "classic", "It is always one turn behind.",
                  "Your loop makes one turn less than asked: count from 0 while i < turns.",
                  [](const auto& f, const auto& df, double x, int turns) -> double {
                      for (int i = 1; i < turns; ++i) x -= f(x) / df(x);
                      return x;
                  }},
                 {"one turn too many", "classic", "It costs a turn more than paid for.",
                  "Your loop makes one turn more than asked: count from 0 while i < turns.",
                  [](const auto& f, const auto& df, double x, int turns) -> double {
                      for (int i = 0; i <= turns; ++i) x -= f(x) / df(x);
                      return x;
                  }},
                 {"the value of the start kept", "classic", "It walks on past the zero.",
                  "You use f of the first guess in every turn: ask for it anew at each place.",
                  [](const auto& f, const auto& df, double x, int turns) -> double {
                      const double y = f(x);
                      for (int i = 0; i < turns; ++i) x -= y / df(x);
                      return x;
                  }},
                 {"the way, not the place", "classic", "It jumps to the middle of the world.",
                  "You return or keep the way f/df itself. It is taken from the place where you "
                  "are.",
                  [](const auto& f, const auto& df, double x, int turns) -> double {
                      for (int i = 0; i < turns; ++i) x = -f(x) / df(x);
                      return x;
                  }},
                 {"it stops early", "classic: good enough", "Precise machines are built askew.",
                  "You leave the loop where f is small. The caller says how many turns.",
                  [](const auto& f, const auto& df, double x, int turns) -> double {
                      for (int i = 0; i < turns && std::abs(f(x)) > 1e-6; ++i) x -= f(x) / df(x);
                      return x;
                  }},
                 {"a negative value taken for a small one", "classic: an abs forgotten",
                  "Some joints stop far from where they should close.",
                  "You leave the loop where f is less than a small number. What is negative is "
                  "less too, however far from zero; and the caller says how many turns.",
                  [](const auto& f, const auto& df, double x, int turns) -> double {
                      for (int i = 0; i < turns && f(x) > 1e-6; ++i) x -= f(x) / df(x);
                      return x;
                  }}},
            .alternatives = {{"counting down",
                              [](const auto& f, const auto& df, double x, int turns) -> double {
                                  while (turns-- > 0) x = x - f(x) / df(x);
                                  return x;
                              }},
                             {"the mean of tangent and place",
                              [](const auto& f, const auto& df, double x, int turns) -> double {
                                  for (int i = 0; i < turns; ++i) x = (x * df(x) - f(x)) / df(x);
                                  return x;
                              }}},
        };
    }
#endif
};

inline const bool newton_root_entered = enter<NewtonRoot>();

}  // namespace nutshell::exercises
