// Chapter 6 · Ways to turn a body for a step, from the printed one to one good for 100 seconds;
// and kick, free motion, kick with any of them.
#pragma once
#include <nutshell/body.hpp>
#include <nutshell/free_top.hpp>

namespace nutshell {

// [printed_rotation]
/// The rotation as printed: the inverse inertia of the body's own axes meets L of the world's.
/// Wrong as soon as the body has turned: it never flips. Source: eqs. (53), (56), listing C10.
inline void printed_rotation(const Vector3& inertia, Quaternion& q, const Vector3& L, double dt) {
    q = product(exponential(L.cwiseQuotient(inertia) * dt), trimmed(q));
}
// [/printed_rotation]

// [explicit_rotation]
/// The printed rotation corrected: the angular velocity of the start, kept for the step. First
/// order; gains energy. Source: eqs. (53*), (56*).
inline void explicit_rotation(const Vector3& inertia, Quaternion& q, const Vector3& L,
                              double dt) {
    // exercise 6.8
    q = product(exponential(angular_velocity(inertia, q, L) * dt), trimmed(q));
    // end 6.8
}
// [/explicit_rotation]

// [magnus_rotation]
/// Fourth order: L in body axes, M' = M x omega, by RK4; the pose by Magnus' formula with omega
/// at the start, the middle (Hermite) and the end; then M as long as L, and the pose turned by
/// the little that is missing between M and L. So L in body axes may be taken from the pose again
/// at the next step (taken at every stage it costs 10^5 times the error near the middle axis).
/// How long a step: see `substeps`; a spin about a principal axis is exact at any.
/// Source: A. Iserles and S. P. Norsett, Phil. Trans. R. Soc. A 357 (1999) 983.
[[gnu::flatten, gnu::always_inline]] inline void magnus_rotation(const Vector3& inertia,
                                                                 Quaternion& q, const Vector3& L,
                                                                 double dt) {
    const double square = L.squaredNorm();
    if (square == 0) return;
    const Quaternion start = trimmed(q);
    const Vector3 J = inertia.cwiseInverse(), M0 = rotate(inverse(start), L);
    const auto rate = [&](const Vector3& M) { return gyroscopic_term(J, M); };
    // exercise 6.11
    const Vector3 k1 = rate(M0), k2 = rate(M0 + dt / 2 * k1), k3 = rate(M0 + dt / 2 * k2),
                  k4 = rate(M0 + dt * k3);
    Vector3 M1 = M0 + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    M1 *= 1.5 - 0.5 * M1.squaredNorm() / square;  // as long as L again
    const Vector3 middle = (M0 + M1) / 2 + dt / 8 * (k1 - rate(M1));
    const Vector3 w0 = J.cwiseProduct(M0), wm = J.cwiseProduct(middle), w1 = J.cwiseProduct(M1);
    const Quaternion turn =
        series_exponential(dt / 6 * (w0 + 4 * wm + w1) + dt * dt / 12 * w0.cross(w1));
    // In the body's axes of the start, L was M0 and must be M0 still.
    const Vector3 missing = rotate(turn, M1).cross(M0) / square;
    q = product(start, product(four_vector(missing / 2, 1), turn));
    // end 6.11
}
// [/magnus_rotation]

// [substeps]
/// The longest turn [rad] of one step of `magnus_rotation`: then any body, wobbling as it may, is
/// off by less than 2e-4 rad, a fifth of a pixel, after ten turns. Twice as long: 16 times that.
inline constexpr double longest_turn = 0.3;

/// Into how many sub-steps a step of dt [s] is to be cut, so that none turns the body further.
/// A spin about a principal axis, or of a ball, needs none of them.
template <Turns State>
int substeps(const State& body, double dt) {
    require_positive(dt, "substeps: the step dt [s]");
    return std::max(
        1, static_cast<int>(std::ceil(angular_velocity(body).norm() * dt / longest_turn)));
}
// [/substeps]

// [kick_free_kick]
/// Half a kick, the free motion with a rotation of your choice, half a kick: Verlet, whose drift
/// is that of `body.hpp`, with another drift.
/// @tparam Rotation  one of the functions above and of free_rotation.hpp and free_top.hpp
template <auto Rotation>
struct KickFreeKick {
    template <Turns State, class Forces>
    State operator()(State state, const Forces& forces, double t, double dt) const {
        kick(state, forces(state, t), dt / 2);
        drift_by<Rotation>(state, dt);
        kick(state, forces(state, t + dt), dt / 2);
        return state;
    }
};

/// The drift of a body with the rotation `Rotation` instead of its own.
template <auto Rotation>
[[gnu::always_inline]] inline void drift_by(Body& body, double dt) {
    body.position += body.momentum / body.mass * dt;
    Rotation(body.inertia, body.orientation, body.angular_momentum, dt);
}
template <auto Rotation>
[[gnu::always_inline]] inline void drift_by(Pinned& body, double dt) {
    Rotation(body.inertia, body.orientation, body.angular_momentum, dt);
}

/// The order of the source: evaluate, drift, kick with what was evaluated (Euler's method), with
/// the rotation `Rotation`. Source: eqs. (50)-(57).
template <auto Rotation>
struct DriftKick {
    template <Turns State, class Forces>
    State operator()(State state, const Forces& forces, double t, double dt) const {
        const auto push = forces(state, t);
        drift_by<Rotation>(state, dt);
        kick(state, push, dt);
        return state;
    }
};

// [/kick_free_kick]

// [engine_step]
/// The step of many game engines, in body axes: M += (gyroscopic term + torque) dt, then turn
/// with the new angular velocity. The gyroscopic term M x omega is what keeps L still in the
/// world. With it this is Euler's method, explicit, and blows up; without it (factor 0, the
/// default of several engines) |L| and the energy are perfect, and L turns with the body.
/// @tparam factor  of the gyroscopic term: 1 right, 0 missing, -1 of the wrong sign, 2 twice
template <int factor = 1>
struct EngineStep {
    template <Turns State, class Forces>
    State operator()(State state, const Forces& forces, double t, double dt) const {
        const Wrench push = forces(state, t);
        const Vector3 M = rotate(inverse(state.orientation), state.angular_momentum);
        const Vector3 gyroscopic = gyroscopic_term(state.inertia.cwiseInverse(), M);
        kick(state,
             push + Wrench{Vector3::Zero(), rotate(state.orientation, factor * gyroscopic)}, dt);
        const Vector3 kicked = rotate(inverse(state.orientation), state.angular_momentum);
        drift_by<explicit_rotation>(state, dt);
        state.angular_momentum = rotate(state.orientation, kicked);  // M stays, L turns along
        return state;
    }
};
// [/engine_step]

}  // namespace nutshell
