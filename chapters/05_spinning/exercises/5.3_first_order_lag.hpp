// Exercise 5.3: how much of its angle one first-order step leaves out.
#pragma once
#include <nutshell/spinning_limits.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct FirstOrderLag {
    static constexpr const char *id = "5.3", *function = "first_order_lag";
    static constexpr auto subject = NUTSHELL_CALL(first_order_lag);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const double theta : {0.4, 1.3, 2.1, 5.0, -1.3, 0.0}) {
            paper.input("theta", theta);
            const double lag = answer(theta);
            paper.output("the angle left out [rad]", lag, theta == 0 ? 1.0 : theta);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<FirstOrderLag> about() {
        return {
            .title = "Predict the lag",
            .hints = {"Draw the 4-vector (0, 0, 0, 1) and the step that (32) adds, at a right "
                      "angle to it. Which angle do the old and the new one make?",
                      "The tangent of that angle is half of theta. But the 4-vector knows only "
                      "half of the turn.",
                      "The turn made is twice the arc tangent of half of theta. The lag is theta "
                      "less that."},
            .picture = "lag.svg",
            .mistakes =
                {{"the turn made", "classic", "The slower the spin, the smaller the warning.",
                  "You return the angle that is turned, not what is missing.",
                  [](double theta) -> double { return 2 * std::atan(theta / 2); }},
                 {"the first term only", "classic: true for small steps",
                  "The warning for fast wheels is far too large.",
                  "theta^3/12 is where the lag begins for small angles. The arc tangent is all "
                  "of "
                  "it.",
                  [](double theta) -> double { return theta * theta * theta / 12; }},
                 {"the angle of the 4-vectors", "classic: half the angle forgotten",
                  "The prediction is far off for every step.",
                  "The 4-vectors are half of the turn apart: double the arc tangent.",
                  [](double theta) -> double { return theta - std::atan(theta / 2); }},
                 {"the tangent of the whole", "classic: half the angle forgotten",
                  "For small steps the prediction is four times too large.",
                  "The step is half as long as theta: its tangent is theta/2.",
                  [](double theta) -> double { return theta - std::atan(theta); }},
                 {"the sine for the tangent", "classic",
                  "The prediction says that the wheel is early.",
                  "The step touches the circle from outside, so its length is a tangent, not a "
                  "sine.",
                  [](double theta) -> double {
                      return theta - 2 * std::asin(std::clamp(theta / 2, -1.0, 1.0));
                  }},
                 {"twice the arc tangent of the whole", "classic", "The lag comes out negative.",
                  "The 4-vector holds half of the angle: the arc tangent is that of theta/2.",
                  [](double theta) -> double { return theta - 2 * std::atan(theta); }},
                 {"the tangent for its inverse", "classic",
                  "The prediction says that the wheel is early.",
                  "You take the tangent. The angle whose tangent is theta/2 is its inverse, the "
                  "arc tangent.",
                  [](double theta) -> double { return theta - 2 * std::tan(theta / 2); }}},
            .alternatives = {{"by both legs",
                              [](double theta) -> double {
                                  return theta - 2 * std::atan2(theta, 2.0);
                              }}},
        };
    }
#endif
};

inline const bool first_order_lag_entered = enter<FirstOrderLag>();

}  // namespace nutshell::exercises
