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
    const auto found = lab::fewest_steps(scene, lab::entry<Scene>("", method), tolerance, fewest, 200'000);
    return found ? found->evaluations : 1'000'000'000;
}

}  // namespace

TEST_CASE("falling with drag: one exact step, then the orders in their order") {
    const FallingWithDrag scene;
    const double pixel = scene.need.tolerance;
    const long kick = least(scene, exponential_kick_method, pixel, 1),
               rk = least(Flow(scene), rk4_method, pixel, 1),
               verlet_2 = least(scene, ExponentialVerlet<>{}, pixel),
               euler_1 = least(scene, euler_method, pixel),
               naive = least(scene, VerletFsal<Vector3>{}, pixel);
    CHECK(kick == 1);
    CHECK(rk < verlet_2);
    CHECK(verlet_2 < euler_1);
    CHECK(euler_1 < naive);  // drag inside the kick makes Verlet worse than Euler here
}

TEST_CASE(
    "springs: high orders pay, the exact propagator asks for nothing, drag in the kick costs ten times") {
    const MassOnSpring spring;
    const double pixel = spring.need.tolerance;
    const long kahan_li = least(spring, kahan_li8(), pixel), rk = least(Flow(spring), rk4_method, pixel),
               yoshida = least(spring, yoshida4(), pixel),
               second = least(spring, VerletFsal<Vector3>{}, pixel),
               midpoint = least(Flow(spring), explicit_midpoint_method, pixel),
               first = least(spring, semi_implicit_euler_method, pixel);
    CHECK(least(spring, SpringPropagator{spring.omega()}, pixel) == 0);
    CHECK(kahan_li < rk);
    CHECK(rk < yoshida);
    CHECK(yoshida < second);
    CHECK(second < midpoint);
    CHECK(midpoint < first);
    CHECK(least(spring, euler_method, pixel) == 1'000'000'000);

    const MassOnSpring damped = MassOnSpring::with_damping(0.1);
    CHECK(8 * least(damped, ExponentialVerlet<>{}, pixel) < least(damped, VerletFsal<Vector3>{}, pixel));
    CHECK(20 * least(damped, exponential_yoshida4(), pixel) < least(damped, yoshida4(), pixel));
    CHECK(least(damped, SpringPropagator{damped.omega(), damped.damping_rate()}, pixel) == 0);
}

TEST_CASE("the planet: the method that knows Kepler's force needs the fewest looks") {
    const Planet scene = Planet::for_orbits(10);
    const double pixel = scene.need.tolerance;
    const Composed<LogHamiltonian, 15> clock{LogHamiltonian(scene.gm, scene.start), kahan_li_weights()};
    const auto error = [&](int steps_an_orbit) {
        return scene.error(run_until({scene.start}, clock, scene.duration, 2 * pi / steps_an_orbit).body,
                           scene.duration);
    };
    CHECK(error(5) < pixel);  // 5 x 15 kicks an orbit
    const long clock_looks = 5 * 15 * 10, kahan_li = least(scene, kahan_li8(), pixel),
               rk = least(Flow(scene), rk4_method, pixel);
    CHECK(5 * clock_looks < kahan_li);
    CHECK(kahan_li < rk);
    long steps = 0;
    const Flow flow(scene);
    long evaluations = 0;
    const lab::Counted<Flow<Planet>> counted(flow, evaluations);
    const FlatPoint end = adaptive(flow.start, counted, 0, scene.duration, {1e-6, 1e-6}, 0.01,
                                   [&](const FlatPoint&, double) { ++steps; });
    CHECK(flow.error(end, scene.duration) < 0.1);
    CHECK(evaluations < rk);
    CHECK(evaluations >= 6 * steps);  // first same as last: six looks a step, and those of the steps refused
    CHECK(clock_looks < evaluations);
}
