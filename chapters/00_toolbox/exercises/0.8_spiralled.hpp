// Exercise 0.8: a complex rate.
#pragma once
#include <nutshell/toolbox.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct Spiralled {
    static constexpr const char *id = "0.8", *function = "spiralled";
    static constexpr auto subject = NUTSHELL_CALL(spiralled);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Complex one{1.2, 0.7}, other{-0.6, -1.1}, slow{-0.4, 1.9}, fast{0.3, -0.8};
        for (const auto& [z, lambda, t] : {std::tuple{one, slow, 1.4},
                                           {one, fast, 1.4},
                                           {other, slow, 1.4},
                                           {one, slow, 0.5}}) {
            paper.input("z", std::vector<double>{z.real(), z.imag()}, "lambda",
                        std::vector<double>{lambda.real(), lambda.imag()}, "t", t);
            const Complex found = answer(z, lambda, t);
            paper.output("the point after t", std::vector<double>{found.real(), found.imag()},
                         3.0);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<Spiralled> about() {
        return {
            .title = "Turn and fade",
            .hints = {"Two things happen to the point, and neither disturbs the other.",
                      "The real part of lambda is a rate for grown, the imaginary part an angle "
                      "per second for turned.",
                      "Multiply z by grown(1, real part, t), then turn it by the imaginary part "
                      "times t."},
            .picture = "turns.svg",
            .mistakes =
                {{"it only turns", "classic: no damping", "The spring swings for ever.",
                  "The real part of lambda is not used: nothing grows or fades.",
                  [](Complex z, Complex lambda, double t) -> Complex {
                      return z * std::polar(1.0, lambda.imag() * t);
                  }},
                 {"it only fades", "classic", "Nothing swings.",
                  "The imaginary part of lambda is not used: nothing turns.",
                  [](Complex z, Complex lambda, double t) -> Complex {
                      return z * std::exp(lambda.real() * t);
                  }},
                 {"the angle without the time", "classic", "The spring stands still at an angle.",
                  "The imaginary part is an angle per second. Multiply it by the time.",
                  [](Complex z, Complex lambda, double t) -> Complex {
                      return z * std::exp(lambda.real() * t) * std::polar(1.0, lambda.imag());
                  }},
                 {"one straight step", "classic: Euler's method in one step",
                  "What should fade flies out.",
                  "You make one step with the change at the start, z + lambda z t. On "
                  "the way the change turns and shrinks with z.",
                  [](Complex z, Complex lambda, double t) -> Complex {
                      return z + lambda * z * t;
                  }},
                 {"the growth without the time", "classic", "Everything has faded at once.",
                  "The real part is a rate per second. Multiply it by the time.",
                  [](Complex z, Complex lambda, double t) -> Complex {
                      return z * std::exp(lambda.real()) * std::polar(1.0, lambda.imag() * t);
                  }},
                 {"turns the other way", "classic", "The spring runs backwards.",
                  "The imaginary part turns counter-clockwise where it is positive.",
                  [](Complex z, Complex lambda, double t) -> Complex {
                      return z * std::exp(lambda.real() * t) *
                             std::polar(1.0, -lambda.imag() * t);
                  }},
                 {"the start forgotten", "classic", "Every spring begins at 1.",
                  "You return the factor alone: z is multiplied by it.",
                  [](Complex z, Complex lambda, double t) -> Complex {
                      return std::exp(lambda * t) + 0.0 * z;
                  }},
                 {"the size of lambda for its real part", "classic", "What should fade explodes.",
                  "It grows with the real part of lambda alone, not with the size of lambda.",
                  [](Complex z, Complex lambda, double t) -> Complex {
                      return z * std::exp(std::abs(lambda) * t) *
                             std::polar(1.0, lambda.imag() * t);
                  }},
                 {"the sign of the growth", "classic", "What should fade explodes.",
                  "The real part of lambda enters with its own sign: negative fades.",
                  [](Complex z, Complex lambda, double t) -> Complex {
                      return z * std::exp(-lambda.real() * t) *
                             std::polar(1.0, lambda.imag() * t);
                  }},
                 {"the angle of lambda for its imaginary part", "classic",
                  "The spring swings at the wrong rate.",
                  "You turn by the argument of lambda. The rate of turning is its imaginary "
                  "part.",
                  [](Complex z, Complex lambda, double t) -> Complex {
                      return z * std::exp(lambda.real() * t) *
                             std::polar(1.0, std::arg(lambda) * t);
                  }},
                 {"real and imaginary part exchanged", "classic", "What should swing explodes.",
                  "You grow by the imaginary part and turn by the real one. The real part is the "
                  "growth, the "
                  "imaginary part the turn.",
                  [](Complex z, Complex lambda, double t) -> Complex {
                      return z * std::exp(lambda.imag() * t) * std::polar(1.0, lambda.real() * t);
                  }},
                 {"size and angle of lambda for its parts", "classic: polar for Cartesian",
                  "What should fade explodes.",
                  "You grow by the size of lambda and turn by its argument. The growth is its "
                  "real part, the turn its imaginary part.",
                  [](Complex z, Complex lambda, double t) -> Complex {
                      return z * std::exp(std::abs(lambda) * t) *
                             std::polar(1.0, std::arg(lambda) * t);
                  }},
                 {"lambda to the power of the time", "classic: a factor per second",
                  "What should fade explodes.",
                  "You multiply by lambda once a second. lambda z is what z changes by per "
                  "second, at every moment: that makes an exponential.",
                  [](Complex z, Complex lambda, double t) -> Complex {
                      return z * std::pow(lambda, t);
                  }},
                 {"the cosine alone", "classic: the shadow of a turn",
                  "The spring swings along a line in the plane.",
                  "You multiply by the cosine only: that is the shadow of a turn. The turn "
                  "itself has a sine beside it, in the imaginary part.",
                  [](Complex z, Complex lambda, double t) -> Complex {
                      return z * std::exp(lambda.real() * t) * std::cos(lambda.imag() * t);
                  }}},
            .alternatives = {{"the complex exponential",
                              [](Complex z, Complex lambda, double t) -> Complex {
                                  return z * std::exp(lambda * t);
                              }},
                             {"polar",
                              [](Complex z, Complex lambda, double t) -> Complex {
                                  return z * std::polar(std::exp(lambda.real() * t),
                                                        lambda.imag() * t);
                              }}},
        };
    }
#endif
};

inline const bool spiralled_entered = enter<Spiralled>();

}  // namespace nutshell::exercises
