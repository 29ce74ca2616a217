// Exercise 5.8: what an eye sees of a turn between two pictures.
#pragma once
#include <nutshell/spinning.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct SeenTurn {
    static constexpr const char *id = "5.8", *function = "seen_turn";
    static constexpr auto subject = NUTSHELL_CALL(seen_turn);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const int spokes : {1, 4, 7})
            for (const double part : {0.3, 0.6, 0.95, 2.7, -0.4, -0.8, 0.0}) {
                const double turn = part * 2 * pi / spokes;
                paper.input("turn", turn, "spokes", static_cast<double>(spokes));
                const double seen = answer(turn, spokes);
                paper.output("the turn seen [rad]", seen, 2 * pi / spokes);
            }
    }

#ifndef NUTSHELL_SHEET
    static About<SeenTurn> about() {
        return {
            .title = "What the eye sees",
            .hints =
                {"A wheel with n equal spokes looks the same after part of a turn. After "
                 "which part?",
                 "Whole numbers of that part cannot be seen: take away the nearest one. What "
                 "is left may be negative.",
                 "The standard library's std::remainder takes away the nearest whole number "
                 "of its second argument."},
            .picture = "wagon.png",
            .mistakes =
                {{"always forwards", "classic: fmod for remainder",
                  "The wagon wheel never turns backwards.",
                  "You take away whole spokes downwards. The eye takes the nearest: what is left "
                  "lies between minus and plus half a spoke.",
                  [](double turn, int spokes) -> double {
                      const double spoke = 2 * pi / spokes;
                      return turn - spoke * std::floor(turn / spoke);
                  }},
                 {"a wheel with one spoke", "classic", "Only very fast wheels turn backwards.",
                  "You take away whole turns. The wheel looks the same after each spoke.",
                  [](double turn, int) -> double { return std::remainder(turn, 2 * pi); }},
                 {"half of a spoke", "classic", "Wheels turn backwards too early.",
                  "The wheel looks the same after 2 pi over the number of spokes, not pi over "
                  "it.",
                  [](double turn, int spokes) -> double {
                      return std::remainder(turn, pi / spokes);
                  }},
                 {"the turn itself", "classic", "The eye is too good.",
                  "You return the turn unchanged. Nobody can see whole spokes.",
                  [](double turn, int) -> double { return turn; }},
                 {"in spokes", "classic: another unit", "The speed shown is too high.",
                  "You return a number of spokes. The angle is asked for, in radians.",
                  [](double turn, int spokes) -> double {
                      const double part = turn * spokes / (2 * pi);
                      return part - std::round(part);
                  }},
                 {"cut towards zero", "classic", "No wheel ever turns backwards.",
                  "fmod cuts towards zero: what is left has the sign of the turn and may be "
                  "nearly a whole gap. The shortest turn is at most half a gap.",
                  [](double turn, int spokes) -> double {
                      return std::fmod(turn, 2 * pi / spokes);
                  }},
                 {"times the spokes", "classic", "Only very fast wheels turn backwards.",
                  "The wheel looks the same after a whole turn over the number of spokes.",
                  [](double turn, int spokes) -> double {
                      return std::remainder(turn, 2 * pi * spokes);
                  }},
                 {"without its sign", "classic", "No wheel ever turns backwards.",
                  "You return the size of the turn. Backwards is negative.",
                  [](double turn, int spokes) -> double {
                      return std::abs(std::remainder(turn, 2 * pi / spokes));
                  }},
                 {"a half added, then cut", "classic", "Wheels that turn backwards jump.",
                  "You add a half and cut. A cast to int and std::fmod cut towards zero, so that "
                  "rounds positive numbers only. std::round does both.",
                  [](double turn, int spokes) -> double {
                      const double gap = 2 * pi / spokes;
                      return turn - gap * static_cast<int>(turn / gap + 0.5);
                  }},
                 {"divided by the spokes afterwards", "classic",
                  "The more spokes, the slower the wheel seems.",
                  "You take off whole turns and divide what is left by the number of spokes. "
                  "What cannot be seen is a whole number of gaps between two spokes; the angle "
                  "itself is not divided.",
                  [](double turn, int spokes) -> double {
                      return std::remainder(turn, 2 * pi) / spokes;
                  }},
                 {"whole turns for spokes", "classic: two units mixed",
                  "The wheel jumps by whole turns.",
                  "You count how many gaps have gone by, and take as many whole turns away. A "
                  "gap is 2 pi over the number of spokes.",
                  [](double turn, int spokes) -> double {
                      return turn - 2 * pi * std::round(turn * spokes / (2 * pi));
                  }}},
            .alternatives = {{"by the nearest whole number of spokes",
                              [](double turn, int spokes) -> double {
                                  const double spoke = 2 * pi / spokes;
                                  return turn - spoke * std::round(turn / spoke);
                              }},
                             {"by sine and cosine",
                              [](double turn, int spokes) -> double {
                                  return std::atan2(std::sin(spokes * turn),
                                                    std::cos(spokes * turn)) /
                                         spokes;
                              }}},
        };
    }
#endif
};

inline const bool seen_turn_entered = enter<SeenTurn>();

}  // namespace nutshell::exercises
