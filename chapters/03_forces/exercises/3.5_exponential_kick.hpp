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
        paper.input("a stone that sinks, x = gamma dt/m", 2.2 * dt / body.mass, "dt", dt);
        const PointMass sunk = answer(body, Sinking{2.2}, 0.0, dt);
        paper.output("the position [m]", sunk.position, body.position, body.velocity * dt,
                     9.81 * dt * dt);
        paper.output("the velocity [m/s]", sunk.velocity, body.velocity, 9.81 * dt);
        paper.input("no drag at all, dt", dt);
        const PointMass thrown = answer(body, Sinking{0}, 0.0, dt);
        paper.output("the position [m]", thrown.position, body.position, body.velocity * dt,
                     9.81 * dt * dt);
        paper.output("the velocity [m/s]", thrown.velocity, body.velocity, 9.81 * dt);
    }
#ifndef NUTSHELL_SHEET
    static Exercise about();
#endif
};

inline const bool exponential_kick_entered = enter<ExponentialKick>();

}  // namespace nutshell::exercises

#ifndef NUTSHELL_SHEET

namespace nutshell::mistakes {

template <class State, class Forces>
State kick_scales_and_drifts(State state, const Forces& forces, double t, double dt) {
    const Vector3 acceleration = force_at_rest(state, forces, t) / state.mass;
    state.velocity = state.velocity * std::exp(-forces.drag * dt / state.mass) +
                     acceleration * dt * mean_decay(forces.drag * dt / state.mass);
    state.position += state.velocity * dt;
    return state;
}
template <class State, class Forces>
State kick_drifts_with_the_old_velocity(State state, const Forces& forces, double t, double dt) {
    const Vector3 acceleration = force_at_rest(state, forces, t) / state.mass;
    state.position += state.velocity * dt;
    state.velocity = state.velocity * std::exp(-forces.drag * dt / state.mass) +
                     acceleration * dt * mean_decay(forces.drag * dt / state.mass);
    return state;
}
template <class State, class Forces>
State kick_overwrites_the_velocity_first(State state, const Forces& forces, double t, double dt) {
    const double x = forces.drag * dt / state.mass;
    const Vector3 acceleration = force_at_rest(state, forces, t) / state.mass;
    state.velocity = state.velocity * std::exp(-x) + acceleration * dt * mean_decay(x);
    state.position +=
        state.velocity * dt * mean_decay(x) + acceleration * dt * dt * second_mean_decay(x);
    return state;
}
template <class State, class Forces>
State kick_by_a_fixed_factor(State state, const Forces& forces, double t, double dt) {
    const Vector3 acceleration = force_at_rest(state, forces, t) / state.mass;
    state.velocity = 0.98 * (state.velocity + acceleration * dt);
    state.position += state.velocity * dt;
    return state;
}
template <class State, class Forces>
State kick_without_mass(State state, const Forces& forces, double t, double dt) {
    const double x = forces.drag * dt;
    const Vector3 acceleration = force_at_rest(state, forces, t) / state.mass;
    state.position +=
        state.velocity * dt * mean_decay(x) + acceleration * dt * dt * second_mean_decay(x);
    state.velocity = state.velocity * std::exp(-x) + acceleration * dt * mean_decay(x);
    return state;
}
template <class State, class Forces>
State kick_counts_the_drag_twice(State state, const Forces& forces, double t, double dt) {
    const double x = forces.drag * dt / state.mass;
    const Vector3 acceleration = forces(state, t) / state.mass;
    state.position +=
        state.velocity * dt * mean_decay(x) + acceleration * dt * dt * second_mean_decay(x);
    state.velocity = state.velocity * std::exp(-x) + acceleration * dt * mean_decay(x);
    return state;
}
template <class State, class Forces>
State kick_divides_by_the_drag(State state, const Forces& forces, double t, double dt) {
    const double x = forces.drag * dt / state.mass;
    const Vector3 terminal = force_at_rest(state, forces, t) / forces.drag,
                  excess = state.velocity - terminal;
    state.position += terminal * dt + excess * dt * (1 - std::exp(-x)) / x;
    state.velocity = terminal + excess * std::exp(-x);
    return state;
}
template <class State, class Forces>
State kick_grows(State state, const Forces& forces, double t, double dt) {
    const double x = -forces.drag * dt / state.mass;
    const Vector3 acceleration = force_at_rest(state, forces, t) / state.mass;
    state.position +=
        state.velocity * dt * mean_decay(x) + acceleration * dt * dt * second_mean_decay(x);
    state.velocity = state.velocity * std::exp(-x) + acceleration * dt * mean_decay(x);
    return state;
}

}  // namespace nutshell::mistakes

namespace nutshell::alternatives {

template <class State, class Forces>
State kick_through_the_terminal_velocity(State state, const Forces& forces, double t, double dt) {
    const Vector3 acceleration = force_at_rest(state, forces, t) / state.mass;
    if (forces.drag == 0) {
        state.position += state.velocity * dt + acceleration * dt * dt / 2;
        state.velocity += acceleration * dt;
        return state;
    }
    const double x = forces.drag * dt / state.mass;
    const Vector3 terminal = acceleration * state.mass / forces.drag,
                  excess = state.velocity - terminal;
    state.position += terminal * dt - excess * dt * std::expm1(-x) / x;
    state.velocity = terminal + excess * std::exp(-x);
    return state;
}

}  // namespace nutshell::alternatives

namespace nutshell::exercises {

inline Exercise ExponentialKick::about() {
    return {
        .title = "The exact step under drag",
        .hints = {"Without the drag the force would be constant over the step. With it, the "
                  "velocity falls towards the terminal velocity as an exponential. Add that "
                  "velocity up, and you have the way.",
                  "Let x = gamma dt/m. The old velocity decays by e^-x; what the force adds is "
                  "the acceleration times dt, times the mean of the decay. mean_decay and "
                  "second_mean_decay are there for you.",
                  "The way of the old velocity is its mean over the step; the way of what the "
                  "force adds is the mean of a mean: acceleration times dt squared times "
                  "second_mean_decay. force_at_rest gives the force without its drag."},
        .mistakes =
            {{"the drift uses the new velocity", "curriculum: scaling v alone",
              "Everything falls a little too far, and less so with smaller steps.",
              "The velocity is exact, and then you drift a whole step with that of the end. The "
              "drift must add up the velocity as it decays.",
              attempt<ExponentialKick>(NUTSHELL_CALL(mistakes::kick_scales_and_drifts))},
             {"the drift uses the old velocity", "classic",
              "Everything moves too far, as if the drag began one step late.",
              "You drift with the velocity of the start, but it decays on the way: take its mean "
              "over the step.",
              attempt<ExponentialKick>(
                  NUTSHELL_CALL(mistakes::kick_drifts_with_the_old_velocity))},
             {"the velocity overwritten too early", "classic",
              "Everything falls too far, though its speed is right.",
              "The velocity is exact. But it is written before the way is added up, and the "
              "formula for the way wants that of the start.",
              attempt<ExponentialKick>(
                  NUTSHELL_CALL(mistakes::kick_overwrites_the_velocity_first))},
             {"a fixed factor", "classic: v *= 0.98 per step",
              "At 144 Hz the drag is nearly five times as strong as at 30 Hz.",
              "You scale the velocity by a number that knows nothing of dt, gamma and the mass. "
              "The factor of a step is e^(-gamma dt/m).",
              attempt<ExponentialKick>(NUTSHELL_CALL(mistakes::kick_by_a_fixed_factor))},
             {"drag without the mass", "classic",
              "Heavy things are braked as much as light ones.",
              "The exponent is gamma dt over the mass.",
              attempt<ExponentialKick>(NUTSHELL_CALL(mistakes::kick_without_mass))},
             {"the drag twice", "classic", "Things stop twice as fast as they should.",
              "You use the whole force, which has the drag in it, and then let the velocity "
              "decay as well. Use force_at_rest.",
              attempt<ExponentialKick>(NUTSHELL_CALL(mistakes::kick_counts_the_drag_twice))},
             {"no drag is a division by zero", "E08's kin",
              "Where the air is turned off, everything becomes NaN.",
              "The terminal velocity F/gamma is infinite where there is no drag. Written with "
              "mean_decay and second_mean_decay, no drag is no special case.",
              attempt<ExponentialKick>(NUTSHELL_CALL(mistakes::kick_divides_by_the_drag))},
             {"a decay that grows", "classic: the sign", "Everything is thrown out of the level.",
              "The exponent has the wrong sign: drag makes the velocity decay.",
              attempt<ExponentialKick>(NUTSHELL_CALL(mistakes::kick_grows))}},
        .alternatives = {{"through the terminal velocity",
                          attempt<ExponentialKick>(
                              NUTSHELL_CALL(alternatives::kick_through_the_terminal_velocity))}},
    };
}

}  // namespace nutshell::exercises

#endif
