// Exercise 1.5: one step of velocity Verlet.
#pragma once
#include "steps.hpp"

namespace nutshell::exercises {

struct Verlet {
    static constexpr const char *id = "1.5", *function = "verlet";
    static constexpr auto subject = NUTSHELL_CALL(verlet);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        ask_step(paper, answer, 0);  // Verlet is for forces of place and time
    }

#ifndef NUTSHELL_SHEET
    static About<Verlet> about() {
        return {
            .title = "A step of velocity Verlet",
            .hints = {"The mean velocity over a step is close to the velocity at its middle. How "
                      "much of the kick has happened by then?",
                      "Half a kick before the drift, half a kick after it. But the body is "
                      "somewhere else by then, and it is later.",
                      "Kick for dt/2 with the force at t; drift for dt; kick for dt/2 with the "
                      "force asked for anew, at t + dt."},
            .order = 2,
            .picture = "planet.png",
            .beyond = beyond_one_state,
            .mistakes =
                {{"a stale force", "classic: the force kept from the start",
                  "A thrown ball is exact, but the planet spirals out, half as fast as with "
                  "Euler.",
                  "Both half kicks use the force of the start. After the drift the body is at a "
                  "new place: ask for the force there before the second half.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const auto push = forces(state, t);
                      kick(state, push, dt / 2);
                      drift(state, dt);
                      kick(state, push, dt / 2);
                      return state;
                  }},
                 {"whole kicks instead of halves", "classic", "Everything weighs twice as much.",
                  "You kick for dt twice, so the force acts for two steps' time in one. Each of "
                  "the two kicks lasts dt/2.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, forces(state, t), dt);
                      drift(state, dt);
                      kick(state, forces(state, t + dt), dt);
                      return state;
                  }},
                 {"a whole second kick", "classic", "Everything weighs half as much again.",
                  "The second kick lasts dt, so in all the force acts for one and a half steps. "
                  "It must last dt/2, like the first.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, forces(state, t), dt / 2);
                      drift(state, dt);
                      kick(state, forces(state, t + dt), dt);
                      return state;
                  }},
                 {"a stale time", "classic",
                  "Forces that change with time act late; others are right.",
                  "The second half kick asks for the force at t. It happens at the end of the "
                  "step: t + dt.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, forces(state, t), dt / 2);
                      drift(state, dt);
                      kick(state, forces(state, t), dt / 2);
                      return state;
                  }},
                 {"the force taken for an acceleration",
                  "classic: gravity not divided by mass in Verlet",
                  "Heavy things fall faster than light ones.",
                  "The change of velocity comes out as force times dt, without the mass. kick "
                  "divides by the mass itself: hand it the force as it is.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, state.mass * forces(state, t), dt / 2);
                      drift(state, dt);
                      kick(state, state.mass * forces(state, t + dt), dt / 2);
                      return state;
                  }},
                 {"half a drift", "classic", "Everything moves at half its speed.",
                  "Only the kicks are halved. The drift stands once, in the middle, so it must "
                  "last the whole of dt.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, forces(state, t), dt / 2);
                      drift(state, dt / 2);
                      kick(state, forces(state, t + dt), dt / 2);
                      return state;
                  }},
                 {"no second half kick", "classic", "Everything falls at half its weight.",
                  "The step ends after the drift: the second half of the kick, with the force of "
                  "the new place, is missing.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, forces(state, t), dt / 2);
                      drift(state, dt);
                      return state;
                  }},
                 {"the two verbs exchanged", "classic: position Verlet",
                  "None to speak of: it is as good as the one asked for.",
                  "You drift, kick, drift. That is position Verlet: also second order, also "
                  "symplectic, but other numbers than velocity Verlet: kick, drift, kick.",
                  [](auto state, const auto& forces, double t, double dt) {
                      drift(state, dt / 2);
                      kick(state, forces(state, t + dt / 2), dt);
                      drift(state, dt / 2);
                      return state;
                  }},
                 {"one kick, not two halves", "classic: this is semi-implicit Euler",
                  "A thrown ball lands a little too early: its error is g T dt/2.",
                  "You kick once, before the drift: that is semi-implicit Euler, of first order. "
                  "Half of the kick belongs after the drift.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, forces(state, t), dt);
                      drift(state, dt);
                      return state;
                  }},
                 {"both forces of the end", "classic",
                  "Nearly right: half of the kick comes a step too early.",
                  "The first half kick asks for the force at t + dt. It happens at the start: t.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, forces(state, t + dt), dt / 2);
                      drift(state, dt);
                      kick(state, forces(state, t + dt), dt / 2);
                      return state;
                  }},
                 {"the second kick at the middle", "classic",
                  "Forces that change with time act a little early.",
                  "The second half kick asks for the force at t + dt/2. It stands at the end of "
                  "the step: t + dt.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, forces(state, t), dt / 2);
                      drift(state, dt);
                      kick(state, forces(state, t + dt / 2), dt / 2);
                      return state;
                  }},
                 {"the times exchanged", "classic",
                  "Forces that change with time act at the wrong end.",
                  "The first half kick belongs to t, the second to t + dt.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, forces(state, t + dt), dt / 2);
                      drift(state, dt);
                      kick(state, forces(state, t), dt / 2);
                      return state;
                  }},
                 {"the force of the start alone, drifted first", "classic",
                  "The planet spirals out.",
                  "All of the force comes from the start of the step. The second half kick asks "
                  "again, at the new place.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const auto push = forces(state, t);
                      drift(state, dt);
                      kick(state, push, dt);
                      return state;
                  }},
                 {"no kick before the drift", "classic: the mean force at the end",
                  "The ball flies too high, as with Euler.",
                  "You drift with the velocity of the start and kick afterwards with the mean of "
                  "both forces. Half of the kick comes before the drift.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const auto push = forces(state, t);
                      drift(state, dt);
                      kick(state, (push + forces(state, t + dt)) / 2, dt);
                      return state;
                  }}},
            .alternatives = {{"the kicks cut up otherwise",
                              [](auto state, const auto& forces, double t, double dt) {
                                  const auto first = forces(state, t);
                                  kick(state, 0.5 * first, dt);
                                  drift(state, dt);
                                  const auto second = forces(state, t + dt);
                                  kick(state, second, 0.25 * dt);
                                  kick(state, second, 0.25 * dt);
                                  return state;
                              }}},
        };
    }
#endif
};

inline const bool verlet_entered = enter<Verlet>();

}  // namespace nutshell::exercises
