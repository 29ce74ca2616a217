// Exercise 1.3: one step of Euler's method.
#pragma once
#include "steps.hpp"

namespace nutshell::exercises {

struct Euler {
    static constexpr const char *id = "1.3", *function = "euler";
    static constexpr auto subject = NUTSHELL_CALL(euler);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        ask_step(paper, answer, 0.4);
    }

#ifndef NUTSHELL_SHEET
    static About<Euler> about() {
        return {
            .title = "A step of Euler's method",
            .hints = {"Everything on the right of eqs. (8) and (9) belongs to the start of the "
                      "step: the place, the velocity and the force.",
                      "drift changes the place, and the force depends on the place. What must "
                      "you ask for, and keep, before you drift?",
                      "Three lines and a return: ask forces for the push of the start and keep "
                      "it; drift; kick with what you kept."},
            .order = 1,
            .picture = "planet.png",
            .beyond = beyond_one_state,
            .mistakes =
                {{"kicks before it drifts", "classic: most engines call this Euler",
                  "The planet stays on its ellipse instead of spiralling out.",
                  "You kick first, so the drift already uses the new velocity. That is "
                  "semi-implicit Euler, a better method and exercise 1.4; Euler's drift uses the "
                  "velocity of the start.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, forces(state, t), dt);
                      drift(state, dt);
                      return state;
                  }},
                 {"the force of the new place", "classic",
                  "The planet's orbit stays closed but sits a little beside the true one.",
                  "You ask for the force after the drift, so it is that of the new place. Euler "
                  "takes place, velocity and force all from the start of the step: ask for the "
                  "push first, and keep it.",
                  [](auto state, const auto& forces, double t, double dt) {
                      drift(state, dt);
                      kick(state, forces(state, t), dt);
                      return state;
                  }},
                 {"the force of the step's end", "classic",
                  "Forces that change with time act one step too early.",
                  "You ask for the force at t + dt. The step starts at t.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const auto push = forces(state, t + dt);
                      drift(state, dt);
                      kick(state, push, dt);
                      return state;
                  }},
                 {"the force taken for an acceleration", "classic: gravity not divided by mass",
                  "Heavy things fall faster than light ones.",
                  "The change of velocity comes out as force times dt, without the mass. kick "
                  "divides by the mass itself: hand it the force as it is.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const auto push = forces(state, t);
                      drift(state, dt);
                      kick(state, state.mass * push, dt);
                      return state;
                  }},
                 {"dt twice", "classic: velocity += force * dt * dt",
                  "Gravity is sixty times too weak at 60 frames a second, and weaker still at "
                  "144.",
                  "dt enters the kick twice. kick multiplies by dt itself: hand it the force "
                  "alone.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const auto push = forces(state, t);
                      drift(state, dt);
                      kick(state, push * dt, dt);
                      return state;
                  }},
                 {"no drift", "classic",
                  "Nothing moves from its place, though its velocity grows.",
                  "The velocity changes but the position never does: the step lacks its drift.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, forces(state, t), dt);
                      return state;
                  }},
                 {"no kick", "classic", "Everything flies straight on; no force is felt.",
                  "The position changes but the velocity never does: the step lacks its kick.",
                  [](auto state, const auto&, double, double dt) {
                      drift(state, dt);
                      return state;
                  }},
                 {"drifts with the mean velocity", "classic",
                  "A thrown ball is exact, and the planet spirals out half as fast.",
                  "You drift with the mean of old and new velocity. That is exact for a constant "
                  "force; Euler's drift uses the velocity of the start.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const auto push = forces(state, t);
                      kick(state, push, dt / 2);
                      drift(state, dt);
                      kick(state, push, dt / 2);
                      return state;
                  }},
                 {"the force of the new place and time", "classic",
                  "The orbit stays closed but sits beside the true one.",
                  "You ask for the force after the drift, at t + dt. Euler takes place, "
                  "velocity, force and time all from the start: ask first, and keep it.",
                  [](auto state, const auto& forces, double t, double dt) {
                      drift(state, dt);
                      kick(state, forces(state, t + dt), dt);
                      return state;
                  }},
                 {"two steps in one", "classic", "Everything goes twice as far.",
                  "drift and kick stand in it twice: the step lasts 2 dt.",
                  [](auto state, const auto& forces, double t, double dt) {
                      for (int i = 0; i < 2; ++i) {
                          const auto push = forces(state, t);
                          drift(state, dt);
                          kick(state, push, dt);
                      }
                      return state;
                  }}},
            .alternatives = {{"from two copies",
                              []<class State, class Forces>(State state, const Forces& forces,
                                                            double t, double dt) {
                                  State moved = state;
                                  drift(moved, dt);
                                  kick(moved, forces(state, t), dt);
                                  return moved;
                              }},
                             {"in two halves",
                              [](auto state, const auto& forces, double t, double dt) {
                                  const auto push = forces(state, t);
                                  drift(state, dt / 2);
                                  drift(state, dt / 2);
                                  kick(state, 0.5 * push, dt);
                                  kick(state, 0.5 * push, dt);
                                  return state;
                              }}},
        };
    }
#endif
};

inline const bool euler_entered = enter<Euler>();

}  // namespace nutshell::exercises
