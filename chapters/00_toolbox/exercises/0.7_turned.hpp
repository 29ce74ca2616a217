// Exercise 0.7: a turn in the plane.
#pragma once
#include <nutshell/toolbox.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct Turned {
    static constexpr const char *id = "0.7", *function = "turned";
    static constexpr auto subject = NUTSHELL_CALL(turned);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Complex one{1.7, -0.9}, other{-0.8, 1.3};
        for (const auto& [z, angle] : {std::pair{one, 0.8}, {one, -2.1}, {other, 0.8}}) {
            paper.input("z", std::vector<double>{z.real(), z.imag()}, "angle", angle);
            const Complex found = answer(z, angle);
            paper.output("the turned point", std::vector<double>{found.real(), found.imag()},
                         std::abs(z));
        }
    }

#ifndef NUTSHELL_SHEET
    static About<Turned> about() {
        return {
            .title = "A turn by any angle",
            .hints = {"Multiplying by a number of size 1 turns. Which number turns by the angle?",
                      "It lies on the unit circle: its parts are the cosine and the sine of the "
                      "angle.",
                      "Multiply z by Complex{cosine, sine}."},
            .picture = "turns.svg",
            .mistakes =
                {{"clockwise", "classic: a sign", "The wheel turns backwards.",
                  "You turn the other way. A positive angle is counter-clockwise: plus the sine "
                  "in the imaginary part.",
                  [](Complex z, double angle) -> Complex { return z * std::polar(1.0, -angle); }},
                 {"in degrees", "classic: degrees and radians", "Everything hardly turns.",
                  "You convert from degrees, and the angle comes in radians.",
                  [](Complex z, double angle) -> Complex {
                      return z * std::polar(1.0, angle * pi / 180);
                  }},
                 {"added, not multiplied", "classic", "The wheel slides instead of turning.",
                  "You add the turn to the point. Turning is multiplying.",
                  [](Complex z, double angle) -> Complex { return z + std::polar(1.0, angle); }},
                 {"one small step", "classic: 1 + i angle", "The wheel grows as it turns.",
                  "1 + i times the angle is the start of a turn: it is longer than 1 and so "
                  "makes the point larger.",
                  [](Complex z, double angle) -> Complex {
                      return z * Complex{1, angle};
                  }},
                 {"turned to the angle, not by it", "classic", "Every stick points the same way.",
                  "You put the point at that angle and forget the angle it had. Turning adds to "
                  "it: multiply.",
                  [](Complex z, double angle) -> Complex {
                      return std::polar(std::abs(z), angle);
                  }},
                 {"sine and cosine exchanged", "classic", "Turning by nothing is a mirror.",
                  "The real part of the factor is the cosine, the imaginary part the sine.",
                  [](Complex z, double angle) -> Complex {
                      return z * Complex{std::sin(angle), std::cos(angle)};
                  }},
                 {"the new x used for y", "classic", "What turns gets smaller or larger.",
                  "You have overwritten x when y is worked out. Both need the x from before.",
                  [](Complex z, double angle) -> Complex {
                      const double x = z.real() * std::cos(angle) - z.imag() * std::sin(angle);
                      return {x, x * std::sin(angle) + z.imag() * std::cos(angle)};
                  }},
                 {"the angle of the point twice", "classic",
                  "Points fly round the faster the further they are turned.",
                  "You use the angle that the point has once more. Multiply by the factor of the "
                  "turn alone.",
                  [](Complex z, double angle) -> Complex {
                      return std::polar(std::abs(z), 2 * std::arg(z) + angle);
                  }},
                 {"each part for itself", "classic", "The wheel is squeezed flat.",
                  "You stretch each part for itself. A turn mixes them: x takes from y, and y "
                  "from x.",
                  [](Complex z, double angle) -> Complex {
                      return {z.real() * std::cos(angle), z.imag() * std::sin(angle)};
                  }},
                 {"the i forgotten", "classic: e to a real power",
                  "The wheel grows and never turns.",
                  "You multiply by e to the angle, a real number, which makes the point longer "
                  "or shorter and never turns it. The i is missing.",
                  [](Complex z, double angle) -> Complex { return z * std::exp(angle); }},
                 {"the angle of the point by the arc cosine", "classic: acos for atan2",
                  "What is below is turned as if it were above.",
                  "You find the angle of the point by an arc cosine. It cannot tell a point "
                  "below the axis from the one above; std::arg can, and multiplying needs no "
                  "angle of the point.",
                  [](Complex z, double angle) -> Complex {
                      return std::polar(std::abs(z), std::acos(z.real() / std::abs(z)) + angle);
                  }}},
            .alternatives = {{"polar",
                              [](Complex z, double angle) -> Complex {
                                  return z * std::polar(1.0, angle);
                              }},
                             {"the exponential of i angle",
                              [](Complex z, double angle) -> Complex {
                                  return z * std::exp(Complex{0, angle});
                              }},
                             {"by components",
                              [](Complex z, double angle) -> Complex {
                                  return {
                                      z.real() * std::cos(angle) - z.imag() * std::sin(angle),
                                      z.real() * std::sin(angle) + z.imag() * std::cos(angle)};
                              }}},
        };
    }
#endif
};

inline const bool turned_entered = enter<Turned>();

}  // namespace nutshell::exercises
