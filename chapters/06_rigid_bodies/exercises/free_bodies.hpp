// What the exercises about turning bodies share: the questions, and Eigen's own means.
#pragma once
#include <nutshell/free_top.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

/// Asks a way to turn a body: single steps for bodies, poses and spins of several kinds; then 0.8
/// s of free motion, against its closed form.
template <class Answer>
void ask_rotation(Paper& paper, const Answer& answer) {
    const double dt = paper.step(0.4);
    const Quaternion a = Quaternion(0.4, 0.3, -0.5, 0.7).normalized(),
                     b = Quaternion(0.9, -0.6, 0.2, 0.1).normalized();
    const Vector3 flat(1.1, 2.3, 2.9), long_one(2.6, 0.7, 2.2), L(2.3, -4.1, 1.7),
        M(-1.9, 3.2, 4.4);
    const auto step = [&](const Vector3& inertia, Quaternion q, const Vector3& l) {
        paper.input("inertia", inertia, "q", q, "L", l, "dt", dt);
        paper.frame(q);
        answer(inertia, q, l, dt);
        paper.output("the pose", q, 1.0);
    };
    step(flat, a, L), step(long_one, a, L), step(flat, b, L), step(flat, a, M);
    const FreeTop exact(long_one, a, L);
    Quaternion q = a;
    for (int n = 0; n < std::lround(0.8 / dt); ++n) answer(long_one, q, L, dt);
    paper.input("q", "a free body, from the start", "dt", dt);
    paper.run("the pose after 0.8 s", q, exact.pose(0.8), 1.0);
}

#ifndef NUTSHELL_SHEET
/// Exp by Eigen's own means.
inline Quaternion turn_by(const Vector3& a) {
    return a.norm() == 0 ? Quaternion(1, 0, 0, 0)
                         : Quaternion(Eigen::AngleAxisd(a.norm(), a.normalized()));
}
/// L in the body's axes, and omega in the world's.
inline Vector3 in_body_axes(const Quaternion& q, const Vector3& L) {
    return q.conjugate() * L;
}
inline Vector3 omega_of(const Vector3& inertia, const Quaternion& q, const Vector3& L) {
    return q * Vector3(in_body_axes(q, L).cwiseQuotient(inertia));
}
#endif

}  // namespace nutshell::exercises
