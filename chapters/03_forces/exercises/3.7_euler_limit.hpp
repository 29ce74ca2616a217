// Exercise 3.7: the largest stable step of Euler's method on a damped spring.
#pragma once
#include <nutshell/stability_limits.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct EulerLimit {
    static constexpr const char *id = "3.7", *function = "euler_limit";
    static constexpr auto subject = NUTSHELL_CALL(euler_limit);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const double nu : {0.0, 0.7, 3.3, 5.0, 5.9999})  // swings; without drag it never is
            ask_one(paper, answer, 3.0, nu);
        ask_one(paper, answer, 2.5, 5.0);                       // just creeps
        for (const double nu : {6.0001, 6.6, 8.0, 10.5, 14.5})  // creeps
            ask_one(paper, answer, 3.0, nu);
        ask_one(paper, answer, 1.4, 2.1);
        ask_one(paper, answer, 1.4, 14.5);
        ask_one(paper, answer, 0.0, 4.0);  // drag alone
    }

  private:
    template <class Answer>
    static void ask_one(Paper& paper, const Answer& answer, double omega, double nu) {
        paper.input("omega", omega, "nu", nu);
        const double limit = answer(omega, nu);
        paper.output("the largest stable step [s]", limit, 1 / (omega + nu));
    }

  public:
#ifndef NUTSHELL_SHEET
    static About<EulerLimit> about() {
        return {
            .title = "Euler's limit",
            .hints =
                {"Euler multiplies each rate's part by 1 + lambda dt every step. Stable "
                 "means that no part grows. Which two rates has the damped spring?",
                 "lambda = -nu/2 plus or minus the root of nu^2/4 - omega^2. Where the root "
                 "is imaginary, ask when |1 + lambda dt| reaches one; where it is real, ask "
                 "when the faster rate times dt reaches minus two.",
                 "Underdamped: |1 + lambda dt|^2 = 1 - nu dt + omega^2 dt^2. Overdamped: the "
                 "faster rate is -(nu + root of (nu^2 - 4 omega^2))/2, and it must not pass "
                 "-2/dt."},
            .picture = "regions.svg",
            .mistakes =
                {{"the limit of drag alone", "classic",
                  "The spring explodes although the drag alone would be stable.",
                  "You took the limit of the drag without the spring. The spring's rate enters "
                  "too.",
                  [](double, double nu) -> double { return 2 / nu; }},
                 {"the swinging case only", "classic", "A strongly damped spring explodes.",
                  "nu/omega^2 holds while the spring swings. Where it creeps, the faster of the "
                  "two real rates decides, and its limit is smaller.",
                  [](double omega, double nu) -> double { return nu / (omega * omega); }},
                 {"Verlet's limit", "E04's claim", "A lightly damped spring explodes at once.",
                  "2/omega is the limit of Verlet and of semi-implicit Euler. Euler's is "
                  "nu/omega^2: without drag it has none but zero.",
                  [](double omega, double) -> double { return 2 / omega; }},
                 {"the slow rate", "classic: the wrong root",
                  "A strongly damped spring explodes.",
                  "You took the slower of the two rates. The faster one breaks first: plus "
                  "before the root.",
                  [](double omega, double nu) -> double {
                      if (nu * nu < 4 * omega * omega) return nu / (omega * omega);
                      return 4 / (nu - std::sqrt(nu * nu - 4 * omega * omega));
                  }},
                 {"a factor of two", "classic",
                  "The step is twice the stable one, and a lightly damped spring explodes.",
                  "|1 + lambda dt|^2 = 1 - nu dt + omega^2 dt^2 is one at dt = nu/omega^2.",
                  [](double omega, double nu) -> double {
                      if (nu * nu < 4 * omega * omega) return 2 * nu / (omega * omega);
                      return 4 / (nu + std::sqrt(nu * nu - 4 * omega * omega));
                  }},
                 {"1 instead of 2", "classic", "Stable, at twice the cost.",
                  "Beyond 1/rate Euler overshoots but comes back. It is unstable only beyond "
                  "2/rate.",
                  [](double omega, double nu) -> double {
                      if (nu * nu < 4 * omega * omega) return nu / (omega * omega);
                      return 2 / (nu + std::sqrt(nu * nu - 4 * omega * omega));
                  }},
                 {"Verlet's limit while it swings", "E04's claim",
                  "A lightly damped spring explodes.",
                  "Where it creeps you are right. Where it swings the limit is nu/omega^2: "
                  "without drag Euler has none but zero. 2/omega is Verlet's.",
                  [](double omega, double nu) -> double {
                      if (nu * nu < 4 * omega * omega) return 2 / omega;
                      return 4 / (nu + std::sqrt(nu * nu - 4 * omega * omega));
                  }},
                 {"the limit of drag alone where it creeps", "classic",
                  "Stable, at up to twice the cost.",
                  "Where it swings you are right. Where it creeps you take the limit of the drag "
                  "alone, but the faster of the two rates is less than nu, so the limit is "
                  "larger.",
                  [](double omega, double nu) -> double {
                      return nu < 2 * omega ? nu / (omega * omega) : 2 / nu;
                  }},
                 {"omega not squared", "classic: a unit that does not fit",
                  "A stiff spring explodes.",
                  "Where it creeps you are right. Where it swings yours is nu over omega, a "
                  "number without a unit: a step is a time.",
                  [](double omega, double nu) -> double {
                      if (nu * nu < 4 * omega * omega) return nu / omega;
                      return 4 / (nu + std::sqrt(nu * nu - 4 * omega * omega));
                  }}},
            .alternatives = {{"by the rates",
                              [](double omega, double nu) -> double {
                                  // both |1 + lambda dt| < 1:  dt < -2 Re(lambda)/|lambda|^2
                                  const auto rates = spring_rates(omega, nu);
                                  double least = std::numeric_limits<double>::infinity();
                                  for (const Complex& rate : rates)
                                      if (std::norm(rate) > 0)
                                          least =
                                              std::min(least, -2 * rate.real() / std::norm(rate));
                                  return std::max(0.0, least);
                              }}},
            .survivors = {{"< to <=", "at nu = 2 omega both limits are 2/omega"}},
        };
    }
#endif
};

inline const bool euler_limit_entered = enter<EulerLimit>();

}  // namespace nutshell::exercises
