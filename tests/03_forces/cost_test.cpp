// Chapter 3: what a pixel costs, in evaluations of the force. The same on every machine, so the page's
// ranking is held here.
#include <nutshell/forces_methods.hpp>
#include <nutshell/forces_scenes.hpp>
#include <nutshell/lab/study.hpp>
#include <nutshell/log_hamiltonian.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

/// The least evaluations that meet `tolerance`, or 1e9 if 200 000 steps do not. Counted from `fewest` steps
/// on: with one step over ten whole periods Euler stands still, and looks right.
template <class Scene, class Method>
long least(const Scene& scene, const Method& method, double tolerance, long fewest = 10) {
    const auto found = lab::fewest_steps(scene, lab::entry<Scene>(method), tolerance, fewest, 200'000);
    return found ? found->evaluations : 1'000'000'000;
}

}  // namespace

TEST_CASE("falling with drag: one exact step, then the orders in their order") {
    const FallingWithDrag scene;
    const double pixel = scene.need.tolerance;
    const long kick = least(scene, methods::exponential_kick, pixel, 1),
               rk = least(scene, methods::rk4, pixel, 1),
               verlet_2 = least(scene, methods::exponential_verlet_inside, pixel),
               euler_1 = least(scene, methods::euler, pixel), verlet_1 = least(scene, methods::verlet, pixel);
    CHECK(kick == 1);
    CHECK(rk < verlet_2);
    CHECK(verlet_2 < euler_1);
    CHECK(euler_1 < verlet_1);  // drag inside the kick makes Verlet worse than Euler here
}

TEST_CASE("falling: Euler's error in position is -1/nu times that in velocity and dies out, Verlet's stays") {
    FallingWithDrag scene;
    const double nu = scene.drag / scene.start.mass;
    const auto off = [&](const auto& method, double dt) {  // of position [m] and velocity [m/s], in the end
        const PointMass end = lab::run(scene, method, std::lround(scene.duration / dt)),
                        exact = scene.exact(scene.duration);
        return std::pair{end.position.y() - exact.position.y(), end.velocity.y() - exact.velocity.y()};
    };
    // Euler: v_n - v_0 = g t - nu (p_n - p_0), as in the exact motion. Round-off: 1e-16 of 50 m, some hundred
    // times.
    const double dt = 0.01;
    const auto [place, speed] = off(methods::euler, dt);
    CHECK(std::abs(place) > 0.01);
    CHECK(place == Approx(-speed / nu).margin(1e-11));
    // After sixty seconds nothing is left of e^(-nu t), 1e-13; Verlet is behind by half a step of falling.
    scene.duration = 60;
    CHECK(std::abs(off(methods::euler, dt).first) < 1e-9);
    CHECK(off(methods::verlet, dt).first == Approx(scene.terminal_velocity().y() * dt / 2).margin(1e-9));
}

TEST_CASE(
    "springs: high orders pay, the exact propagator asks for nothing, drag in the kick costs ten times") {
    const MassOnSpring spring;
    const double pixel = spring.need.tolerance;
    const long kahan_li = least(spring, methods::kahan_li8, pixel), rk = least(spring, methods::rk4, pixel),
               yoshida = least(spring, methods::yoshida4, pixel),
               second = least(spring, methods::verlet, pixel),
               midpoint = least(spring, methods::explicit_midpoint, pixel),
               first = least(spring, methods::semi_implicit_euler, pixel);
    CHECK(least(spring, methods::exact_propagator, pixel) == 0);
    CHECK(kahan_li < rk);
    CHECK(rk < yoshida);
    CHECK(yoshida < second);
    CHECK(second < midpoint);
    CHECK(midpoint < first);
    CHECK(least(spring, methods::euler, pixel) == 1'000'000'000);

    const MassOnSpring damped = MassOnSpring::with_damping(0.1);
    CHECK(8 * least(damped, methods::exponential_verlet_inside, pixel) <
          least(damped, methods::verlet, pixel));
    CHECK(20 * least(damped, methods::exponential_yoshida4, pixel) < least(damped, methods::yoshida4, pixel));
    CHECK(least(damped, methods::exact_propagator, pixel) == 0);
}

TEST_CASE("the planet: the method that knows Kepler's force needs the fewest evaluations") {
    const Planet scene = Planet::for_orbits(10);
    const double pixel = scene.need.tolerance;
    const auto error = [&](int steps_an_orbit) {
        return scene.error(run_until({scene.start}, methods::logarithmic_leapfrog8.start(scene),
                                     scene.duration, 2 * pi / steps_an_orbit)
                               .body,
                           scene.duration);
    };
    CHECK(error(5) < pixel);  // 5 x 15 kicks an orbit
    const long clock_evaluations = 5 * 15 * 10, kahan_li = least(scene, methods::kahan_li8, pixel),
               rk = least(scene, methods::rk4, pixel);
    CHECK(5 * clock_evaluations < kahan_li);
    CHECK(kahan_li < rk);
    long steps = 0;
    long evaluations = 0;
    const lab::Counted<Planet> counted(scene, evaluations);
    const FlatPoint end =
        adaptive(flat(scene.start), right_hand_side(scene.start, counted), 0, scene.duration, {1e-6, 1e-6},
                 0.01, [&](const FlatPoint&, double) { ++steps; });
    CHECK(scene.error(unflat(end, scene.start), scene.duration) < 0.1);
    CHECK(evaluations < rk);
    CHECK(evaluations >=
          6 * steps);  // first same as last: six evaluations a step, and those of the steps refused
    CHECK(clock_evaluations < evaluations);
}
