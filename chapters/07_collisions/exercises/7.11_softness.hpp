// Exercise 7.11: a contact as a damped spring, its step by implicit Euler.
#pragma once
#include <nutshell/contact_solver.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct SoftContact {
    static constexpr const char *id = "7.11", *function = "softness";
    static constexpr auto subject = NUTSHELL_CALL(softness);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        one(paper, answer, 3.0, 0.7, 0.02);
        one(paper, answer, 5.0, 0.7, 0.02);
        one(paper, answer, 3.0, 2.5, 0.02);
        one(paper, answer, 3.0, 0.7, 0.05);
        one(paper, answer, 0.8, 10.0, 0.3);
    }

  private:
    template <class Answer>
    static void one(Paper& paper, const Answer& answer, double frequency, double damping,
                    double h) {
        paper.input("frequency", frequency, "damping", damping, "h", h);
        const Softness soft = answer(frequency, damping, h);
        paper.output("the rate [1/s]", soft.rate, 2 * pi * frequency / damping);
        paper.output("the part of the mass that answers", soft.mass, 1.0);
        paper.output("the part of the impulse given back", soft.fade, 1.0);
    }

  public:
#ifndef NUTSHELL_SHEET
    static About<SoftContact> about() {
        return {
            .title = "A soft contact",
            .hints =
                {"Take the spring's force at the end of the step: what is the depth there, "
                 "and the speed? Chapter 3's implicit Euler does just that.",
                 "Solve for the speed at the end. Everything depends on two numbers: h omega "
                 "and the damping ratio.",
                 "With c = 2 damping + h omega and k = h omega c: rate omega/c, mass k/(1 + "
                 "k), fade 1/(1 + k)."},
            .mistakes =
                {{"turns for radians", "classic: omega = f", "Everything sinks in like in snow.",
                  "omega is 2 pi times the frequency.",
                  [](double frequency, double damping, double h) -> Softness {
                      const double c = 2 * damping + h * frequency, k = h * frequency * c;
                      return {frequency / c, k / (1 + k), 1 / (1 + k)};
                  }},
                 {"explicit Euler's spring", "classic: the force of the start",
                  "A stiff stack explodes.",
                  "You take the depth at the start of the step: h omega is missing beside the "
                  "damping.",
                  [](double frequency, double damping, double h) -> Softness {
                      const double omega = 2 * pi * frequency, c = 2 * damping, k = h * omega * c;
                      return {omega / c, k / (1 + k), 1 / (1 + k)};
                  }},
                 {"half the damping", "classic: the 2 of 2 zeta omega",
                  "Boxes wobble on landing.",
                  "A damping ratio of one is critical: the damping is 2 zeta m omega.",
                  [](double frequency, double damping, double h) -> Softness {
                      const double omega = 2 * pi * frequency, c = damping + h * omega,
                                   k = h * omega * c;
                      return {omega / c, k / (1 + k), 1 / (1 + k)};
                  }},
                 {"all at once", "classic: Baumgarte with rate 1/h",
                  "What overlaps is shot out and hops.",
                  "You undo the whole depth in one step. The speed that does it stays in the "
                  "body.",
                  [](double frequency, double damping, double h) -> Softness {
                      const double omega = 2 * pi * frequency, c = 2 * damping + h * omega,
                                   k = h * omega * c;
                      return {1 / h, k / (1 + k), 1 / (1 + k)};
                  }},
                 {"mass and fade exchanged", "classic",
                  "Stacks feel like jelly, and jelly like stone.",
                  "The part that answers and the part that is given back add up to one, and you "
                  "have them the wrong way round: a stiff contact answers with nearly all of its "
                  "mass.",
                  [](double frequency, double damping, double h) -> Softness {
                      const double omega = 2 * pi * frequency, c = 2 * damping + h * omega,
                                   k = h * omega * c;
                      return {omega / c, 1 / (1 + k), k / (1 + k)};
                  }},
                 {"k in seconds", "classic: an omega forgotten",
                  "Stacks are soft on fast machines.",
                  "k is a number without unit, h omega times c. Your h c is a time.",
                  [](double frequency, double damping, double h) -> Softness {
                      const double omega = 2 * pi * frequency, c = 2 * damping + h * omega,
                                   k = h * c;
                      return {omega / c, k / (1 + k), 1 / (1 + k)};
                  }},
                 {"the step forgotten in the rate", "classic: omega/(2 zeta)",
                  "Deep contacts shoot out.",
                  "Mass and fade are right. The rate is omega/c too, with h omega beside the "
                  "damping.",
                  [](double frequency, double damping, double h) -> Softness {
                      const double omega = 2 * pi * frequency, c = 2 * damping + h * omega,
                                   k = h * omega * c;
                      return {omega / (2 * damping), k / (1 + k), 1 / (1 + k)};
                  }}},
            .alternatives =
                {{"with spring and damper of a unit mass",
                  [](double frequency, double damping, double h) -> Softness {
                      const double omega = 2 * pi * frequency, spring = omega * omega,
                                   damper = 2 * damping * omega;
                      const double both = damper + h * spring;
                      return {spring / both, h * both / (1 + h * both), 1 / (1 + h * both)};
                  }}},
            .survivors = {},
        };
    }
#endif
};

inline const bool softness_entered = enter<SoftContact>();

}  // namespace nutshell::exercises
