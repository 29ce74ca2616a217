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
                                              {2.0, -2.6, 2.1},   // below zero at first
                                              {2.0, -2.6, -1.9},  // below zero all the way
                                              {-1.2, -0.4, 2.1}}) {
                const auto cubic = [c = slant](double x) { return x * x * x - c * x + 3; };
                paper.input("f", "x^3 - c x + 3", "c", slant, "a", a, "b", b, "strips", strips);
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
                  }},
                 {"both ends of each strip", "classic",
                  "None to speak of: its error is twice as large, with the other sign.",
                  "You take the mean of both ends. That is the rule of trapezes, also of order "
                  "2; the middle was asked for.",
                  [](const auto& f, double a, double b, int strips) -> double {
                      const double w = (b - a) / strips;
                      double sum = 0;
                      for (int i = 0; i < strips; ++i)
                          sum += (f(a + i * w) + f(a + (i + 1) * w)) / 2 * w;
                      return sum;
                  }},
                 {"one strip for all", "classic", "Refining changes nothing.",
                  "You take one strip from a to b, however many are asked for.",
                  [](const auto& f, double a, double b, int strips) -> double {
                      return (b - a) * f((a + b) / 2) + 0 * strips;
                  }},
                 {"strips that begin at zero", "classic",
                  "It is right only where the interval begins at zero.",
                  "Your first strip begins at 0. It begins at a.",
                  [](const auto& f, double a, double b, int strips) -> double {
                      const double w = (b - a) / strips;
                      double sum = 0;
                      for (int i = 0; i < strips; ++i) sum += f((i + 0.5) * w) * w;
                      return sum;
                  }},
                 {"the mean height", "classic", "The area does not grow with the width.",
                  "You divide by the number of strips: that is the mean height. Times b - a it "
                  "is the area.",
                  [](const auto& f, double a, double b, int strips) -> double {
                      const double w = (b - a) / strips;
                      double sum = 0;
                      for (int i = 0; i < strips; ++i) sum += f(a + (i + 0.5) * w) / strips;
                      return sum;
                  }},
                 {"all strips one too far", "classic", "Everything comes late by a strip.",
                  "You count strips from 1. Strip 0 is the first, and the last ends at b.",
                  [](const auto& f, double a, double b, int strips) -> double {
                      const double w = (b - a) / strips;
                      double sum = 0;
                      for (int i = 1; i <= strips; ++i) sum += f(a + (i + 0.5) * w) * w;
                      return sum;
                  }},
                 {"one strip too few", "classic", "The last bit is always missing.",
                  "Your loop leaves out a strip: count from 0 to strips - 1, so i < strips.",
                  [](const auto& f, double a, double b, int strips) -> double {
                      const double w = (b - a) / strips;
                      double sum = 0;
                      for (int i = 0; i < strips - 1; ++i) sum += f(a + (i + 0.5) * w) * w;
                      return sum;
                  }},
                 {"every strip counted as positive", "classic: an area is never negative",
                  "A car that rolls back gets ever farther away.",
                  "You take the size of each height. Where f is below zero its strip is taken "
                  "away: it has a minus by itself.",
                  [](const auto& f, double a, double b, int strips) -> double {
                      const double w = (b - a) / strips;
                      double sum = 0;
                      for (int i = 0; i < strips; ++i) sum += std::abs(f(a + (i + 0.5) * w)) * w;
                      return sum;
                  }},
                 {"the borders for the middles", "classic: fence posts",
                  "Everything is a strip too long.",
                  "You take the height at every border, with a full width each: there is one "
                  "border more than there are strips. Take the middles.",
                  [](const auto& f, double a, double b, int strips) -> double {
                      const double w = (b - a) / strips;
                      double sum = 0;
                      for (int i = 0; i <= strips; ++i) sum += f(a + i * w) * w;
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
