// Chapter 3 · Drag and springs without error: where a force is linear, its exact effect over a
// whole step is known.
//
// The forces given to these methods have a member `drag` (gamma [kg/s]) for the linear drag
// they contain.
#pragma once
#include <nutshell/revised_newton.hpp>

namespace nutshell {

// [drag_verbs]
/// Stop: the body is where it was, at rest.
inline void stop(PointMass& body) {
    body.velocity.setZero();
}

/// Decay: linear drag alone, gamma = `drag` [kg/s], acts on the body for dt seconds, exactly.
inline void decay(PointMass& body, double drag, double dt) {
    body.velocity *= std::exp(-drag * dt / body.mass);
}

/// The same by implicit Euler: by 1/(1 + gamma dt/m). Needs no exponential; first order.
inline void implicit_decay(PointMass& body, double drag, double dt) {
    body.velocity *= 1 / (1 + drag * dt / body.mass);
}

/// The force without its linear drag: what the body would feel here at rest.
template <class State, class Forces>
auto force_at_rest(State state, const Forces& forces, double t) {
    stop(state);
    return forces(state, t);
}
// [/drag_verbs]

// The same verbs for chapter 2's particle: drag takes from the momentum.
inline void stop(Particle& body) {
    body.momentum.setZero();
}
inline void decay(Particle& body, double drag, double dt) {
    body.momentum *= std::exp(-drag * dt / body.mass);
}
inline void implicit_decay(Particle& body, double drag, double dt) {
    body.momentum *= 1 / (1 + drag * dt / body.mass);
}

/// The function phi_1 of exponential integrators, (e^z - 1)/z; 1 at z = 0. phi_1(-x) is the mean
/// of a decay e^-x over its interval.
inline double phi_1(double z) {
    return z == 0 ? 1 : std::expm1(z) / z;
}

/// phi_2, (phi_1(z) - 1)/z; 1/2 at z = 0. By its series where the difference would lose digits.
inline double phi_2(double z) {
    if (std::abs(z) > 0.5) return (phi_1(z) - 1) / z;
    double term = 0.5, sum = 0.5;
    for (int n = 3; std::abs(term) > 1e-17; ++n) sum += term *= z / n;
    return sum;
}

/// A constant force [N] beside a linear drag.
struct UnderForce {
    Vector3 force;
    double drag;  ///< gamma [kg/s]
    Vector3 operator()(const PointMass&, double) const { return force; }
};

// [exponential_kick]
/// One step under a constant force and linear drag, exact at any step: the velocity falls
/// towards the terminal velocity F/gamma as e^(-gamma t/m), and the drift adds up that
/// velocity. First order where the force changes. Eqs. (3.d)-(3.e), written so that no drag
/// (gamma = 0) is no special case.
template <class State, class Forces>
State exponential_kick(State state, const Forces& forces, double t, double dt) {
    // exercise 3.5
    const double x = forces.drag * dt / state.mass;
    const Vector3 acceleration = force_at_rest(state, forces, t) / state.mass;
    state.position += state.velocity * dt * phi_1(-x) + acceleration * dt * dt * phi_2(-x);
    state.velocity = state.velocity * std::exp(-x) + acceleration * dt * phi_1(-x);
    return state;
    // end 3.5
}
// [/exponential_kick]

/// The same for a particle, which is a point mass that keeps its momentum.
template <class Forces>
Particle exponential_kick(Particle body, const Forces& forces, double t, double dt) {
    const UnderForce without_drag{force_at_rest(body, forces, t), forces.drag};
    const PointMass moved = exponential_kick(PointMass{body.mass, body.position, velocity(body)},
                                             without_drag, t, dt);
    return in_momentum(moved);
}

// [exponential_verlet]
/// One step of Verlet with linear drag: half the drag, a Verlet step of the other forces, half
/// the drag, the drag by its exact decay. Second order, symmetric, stable on a damped spring
/// while omega dt < 2 (half-drag outermost).
template <class State, class Forces>
State exponential_verlet(State state, const Forces& forces, double t, double dt) {
    // exercise 3.6
    decay(state, forces.drag, dt / 2);
    kick(state, force_at_rest(state, forces, t), dt / 2);
    drift(state, dt);
    kick(state, force_at_rest(state, forces, t + dt), dt / 2);
    decay(state, forces.drag, dt / 2);
    return state;
    // end 3.6
}
// [/exponential_verlet]

// [exponential_verlet_inside]
/// The same with the half-drags next to the drift: stable while (omega dt)^2 < 2 (1 +
/// E)/sqrt(E), E = e^(-gamma dt/m). Keeps the force of its end for the next step ("first same
/// as last"): one evaluation a step. One object per run.
template <class State, class Push>
struct ExponentialVerletInside {
    std::optional<Push> kept = {};
    State still = State();

    template <class Forces>
    State operator()(State state, const Forces& forces, double t, double dt) {
        if (!kept) evaluate_at_rest(state, forces, t);
        kick(state, *kept, dt / 2);
        decay(state, forces.drag, dt / 2);
        drift(state, dt);
        decay(state, forces.drag, dt / 2);
        evaluate_at_rest(state, forces, t + dt);
        kick(state, *kept, dt / 2);
        return state;
    }

    /// kept = force_at_rest(state, forces, t), in the room that is here already.
    template <class Forces>
    void evaluate_at_rest(const State& state, const Forces& forces, double t) {
        if (!kept) kept.emplace();
        still = state;
        stop(still);
        evaluate(forces, std::as_const(still), t, *kept);
    }
};
// [/exponential_verlet_inside]

// [semi_implicit_drag]
/// Semi-implicit Euler with the drag by its exact decay, before the kick. First order; on a
/// damped spring stable while omega dt < sqrt(2 (1 + e^(-gamma dt/m))).
template <class State, class Forces>
State semi_implicit_exponential(State state, const Forces& forces, double t, double dt) {
    decay(state, forces.drag, dt);
    kick(state, force_at_rest(state, forces, t), dt);
    drift(state, dt);
    return state;
}

/// Semi-implicit Euler with implicit drag, that of the velocity at the end. First
/// order; on a damped spring stable while dt < (nu + sqrt(nu^2 + 4 omega^2))/omega^2, nu =
/// gamma/m.
template <class State, class Forces>
State semi_implicit_division(State state, const Forces& forces, double t, double dt) {
    kick(state, force_at_rest(state, forces, t), dt);
    implicit_decay(state, forces.drag, dt);
    drift(state, dt);
    return state;
}
// [/semi_implicit_drag]

// [oscillation]
/// What a damped oscillator x'' = -omega^2 x - nu x' does in a time t, as a matrix on (x, x').
/// Exact in all three regimes (under-, critically and over-damped), to a few units of
/// round-off; omega [rad/s] and nu = gamma/m [1/s] not negative. Eq. (3A.c).
inline Eigen::Matrix2d oscillation(double omega, double nu, double t) {
    const double d = nu / 2, D = omega * omega - d * d;
    // e^(-d t) cos(rt), e^(-d t) sin(rt)/r, r = sqrt(D); cosh and sinh where D is negative; near
    // critical two terms of their series suffice
    double c, s;
    if (const double r = std::sqrt(std::abs(D)); r * t < 1e-4) {
        c = std::exp(-d * t) * (1 - D * t * t / 2);
        s = std::exp(-d * t) * t * (1 - D * t * t / 6);
    } else if (D > 0) {
        c = std::exp(-d * t) * std::cos(r * t);
        s = std::exp(-d * t) * std::sin(r * t) / r;
    } else {
        const double slow = std::exp(-omega * omega / (d + r) * t), fast = std::exp(-(d + r) * t);
        c = (slow + fast) / 2;
        s = -slow * std::expm1(-2 * r * t) / (2 * r);
    }
    Eigen::Matrix2d step;
    step << c + d * s, s, -omega * omega * s, c - d * s;
    return step;
}
// [/oscillation]

// [spring_propagator]
/// The exact step of a body on a spring of rest length zero, with or without linear drag: four
/// numbers, computed once for each length of step. Nothing is left to integrate; it asks for no
/// force at all.
struct SpringPropagator {
    double omega;      ///< sqrt(kappa/m) [rad/s]
    double nu = 0;     ///< gamma/m [1/s]
    double known = 0;  ///< the step the matrix belongs to [s]
    Eigen::Matrix2d step = Eigen::Matrix2d::Identity();

    template <class State, class Forces>
    State operator()(State state, const Forces&, double, double dt) {
        if (dt != known) step = oscillation(omega, nu, dt), known = dt;
        const Vector3 position = step(0, 0) * state.position + step(0, 1) * state.velocity;
        state.velocity = step(1, 0) * state.position + step(1, 1) * state.velocity;
        state.position = position;
        return state;
    }
};
// [/spring_propagator]

}  // namespace nutshell
