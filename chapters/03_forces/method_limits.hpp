// Every method of the chapter beside its largest stable step on one spring, from theory: for the
// chapter's program and its tests, which find the same steps by running.
#pragma once
#include <functional>
#include <nutshell/forces_methods.hpp>
#include <nutshell/forces_scenes.hpp>
#include <nutshell/lab/stability.hpp>
#include <nutshell/spring_limits.hpp>
#include <nutshell/stability_limits.hpp>

namespace nutshell {

/// 1 kg on a spring with omega [rad/s] and g = gamma/m [1/s], or with drag alone (omega = 0);
/// started so that every mode takes part.
inline MassOnSpring spring_of(double omega, double g) {
    MassOnSpring scene;
    scene.stiffness = omega * omega, scene.drag = g;
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
Eigen::MatrixXd spring_matrix(const Method& method, double omega, double g, double dt) {
    const MassOnSpring scene = spring_of(omega, g);
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
/// are to 300/(omega + g). (Far beyond, a composition's steps back overflow.)
template <class Method>
double limit_by_eigenvalue(const Method& method, double omega, double g) {
    if (omega > 0 && omega != 1)  // in units of 1/omega, in which the matrix is well scaled
        return limit_by_eigenvalue(method, 1, g / omega) / omega;
    constexpr double slack = 2e-11;  // eigenvalues 1e-5 apart are known no better
    const double smallest = 0.005 / (omega + g);
    const double limit = first_limit(
        [&](double dt) {
            return 1 + slack - lab::spectral_radius(spring_matrix(method, omega, g, dt));
        },
        smallest, 60'000);
    return limit < smallest ? 0 : limit;
}

/// What theory knows of a method on one spring.
struct OnSpring {
    std::function<double(double omega, double g)> limit;  ///< the largest stable step [s]
    std::function<Eigen::MatrixXd(double omega, double g, double dt)> matrix;  ///< of one step

    /// What one step of `dt` multiplies the fastest growing error by.
    double growth(double omega, double g, double dt) const {
        return lab::spectral_radius(matrix(omega, g, dt));
    }
    /// So many steps at 1.01 of the limit let an error grow so many times.
    long steps_to_grow(double times, double omega, double g) const {
        return std::lround(
            std::ceil(std::log(times) / std::log(growth(omega, g, 1.01 * limit(omega, g)))));
    }
};

/// Calls visit(method, theory) for every method that moves a body on a spring; theory is an OnSpring
/// whose limit is the closed form, or where there is none the largest eigenvalue.
template <class Visit>
void each_limit(const Visit& visit) {
    const auto known = [&](const auto& method, const auto& limit) {
        visit(method, OnSpring{limit, [&method](double omega, double g, double dt) {
                                   return spring_matrix(method, omega, g, dt);
                               }});
    };
    const auto by_eigenvalue = [&](const auto& method) {
        known(method, [&method](double omega, double g) {
            return limit_by_eigenvalue(method, omega, g);
        });
    };
    const auto general = [&](const auto& method, Complex (*stability)(Complex)) {
        known(method,
              [stability](double omega, double g) { return general_limit(stability, omega, g); });
    };
    known(methods::euler, euler_limit);
    known(methods::semi_implicit_euler, semi_implicit_limit);
    known(methods::semi_implicit_division, division_limit);
    known(methods::semi_implicit_exponential, exponential_limit);
    by_eigenvalue(methods::exponential_kick);
    known(methods::verlet_re_evaluated, verlet_re_evaluated_limit);
    by_eigenvalue(methods::verlet);
    known(methods::exponential_verlet,
          [](double omega, double) { return exponential_verlet_limit(omega); });
    known(methods::exponential_verlet_inside, exponential_verlet_inside_limit);
    by_eigenvalue(methods::yoshida4_re_evaluated);
    by_eigenvalue(methods::yoshida4);
    by_eigenvalue(methods::exponential_yoshida4);
    by_eigenvalue(methods::kahan_li8_re_evaluated);
    by_eigenvalue(methods::kahan_li8);
    general(methods::explicit_midpoint, StabilityFunction::explicit_midpoint);
    general(methods::rk4, StabilityFunction::rk4);
    general(methods::dormand_prince, StabilityFunction::dormand_prince);
    general(methods::implicit_euler, StabilityFunction::implicit_euler);
    general(methods::implicit_midpoint, StabilityFunction::implicit_midpoint);
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
