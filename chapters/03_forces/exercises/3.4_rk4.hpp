// Exercise 3.4: the classical Runge-Kutta step.
#pragma once
#include <nutshell/runge_kutta.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct RungeKutta4 {
    static constexpr const char *id = "3.4", *function = "rk4";
    static constexpr auto subject = NUTSHELL_CALL(rk4);

    /// A pendulum that is pushed: not linear, and it depends on the time.
    struct Pendulum {
        double gravity;
        Eigen::Vector2d operator()(const Eigen::Vector2d& y, double t) const {
            return {y[1] + 0.1 * t, -gravity * std::sin(y[0]) - 0.4 * y[1] + t * t};
        }
    };

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const double dt = paper.step(0.2);
        const Eigen::Vector2d one(0.9, -1.3), other(-0.4, 2.2);
        for (const auto& [start, gravity, t] :
             {std::tuple{one, 3.7, 0.0}, {one, 3.7, 1.4}, {other, 3.7, 0.0}, {one, 9.8, 0.0}}) {
            const Pendulum pendulum{gravity};
            paper.input("a pushed pendulum, angle and rate", start, "gravity", gravity, "t", t,
                        "dt", dt);
            const Eigen::Vector2d end = answer(start, pendulum, t, dt);
            paper.changed("the state after the step", end, start,
                          Eigen::Vector2d(pendulum(start, t) * dt));
        }
        const double large = paper.step(0.8);  // where methods of one order differ
        paper.input("a pushed pendulum, angle and rate", one, "gravity", 3.7, "t", 0.0, "dt",
                    large);
        const Eigen::Vector2d far = answer(one, Pendulum{3.7}, 0.0, large);
        paper.changed("the state after the step", far, one,
                      Eigen::Vector2d(Pendulum{3.7}(one, 0) * large));
        const int steps = static_cast<int>(std::lround(1 / paper.step(1.0 / 8)));
        paper.input("y' = -y + 2 t from y = 1, for 1 s in", steps, "steps");
        Eigen::Vector2d y(1, 0);
        const auto f = [](const Eigen::Vector2d& at, double t) -> Eigen::Vector2d {
            return {-at[0] + 2 * t, at[0] - 2 * at[1]};
        };
        for (int i = 0; i < steps; ++i)
            y = answer(y, f, i / static_cast<double>(steps), 1.0 / steps);
        paper.run("the first number at the end", y[0], 3 * std::exp(-1.0), 1.0);
    }

#ifndef NUTSHELL_SHEET
    static About<RungeKutta4> about() {
        return {
            .title = "A step of RK4",
            .hints = {"Four looks at the rate: one at the start, two in the middle, one at the "
                      "end. Each look stands where the one before it pointed.",
                      "The second look goes half a step along the first rate, the third half a "
                      "step along the second, the fourth a whole step along the third. Each at "
                      "its own time.",
                      "The mean of the four rates: the two in the middle count twice, the outer "
                      "ones once. What must the sum be divided by?"},
            .order = 4,
            .mistakes =
                {{"the fourth look half way", "classic",
                  "It is no better than the midpoint rule, at twice the cost.",
                  "The fourth rate is that of the end: a whole step along the third, at t + dt.",
                  []<class Flat, class Rate>(const Flat& y, const Rate& f, double t,
                                             double dt) -> Flat {
                      const Flat k1 = f(y, t), k2 = f(Flat(y + dt / 2 * k1), t + dt / 2),
                                 k3 = f(Flat(y + dt / 2 * k2), t + dt / 2),
                                 k4 = f(Flat(y + dt / 2 * k3), t + dt / 2);
                      return y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
                  }},
                 {"equal weights", "classic",
                  "Halving the step halves the error only, or quarters it; never a sixteenth.",
                  "You give all four rates the same weight. The two in the middle count twice, "
                  "and the sum is divided by six.",
                  []<class Flat, class Rate>(const Flat& y, const Rate& f, double t,
                                             double dt) -> Flat {
                      const Flat k1 = f(y, t), k2 = f(Flat(y + dt / 2 * k1), t + dt / 2),
                                 k3 = f(Flat(y + dt / 2 * k2), t + dt / 2),
                                 k4 = f(Flat(y + dt * k3), t + dt);
                      return y + dt / 4 * (k1 + k2 + k3 + k4);
                  }},
                 {"the third look repeats the second", "classic: copy and paste",
                  "The order drops to two or three.",
                  "k3 is found by going along k2, not along k1 again. That correction is what "
                  "the third look is for.",
                  []<class Flat, class Rate>(const Flat& y, const Rate& f, double t,
                                             double dt) -> Flat {
                      const Flat k1 = f(y, t), k2 = f(Flat(y + dt / 2 * k1), t + dt / 2),
                                 k3 = f(Flat(y + dt / 2 * k1), t + dt / 2),
                                 k4 = f(Flat(y + dt * k3), t + dt);
                      return y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
                  }},
                 {"time stands still", "classic",
                  "Forces that change with time act late; all is well where they do not.",
                  "The looks in the middle are at t + dt/2, the last is at t + dt. You ask for "
                  "all at t.",
                  []<class Flat, class Rate>(const Flat& y, const Rate& f, double t,
                                             double dt) -> Flat {
                      const Flat k1 = f(y, t), k2 = f(Flat(y + dt / 2 * k1), t),
                                 k3 = f(Flat(y + dt / 2 * k2), t), k4 = f(Flat(y + dt * k3), t);
                      return y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
                  }},
                 {"Euler's step", "classic", "Everything drifts off as in chapter 1.",
                  "You look once, at the start. That is Euler's method.",
                  []<class Flat, class Rate>(const Flat& y, const Rate& f, double t,
                                             double dt) -> Flat { return y + dt * f(y, t); }},
                 {"the midpoint rule", "classic: RK2",
                  "The error falls to a quarter when the step is halved, not to a sixteenth.",
                  "Two looks make the midpoint rule, of second order. RK4 looks four times.",
                  []<class Flat, class Rate>(const Flat& y, const Rate& f, double t, double dt)
                      -> Flat { return explicit_midpoint(y, f, t, dt); }},
                 {"no division by six", "classic", "Everything moves six times too far.",
                  "The weights 1, 2, 2, 1 add up to six: divide by it.",
                  []<class Flat, class Rate>(const Flat& y, const Rate& f, double t,
                                             double dt) -> Flat {
                      const Flat k1 = f(y, t), k2 = f(Flat(y + dt / 2 * k1), t + dt / 2),
                                 k3 = f(Flat(y + dt / 2 * k2), t + dt / 2),
                                 k4 = f(Flat(y + dt * k3), t + dt);
                      return y + dt * (k1 + 2 * k2 + 2 * k3 + k4);
                  }},
                 {"the middle rates counted once", "classic: the weights",
                  "Everything moves by two thirds of its way.",
                  "You divide by six, but count the two rates in the middle once: the weights "
                  "are 1, 2, 2, 1.",
                  []<class Flat, class Rate>(const Flat& y, const Rate& f, double t,
                                             double dt) -> Flat {
                      const Flat k1 = f(y, t), k2 = f(Flat(y + dt / 2 * k1), t + dt / 2),
                                 k3 = f(Flat(y + dt / 2 * k2), t + dt / 2),
                                 k4 = f(Flat(y + dt * k3), t + dt);
                      return y + dt / 6 * (k1 + k2 + k3 + k4);
                  }},
                 {"the looks forget dt", "classic: a rate for a way",
                  "With small steps the looks stand far away, and it gets worse.",
                  "You go along the rates as if they were ways. A rate times dt is a way: y + "
                  "dt/2 k1.",
                  []<class Flat, class Rate>(const Flat& y, const Rate& f, double t,
                                             double dt) -> Flat {
                      const Flat k1 = f(y, t), k2 = f(Flat(y + k1 / 2), t + dt / 2),
                                 k3 = f(Flat(y + k2 / 2), t + dt / 2),
                                 k4 = f(Flat(y + k3), t + dt);
                      return y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
                  }},
                 {"Heun's method", "classic: RK2",
                  "The error falls to a quarter when the step is halved, not to a sixteenth.",
                  "The mean of the rates at the start and at the end is Heun's method, of second "
                  "order. RK4 looks twice in the middle too.",
                  []<class Flat, class Rate>(const Flat& y, const Rate& f, double t,
                                             double dt) -> Flat {
                      const Flat k1 = f(y, t), k2 = f(Flat(y + dt * k1), t + dt);
                      return y + dt / 2 * (k1 + k2);
                  }},
                 {"whole steps to the middle", "classic", "The order drops to one.",
                  "The looks in the middle are half a step away: dt/2 times the rate.",
                  []<class Flat, class Rate>(const Flat& y, const Rate& f, double t,
                                             double dt) -> Flat {
                      const Flat k1 = f(y, t);
                      const Flat k2 = f(Flat(y + dt * k1), t + dt / 2),
                                 k3 = f(Flat(y + dt * k2), t + dt / 2),
                                 k4 = f(Flat(y + dt * k3), t + dt);
                      return y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
                  }},
                 {"the fourth look from the second", "classic", "The order drops to three.",
                  "k4 is found by going along k3, the better of the two in the middle.",
                  []<class Flat, class Rate>(const Flat& y, const Rate& f, double t,
                                             double dt) -> Flat {
                      const Flat k1 = f(y, t);
                      const Flat k2 = f(Flat(y + dt / 2 * k1), t + dt / 2),
                                 k3 = f(Flat(y + dt / 2 * k2), t + dt / 2),
                                 k4 = f(Flat(y + dt * k2), t + dt);
                      return y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
                  }},
                 {"the outer rates twice", "classic", "The order drops to two.",
                  "The two rates in the middle count twice, not those of the ends.",
                  []<class Flat, class Rate>(const Flat& y, const Rate& f, double t,
                                             double dt) -> Flat {
                      const Flat k1 = f(y, t);
                      const Flat k2 = f(Flat(y + dt / 2 * k1), t + dt / 2),
                                 k3 = f(Flat(y + dt / 2 * k2), t + dt / 2),
                                 k4 = f(Flat(y + dt * k3), t + dt);
                      return y + dt / 6 * (2 * k1 + k2 + k3 + 2 * k4);
                  }},
                 {"the fourth look at the middle's time", "classic",
                  "Forces that change with time act late.",
                  "k4 stands at the end of the step: its time is t + dt.",
                  []<class Flat, class Rate>(const Flat& y, const Rate& f, double t,
                                             double dt) -> Flat {
                      const Flat k1 = f(y, t);
                      const Flat k2 = f(Flat(y + dt / 2 * k1), t + dt / 2),
                                 k3 = f(Flat(y + dt / 2 * k2), t + dt / 2),
                                 k4 = f(Flat(y + dt * k3), t + dt / 2);
                      return y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
                  }},
                 {"each look goes on from the one before", "classic",
                  "The looks walk beyond the step.",
                  "Each look starts from y, not from the place of the look before.",
                  []<class Flat, class Rate>(const Flat& y, const Rate& f, double t,
                                             double dt) -> Flat {
                      const Flat k1 = f(y, t);
                      const Flat y2 = y + dt / 2 * k1, k2 = f(y2, t + dt / 2),
                                 y3 = y2 + dt / 2 * k2, k3 = f(y3, t + dt / 2), y4 = y3 + dt * k3,
                                 k4 = f(y4, t + dt);
                      return y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
                  }},
                 {"the last rate alone", "classic", "It is of first order.",
                  "You go with the last rate alone. The step is the weighted mean of all four.",
                  []<class Flat, class Rate>(const Flat& y, const Rate& f, double t,
                                             double dt) -> Flat {
                      const Flat k1 = f(y, t), k2 = f(Flat(y + dt / 2 * k1), t + dt / 2),
                                 k3 = f(Flat(y + dt / 2 * k2), t + dt / 2),
                                 k4 = f(Flat(y + dt * k3), t + dt);
                      return y + dt * k4;
                  }},
                 {"Kutta's 3/8 rule", "classic: the other method of 1901",
                  "None to speak of: it is as good as the one asked for.",
                  "Your looks stand at one and two thirds of the step. That is Kutta's 3/8 rule, "
                  "of fourth order too; the classical method looks twice in the middle, with the "
                  "weights 1, 2, 2, 1.",
                  []<class Flat, class Rate>(const Flat& y, const Rate& f, double t,
                                             double dt) -> Flat {
                      const Flat k1 = f(y, t), k2 = f(Flat(y + dt / 3 * k1), t + dt / 3),
                                 k3 = f(Flat(y + dt * (k2 - k1 / 3.0)), t + 2 * dt / 3),
                                 k4 = f(Flat(y + dt * (k1 - k2 + k3)), t + dt);
                      return y + dt / 8 * (k1 + 3 * k2 + 3 * k3 + k4);
                  }}},
            .alternatives = {{"by increments",
                              []<class Flat, class Rate>(const Flat& y, const Rate& f, double t,
                                                         double dt) -> Flat {
                                  const Flat a = dt * f(y, t),
                                             b = dt * f(Flat(y + a / 2), t + dt / 2),
                                             c = dt * f(Flat(y + b / 2), t + dt / 2),
                                             d = dt * f(Flat(y + c), t + dt);
                                  return y + (a + d) / 6 + (b + c) / 3;
                              }}},
        };
    }
#endif
};

inline const bool rk4_entered = enter<RungeKutta4>();

}  // namespace nutshell::exercises
