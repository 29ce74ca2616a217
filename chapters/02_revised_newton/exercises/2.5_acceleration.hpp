// Exercise 2.5: Newton's law for a body that gains or loses mass.
#pragma once
#include <nutshell/revised_newton.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct AccelerationWithFlow {
    static constexpr const char *id = "2.5", *function = "acceleration";
    static constexpr auto subject = NUTSHELL_CALL(acceleration);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Vector3 f{3.2, -24, 1.7}, g{-5.1, 8.3, 4.4}, exhaust{-8, 5.5, 3.1};
        for (const auto& [force, mass, w, rate] : {std::tuple{f, 2.4, exhaust, -1.3},
                                                   {f, 2.4, exhaust, 0.7},
                                                   {f, 2.4, exhaust, 0.0},
                                                   {g, 2.4, exhaust, -1.3},
                                                   {f, 7.1, exhaust, -1.3},
                                                   {f, 2.4, g, -1.3}}) {
            paper.input("force", force, "mass", mass, "w", w, "mass_rate", rate);
            const Vector3 a = answer(force, mass, w, rate);
            paper.output("the acceleration [m/s^2]", a, force / mass, rate / mass * w);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<AccelerationWithFlow> about() {
        return {
            .title = "Newton's law for a mass that changes",
            .hints = {"Two things change the body's momentum: the forces, and what comes or "
                      "goes. Which of the two does equation (11) forget?",
                      "Equation (11*): the exchanged mass acts like a force. It is large when "
                      "much mass goes, and when it goes fast.",
                      "That force is the velocity relative to the body times dm/dt, sign and "
                      "all. Add it to the forces; then divide by the mass."},
            .mistakes =
                {{"the product rule of K = m v", "E05",
                  "The rocket flies backwards, and a drop that gathers rain shoots ahead.",
                  "You take the exchanged momentum from the force, as the derivative of m v "
                  "seems to say. What comes in at w pushes along w: add it.",
                  [](const Vector3& force, double mass, const Vector3& w,
                     double mass_rate) -> Vector3 { return (force - mass_rate * w) / mass; }},
                 {"no thrust", "classic", "The engine burns and nothing happens.",
                  "You use the forces only. The exchanged mass comes or goes at w and pushes "
                  "too.",
                  [](const Vector3& force, double mass, const Vector3&, double) -> Vector3 {
                      return force / mass;
                  }},
                 {"the thrust forgets the mass", "classic",
                  "A full rocket leaps up like an empty one.",
                  "You divide the force by the mass, but not the thrust. Both are forces [N]: "
                  "divide their sum.",
                  [](const Vector3& force, double mass, const Vector3& w,
                     double mass_rate) -> Vector3 { return force / mass + mass_rate * w; }},
                 {"a force, not an acceleration", "classic",
                  "Everything moves as if it weighed one kilogram.",
                  "You return the whole force. The acceleration is that over the mass.",
                  [](const Vector3& force, double, const Vector3& w,
                     double mass_rate) -> Vector3 { return force + mass_rate * w; }},
                 {"the mass a second later", "classic",
                  "The rocket is a little too lively from the start.",
                  "You divide by the mass plus its rate. A rate is no mass: dm/dt acts through "
                  "the thrust alone; divide by the mass of this moment.",
                  [](const Vector3& force, double mass, const Vector3& w, double mass_rate)
                      -> Vector3 { return (force + mass_rate * w) / (mass + mass_rate); }},
                 {"the thrust without its rate", "classic",
                  "The engine pushes as hard when it is off.",
                  "You add the velocity of the exhaust as if it were a force. It becomes one by "
                  "the mass that goes per second: times dm/dt.",
                  [](const Vector3& force, double mass, const Vector3& w, double) -> Vector3 {
                      return (force + w) / mass;
                  }},
                 {"the rate without its sign", "classic", "Braking with the engine speeds up.",
                  "You take the size of mass_rate. Its sign says whether mass comes or goes.",
                  [](const Vector3& force, double mass, const Vector3& w, double mass_rate)
                      -> Vector3 { return (force + std::abs(mass_rate) * w) / mass; }},
                 {"the thrust divided by the rate", "classic", "A weak engine pushes the most.",
                  "The thrust is w times mass_rate.",
                  [](const Vector3& force, double mass, const Vector3& w,
                     double mass_rate) -> Vector3 { return (force + w / mass_rate) / mass; }},
                 {"pushed against w always", "classic: a rocket taken for granted",
                  "A drop that gathers rain from below is pulled down by it.",
                  "You push against w whatever the sign of mass_rate. That is right where mass "
                  "leaves; what comes in at w pushes along w.",
                  [](const Vector3& force, double mass, const Vector3& w, double mass_rate)
                      -> Vector3 { return (force - std::abs(mass_rate) * w) / mass; }},
                 {"nothing comes in", "classic: a rocket taken for granted",
                  "Rain does not slow the drop.",
                  "You leave the thrust out where the body gains mass. What comes in at w pushes "
                  "along w.",
                  [](const Vector3& force, double mass, const Vector3& w, double mass_rate)
                      -> Vector3 { return (force + std::min(0.0, mass_rate) * w) / mass; }}},
            .alternatives = {{"each part over the mass",
                              [](const Vector3& force, double mass, const Vector3& w,
                                 double mass_rate) -> Vector3 {
                                  return force / mass + (mass_rate / mass) * w;
                              }}},
        };
    }
#endif
};

inline const bool acceleration_with_flow_entered = enter<AccelerationWithFlow>();

}  // namespace nutshell::exercises
