// Exercise 3.6: Verlet with drag that keeps its second order.
#pragma once
#include "exercise.hpp"
#include "steps.hpp"

namespace nutshell::exercises {

struct ExponentialVerletStep {
    static constexpr const char *id = "3.6", *function = "exponential_verlet";
    static constexpr auto subject = NUTSHELL_CALL(exponential_verlet);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        ask_dragged_step(paper, answer);
        const int steps = static_cast<int>(std::lround(1 / paper.step(1.0 / 64)));
        paper.input("a body that falls, for 1 s in", steps, "steps");
        const Sinking forces{2.2};
        const PointMass start{1.5, {0.3, 4.1, -0.6}, {6.2, 3.3, -1.9}};
        PointMass body = start;
        for (int i = 0; i < steps; ++i)
            body = answer(body, forces, i / static_cast<double>(steps), 1.0 / steps);
        const double x = forces.drag / start.mass;
        const Vector3 terminal =
            forces(PointMass{start.mass, start.position, Vector3::Zero()}, 0) / forces.drag;
        const Vector3 exact =
            start.position + terminal + (start.velocity - terminal) * (1 - std::exp(-x)) / x;
        paper.run("the position at the end [m]", body.position, exact, start.position,
                  start.velocity);
    }

#ifndef NUTSHELL_SHEET
    static About<ExponentialVerletStep> about() {
        return {
            .title = "Verlet with drag",
            .hints =
                {"Verlet's half kicks are right for forces of the place. The drag is not one; "
                 "give it its own exact step, the decay, and take that out of the kicks.",
                 "What makes Verlet second order is that it reads the same backwards. Where can "
                 "the decay stand so that the new step does too?",
                 "Half the decay, a Verlet step of the force at rest, half the decay. Half the "
                 "decay is e to the minus gamma dt/(2 m)."},
            .order = 2,
            .picture = "damped_spring.png",
            .mistakes =
                {{"drag inside the kicks", "curriculum: Verlet with drag",
                  "The swing runs ahead or behind; half the step halves the error only.",
                  "This is plain Verlet with the drag in its force. Its second half-kick sees "
                  "the velocity before that kick, so it drops to first order.",
                  [](auto state, const auto& forces, double t, double dt) {
                      return verlet(state, forces, t, dt);
                  }},
                 {"all the drag at the start", "classic", "Half the step halves the error only.",
                  "The whole decay stands at the start, so the step does not read the same "
                  "backwards. Take half before and half after.",
                  [](auto state, const auto& forces, double t, double dt) {
                      state.velocity *= std::exp(-forces.drag * dt / state.mass);
                      kick(state, force_at_rest(state, forces, t), dt / 2);
                      drift(state, dt);
                      kick(state, force_at_rest(state, forces, t + dt), dt / 2);
                      return state;
                  }},
                 {"all the drag at the end", "classic", "Half the step halves the error only.",
                  "The whole decay stands at the end, so the step does not read the same "
                  "backwards. Take half before and half after.",
                  [](auto state, const auto& forces, double t, double dt) {
                      kick(state, force_at_rest(state, forces, t), dt / 2);
                      drift(state, dt);
                      kick(state, force_at_rest(state, forces, t + dt), dt / 2);
                      state.velocity *= std::exp(-forces.drag * dt / state.mass);
                      return state;
                  }},
                 {"a whole decay at both ends", "classic",
                  "The drag is twice as strong as it should be.",
                  "You let the velocity decay by a whole step twice. Each end gets half: dt/2 in "
                  "the exponent.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double decay = std::exp(-forces.drag * dt / state.mass);
                      state.velocity *= decay;
                      kick(state, force_at_rest(state, forces, t), dt / 2);
                      drift(state, dt);
                      kick(state, force_at_rest(state, forces, t + dt), dt / 2);
                      state.velocity *= decay;
                      return state;
                  }},
                 {"decay and drag in the kick", "classic",
                  "The drag is twice as strong as it should be, and the error falls at first "
                  "order.",
                  "The force you kick with still has the drag in it. Use force_at_rest.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double half_decay = std::exp(-forces.drag * dt / 2 / state.mass);
                      state.velocity *= half_decay;
                      state = verlet(state, forces, t, dt);
                      state.velocity *= half_decay;
                      return state;
                  }},
                 {"drag without the mass", "classic",
                  "Heavy things are braked as much as light ones.",
                  "The exponent is gamma dt over twice the mass.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double half_decay = std::exp(-forces.drag * dt / 2);
                      state.velocity *= half_decay;
                      kick(state, force_at_rest(state, forces, t), dt / 2);
                      drift(state, dt);
                      kick(state, force_at_rest(state, forces, t + dt), dt / 2);
                      state.velocity *= half_decay;
                      return state;
                  }},
                 {"the force of the start, twice", "classic: a stale force",
                  "The swing gains energy.",
                  "The second half-kick belongs to the new place and time: ask for the force "
                  "again.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double half_decay = std::exp(-forces.drag * dt / 2 / state.mass);
                      state.velocity *= half_decay;
                      const Vector3 force = force_at_rest(state, forces, t);
                      kick(state, force, dt / 2);
                      drift(state, dt);
                      kick(state, force, dt / 2);
                      state.velocity *= half_decay;
                      return state;
                  }},
                 {"half of the decay, not the decay of half a step", "classic",
                  "Everything stops within a few steps, even in a vacuum.",
                  "You take half of the factor. What each end needs is the factor of half a "
                  "step: dt/2 goes into the exponent.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double half_decay = std::exp(-forces.drag * dt / state.mass) / 2;
                      state.velocity *= half_decay;
                      kick(state, force_at_rest(state, forces, t), dt / 2);
                      drift(state, dt);
                      kick(state, force_at_rest(state, forces, t + dt), dt / 2);
                      state.velocity *= half_decay;
                      return state;
                  }},
                 {"a straight line for the decay", "classic: 1 - x for e^-x",
                  "The error falls at first order, and with strong drag the velocity turns "
                  "round.",
                  "1 - gamma dt/(2 m) is only the beginning of the exponential: take e to the "
                  "power of it.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double half_decay = 1 - forces.drag * dt / (2 * state.mass);
                      state.velocity *= half_decay;
                      kick(state, force_at_rest(state, forces, t), dt / 2);
                      drift(state, dt);
                      kick(state, force_at_rest(state, forces, t + dt), dt / 2);
                      state.velocity *= half_decay;
                      return state;
                  }},
                 {"a decay that grows", "classic: the sign",
                  "Everything is thrown out of the level.",
                  "The exponent has the wrong sign: drag makes the velocity decay.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double half_decay = std::exp(forces.drag * dt / 2 / state.mass);
                      state.velocity *= half_decay;
                      kick(state, force_at_rest(state, forces, t), dt / 2);
                      drift(state, dt);
                      kick(state, force_at_rest(state, forces, t + dt), dt / 2);
                      state.velocity *= half_decay;
                      return state;
                  }},
                 {"the half-drags inside", "the book's other form",
                  "None to speak of: it is as good as the one asked for, and has another limit.",
                  "You put the half-drags next to the drift. That is of second order too, but "
                  "here they stand outermost.",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double half_decay = std::exp(-forces.drag * dt / 2 / state.mass);
                      kick(state, force_at_rest(state, forces, t), dt / 2);
                      state.velocity *= half_decay;
                      drift(state, dt);
                      state.velocity *= half_decay;
                      kick(state, force_at_rest(state, forces, t + dt), dt / 2);
                      return state;
                  }},
                 {"the second force at the start's time", "classic",
                  "Forces that change with time act late.",
                  "The second half kick stands at the end of the step: its time is t + dt.",
                  [](auto state, const auto& forces, double t, double dt) {
                      decay(state, forces.drag, dt / 2);
                      kick(state, force_at_rest(state, forces, t), dt / 2);
                      drift(state, dt);
                      kick(state, force_at_rest(state, forces, t), dt / 2);
                      decay(state, forces.drag, dt / 2);
                      return state;
                  }},
                 {"only half of the drag", "classic",
                  "The drag is half as strong as it should be.",
                  "There is one half-decay. One stands at the start and one at the end.",
                  [](auto state, const auto& forces, double t, double dt) {
                      decay(state, forces.drag, dt / 2);
                      kick(state, force_at_rest(state, forces, t), dt / 2);
                      drift(state, dt);
                      kick(state, force_at_rest(state, forces, t + dt), dt / 2);
                      return state;
                  }},
                 {"an implicit step for the decay", "classic: v /= 1 + x",
                  "The drag is a little too weak, and more so in large steps.",
                  "You divide by 1 + gamma dt/(2 m). That never explodes, but the decay of half "
                  "a "
                  "step is another: e to the power of -gamma dt/(2 m).",
                  [](auto state, const auto& forces, double t, double dt) {
                      const double half_decay = 1 / (1 + forces.drag * dt / (2 * state.mass));
                      state.velocity *= half_decay;
                      kick(state, force_at_rest(state, forces, t), dt / 2);
                      drift(state, dt);
                      kick(state, force_at_rest(state, forces, t + dt), dt / 2);
                      state.velocity *= half_decay;
                      return state;
                  }}},
            .alternatives = {{"Verlet of the force at rest",
                              []<class State, class Forces>(State state, const Forces& forces,
                                                            double t, double dt) {
                                  const auto still = [&](const State& at, double time) {
                                      return force_at_rest(at, forces, time);
                                  };
                                  state.velocity *=
                                      std::exp(-forces.drag * dt / (2 * state.mass));
                                  state = verlet(state, still, t, dt);
                                  state.velocity *=
                                      std::exp(-forces.drag * dt / (2 * state.mass));
                                  return state;
                              }}},
        };
    }
#endif
};

inline const bool exponential_verlet_entered = enter<ExponentialVerletStep>();

}  // namespace nutshell::exercises
