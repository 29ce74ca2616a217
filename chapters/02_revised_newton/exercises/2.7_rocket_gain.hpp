// Exercise 2.7: Tsiolkovsky's formula.
#pragma once
#include <nutshell/revised_newton.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct RocketGain {
    static constexpr const char *id = "2.7", *function = "rocket_gain";
    static constexpr auto subject = NUTSHELL_CALL(rocket_gain);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const auto& [u, m0, m] : {std::tuple{230.0, 10.0, 2.5},
                                       {230.0, 10.0, 7.3},
                                       {230.0, 10.0, 9.9},
                                       {4400.0, 10.0, 2.5},
                                       {230.0, 36.0, 2.5}}) {
            paper.input("u", u, "m0", m0, "m", m);
            const double gain = answer(u, m0, m);
            paper.output("the gain of speed [m/s]", gain, u * (m0 - m) / m0);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<RocketGain> about() {
        return {
            .title = "What a rocket gains",
            .hints = {"Each small parcel adds u times its share of the mass that is there at "
                      "that moment. What is the sum of all those shares?",
                      "The sum of dm/m, from the mass after to the mass before, is an integral "
                      "you have met in school.",
                      "The integral of dm/m is the natural logarithm; from m to m0 it is that of "
                      "their ratio. In C++ it is std::log."},
            .picture = "rocket_gain.svg",
            .mistakes =
                {{"the logarithm to base ten", "classic: log is not log10",
                  "The rocket reaches less than half of its speed.",
                  "You use the logarithm to base ten. The integral of dm/m is the natural one, "
                  "std::log.",
                  [](double u, double m0, double m) -> double { return u * std::log10(m0 / m); }},
                 {"the ratio upside down", "classic: a sign", "The rocket flies tail first.",
                  "You take the mass after over the mass before: the logarithm of that is "
                  "negative. A gain needs the greater mass on top.",
                  [](double u, double m0, double m) -> double { return u * std::log(m / m0); }},
                 {"the same gain from every kilogram", "classic",
                  "No rocket ever gets faster than its own exhaust.",
                  "You count every kilogram thrown out as if the full rocket threw it. The later "
                  "ones push a lighter rocket and give more.",
                  [](double u, double m0, double m) -> double { return u * (m0 - m) / m0; }},
                 {"everything in one parcel", "classic",
                  "The rocket is far too fast, as if fired from a gun.",
                  "You throw all of it at once, with the whole of the gain for what is left. A "
                  "stream of small parcels gives less: the early ones must push the later ones "
                  "along.",
                  [](double u, double m0, double m) -> double { return u * (m0 - m) / m; }},
                 {"the logarithm of the difference", "classic",
                  "The gain depends on whether you count kilograms or tonnes.",
                  "You take the logarithm of a mass. It is that of a number without unit: how "
                  "often m goes into m0.",
                  [](double u, double m0, double m) -> double { return u * std::log(m0 - m); }},
                 {"a quotient of logarithms", "classic: log(a/b) is not log(a)/log(b)",
                  "The gain depends on whether you count kilograms or tonnes.",
                  "The logarithm of a quotient is the difference of two logarithms, not their "
                  "quotient.",
                  [](double u, double m0, double m) -> double {
                      return u * std::log(m0) / std::log(m);
                  }},
                 {"the exponential", "classic: the inverse function",
                  "The smallest rocket reaches the stars.",
                  "The exponential undoes the logarithm. To get the gain from the masses take "
                  "the logarithm.",
                  [](double u, double m0, double m) -> double { return u * std::exp(m0 / m); }},
                 {"no logarithm", "classic", "The rocket is far too fast.",
                  "You multiply by the ratio of the masses. The stream adds up dm/m: the "
                  "logarithm of that ratio.",
                  [](double u, double m0, double m) -> double { return u * m0 / m; }},
                 {"the logarithm of one plus the ratio", "classic",
                  "A rocket without propellant gains speed.",
                  "log1p(x) is the logarithm of 1 + x. Use std::log.",
                  [](double u, double m0, double m) -> double { return u * std::log1p(m0 / m); }},
                 {"the logarithm to base two", "classic", "The rocket is 1.4 times too fast.",
                  "You use the logarithm to base two. The integral of dm/m is the natural one, "
                  "std::log.",
                  [](double u, double m0, double m) -> double { return u * std::log2(m0 / m); }},
                 {"over the mean mass", "classic: a mean for an integral",
                  "A rocket that burns nearly all of itself is too slow.",
                  "You divide all that is thrown out by the mean of the masses before and after. "
                  "That is near for small parts only: each bit counts by the mass of its own "
                  "moment.",
                  [](double u, double m0, double m) -> double {
                      return u * (m0 - m) / ((m0 + m) / 2);
                  }},
                 {"u before the first logarithm only", "classic: a bracket",
                  "A rocket without propellant gains speed.",
                  "The logarithm of a quotient is a difference of two, and u multiplies both: a "
                  "bracket is missing.",
                  [](double u, double m0, double m) -> double {
                      return u * std::log(m0) - std::log(m);
                  }}},
            .alternatives = {{"two logarithms",
                              [](double u, double m0, double m) -> double {
                                  return u * std::log(m0) - u * std::log(m);
                              }},
                             {"log1p",
                              [](double u, double m0, double m) -> double {
                                  return -u * std::log1p(-(m0 - m) / m0);
                              }}},
        };
    }
#endif
};

inline const bool rocket_gain_entered = enter<RocketGain>();

}  // namespace nutshell::exercises
