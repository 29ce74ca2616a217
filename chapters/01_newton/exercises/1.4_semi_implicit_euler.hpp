// Exercise 1.4: one step of semi-implicit Euler.
#pragma once
#include "steps.hpp"

namespace nutshell::exercises {

struct SemiImplicitEuler {
    static constexpr const char *id = "1.4", *function = "semi_implicit_euler";
    static constexpr auto subject = NUTSHELL_CALL(semi_implicit_euler);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        ask_step(paper, answer, 0.4);
    }

#ifndef NUTSHELL_SHEET
    static About<SemiImplicitEuler> about() {
        return {
            .title = "A step of semi-implicit Euler",
            .hints = {"It is Euler's method with its two halves in the other order.",
                      "The body must move with the velocity that the force of this step has "
                      "already changed.",
                      "Ask for the force at the start, kick with it for the whole of dt, and "
                      "only then drift."},
            .order = 1,
            .picture = "planet.png",
            .beyond = beyond_one_state,
            .mistakes =
                {{"drifts with the old velocity", "classic: this is Euler",
                  "The planet spirals out, and a spring swings wider on every swing.",
                  "You drift with the velocity of the start, as Euler does. Here the drift must "
                  "use the velocity the kick leaves: kick first.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const auto push = forces(state, t);
                      drift(state, dt);
                      kick(state, push, dt);
                      return state;
                  }},
                 {"drifts before it kicks", "classic: the other symplectic Euler",
                  "The orbit stays closed, but sits a little on the other side of the true one.",
                  "You drift first and take the force of the new place. That also keeps energy "
                  "in a band, but it is the mirror image of the method asked for: kick with the "
                  "force of the start, then drift.",
                  [](auto state, const auto& forces, double t, double dt) {
                      drift(state, dt);
                      kick(state, forces(state, t), dt);
                      return state;
                  }},
                 {"drifts with the mean velocity", "classic: v t + a t^2/2",
                  "A thrown ball is exact, but the planet spirals out, half as fast as with "
                  "Euler.",
                  "You drift with the mean of old and new velocity. That is exact for a constant "
                  "force only; here the drift uses the new velocity.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const auto push = forces(state, t);
                      kick(state, push, dt / 2);
                      drift(state, dt);
                      kick(state, push, dt / 2);
                      return state;
                  }},
                 {"half a kick", "classic: Verlet left unfinished",
                  "Everything falls at half its weight.",
                  "You kick for dt/2 only. There is one kick in this step, so it must last the "
                  "whole of dt.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, forces(state, t), dt / 2);
                      drift(state, dt);
                      return state;
                  }},
                 {"the force taken for an acceleration", "classic: gravity not divided by mass",
                  "Heavy things fall faster than light ones.",
                  "The change of velocity comes out as force times dt, without the mass. kick "
                  "divides by the mass itself: hand it the force as it is.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, state.mass * forces(state, t), dt);
                      drift(state, dt);
                      return state;
                  }},
                 {"the force of the step's end", "classic",
                  "Forces that change with time act one step too early.",
                  "You ask for the force at t + dt. The step starts at t.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, forces(state, t + dt), dt);
                      drift(state, dt);
                      return state;
                  }},
                 {"drifts first, with the force of the end", "classic",
                  "The orbit stays closed, but sits on the other side of the true one.",
                  "You drift first and kick with the force of the new place at t + dt. Here the "
                  "kick comes first, with the force of the start.",
                  [](auto state, const auto& forces, double t, double dt) {
                      drift(state, dt);
                      kick(state, forces(state, t + dt), dt);
                      return state;
                  }},
                 {"no drift", "classic",
                  "Nothing moves from its place, though its velocity grows.",
                  "The velocity changes but the position does not: there is no drift, or it "
                  "moves a copy that is not returned.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, forces(state, t), dt);
                      return state;
                  }},
                 {"no kick", "classic", "Everything flies straight on.",
                  "The position changes but the velocity does not: there is no kick, or it "
                  "changes a copy that is not returned.",
                  [](auto state, const auto&, double, double dt) {
                      drift(state, dt);
                      return state;
                  }},
                 {"dt twice", "classic", "Gravity fades with the frame rate.",
                  "dt enters the kick twice. kick multiplies by dt itself: hand it the force "
                  "alone.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, forces(state, t) * dt, dt);
                      drift(state, dt);
                      return state;
                  }}},
            .alternatives = {{"in two halves",
                              [](auto state, const auto& forces, double t, double dt) {
                                  const auto push = forces(state, t);
                                  kick(state, push, dt / 2);
                                  kick(state, push, dt / 2);
                                  drift(state, dt / 2);
                                  drift(state, dt / 2);
                                  return state;
                              }}},
        };
    }
#endif
};

inline const bool semi_implicit_euler_entered = enter<SemiImplicitEuler>();

}  // namespace nutshell::exercises
