// The questions that the methods for a pose are asked alike.
#pragma once
#include <nutshell/spinning_scenes.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

/// An angular velocity that lets no slip hide: it depends on the time, and if `held` is not zero
/// on the pose.
struct Wobble {
    double held, swing = 1;
    Vector3 operator()(const Quaternion& pose, double t) const {
        return swing * Vector3(0.9 - t, 1.4 * t, -0.7 + t * t) +
               held * (pose.toRotationMatrix() * Vector3(0.8, -0.5, 1.1));
    }
};

/// Single steps; then coning for 0.8 s, against its closed form.
template <class Answer>
void ask_spin(Paper& paper, const Answer& answer, double held) {
    const double dt = paper.step(0.2);
    const Quaternion a = Quaternion(0.4, 0.3, -0.5, 0.7).normalized(),
                     b = Quaternion(0.9, -0.6, 0.2, 0.1).normalized();
    const auto step = [&](const Quaternion& q, const Wobble& spin, double t) {
        paper.input("q", q, "t", t, "dt", dt, "how far spin swings", spin.swing);
        paper.frame(q);
        const Quaternion next = answer(q, spin, t, dt);
        paper.output("the pose", next, 1.0);
    };
    step(a, {held}, 0.6), step(b, {held}, 0.6), step(a, {held}, 1.7), step(a, {held, -0.4}, 0.6);
    const Coning scene;
    Quaternion q = scene.start;
    for (int n = 0; n < std::lround(0.8 / dt); ++n) q = answer(q, scene, n * dt, dt);
    paper.input("q", "coning, from the start", "dt", dt);
    paper.run("the pose after 0.8 s", q, scene.exact(0.8), 1.0);
}

#ifndef NUTSHELL_SHEET
/// Exp, product and all by Eigen's own means.
inline Quaternion exp_of(const Vector3& a) {
    return a.norm() == 0 ? Quaternion(1, 0, 0, 0)
                         : Quaternion(Eigen::AngleAxisd(a.norm(), a.normalized()));
}
#endif

}  // namespace nutshell::exercises
