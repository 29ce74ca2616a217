// What the tests of chapter 3 share: errors at several steps.
#pragma once
#include <nutshell/lab/run.hpp>
#include "check.hpp"

/// The largest error of a run at each number of steps.
template <class Scene, class Method>
Convergence errors(const Scene& scene, const Method& method, const std::vector<long>& steps) {
    Convergence c;
    for (const long n : steps) {
        const auto m = nutshell::lab::measure(scene, method, n);
        c.dt.push_back(m.dt), c.error.push_back(m.max_error);
    }
    return c;
}
