// The methods of chapter 5 in a form the lab runs, and errors at several steps: shared by this room.
#pragma once
#include <nutshell/lab/study.hpp>
#include <nutshell/spinning_limits.hpp>
#include <nutshell/spinning_scenes.hpp>
#include "check.hpp"

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double identity = 16 * epsilon;  ///< what identities of rotations hold to, times their condition

#define SPIN_METHOD(name)                                                      \
    [](const nutshell::Quaternion& q, const auto& spin, double t, double dt) { \
        return nutshell::name(q, spin, t, dt);                                 \
    }

/// Maximum errors of a scene at several numbers of steps.
template <class Scene, class Method>
Convergence convergence(const Scene& scene, const Method& method, const std::vector<long>& steps) {
    Convergence c;
    for (const long n : steps) {
        const auto m = nutshell::lab::measure(scene, method, n);
        c.dt.push_back(m.dt), c.error.push_back(m.max_error);
    }
    return c;
}

inline double apart(const nutshell::Quaternion& a, const nutshell::Quaternion& b) {
    return (a.coeffs() - b.coeffs()).norm();
}
