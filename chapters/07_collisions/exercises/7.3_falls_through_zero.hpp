// Exercise 7.3: when a distance falls through zero, the heart of every time of impact.
#pragma once
#include <nutshell/time_of_impact.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct FallsThroughZero {
    static constexpr const char *id = "7.3", *function = "falls_through_zero";
    static constexpr auto subject = NUTSHELL_CALL(falls_through_zero);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        struct Case {
            double a, b, c;
        };
        for (const auto& [a, b, c] :
             {Case{-4.9, 3.1, 1.7}, {-4.9, -3.1, 1.7}, {-2.2, 3.1, 1.7}, {-4.9, 1.1, 1.7},
              {-4.9, 3.1, 0.6},                        // thrown up, thrown down, each varied
              {1.3, -4.1, 2.2},     {2.6, -4.9, 2.2},  // comes near and leaves again
              {1.3, -2.1, 2.2},     {1.3, 4.1, 2.2},   // stays away
              {0, -2.5, 1.5},       {0, 2.5, 1.5},     {0, 0, 1},      // no acceleration
              {-1e-9, -1, 1},       {1e-9, -1, 1},     {-1e-9, 1, 1},  // hardly any
              {-4.9, 0, 1.2},       {2, 0, 1.2},                       // from rest
              {-4.9, -1, 0},        {-4.9, 2, 0},      {3, 1, 0},        {3, -1, 0},
              {-4.9, 0, 0},  // touches
              {1.5, -2, -0.25},     {-4.9, 0.5, 0},    {-4.9, 1, 0},     {1, 0.5, 0},
              {-4.9, 0.0005, 0},    {-4.9, 0, -0.3},   {0.5, 0, -0.2},   {0, 0, -0.2},
              {-0.3, -0.4, 0.5},    {-4.9, 3, -0.3},   {1, -2, 1}}) {  // overlaps; grazes
            paper.input("a", a, "b", b, "c", c);
            const std::optional<double> t = answer(a, b, c);
            paper.output("it meets: 1, or not: 0", t ? 1.0 : 0.0, 1.0);
            paper.output("the time [s]", t.value_or(-1), t && *t > 0 ? *t : 1.0);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<FallsThroughZero> about() {
        return {
            .title = "When does it touch?",
            .hints =
                {"It is a quadratic equation. Which of its two roots is a fall through zero "
                 "from above, which a rise? Draw the parabola for a < 0 and for a > 0.",
                 "Where b is large, one root is the difference of two numbers that are almost "
                 "equal. Compute q = -(b + sign(b) sqrt(b^2 - 4ac))/2 first; the roots are "
                 "q/a and c/q.",
                 "What touches already (c <= 0) and closes in meets now. For a < 0 take the "
                 "root that is positive; for a >= 0 it only meets if b < 0, and first at the "
                 "smaller root, c/q."},
            .mistakes =
                {{"the school's formula", "classic: cancellation",
                  "Slow things under weak gravity touch at times that jump about.",
                  "Your formula is right on paper, but takes two numbers of almost one size from "
                  "each other, and divides by zero where there is no acceleration.",
                  [](double a, double b, double c) -> std::optional<double> {
                      if (c <= 0 && (b < 0 || (b == 0 && a < 0))) return 0.0;
                      const double square = b * b - 4 * a * c;
                      if (!(square >= 0)) return {};
                      const double t = (-b - std::sqrt(square)) / (2 * a);
                      if (!(t >= 0)) return {};
                      return t;
                  }},
                 {"the later root", "classic",
                  "The ball dives through the floor and bounces on "
                  "its way out, or from behind.",
                  "You take the other root: there the distance rises through zero.",
                  [](double a, double b, double c) -> std::optional<double> {
                      if (c <= 0 && (b < 0 || (b == 0 && a < 0))) return 0.0;
                      const double square = b * b - 4 * a * c;
                      if (!(square >= 0)) return {};
                      const double q = -(b + std::copysign(std::sqrt(square), b)) / 2;
                      if (a < 0) return q > 0 ? q / a : c / q;
                      if (b < 0) return a > 0 ? q / a : c / q;
                      return {};
                  }},
                 {"touching is not seen", "classic: c > 0 taken for granted",
                  "A ball that touches the floor and moves down falls through.",
                  "What touches already and closes in meets now, at time 0.",
                  [](double a, double b, double c) -> std::optional<double> {
                      if (c <= 0) return {};
                      const double square = b * b - 4 * a * c;
                      if (!(square >= 0)) return {};
                      const double q = -(b + std::copysign(std::sqrt(square), b)) / 2;
                      if (a < 0) return q > 0 ? c / q : q / a;
                      if (b < 0) return c / q;
                      return {};
                  }},
                 {"an impact in the past", "classic", "Balls that fly apart collide.",
                  "Your time may lie in the past. What comes nearer no more will not meet.",
                  [](double a, double b, double c) -> std::optional<double> {
                      if (c <= 0 && (b < 0 || (b == 0 && a < 0))) return 0.0;
                      const double square = b * b - 4 * a * c;
                      if (!(square >= 0)) return {};
                      const double q = -(b + std::copysign(std::sqrt(square), b)) / 2;
                      if (a < 0) return q > 0 ? c / q : q / a;
                      if (b == 0 && a == 0) return {};
                      return c / q;
                  }},
                 {"the other root", "classic: + before the root, always",
                  "A thrown ball falls through the floor, or meets it when it is under it.",
                  "With + before the root you get the later meeting for a > 0, and for a < 0 the "
                  "one in the past. Which root comes first hangs on the sign of a.",
                  [](double a, double b, double c) -> std::optional<double> {
                      if (c <= 0 && (b < 0 || (b == 0 && a < 0))) return 0.0;
                      if (a == 0 && b < 0) return -c / b;
                      const double t = (std::sqrt(b * b - 4 * a * c) - b) / (2 * a);
                      if (!(t >= 0)) return {};
                      return t;
                  }},
                 {"a straight flight", "classic: gravity forgotten",
                  "A ball that is thrown upwards never comes down on anything.",
                  "You use distance over speed. The speed changes on the way: solve the "
                  "quadratic.",
                  [](double a, double b, double c) -> std::optional<double> {
                      if (c <= 0 && (b < 0 || (b == 0 && a < 0))) return 0.0;
                      if (b < 0) return -c / b;
                      return {};
                  }},
                 {"a taken for an acceleration", "classic: a t^2/2",
                  "Falling balls meet too soon.",
                  "You solve a t^2/2 + b t + c = 0. The distance here is a t^2 + b t + c: under "
                  "the root stands "
                  "b^2 - 4ac.",
                  [](double a, double b, double c) -> std::optional<double> {
                      if (c <= 0 && (b < 0 || (b == 0 && a < 0))) return 0.0;
                      const double square = b * b - 2 * a * c;
                      if (!(square >= 0)) return {};
                      const double q = -(b + std::copysign(std::sqrt(square), b)) / 2;
                      if (a < 0) return q > 0 ? c / q : q / a;
                      if (b < 0) return c / q;
                      return {};
                  }},
                 {"the time of the top", "classic", "Balls bounce in mid-air.",
                  "-b/(2a) is when the distance is largest or smallest, not when it is zero.",
                  [](double a, double b, double c) -> std::optional<double> {
                      if (c <= 0) return 0.0;
                      if (a == 0) return {};
                      return -b / (2 * a);
                  }},
                 {"the first root that is not negative", "classic",
                  "Balls that fly apart stick, and slow ones jump.",
                  "What touches and moves away meets nothing now; and a difference of two "
                  "numbers of almost one "
                  "size loses digits where a is small: divide 2c by a sum instead.",
                  [](double a, double b, double c) -> std::optional<double> {
                      if (c <= 0) return 0.0;
                      if (a == 0) return b >= 0 ? std::optional<double>() : -c / b;
                      const double D = b * b - 4 * a * c;
                      if (D < 0) return {};
                      const double one = (-b - std::sqrt(D)) / (2 * a),
                                   two = (-b + std::sqrt(D)) / (2 * a);
                      if (std::min(one, two) >= 0) return std::min(one, two);
                      if (std::max(one, two) >= 0) return std::max(one, two);
                      return {};
                  }},
                 {"at rest under a pull", "classic: b < 0 taken for all that closes in",
                  "What lies still falls through.",
                  "What touches, at rest, and is pulled in (b = 0, a < 0) meets at once too.",
                  [](double a, double b, double c) -> std::optional<double> {
                      if (c <= 0 && b < 0) return 0.0;
                      const double square = b * b - 4 * a * c;
                      if (!(square >= 0)) return {};
                      const double q = -(b + std::copysign(std::sqrt(square), b)) / 2;
                      if (a < 0) return q > 0 ? c / q : q / a;
                      if (b < 0) return c / q;
                      return {};
                  }},
                 {"a rise taken for a fall", "classic: the first root that is not negative",
                  "A ball that has left the floor meets it at once, or on its way out.",
                  "You take the earlier root that is not negative. Where the distance begins at "
                  "zero or below it may be one at which it rises: only a fall through zero "
                  "counts.",
                  [](double a, double b, double c) -> std::optional<double> {
                      if (c <= 0 && (b < 0 || (b == 0 && a < 0))) return 0.0;
                      if (a == 0) return b < 0 ? std::optional<double>(-c / b) : std::nullopt;
                      const double square = b * b - 4 * a * c;
                      if (square < 0) return {};
                      const double q = -(b + std::copysign(std::sqrt(square), b)) / 2,
                                   one = std::min(q / a, c / q), two = std::max(q / a, c / q);
                      if (one >= 0) return one;
                      if (two >= 0) return two;
                      return {};
                  }},
                 {"small steps in time", "classic: a loop instead of a formula",
                  "Thin things are missed, and late ones never found.",
                  "You go on in small steps of time until the distance is negative. You come "
                  "late by up to a step, miss what happens between two of them, and stop some "
                  "day. The equation can be solved.",
                  [](double a, double b, double c) -> std::optional<double> {
                      for (double t = 0; t < 10; t += 0.001)
                          if (a * t * t + b * t + c < 0) return t;
                      return {};
                  }}},
            .alternatives = {{"root by root",
                              [](double a, double b, double c) -> std::optional<double> {
                                  if (c <= 0 && b <= 0 && (b < 0 || a < 0)) return 0.0;
                                  const double square = b * b - 4 * a * c;
                                  if (square < 0 || (a >= 0 && b >= 0)) return {};
                                  const double root = std::sqrt(square);
                                  return b < 0 ? 2 * c / (root - b) : -(b + root) / (2 * a);
                              }}},
            .survivors = {{"0.0 to 0.999 of it", "zero has no fraction"},
                          {"0.0 without its point", "zero has no fraction"},
                          {"result to int", "zero has no fraction"},
                          {"<= to <", "a touch at c = 0 is found by the roots as well"},
                          {"> to >=", "q is zero only where a touch was found before"},
                          {"statements 1 and 2 swapped", "neither uses what the other finds"},
                          {"statements 6 and 7 swapped", "for a < 0 and b < 0 both give c/q"}},
        };
    }
#endif
};

inline const bool falls_through_zero_entered = enter<FallsThroughZero>();

}  // namespace nutshell::exercises
