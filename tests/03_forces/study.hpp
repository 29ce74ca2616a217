// What the tests of chapter 3 share: errors at several steps, and one step of any method as a matrix on (x, v).
#pragma once
#include <nutshell/flow.hpp>
#include <nutshell/lab/stability.hpp>
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

/// One step of a kick-and-drift method along x, as a matrix on (x, v).
template <class Scene, class Method>
Eigen::MatrixXd matrix_of(const Scene& scene, const Method& method, double dt) {
    return nutshell::lab::step_matrix(Eigen::VectorXd::Zero(2), [&](const Eigen::VectorXd& y) -> Eigen::VectorXd {
        nutshell::PointMass body = scene.start;
        body.position = {y[0], 0, 0}, body.velocity = {y[1], 0, 0};
        Method fresh = method;   // one that remembers starts fresh
        body = fresh(body, scene, 0.0, dt);
        return Eigen::Vector2d(body.position.x(), body.velocity.x());
    });
}

/// The same for a method that takes flows.
template <class Scene, class Method>
Eigen::MatrixXd matrix_of_flow(const Scene& scene, const Method& method, double dt) {
    const nutshell::Flow<Scene> flow(scene);
    return nutshell::lab::step_matrix(Eigen::VectorXd::Zero(2), [&](const Eigen::VectorXd& y) -> Eigen::VectorXd {
        nutshell::FlatPoint flat = nutshell::FlatPoint::Zero();
        flat[0] = y[0], flat[3] = y[1];
        Method fresh = method;
        flat = fresh(flat, flow, 0.0, dt);
        return Eigen::Vector2d(flat[0], flat[3]);
    });
}
