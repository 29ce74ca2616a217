// An error study, and numbers within a distance: shared by the tests of this
// room.
#pragma once
#include <nutshell/lab/run.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/revised_newton_scenes.hpp>
#include "check.hpp"

constexpr double epsilon = std::numeric_limits<double>::epsilon();

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

/// CHECK(x == near(value, within)): not farther than `within` from `value`; prints both.
struct Near {
    double value, within;
};
inline Near near(double value, double within) {
    return {value, within};
}
inline bool operator==(double x, const Near& n) {
    return std::abs(x - n.value) <= n.within;
}
inline std::ostream& operator<<(std::ostream& out, const Near& n) {
    return out << n.value << " +- " << n.within;
}

/// The integral of f from 0 to T by Simpson's rule with n (even) intervals.
template <class F>
nutshell::Vector3 simpson(const F& f, double T, int n) {
    const double h = T / n;
    nutshell::Vector3 sum = f(0) + f(T);
    for (int i = 1; i < n; ++i) sum += (i % 2 ? 4 : 2) * f(i * h);
    return sum * (h / 3);
}
