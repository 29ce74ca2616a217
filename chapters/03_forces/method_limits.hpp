// Every method of the chapter beside its largest stable step on one spring, from theory: for the
// chapter's program and its tests, which find the same steps by running.
#pragma once
#include <functional>
#include <map>
#include <nutshell/forces_methods.hpp>
#include <nutshell/forces_scenes.hpp>
#include <nutshell/lab/stability.hpp>
#include <nutshell/spring_limits.hpp>
#include <nutshell/stability_limits.hpp>

namespace nutshell {

/// 1 kg on a spring with omega [rad/s] and nu = gamma/m [1/s], or with drag alone (omega = 0);
/// started so that every mode takes part.
inline MassOnSpring spring_of(double omega, double nu) {
    MassOnSpring scene;
    scene.stiffness = omega * omega, scene.drag = nu;
    scene.start = {1, {1, 0, 0}, {0.7, 0, 0}};
    return scene;
}

/// How far a run has strayed: the largest number of its state.
inline double size_of(const PointMass& s) {
    return std::max(std::abs(s.position.x()), std::abs(s.velocity.x()));
}

/// The force a stepper keeps for its next step: part of its state, where the force depends on the
/// velocity.
inline std::optional<Vector3>& kept_force(KeptVerlet<Vector3>& step) {
    return step.kept;
}
template <std::size_t Count>
std::optional<Vector3>& kept_force(Composed<KeptVerlet<Vector3>, Count>& step) {
    return step.part.kept;
}

/// One step on a spring as a matrix on (x, v), and on the force where the method keeps one.
template <class Method>
Eigen::MatrixXd spring_matrix(const Method& method, double omega, double nu, double dt) {
    const MassOnSpring scene = spring_of(omega, nu);
    constexpr bool keeps = requires {
        kept_force(std::declval<decltype(method.start(scene))&>());
    };
    return lab::step_matrix(Eigen::VectorXd::Zero(keeps ? 3 : 2), [&](const Vector& y) -> Vector {
        auto step = method.start(scene);
        if constexpr (keeps) kept_force(step) = Vector3(y[2], 0, 0);
        const PointMass body = step(PointMass{1, {y[0], 0, 0}, {y[1], 0, 0}}, scene, 0.0, dt);
        if constexpr (keeps)
            return Vector3(body.position.x(), body.velocity.x(), kept_force(step)->x());
        return Eigen::Vector2d(body.position.x(), body.velocity.x());
    });
}

/// The limit by the largest eigenvalue of that matrix: 0 if no step is stable, infinite if all
/// are to 300/(omega + nu). (Far beyond, a composition's steps back overflow.)
template <class Method>
double limit_by_eigenvalue(const Method& method, double omega, double nu) {
    if (omega > 0 && omega != 1)  // in units of 1/omega, in which the matrix is well scaled
        return limit_by_eigenvalue(method, 1, nu / omega) / omega;
    constexpr double slack = 2e-11;  // eigenvalues 1e-5 apart are known no better
    const double smallest = 0.005 / (omega + nu);
    const double limit = first_limit(
        [&](double dt) {
            return 1 + slack - lab::spectral_radius(spring_matrix(method, omega, nu, dt));
        },
        smallest, 60'000);
    return limit < smallest ? 0 : limit;
}

/// What theory knows of a method on one spring.
struct OnSpring {
    std::function<double(double omega, double nu)> limit;  ///< the largest stable step [s]
    std::function<Eigen::MatrixXd(double omega, double nu, double dt)> matrix;  ///< of one step

    /// What one step of `dt` multiplies the fastest growing error by.
    double growth(double omega, double nu, double dt) const {
        return lab::spectral_radius(matrix(omega, nu, dt));
    }
    /// So many steps at 1.01 of the limit let an error grow so many times.
    long steps_to_grow(double times, double omega, double nu) const {
        return std::lround(
            std::ceil(std::log(times) / std::log(growth(omega, nu, 1.01 * limit(omega, nu)))));
    }
};

using Limit = std::function<double(double omega, double nu)>;

/// The limits that have a closed form, by method.
inline const std::map<std::string, Limit>& closed_forms() {
    const auto general = [](Complex (*stability)(Complex)) -> Limit {
        return [=](double omega, double nu) { return general_limit(stability, omega, nu); };
    };
    static const std::map<std::string, Limit> forms{
        {methods::euler.name, euler_limit},
        {methods::semi_implicit_euler.name, semi_implicit_limit},
        {methods::semi_implicit_division.name, division_limit},
        {methods::semi_implicit_exponential.name, exponential_limit},
        {methods::verlet_re_evaluated.name, verlet_re_evaluated_limit},
        {methods::exponential_verlet.name,
         [](double omega, double) { return exponential_verlet_limit(omega); }},
        {methods::exponential_verlet_inside.name, exponential_verlet_inside_limit},
        {methods::explicit_midpoint.name, general(StabilityFunction::explicit_midpoint)},
        {methods::rk4.name, general(StabilityFunction::rk4)},
        {methods::dormand_prince.name, general(StabilityFunction::dormand_prince)},
        {methods::implicit_euler.name, general(StabilityFunction::implicit_euler)},
        {methods::implicit_midpoint.name, general(StabilityFunction::implicit_midpoint)}};
    return forms;
}

/// Calls visit(method, theory) for every method that moves a body on a spring; theory is an OnSpring
/// whose limit is the closed form, or where there is none the largest eigenvalue.
template <class Visit>
void each_limit(const Visit& visit) {
    each(std::tuple_cat(kick_and_drift_methods, general_methods), [&](const auto& method) {
        const auto form = closed_forms().find(method.name);
        const Limit limit =
            form != closed_forms().end() ? form->second : Limit([&](double omega, double nu) {
                return limit_by_eigenvalue(method, omega, nu);
            });
        visit(method, OnSpring{limit, [&](double omega, double nu, double dt) {
                                   return spring_matrix(method, omega, nu, dt);
                               }});
    });
}

/// A net without gravity and drag, each particle that is not held with a little speed [m/s] of
/// its own in the plane of the net: a little of every mode.
inline SpringNet shaken(SpringNet net, double speed = 1e-9) {
    net.g = 0, net.drag = 0;
    for (std::size_t i = 0; i < net.start.size(); ++i) {
        if (std::binary_search(net.held.begin(), net.held.end(), i)) continue;
        const auto k = static_cast<double>(i);
        const double down = net.springs.rows > 1 ? std::sin(2 + 5 * k * k) : 0;
        net.start.velocity.set(i, speed * Vector3(std::sin(1 + 7 * k * k), down, 0));
    }
    return net;
}

/// The greatest speed [m/s] of any particle.
inline double fastest_speed(const Particles& all) {
    double most = 0;
    for (std::size_t i = 0; i < all.size(); ++i) most = std::max(most, all.velocity[i].norm());
    return most;
}
}  // namespace nutshell
