// Exercise 2.8: how much must a rocket throw out?
#pragma once
#include <nutshell/revised_newton.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct PropellantFor {
    static constexpr const char *id = "2.8", *function = "propellant_for";
    static constexpr auto subject = NUTSHELL_CALL(propellant_for);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const auto& [gain, u, m0] :
             {std::tuple{40.0, 230.0, 10.0},
              {230.0, 230.0, 10.0},
              {610.0, 230.0, 10.0},
              {610.0, 1800.0, 10.0},
              {610.0, 230.0, 37.0},
              {3e5, 230.0, 10.0}}) {  // all of it, and e^1300 is infinite
            paper.input("gain", gain, "u", u, "m0", m0);
            const double propellant = answer(gain, u, m0);
            paper.output("the propellant [kg]", propellant, m0);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<PropellantFor> about() {
        return {
            .title = "How much to throw out",
            .hints = {"Turn exercise 2.7 round: which mass is left when the gain is reached? "
                      "What is gone then?",
                      "The logarithm of m0/m is gain/u. Undo the logarithm to get m0/m, and from "
                      "it m.",
                      "The mass left is m0 divided by e to the power gain/u. The propellant is "
                      "the rest of m0."},
            .mistakes =
                {{"what is left, not what is thrown", "classic",
                  "The faster the rocket shall be, the less it burns.",
                  "You return the mass after the burn. The propellant is the other part of m0.",
                  [](double gain, double u, double m0) -> double {
                      return m0 * std::exp(-gain / u);
                  }},
                 {"in proportion", "classic",
                  "The planner asks for more propellant than the rocket weighs, or sends it off "
                  "with too much.",
                  "You count the same propellant for each m/s. Near the end the rocket is light, "
                  "and little gives much.",
                  [](double gain, double u, double m0) -> double { return m0 * gain / u; }},
                 {"m0 taken for the mass after", "classic",
                  "The planner asks for more than the whole rocket.",
                  "Your formula takes m0 as the mass that is left. Here m0 is the mass before, "
                  "propellant and all.",
                  [](double gain, double u, double m0) -> double {
                      return m0 * (std::exp(gain / u) - 1);
                  }},
                 {"the two speeds swapped", "classic: upside down",
                  "A better engine needs more propellant.",
                  "You divide the exhaust speed by the gain. It is the gain, counted in exhaust "
                  "speeds, that goes into the exponent.",
                  [](double gain, double u, double m0) -> double {
                      return m0 * (1 - std::exp(-u / gain));
                  }},
                 {"the sign in the exponent", "classic: a sign",
                  "The planner asks for a negative mass, and for an infinite one.",
                  "What is left of m0 falls with the gain: e to the power minus gain/u.",
                  [](double gain, double u, double m0) -> double {
                      return m0 * (1 - std::exp(gain / u));
                  }},
                 {"a logarithm again", "classic: the inverse function",
                  "The planner asks for a negative mass.",
                  "Exercise 2.7 has the logarithm. To undo it you need the exponential.",
                  [](double gain, double u, double m0) -> double {
                      return m0 * std::log(gain / u);
                  }},
                 {"m0 outside the product", "classic", "Small rockets need negative propellant.",
                  "You subtract the exponential from m0. The mass that is left is m0 times the "
                  "exponential.",
                  [](double gain, double u, double m0) -> double {
                      return m0 - std::exp(-gain / u);
                  }},
                 {"powers of ten", "classic", "The planner asks for twice what is needed.",
                  "You use powers of ten. The gain is a natural logarithm, its inverse std::exp.",
                  [](double gain, double u, double m0) -> double {
                      return m0 * (1 - std::pow(10, -gain / u));
                  }},
                 {"powers of two", "classic", "The planner asks for too little.",
                  "You use powers of two. The gain is a natural logarithm, its inverse std::exp.",
                  [](double gain, double u, double m0) -> double {
                      return m0 * (1 - std::exp2(-gain / u));
                  }},
                 {"everything in one parcel", "classic: one throw for a stream",
                  "The planner asks for too little.",
                  "You throw all of it at once: the momentum of one parcel against that of the "
                  "rest. In a stream the early parts must speed up the later ones too, which "
                  "takes more: it is exercise 2.7 solved for the mass.",
                  [](double gain, double u, double m0) -> double {
                      return m0 * gain / (gain + u);
                  }}},
            .alternatives = {{"expm1",
                              [](double gain, double u, double m0) -> double {
                                  return -m0 * std::expm1(-gain / u);
                              }},
                             {"by the mass after",
                              [](double gain, double u, double m0) -> double {
                                  const double after = m0 / std::exp(gain / u);
                                  return m0 - after;
                              }}},
        };
    }
#endif
};

inline const bool propellant_for_entered = enter<PropellantFor>();

}  // namespace nutshell::exercises
