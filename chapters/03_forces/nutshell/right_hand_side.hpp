// Chapter 3 · A scene as a general-purpose method sees it: y' = f(t, y), with y one flat list
// of numbers.
#pragma once
#include <nutshell/revised_newton.hpp>

namespace nutshell {

// [flat]
/// Position [m] and velocity [m/s] of a point mass, one after the other.
using FlatPoint = Eigen::Matrix<double, 6, 1>;

inline FlatPoint flat(const PointMass& body) {
    FlatPoint y;
    y << body.position, body.velocity;
    return y;
}

/// The body `like`, but where y says. Its mass does not change.
inline PointMass unflat(const FlatPoint& y, PointMass like) {
    like.position = y.head<3>();
    like.velocity = y.tail<3>();
    return like;
}

/// How the flat state changes per second: position by the velocity, velocity by force [N] over
/// mass.
inline FlatPoint rate(const PointMass& body, const Vector3& force) {
    FlatPoint y;
    y << body.velocity, force / body.mass;
    return y;
}
// [/flat]

// The same three for a particle of chapter 2: position [m] and momentum [kg m/s].
inline FlatPoint flat(const Particle& body) {
    FlatPoint y;
    y << body.position, body.momentum;
    return y;
}
inline Particle unflat(const FlatPoint& y, Particle like) {
    like.position = y.head<3>();
    like.momentum = y.tail<3>();
    return like;
}
inline FlatPoint rate(const Particle& body, const Vector3& force) {
    FlatPoint y;
    y << velocity(body), force;
    return y;
}

// A state that is flat already is its own flat form, and its push is its rate.
template <int Size>
Eigen::Matrix<double, Size, 1> flat(const Eigen::Matrix<double, Size, 1>& y) {
    return y;
}
template <int Size>
Eigen::Matrix<double, Size, 1> unflat(const Eigen::Matrix<double, Size, 1>& y,
                                      const Eigen::Matrix<double, Size, 1>&) {
    return y;
}
template <int Size>
Eigen::Matrix<double, Size, 1> rate(const Eigen::Matrix<double, Size, 1>&,
                                    const Eigen::Matrix<double, Size, 1>& push) {
    return push;
}

// [right_hand_side]
/// The right-hand side f of y' = f(t, y), called as f(y, t), for any state that has flat, unflat
/// and rate. @param like  what the flat form leaves out, such as masses
template <class State, class Forces>
auto right_hand_side(const State& like, const Forces& forces) {
    return [&](const auto& y, double t) {
        const State state = unflat(y, like);
        return rate(state, forces(state, t));
    };
}

/// The stepper of a general-purpose method: it moves the flat form of any state.
/// @tparam Step  called as step(y, f, t, dt)
template <class Step>
struct FlatStepper {
    Step step;

    template <class State, class Forces>
    State operator()(const State& state, const Forces& forces, double t, double dt) {
        return unflat(step(flat(state), right_hand_side(state, forces), t, dt), state);
    }
};
// [/right_hand_side]

/// How a run of a general-purpose method that keeps nothing starts.
template <class Step>
constexpr auto on_flat(Step step) {
    return [step](const auto&) { return FlatStepper<Step>{step}; };
}

}  // namespace nutshell
