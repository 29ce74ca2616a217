// Chapter 3: every method converges at its order, on the scenes it is made for and on those it is not.
#include <map>
#include <nutshell/forces_methods.hpp>
#include <nutshell/forces_scenes.hpp>
#include <nutshell/log_hamiltonian.hpp>
#include <nutshell/stability_limits.hpp>
#include "study.hpp"

using namespace nutshell;

namespace {

template <class Scene>
double drag_of(const Scene& scene) {
    if constexpr (requires { scene.drag; })
        return scene.drag;
    else
        return 0;
}

/// Each method's order on a scene. @param steps  of a method of order 1, 2, 4, 5 and 8
/// @param exact  the name of a method that has no error here
template <class Scene, class List>
void check_orders(const Scene& scene, const List& methods, const std::map<int, std::vector<long>>& steps,
                  const char* exact = "") {
    each(methods, [&](const auto& method) {
        if (std::string(method.name) == exact) return;
        // Verlet and its kin are made for forces of position and time: drag in a kick costs them their order.
        const bool spoilt = method.look.family == Family::symplectic && drag_of(scene) > 0;
        const int order = spoilt ? 1 : method.order;
        INFO(method.name << ", order " << order);
        CHECK_THAT(errors(scene, method, steps.at(order)), HasOrder(order, order < 5 ? 0.05 : 0.25));
    });
}

const auto every_method = std::tuple_cat(kick_and_drift_methods, general_methods);

}  // namespace

TEST_CASE("orders on the undamped spring") {
    check_orders(MassOnSpring{}, every_method,
                 {{1, {100000, 200000, 400000}},
                  {2, {1000, 2000, 4000}},
                  {4, {500, 1000, 2000}},
                  {5, {200, 400, 800}},
                  {8, {100, 150, 200}}});
}

TEST_CASE("orders on the damped spring: drag inside the kick costs Verlet and its kin theirs") {
    for (const double ratio : {0.1, 1.0, 2.0}) {
        INFO("damping ratio " << ratio);
        const long k = ratio > 1 ? 3 : 1;  // the fast part of the overdamped spring asks for small steps
        check_orders(MassOnSpring::with_damping(ratio), every_method,
                     {{1, {40000, 80000, 160000}},
                      {2, {2000 * k, 4000 * k, 8000 * k}},
                      {4, {1600 * k, 3200 * k, 6400 * k}},
                      {5, {800 * k, 1200 * k, 1600 * k}}});
    }
}

TEST_CASE("orders of falling with linear drag") {
    const FallingWithDrag falling;
    check_orders(falling, every_method,
                 {{1, {1000, 2000, 4000}}, {2, {200, 400, 800}}, {4, {40, 80, 160}}, {5, {80, 120, 160}}},
                 methods::exponential_kick.name);
    for (const long steps : {1, 7, 500})
        CHECK(lab::measure(falling, methods::exponential_kick, steps).max_error < 1e-12);
}

TEST_CASE("orders of falling in air, where the drag is not linear") {
    check_orders(FallingInAir{}, general_methods,
                 {{1, {1000, 2000, 4000}}, {2, {200, 400, 800}}, {4, {200, 400, 800}}, {5, {80, 120, 160}}});
}

TEST_CASE("orders on the planet") {
    check_orders(
        Planet{},
        std::tuple{methods::yoshida4, methods::kahan_li8, methods::explicit_midpoint, methods::rk4,
                   methods::dormand_prince, methods::implicit_midpoint},
        {{2, {4000, 8000, 16000}}, {4, {2000, 4000, 8000}}, {5, {1600, 2400, 3200}}, {8, {200, 250, 300}}});
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
    const std::map<int, std::vector<long>> steps{{1, {10000, 20000, 40000}},
                                                 {2, {2000, 4000, 8000}},
                                                 {4, {200, 400, 800}},
                                                 {5, {100, 200, 400}},
                                                 {8, {40, 50, 60}}};
    check_orders(ShakenSpring{0}, every_method, steps);
    check_orders(ShakenSpring{1.5}, every_method, steps);
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
    CHECK_THAT(logarithmic(Composed{leapfrog, yoshida_weights()}, {64, 128, 256}, 1. / 3), HasOrder(4));
    CHECK_THAT(logarithmic(Composed{leapfrog, kahan_li_weights()}, {16, 20, 24}, 1. / 3), HasOrder(8, 0.3));

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
