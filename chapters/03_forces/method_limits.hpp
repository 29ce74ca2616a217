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
inline double size_of(const FlatPoint& y) {
    return y.cwiseAbs().maxCoeff();
}

/// What a method moves: bodies, or flows y' = flow(y, t).
struct Bodies {
    template <class Scene>
    const Scene& operator()(const Scene& scene) const {
        return scene;
    }
};
struct Flows {
    Flow<MassOnSpring> operator()(const MassOnSpring& scene) const { return Flow(scene); }
    NetFlow operator()(const SpringNet& net) const { return NetFlow(net); }
};

/// The force a method keeps for its next step: part of its state.
inline std::optional<Vector3>& kept_force(VerletFsal<Vector3>& method) {
    return method.kept;
}
template <std::size_t Count>
std::optional<Vector3>& kept_force(Composed<VerletFsal<Vector3>, Count>& method) {
    return method.method.kept;
}

/// One step on a spring as a matrix on (x, v), and on the force where the method keeps one.
template <class Method>
Eigen::MatrixXd spring_matrix(const Method& method, Bodies, double omega, double g, double dt) {
    constexpr bool keeps = requires(Method m) {
        kept_force(m);
    };
    const MassOnSpring scene = spring_of(omega, g);
    return lab::step_matrix(Eigen::VectorXd::Zero(keeps ? 3 : 2), [&](const Vector& y) -> Vector {
        Method fresh = method;  // one that remembers starts fresh
        if constexpr (keeps) kept_force(fresh) = Vector3(y[2], 0, 0);
        const PointMass body = fresh(PointMass{1, {y[0], 0, 0}, {y[1], 0, 0}}, scene, 0.0, dt);
        if constexpr (keeps)
            return Vector3(body.position.x(), body.velocity.x(), kept_force(fresh)->x());
        return Eigen::Vector2d(body.position.x(), body.velocity.x());
    });
}
template <class Method>
Eigen::MatrixXd spring_matrix(const Method& method, Flows, double omega, double g, double dt) {
    const Flow<MassOnSpring> flow(spring_of(omega, g));
    return lab::step_matrix(Eigen::VectorXd::Zero(2), [&](const Vector& y) -> Vector {
        FlatPoint flat = FlatPoint::Zero();
        flat[0] = y[0], flat[3] = y[1];
        flat = Method(method)(flat, flow, 0.0, dt);
        return Eigen::Vector2d(flat[0], flat[3]);
    });
}

/// The limit by the largest eigenvalue of that matrix: 0 if no step is stable, infinite if all
/// are to 300/(omega + g). (Far beyond, a composition's steps back overflow.)
template <class Method, class As>
double limit_by_eigenvalue(const Method& method, As as, double omega, double g) {
    if (omega > 0 && omega != 1)  // in units of 1/omega, in which the matrix is well scaled
        return limit_by_eigenvalue(method, as, 1, g / omega) / omega;
    constexpr double slack = 2e-11;  // eigenvalues 1e-5 apart are known no better
    const double smallest = 0.005 / (omega + g);
    const double limit = first_limit(
        [&](double dt) {
            return 1 + slack - lab::spectral_radius(spring_matrix(method, as, omega, g, dt));
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

/// Calls visit(name, method, as, theory) for every method; as is Bodies{} or Flows{}, theory an
/// OnSpring whose limit is the closed form, or where there is none the largest eigenvalue.
/// @tparam Push, Flat  what the scene's forces and flat states are: Vector3 and FlatPoint for one
/// body, ForceArrays and Vector for a net
template <class Push, class Flat, class Visit>
void each_method(const Visit& visit) {
    const Bodies bodies;
    const Flows flows;
    // `single` is the method for one body: the same, but where the type of what it keeps differs.
    const auto row = [&](const char* name, const auto& method, const auto& single, auto as,
                         const auto& limit) {
        visit(std::string(name), method, as,
              OnSpring{limit, [single, as](double omega, double g, double dt) {
                           return spring_matrix(single, as, omega, g, dt);
                       }});
    };
    const auto body = [&](const char* name, const auto& method, const auto& limit) {
        row(name, method, method, bodies, limit);
    };
    const auto by_eigenvalue = [&](const char* name, const auto& method, const auto& single) {
        row(name, method, single, bodies, [single](double omega, double g) {
            return limit_by_eigenvalue(single, Bodies{}, omega, g);
        });
    };
    const auto flow = [&](const char* name, const auto& method, const auto& single,
                          Complex (*amplification)(Complex)) {
        row(name, method, single, flows, [amplification](double omega, double g) {
            return general_limit(amplification, omega, g);
        });
    };
    const Composed<Verlet, 3> yoshida{{}, yoshida_weights()};
    const Composed<Verlet, 15> kahan_li{{}, kahan_li_weights()};

    body("Euler", euler_method, euler_limit);
    body("semi-implicit Euler", semi_implicit_euler_method, semi_implicit_limit);
    body("semi-implicit, implicit drag", semi_implicit_division_method, division_limit);
    body("semi-implicit, exponential drag", semi_implicit_exponential_method, exponential_limit);
    by_eigenvalue("exponential kick", exponential_kick_method, exponential_kick_method);
    body("Verlet, naive", verlet_method, naive_verlet_limit);
    by_eigenvalue("Verlet, kept force", VerletFsal<Push>{}, VerletFsal<Vector3>{});
    body("exponential Verlet", exponential_verlet_method,
         [](double omega, double) { return exponential_verlet_limit(omega); });
    row("exponential Verlet, half-drags inside", ExponentialVerlet<Push>{}, ExponentialVerlet<>{},
        bodies, exponential_verlet_inside_limit);
    by_eigenvalue("Yoshida 4, naive", yoshida, yoshida);
    by_eigenvalue("Yoshida 4, kept force", yoshida4<Push>(), yoshida4());
    by_eigenvalue("exponential Yoshida 4", exponential_yoshida4<Push>(), exponential_yoshida4());
    by_eigenvalue("Kahan-Li 8, naive", kahan_li, kahan_li);
    by_eigenvalue("Kahan-Li 8, kept force", kahan_li8<Push>(), kahan_li8());
    flow("explicit midpoint", explicit_midpoint_method, explicit_midpoint_method,
         Amplification::midpoint);
    flow("RK4", rk4_method, rk4_method, Amplification::rk4);
    flow("Dormand-Prince 5(4)", DormandPrince<Flat>{}, DormandPrince<FlatPoint>{},
         Amplification::dormand_prince);
    flow("implicit Euler", implicit_euler_method, implicit_euler_method,
         Amplification::implicit_euler);
    flow("implicit midpoint", implicit_midpoint_method, implicit_midpoint_method,
         Amplification::implicit_midpoint);
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

/// The greatest speed [m/s] of any particle; of a flat state, the greatest number among its
/// velocities.
inline double fastest_speed(const Particles& all) {
    double most = 0;
    for (std::size_t i = 0; i < all.size(); ++i) most = std::max(most, all.velocity[i].norm());
    return most;
}
inline double fastest_speed(const Vector& y) {
    return y.tail(y.size() / 2).lpNorm<Eigen::Infinity>();
}

}  // namespace nutshell
