// Exercise 3.5: a step under weight and drag that is exact at any length.
#pragma once
#include "exercise.hpp"
#include "steps.hpp"

namespace nutshell::exercises {

struct ExponentialKick {
    static constexpr const char *id = "3.5", *function = "exponential_kick";
    static constexpr auto subject = NUTSHELL_CALL(exponential_kick);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        ask_dragged_step(paper, answer);
        const double dt = paper.step(2.0);  // x = gamma dt/m is above one
        const PointMass body{1.5, {0.3, 4.1, -0.6}, {6.2, 3.3, -1.9}};
        paper.input("a body that falls, x = gamma dt/m", 2.2 * dt / body.mass, "dt", dt);
        const PointMass sunk = answer(body, Sinking{2.2}, 0.0, dt);
        paper.changed("the position [m]", sunk.position, body.position, body.velocity * dt,
                      9.81 * dt * dt);
        paper.changed("the velocity [m/s]", sunk.velocity, body.velocity, 9.81 * dt);
        paper.input("no drag at all, dt", dt);
        const PointMass thrown = answer(body, Sinking{0}, 0.0, dt);
        paper.changed("the position [m]", thrown.position, body.position, body.velocity * dt,
                      9.81 * dt * dt);
        paper.changed("the velocity [m/s]", thrown.velocity, body.velocity, 9.81 * dt);
    }

#ifndef NUTSHELL_SHEET
    static About<ExponentialKick> about() {
        return {
            .title = "The exact step under drag",
            .hints = {"Without the drag the force would be constant over the step. With it, the "
                      "velocity falls towards the terminal velocity as an exponential. Add that "
                      "velocity up, and you have the way.",
                      "Let x = gamma dt/m. The old velocity decays by e^-x; what the force adds "
                      "is the acceleration times dt, times the mean of the decay, phi_1(-x). "
                      "phi_1 and "
                      "phi_2 are there for you.",
                      "The way of the old velocity is its mean over the step; the way of what "
                      "the force adds is the mean of a mean: acceleration times dt squared times "
                      "phi_2(-x). force_at_rest gives the force without its drag."},
            .mistakes =
                {{"the drift uses the new velocity", "curriculum: scaling v alone",
                  "Everything falls a little too far, and less so with smaller steps.",
                  "The velocity is exact, and then you drift a whole step with that of the end. "
                  "The drift must add up the velocity as it decays.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const Vector3 acceleration = force_at_rest(state, forces, t) / state.mass;
                      state.velocity = state.velocity * std::exp(-forces.drag * dt / state.mass) +
                                       acceleration * dt * phi_1(-forces.drag * dt / state.mass);
                      state.position += state.velocity * dt;
                      return state;
                  }},
                 {"the drift uses the old velocity", "classic",
                  "Everything moves too far, as if the drag began one step late.",
                  "You drift with the velocity of the start, but it decays on the way: take its "
                  "mean over the step.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const Vector3 acceleration = force_at_rest(state, forces, t) / state.mass;
                      state.position += state.velocity * dt;
                      state.velocity = state.velocity * std::exp(-forces.drag * dt / state.mass) +
                                       acceleration * dt * phi_1(-forces.drag * dt / state.mass);
                      return state;
                  }},
                 {"the velocity overwritten too early", "classic",
                  "Everything falls too far, though its speed is right.",
                  "The velocity is exact. But it is written before the way is added up, and the "
                  "formula for the way wants that of the start.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double x = forces.drag * dt / state.mass;
                      const Vector3 acceleration = force_at_rest(state, forces, t) / state.mass;
                      state.velocity =
                          state.velocity * std::exp(-x) + acceleration * dt * phi_1(-x);
                      state.position +=
                          state.velocity * dt * phi_1(-x) + acceleration * dt * dt * phi_2(-x);
                      return state;
                  }},
                 {"a fixed factor", "classic: v *= 0.98 per step",
                  "At 144 Hz the drag is nearly five times as strong as at 30 Hz.",
                  "You scale the velocity by a number that knows nothing of dt, gamma and the "
                  "mass. The factor of a step is e^(-gamma dt/m).",
                  [](auto state, const auto& forces, double t, double dt) {
                      const Vector3 acceleration = force_at_rest(state, forces, t) / state.mass;
                      state.velocity = 0.98 * (state.velocity + acceleration * dt);
                      state.position += state.velocity * dt;
                      return state;
                  }},
                 {"drag without the mass", "classic",
                  "Heavy things are braked as much as light ones.",
                  "The exponent is gamma dt over the mass.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double x = forces.drag * dt;
                      const Vector3 acceleration = force_at_rest(state, forces, t) / state.mass;
                      state.position +=
                          state.velocity * dt * phi_1(-x) + acceleration * dt * dt * phi_2(-x);
                      state.velocity =
                          state.velocity * std::exp(-x) + acceleration * dt * phi_1(-x);
                      return state;
                  }},
                 {"the drag twice", "classic", "Things stop twice as fast as they should.",
                  "You use the whole force, which has the drag in it, and then let the velocity "
                  "decay as well. Use force_at_rest.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double x = forces.drag * dt / state.mass;
                      const Vector3 acceleration = forces(state, t) / state.mass;
                      state.position +=
                          state.velocity * dt * phi_1(-x) + acceleration * dt * dt * phi_2(-x);
                      state.velocity =
                          state.velocity * std::exp(-x) + acceleration * dt * phi_1(-x);
                      return state;
                  }},
                 {"no drag is a division by zero", "E08's kin",
                  "Where the air is turned off, everything becomes NaN.",
                  "The terminal velocity F/gamma is infinite where there is no drag. Written "
                  "with phi_1 and phi_2, no drag is no special case.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double x = forces.drag * dt / state.mass;
                      const Vector3 terminal = force_at_rest(state, forces, t) / forces.drag,
                                    excess = state.velocity - terminal;
                      state.position += terminal * dt + excess * dt * (1 - std::exp(-x)) / x;
                      state.velocity = terminal + excess * std::exp(-x);
                      return state;
                  }},
                 {"a decay that grows", "classic: the sign",
                  "Everything is thrown out of the level.",
                  "The exponent has the wrong sign: drag makes the velocity decay.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double x = -forces.drag * dt / state.mass;
                      const Vector3 acceleration = force_at_rest(state, forces, t) / state.mass;
                      state.position +=
                          state.velocity * dt * phi_1(-x) + acceleration * dt * dt * phi_2(-x);
                      state.velocity =
                          state.velocity * std::exp(-x) + acceleration * dt * phi_1(-x);
                      return state;
                  }},
                 {"the fall without its drag", "classic: a t^2/2",
                  "The velocity is right, and a long step falls too far.",
                  "The way of what the force adds is a dt^2/2 without drag only; with it the "
                  "half becomes phi_2(-x).",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double x = forces.drag * dt / state.mass;
                      const Vector3 a = force_at_rest(state, forces, t) / state.mass;
                      state.position += state.velocity * dt * phi_1(-x) + a * dt * dt / 2;
                      state.velocity = state.velocity * std::exp(-x) + a * dt * phi_1(-x);
                      return state;
                  }},
                 {"the gain without its drag", "classic: v + a t",
                  "A falling body never reaches its terminal velocity.",
                  "What the force adds during the step decays too: a dt times phi_1(-x).",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double x = forces.drag * dt / state.mass;
                      const Vector3 a = force_at_rest(state, forces, t) / state.mass;
                      state.position += state.velocity * dt * phi_1(-x) + a * dt * dt * phi_2(-x);
                      state.velocity = state.velocity * std::exp(-x) + a * dt;
                      return state;
                  }},
                 {"the force taken for an acceleration", "classic: not divided by mass",
                  "Heavy things fall faster than light ones.",
                  "force_at_rest gives a force: divide it by the mass.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double x = forces.drag * dt / state.mass;
                      const Vector3 a = force_at_rest(state, forces, t);
                      state.position += state.velocity * dt * phi_1(-x) + a * dt * dt * phi_2(-x);
                      state.velocity = state.velocity * std::exp(-x) + a * dt * phi_1(-x);
                      return state;
                  }},
                 {"phi of what grows", "classic: the sign, once of three times",
                  "Things that brake roll too far.",
                  "phi_1 and phi_2 are of -x too, as the exponential is: all three belong to a "
                  "decay.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double x = forces.drag * dt / state.mass;
                      const Vector3 a = force_at_rest(state, forces, t) / state.mass;
                      state.position += state.velocity * dt * phi_1(x) + a * dt * dt * phi_2(x);
                      state.velocity = state.velocity * std::exp(-x) + a * dt * phi_1(x);
                      return state;
                  }},
                 {"dt once in the fall", "classic: m/s^2 times s is no way",
                  "Things fall too far in short steps.",
                  "The way that an acceleration adds is dt^2 phi_2(-x) times it: dt twice.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double x = forces.drag * dt / state.mass;
                      const Vector3 a = force_at_rest(state, forces, t) / state.mass;
                      state.position += state.velocity * dt * phi_1(-x) + a * dt * phi_2(-x);
                      state.velocity = state.velocity * std::exp(-x) + a * dt * phi_1(-x);
                      return state;
                  }},
                 {"the mean of both velocities", "classic: a trapezium for a curve",
                  "Things that brake roll a little too far.",
                  "The velocity is exact, and you drift with the mean of those at start and end. "
                  "It falls along a curve, so its mean over the step is another one.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double x = forces.drag * dt / state.mass;
                      const Vector3 a = force_at_rest(state, forces, t) / state.mass,
                                    before = state.velocity;
                      state.velocity = before * std::exp(-x) + a * dt * phi_1(-x);
                      state.position += (before + state.velocity) / 2 * dt;
                      return state;
                  }},
                 {"one implicit step", "classic: v /= 1 + x",
                  "Things stop a little too late, and less so with smaller steps.",
                  "You brake by 1/(1 + gamma dt/m). That never explodes, but it is one implicit "
                  "step of first order; the velocity falls as an exponential.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const Vector3 a = force_at_rest(state, forces, t) / state.mass;
                      state.velocity =
                          (state.velocity + a * dt) / (1 + forces.drag * dt / state.mass);
                      state.position += state.velocity * dt;
                      return state;
                  }}},
            .alternatives = {{"through the terminal velocity",
                              [](auto state, const auto& forces, double t, double dt) {
                                  const Vector3 acceleration =
                                      force_at_rest(state, forces, t) / state.mass;
                                  if (forces.drag == 0) {
                                      state.position +=
                                          state.velocity * dt + acceleration * dt * dt / 2;
                                      state.velocity += acceleration * dt;
                                      return state;
                                  }
                                  const double x = forces.drag * dt / state.mass;
                                  const Vector3 terminal =
                                                    acceleration * state.mass / forces.drag,
                                                excess = state.velocity - terminal;
                                  state.position +=
                                      terminal * dt - excess * dt * std::expm1(-x) / x;
                                  state.velocity = terminal + excess * std::exp(-x);
                                  return state;
                              }}},
        };
    }
#endif
};

inline const bool exponential_kick_entered = enter<ExponentialKick>();

}  // namespace nutshell::exercises
