// Exercise 0.5: the area under a function.
#pragma once
#include <nutshell/toolbox.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct AreaUnder {
    static constexpr const char *id = "0.5", *function = "area_under";
    static constexpr auto subject = NUTSHELL_CALL(area_under);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const int strips : {1, 7})
            for (const auto& [slant, a, b] : {std::tuple{2.0, -0.4, 2.1},
                                              {2.0, -0.4, 0.9},
                                              {2.0, 0.3, 2.1},
                                              {-1.2, -0.4, 2.1}}) {
                const auto cubic = [c = slant](double x) { return x * x * x - c * x + 3; };
                paper.input("f = x^3 - c x + 3, c", slant, "a", a, "b", b, "strips", strips);
                const double area = answer(cubic, a, b, strips);
                paper.output("the area", area, 10.0);
            }
    }

#ifndef NUTSHELL_SHEET
    static About<AreaUnder> about() {
        return {
            .title = "The area under a curve",
            .hints = {"How wide is one strip, and where is the middle of the first one?",
                      "Strip i begins at a + i width; its middle is half a width further.",
                      "Add f(middle) times the width over all strips."},
            .mistakes =
                {{"the left end of each strip", "classic: Euler's method",
                  "What starts slowly arrives late.",
                  "You take each strip as high as at its left end. That is Euler's method, of "
                  "order 1. Take the middle.",
                  [](const auto& f, double a, double b, int strips) -> double {
                      const double w = (b - a) / strips;
                      double sum = 0;
                      for (int i = 0; i < strips; ++i) sum += f(a + i * w) * w;
                      return sum;
                  }},
                 {"the right end of each strip", "classic", "What starts slowly arrives early.",
                  "You take each strip as high as at its right end. Take the middle.",
                  [](const auto& f, double a, double b, int strips) -> double {
                      const double w = (b - a) / strips;
                      double sum = 0;
                      for (int i = 1; i <= strips; ++i) sum += f(a + i * w) * w;
                      return sum;
                  }},
                 {"without the width", "classic", "The finer the strips, the larger the area.",
                  "You add heights. An area is height times width.",
                  [](const auto& f, double a, double b, int strips) -> double {
                      const double w = (b - a) / strips;
                      double sum = 0;
                      for (int i = 0; i < strips; ++i) sum += f(a + (i + 0.5) * w);
                      return sum;
                  }},
                 {"one strip too many", "classic: off by one",
                  "Everything goes a little too far.",
                  "Your loop makes one strip more than there are: count from 0 to strips - 1.",
                  [](const auto& f, double a, double b, int strips) -> double {
                      const double w = (b - a) / strips;
                      double sum = 0;
                      for (int i = 0; i <= strips; ++i) sum += f(a + (i + 0.5) * w) * w;
                      return sum;
                  }}},
            .alternatives = {{"walking along",
                              [](const auto& f, double a, double b, int strips) -> double {
                                  const double w = (b - a) / strips;
                                  double sum = 0, x = a + w / 2;
                                  for (int i = 0; i < strips; ++i, x += w) sum += f(x);
                                  return sum * w;
                              }},
                             {"from the far end",
                              [](const auto& f, double a, double b, int strips) -> double {
                                  const double w = (b - a) / strips;
                                  double sum = 0;
                                  for (int i = strips; i > 0; --i)
                                      sum += w * f(b - (strips - i + 0.5) * w);
                                  return sum;
                              }}},
        };
    }
#endif
};

inline const bool area_under_entered = enter<AreaUnder>();

}  // namespace nutshell::exercises
