// Chapter 3: every method converges at its order, on the scenes it is made for and on those it is not.
#include <nutshell/forces_methods.hpp>
#include <nutshell/forces_scenes.hpp>
#include <nutshell/log_hamiltonian.hpp>
#include <nutshell/stability_limits.hpp>
#include "study.hpp"

using namespace nutshell;

TEST_CASE("orders on the undamped spring") {
    const MassOnSpring spring;
    const Flow flow(spring);
    CHECK_THAT(errors(spring, euler_method, {100000, 200000, 400000}), HasOrder(1));
    CHECK_THAT(errors(spring, semi_implicit_euler_method, {8000, 16000, 32000}), HasOrder(1));
    CHECK_THAT(errors(spring, verlet_method, {1000, 2000, 4000}), HasOrder(2));
    CHECK_THAT(errors(spring, VerletFsal<Vector3>{}, {1000, 2000, 4000}), HasOrder(2));
    CHECK_THAT(errors(spring, yoshida4(), {500, 1000, 2000}), HasOrder(4));
    CHECK_THAT(errors(spring, kahan_li8(), {100, 150, 200}), HasOrder(8, 0.1));
    CHECK_THAT(errors(flow, explicit_midpoint_method, {2000, 4000, 8000}), HasOrder(2));
    CHECK_THAT(errors(flow, rk4_method, {500, 1000, 2000}), HasOrder(4));
    CHECK_THAT(errors(flow, dormand_prince_method, {200, 400, 800}), HasOrder(5));
    CHECK_THAT(errors(flow, implicit_euler_method, {100000, 200000, 400000}), HasOrder(1));
    CHECK_THAT(errors(flow, implicit_midpoint_method, {1000, 2000, 4000}), HasOrder(2));
}

TEST_CASE("orders on the damped spring: drag inside the kick costs Verlet and Yoshida theirs") {
    for (const double ratio : {0.1, 1.0, 2.0}) {
        INFO("damping ratio " << ratio);
        const MassOnSpring spring = MassOnSpring::with_damping(ratio);
        const Flow flow(spring);
        const long k = ratio > 1 ? 6 : 2;  // the fast part of the overdamped spring asks for small steps
        CHECK_THAT(errors(spring, euler_method, {20000, 40000, 80000}), HasOrder(1));
        CHECK_THAT(errors(spring, semi_implicit_euler_method, {10000, 20000, 40000}), HasOrder(1));
        CHECK_THAT(errors(spring, semi_implicit_exponential_method, {20000, 40000, 80000}), HasOrder(1));
        CHECK_THAT(errors(spring, semi_implicit_division_method, {20000, 40000, 80000}), HasOrder(1));
        CHECK_THAT(errors(spring, exponential_kick_method, {20000, 40000, 80000}), HasOrder(1));
        CHECK_THAT(errors(spring, verlet_method, {20000, 40000, 80000}), HasOrder(1));
        CHECK_THAT(errors(spring, VerletFsal<Vector3>{}, {20000, 40000, 80000}), HasOrder(1));
        CHECK_THAT(errors(spring, yoshida4(), {20000, 40000, 80000}), HasOrder(1));
        CHECK_THAT(errors(spring, exponential_verlet_method, {1000, 2000, 4000}), HasOrder(2));
        CHECK_THAT(errors(spring, ExponentialVerlet<>{}, {1000, 2000, 4000}), HasOrder(2));
        CHECK_THAT(errors(spring, exponential_yoshida4(), {800, 1600, 3200}), HasOrder(4));
        CHECK_THAT(errors(flow, rk4_method, {800 * k, 1600 * k, 3200 * k}), HasOrder(4));
        CHECK_THAT(errors(flow, dormand_prince_method, {400 * k, 600 * k, 800 * k}), HasOrder(5, 0.15));
        CHECK_THAT(errors(flow, implicit_midpoint_method, {2000, 4000, 8000}), HasOrder(2));
    }
}

TEST_CASE("orders of falling with linear drag") {
    const FallingWithDrag falling;
    const Flow flow(falling);
    CHECK_THAT(errors(falling, euler_method, {1000, 2000, 4000}), HasOrder(1));
    CHECK_THAT(errors(falling, semi_implicit_euler_method, {1000, 2000, 4000}), HasOrder(1));
    CHECK_THAT(errors(falling, verlet_method, {1000, 2000, 4000}), HasOrder(1));
    CHECK_THAT(errors(falling, VerletFsal<Vector3>{}, {1000, 2000, 4000}), HasOrder(1));
    CHECK_THAT(errors(falling, exponential_verlet_method, {100, 200, 400}), HasOrder(2));
    CHECK_THAT(errors(falling, exponential_yoshida4(), {20, 40, 80}), HasOrder(4));
    CHECK_THAT(errors(flow, explicit_midpoint_method, {200, 400, 800}), HasOrder(2));
    CHECK_THAT(errors(flow, rk4_method, {100, 200, 400}), HasOrder(4));
    CHECK_THAT(errors(flow, dormand_prince_method, {80, 120, 160}), HasOrder(5, 0.1));
    CHECK_THAT(errors(flow, implicit_euler_method, {1000, 2000, 4000}), HasOrder(1));
    CHECK_THAT(errors(flow, implicit_midpoint_method, {200, 400, 800}), HasOrder(2));
    // Scaling the velocity alone, with Euler's drift, is first order under gravity; the exponential kick is
    // exact.
    CHECK_THAT(errors(falling, semi_implicit_exponential_method, {1000, 2000, 4000}), HasOrder(1));
    for (const long steps : {1, 7, 500})
        CHECK(lab::measure(falling, exponential_kick_method, steps).max_error < 1e-12);
}

TEST_CASE("orders of falling in air, where the drag is not linear") {
    const Flow flow{FallingInAir{}};
    CHECK_THAT(errors(flow, explicit_midpoint_method, {200, 400, 800}), HasOrder(2));
    CHECK_THAT(errors(flow, rk4_method, {200, 400, 800}), HasOrder(4));
    CHECK_THAT(errors(flow, dormand_prince_method, {80, 120, 160}), HasOrder(5, 0.1));
    CHECK_THAT(errors(flow, implicit_euler_method, {1000, 2000, 4000}), HasOrder(1));
    CHECK_THAT(errors(flow, implicit_midpoint_method, {200, 400, 800}), HasOrder(2));
}

TEST_CASE("orders on the planet") {
    const Planet planet;
    const Flow flow(planet);
    CHECK_THAT(errors(planet, yoshida4(), {2000, 4000, 8000}), HasOrder(4));
    CHECK_THAT(errors(planet, kahan_li8(), {200, 250, 300}), HasOrder(8, 0.25));
    CHECK_THAT(errors(flow, explicit_midpoint_method, {4000, 8000, 16000}), HasOrder(2));
    CHECK_THAT(errors(flow, rk4_method, {2000, 4000, 8000}), HasOrder(4));
    CHECK_THAT(errors(flow, dormand_prince_method, {1600, 2400, 3200}), HasOrder(5, 0.15));
    CHECK_THAT(errors(flow, implicit_midpoint_method, {2000, 4000, 8000}), HasOrder(2));
}

namespace {

/// A spring whose other end is shaken: 1 kg, x'' = -omega^2 x - g x' + cos(3 t). A step that asks for the
/// force at a wrong time loses its order here, and nowhere else.
struct ShakenSpring {
    double drag, omega = 2;  // [kg/s], [rad/s]
    std::string name = "shaken_spring";
    PointMass start{1, {1, 0, 0}, {0.7, 0, 0}};
    double duration = 4;  // [s]

    Vector3 operator()(const PointMass& s, double t) const {
        return -omega * omega * s.position - drag * s.velocity + Vector3(std::cos(3 * t), 0, 0);
    }
    /// The swing of the shaking's own rhythm, and what is left of the start on top of it.
    double error(const PointMass& s, double t) const {
        const auto forced = [&](double at) {
            const Complex swing = std::polar(1.0, 3 * at) / Complex(omega * omega - 9, 3 * drag);
            return Eigen::Vector2d(swing.real(), -3 * swing.imag());
        };
        const Eigen::Vector2d at_start(start.position.x(), start.velocity.x());
        const Eigen::Vector2d exact = forced(t) + oscillation(omega, drag, t) * (at_start - forced(0));
        return std::abs(s.position.x() - exact[0]);
    }
};

}  // namespace

TEST_CASE("orders where the force depends on time too") {
    const ShakenSpring free{0}, dragged{1.5};
    CHECK_THAT(errors(free, euler_method, {10000, 20000, 40000}), HasOrder(1));
    CHECK_THAT(errors(free, semi_implicit_euler_method, {2000, 4000, 8000}), HasOrder(1));
    CHECK_THAT(errors(free, verlet_method, {1000, 2000, 4000}), HasOrder(2));
    CHECK_THAT(errors(free, VerletFsal<Vector3>{}, {1000, 2000, 4000}), HasOrder(2));
    CHECK_THAT(errors(free, yoshida4(), {200, 400, 800}), HasOrder(4));
    CHECK_THAT(errors(free, kahan_li8(), {40, 50, 60}), HasOrder(8, 0.2));
    CHECK_THAT(errors(dragged, semi_implicit_exponential_method, {2000, 4000, 8000}), HasOrder(1));
    CHECK_THAT(errors(dragged, semi_implicit_division_method, {2000, 4000, 8000}), HasOrder(1));
    CHECK_THAT(errors(dragged, exponential_kick_method, {10000, 20000, 40000}), HasOrder(1));
    CHECK_THAT(errors(dragged, exponential_verlet_method, {1000, 2000, 4000}), HasOrder(2));
    CHECK_THAT(errors(dragged, ExponentialVerlet<>{}, {1000, 2000, 4000}), HasOrder(2));
    CHECK_THAT(errors(dragged, exponential_yoshida4(), {200, 400, 800}), HasOrder(4));
    for (const Flow<ShakenSpring>& flow : {Flow(free), Flow(dragged)}) {
        CHECK_THAT(errors(flow, explicit_midpoint_method, {2000, 4000, 8000}), HasOrder(2));
        CHECK_THAT(errors(flow, rk4_method, {200, 400, 800}), HasOrder(4));
        CHECK_THAT(errors(flow, dormand_prince_method, {100, 200, 400}), HasOrder(5, 0.1));
        CHECK_THAT(errors(flow, implicit_euler_method, {10000, 20000, 40000}), HasOrder(1));
        CHECK_THAT(errors(flow, implicit_midpoint_method, {1000, 2000, 4000}), HasOrder(2));
    }
}

namespace {

/// Where the planet is after `orbits` orbits with the logarithmic leapfrog, against where it should be.
template <class Method>
Convergence logarithmic(const Method& method, const std::vector<int>& steps_an_orbit, double orbits) {
    Convergence c;
    const Planet planet = Planet::for_orbits(orbits);
    for (const int n : steps_an_orbit) {
        const auto end = run_until({planet.start}, method, planet.duration, 2 * pi / n);
        c.dt.push_back(2 * pi / n), c.error.push_back(planet.error(end.body, planet.duration));
        CHECK(end.time == Approx(planet.duration).epsilon(1e-15));
    }
    return c;
}

}  // namespace

TEST_CASE("the logarithmic leapfrog: orders 2, 4 and 8, always on the exact ellipse") {
    const Planet planet;
    const LogHamiltonian leapfrog(planet.gm, planet.start);
    // A third of an orbit: at whole orbits the error of the time is all there is, and its order looks the
    // same.
    CHECK_THAT(logarithmic(leapfrog, {128, 256, 512}, 1. / 3), HasOrder(2));
    CHECK_THAT(logarithmic(Composed<LogHamiltonian, 3>{leapfrog, yoshida_weights()}, {64, 128, 256}, 1. / 3),
               HasOrder(4));
    CHECK_THAT(logarithmic(Composed<LogHamiltonian, 15>{leapfrog, kahan_li_weights()}, {16, 20, 24}, 1. / 3),
               HasOrder(8, 0.3));

    TimedPlanet state{planet.start};
    const double h = angular_momentum(planet.start).norm();
    for (int n = 0; n < 2000; ++n) {
        state = leapfrog(state, 0, 0.0, 2 * pi / 20);  // twenty steps an orbit
        const double r = state.body.position.norm(), x = state.body.position.x();
        CHECK(std::abs(planet.energy(state.body) + 0.5) < 1e-12);
        CHECK(std::abs(angular_momentum(state.body).norm() - h) < 1e-12);
        CHECK(std::abs(r - (h * h - 0.6 * x)) < 1e-12);  // the ellipse: r = p - e x
    }
    CHECK_THROWS_WITH(LogHamiltonian(1, PointMass{1, {1, 0, 0}, {0, 2, 0}}), ContainsSubstring("ellipse"));
}
