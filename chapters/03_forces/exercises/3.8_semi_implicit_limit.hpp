// Exercise 3.8: the largest stable step of semi-implicit Euler on a damped spring.
#pragma once
#include <nutshell/stability_limits.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

#ifndef NUTSHELL_SHEET
inline double limit_dividing_by_zero(double omega, double nu) {
    return (-nu + std::sqrt(nu * nu + 4 * omega * omega)) / (omega * omega);
}
#endif

struct SemiImplicitLimit {
    static constexpr const char *id = "3.8", *function = "semi_implicit_limit";
    static constexpr auto subject = NUTSHELL_CALL(semi_implicit_limit);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const auto& [omega, nu] : {std::pair{3.0, 0.0},
                                        {3.0, 0.7},
                                        {1.4, 2.1},
                                        {2.5, 5.0},
                                        {3.0, 14.5},
                                        {1e-5, 4.0},
                                        {1e-9, 4.0},
                                        {0.0, 4.0}}) {
            paper.input("omega", omega, "nu", nu);
            const double limit = answer(omega, nu);
            paper.output("the largest stable step [s]", limit, 1 / (omega + nu));
        }
    }

#ifndef NUTSHELL_SHEET
    static About<SemiImplicitLimit> about() {
        return {
            .title = "Semi-implicit Euler's limit",
            .hints =
                {"Write one step as a two by two matrix on x and v. Its determinant and its "
                 "trace say whether anything grows.",
                 "With theta = omega dt and G = nu dt the determinant is 1 - G and the trace "
                 "2 - G - theta^2. It is stable while |trace| stays below 1 + determinant.",
                 "The condition is theta^2 + 2 G = 4: a quadratic in dt. Write its positive "
                 "root so that neither nu = 0 nor omega = 0 is a division by zero."},
            .picture = "regions_spring.svg",
            .mistakes =
                {{"the drag left out", "classic",
                  "A damped spring explodes at a step that was safe without damping.",
                  "2/omega is the limit without drag. Drag in the kick makes it smaller.",
                  [](double omega, double) -> double { return 2 / omega; }},
                 {"implicit drag", "classic: the sign of nu", "A damped spring explodes.",
                  "With a plus you have the limit for implicit drag, v/(1 + nu dt), which "
                  "grows with nu. With the drag in the kick it shrinks.",
                  [](double omega, double nu) -> double {
                      return (nu + std::sqrt(nu * nu + 4 * omega * omega)) / (omega * omega);
                  }},
                 {"the limit of drag alone", "classic", "A stiff spring explodes.",
                  "2/nu is the limit without spring. Both enter.",
                  [](double, double nu) -> double { return 2 / nu; }},
                 {"no spring is a division by zero", "classic",
                  "Where there is only drag, the step becomes NaN.",
                  "The formula is right, but for omega = 0 it is zero over zero, and "
                  "near it loses its digits. Multiply above and below by the same sum.",
                  [](double omega, double nu) -> double {
                      return (-nu + std::sqrt(nu * nu + 4 * omega * omega)) / (omega * omega);
                  }},
                 {"the digits cancel", "classic: a difference of neighbours",
                  "With much drag and a weak spring the step is noise, or zero.",
                  "The formula is right, and no spring at all is looked after. But for a "
                  "weak one the root is nearly nu, and the difference loses its digits. "
                  "Multiply above and below by the same sum.",
                  [](double omega, double nu) -> double {
                      return omega == 0 ? 2 / nu : limit_dividing_by_zero(omega, nu);
                  }},
                 {"Euler's limit", "classic",
                  "The step is far smaller than it need be, or zero without drag.",
                  "This is Euler's limit. Semi-implicit Euler kicks first, and its "
                  "matrix is another.",
                  [](double omega, double nu) -> double {
                      if (nu * nu < 4 * omega * omega) return nu / (omega * omega);
                      return 4 / (nu + std::sqrt(nu * nu - 4 * omega * omega));
                  }},
                 {"half the limit", "classic: a lost factor", "Stable, at twice the cost.",
                  "At theta^2 + 2 G = 4 the root gives 4 over the sum, not 2.",
                  [](double omega, double nu) -> double {
                      return 2 / (nu + std::sqrt(nu * nu + 4 * omega * omega));
                  }},
                 {"the lesser of two limits", "classic",
                  "With spring and drag together it explodes.",
                  "You take the lesser of the limits for spring and drag alone. Together they "
                  "leave less than either.",
                  [](double omega, double nu) -> double { return std::min(2 / omega, 2 / nu); }},
                 {"the 4 under the root lost", "classic: the quadratic formula",
                  "A stiff spring explodes.",
                  "The discriminant of the quadratic is nu^2 + 4 omega^2.",
                  [](double omega, double nu) -> double {
                      return 4 / (nu + std::sqrt(nu * nu + omega * omega));
                  }}},
            .alternatives = {{"by bisection",
                              [](double omega, double nu) -> double {
                                  // trace and determinant of one step: stable while
                                  // omega^2 dt^2 + 2 nu dt < 4
                                  double low = 0, high = 4 / (omega + nu);
                                  for (int turn = 0; turn < 200; ++turn) {
                                      const double dt = (low + high) / 2;
                                      (omega * omega * dt * dt + 2 * nu * dt < 4 ? low : high) =
                                          dt;
                                  }
                                  return low;
                              }}},
        };
    }
#endif
};

inline const bool semi_implicit_limit_entered = enter<SemiImplicitLimit>();

}  // namespace nutshell::exercises
