// Exercise 6.12: the two speeds at which a top goes round without nodding.
#pragma once
#include <nutshell/heavy_top.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct SteadyPrecession {
    static constexpr const char *id = "6.12", *function = "steady_precession";
    static constexpr auto subject = NUTSHELL_CALL(steady_precession);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const auto one = [&](double across, double along, double weight, double L3,
                             double angle) {
            paper.input("top.across", across, "top.along", along, "top.weight", weight, "L3", L3,
                        "angle", angle);
            const std::array<double, 2> rates = answer(Top{across, along, weight}, L3, angle);
            const double size = std::abs(L3) / across;
            paper.output("the slow rate [rad/s]", rates[0], size);
            paper.output("the fast rate [rad/s]", rates[1], size);
        };
        one(0.31, 0.1, 4.9, 3.1, 0.5);
        one(0.47, 0.1, 4.9, 3.1, 0.5);
        one(0.31, 0.23, 4.9, 3.1, 0.5);
        one(0.31, 0.1, 2.3, 3.1, 0.5);
        one(0.31, 0.1, 4.9, 4.7, 0.5);
        one(0.31, 0.1, 4.9, 3.1, 1.2);
        one(0.31, 0.1, 4.9, -3.1, 0.5);  // spins the other way
        one(0.31, 0.1, 4.9, 3.1, 2.2);   // hangs
    }

#ifndef NUTSHELL_SHEET
    using T = const Top&;
    using Rates = std::array<double, 2>;
    /// The two roots of I1 cos Omega^2 - L3 Omega + weight = 0, the slow one first.
    static Rates roots(double I1, double L3, double weight, double c) {
        const double s = std::copysign(std::sqrt(L3 * L3 - 4 * I1 * weight * c), L3);
        return {(L3 - s) / (2 * I1 * c), (L3 + s) / (2 * I1 * c)};
    }
    static About<SteadyPrecession> about() {
        return {
            .title = "Two ways to go round",
            .hints =
                {"It is a quadratic in Omega with two roots. The square root, with its sign "
                 "chosen as that of L3, makes the larger of L3 minus and L3 plus: call that "
                 "far.",
                 "The fast rate is far over twice I1 times the cosine. For the slow one do "
                 "not subtract two numbers that are nearly equal: the product of the roots "
                 "is m g l over I1 times the cosine.",
                 "root has been checked above and holds the square's contents, c the cosine. "
                 "std::copysign(std::sqrt(root), L3) has the right sign. Slow first: twice "
                 "the weight over far."},
            .picture = "top.png",
            .mistakes =
                {{"fast first", "classic: the order of the roots",
                  "The top is sent round so fast that it blurs.",
                  "Both rates are right, but the slow one comes first.",
                  [](T top, double L3, double angle) -> Rates {
                      const auto [slow, fast] =
                          roots(top.across, L3, top.weight, std::cos(angle));
                      return {fast, slow};
                  }},
                 {"the moment about its own axis", "classic: I3 for I1",
                  "The top nods however it is started.",
                  "Going round tilts the whole top: the moment is the one across, I1.",
                  [](T top, double L3, double angle) -> Rates {
                      const double far =
                          L3 + std::copysign(std::sqrt(L3 * L3 - 4 * top.across * top.weight *
                                                                     std::cos(angle)),
                                             L3);
                      return {2 * top.weight / far, far / (2 * top.along * std::cos(angle))};
                  }},
                 {"the angle forgotten", "classic: right for an upright top only",
                  "Tops that lean more nod more.",
                  "The cosine of the lean stands under the root and below it.",
                  [](T top, double L3, double angle) -> Rates {
                      const double far =
                          L3 + std::copysign(std::sqrt(L3 * L3 - 4 * top.across * top.weight *
                                                                     std::cos(angle)),
                                             L3);
                      return {2 * top.weight / far, far / (2 * top.across)};
                  }},
                 {"the rule of thumb", "classic: m g l / L3", "Slow tops nod, fast ones hardly.",
                  "m g l over L3 holds for a very fast spin. The slow root is exact.",
                  [](T top, double L3, double angle) -> Rates {
                      return {top.weight / L3,
                              roots(top.across, L3, top.weight, std::cos(angle))[1]};
                  }},
                 {"the two forgotten", "classic", "The top goes round half as fast as it should.",
                  "The product of the roots is m g l/(I1 cos): with far as twice I1 cos times "
                  "the fast rate, the slow one is twice the weight over far.",
                  [](T top, double L3, double angle) -> Rates {
                      const auto [slow, fast] =
                          roots(top.across, L3, top.weight, std::cos(angle));
                      return {slow / 2, fast};
                  }},
                 {"the cosine forgotten below the line", "classic",
                  "Tops that lean go round too slowly.",
                  "Both are divided by twice I1 times the cosine of the angle; your divisor has "
                  "no cosine.",
                  [](T top, double L3, double angle) -> Rates {
                      const double c = std::cos(angle);
                      const auto [slow, fast] = roots(top.across, L3, top.weight, c);
                      return {slow * c, fast * c};
                  }},
                 {"the root not taken", "classic", "A top goes round backwards.",
                  "What stands under the root is taken for the root itself: its std::sqrt is "
                  "missing.",
                  [](T top, double L3, double angle) -> Rates {
                      const double c = std::cos(angle),
                                   root = L3 * L3 - 4 * top.across * top.weight * c;
                      return {(L3 - root) / (2 * top.across * c),
                              (L3 + root) / (2 * top.across * c)};
                  }},
                 {"the root not taken", "classic",
                  "The top is sent round at a wrong speed, and nods.",
                  "What stands under the root is taken for the root itself: its std::sqrt is "
                  "missing.",
                  [](T top, double L3, double angle) -> Rates {
                      const double c = std::cos(angle),
                                   root = L3 * L3 - 4 * top.across * top.weight * c,
                                   far = L3 + std::copysign(root, L3);
                      return {2 * top.weight / far, far / (2 * top.across * c)};
                  }}},
            .alternatives = {{"the school formula, and Vieta",
                              [](T top, double L3, double angle) -> Rates {
                                  const double c = std::cos(angle);
                                  const double fast = roots(top.across, L3, top.weight, c)[1];
                                  return {top.weight / (top.across * c * fast), fast};
                              }}},
        };
    }
#endif
};

inline const bool steady_precession_entered = enter<SteadyPrecession>();

}  // namespace nutshell::exercises
