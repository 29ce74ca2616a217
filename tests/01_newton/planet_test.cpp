// Chapter 1: the planet. Angular momentum, the turning axis, energy bands, orders.
#include <nutshell/apsides.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/newton_scenes.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

const double ulp = std::numeric_limits<double>::epsilon();

template <class Step>
Convergence convergence(const Step& method, std::vector<long> steps,
                        double (*error)(const lab::Measurement&)) {
    Convergence c;
    for (long n : steps) {
        const auto m = lab::measure(Planet{}, method, n);
        c.dt.push_back(m.dt), c.error.push_back(error(m));
    }
    return c;
}

double max_error(const lab::Measurement& m) {
    return m.max_error;
}
double final_error(const lab::Measurement& m) {
    return m.final_error;
}

template <class Step>
double turn_per_orbit(const Step& method, long steps_an_orbit) {
    Aphelia aphelia;
    lab::run(Planet::for_orbits(21), method, 21 * steps_an_orbit,  // 21 aphelia: 20 orbits between them
             [&](const PointMass& planet, double) { aphelia.observe(planet.position); });
    REQUIRE(aphelia.angles.size() == 21);
    return aphelia.turn_per_orbit();
}

/// Lowest and highest relative energy change over three orbits.
template <class Step>
std::pair<double, double> energy_band(const Step& method, long steps_an_orbit) {
    const Planet scene = Planet::for_orbits(3);
    const double start = scene.energy(scene.start);
    double low = 0, high = 0;
    lab::run(scene, method, 3 * steps_an_orbit, [&](const PointMass& planet, double) {
        const double change = (scene.energy(planet) - start) / std::abs(start);
        low = std::min(low, change), high = std::max(high, change);
    });
    return {low, high};
}

}  // namespace

TEST_CASE("Euler's angular momentum grows by exactly 1 + GM dt^2 / r^3 in every step") {
    const Planet scene;
    const long steps = 500;
    const double dt = scene.duration / steps;
    double expected = angular_momentum(scene.start).z();
    PointMass before = scene.start;
    lab::run(scene, methods::euler, steps, [&](const PointMass& planet, double t) {
        if (t > 0) expected *= 1 + scene.gm * dt * dt / std::pow(before.position.norm(), 3);
        before = planet;
        CHECK(std::abs(angular_momentum(planet).z() - expected) <= 4 * (t / dt + 1) * ulp * expected);
    });
    CHECK(expected >
          1.02 * angular_momentum(scene.start).z());  // the product is a real growth, not round-off
}

TEST_CASE("semi-implicit Euler and Verlet keep the angular momentum vector to round-off") {
    const Planet scene = Planet::for_orbits(20);
    const double bound = 20 * 500 * 2 * ulp;  // an ulp or two of |r v| <= 1 in each of 10 000 steps
    CHECK(lab::largest_change(scene, methods::semi_implicit_euler, 20 * 500, angular_momentum) < bound);
    CHECK(lab::largest_change(scene, methods::verlet, 20 * 500, angular_momentum) < bound);
    CHECK(lab::largest_change(scene, methods::euler, 20 * 500, angular_momentum) > 0.1);
}

TEST_CASE(
    "the axis turns by -1.03e-3 rad an orbit at 500 steps an orbit, for both symplectic methods alike") {
    const double semi_implicit = turn_per_orbit(methods::semi_implicit_euler, 500);
    const double verlet_turn = turn_per_orbit(methods::verlet, 500);
    CHECK(verlet_turn == Approx(-1.03e-3).epsilon(0.005));  // the last printed digit of 1.03
    CHECK(semi_implicit == Approx(verlet_turn).epsilon(1e-3));
    CHECK(turn_per_orbit(methods::verlet, 1000) == Approx(verlet_turn / 4).epsilon(0.02));  // O(dt^2)
}

TEST_CASE(
    "energy stays in a band of 3-4 % for semi-implicit Euler, 0.12 % for Verlet, and runs away for Euler") {
    const auto [s_low, s_high] = energy_band(methods::semi_implicit_euler, 500);
    CHECK((s_low < -0.03 && s_low > -0.04));
    CHECK((s_high > 0.03 && s_high < 0.04));
    const auto [v_low, v_high] = energy_band(methods::verlet, 500);
    CHECK(std::max(v_high, -v_low) == Approx(0.0012).epsilon(0.05));
    CHECK(energy_band(methods::euler, 500).second > 0.3);
}

TEST_CASE("orders over one orbit, by the maximum error: 1, 1, 2") {
    CHECK_THAT(convergence(methods::euler, {16000, 32000, 64000, 128000}, max_error), HasOrder(1));
    CHECK_THAT(convergence(methods::semi_implicit_euler, {2000, 4000, 8000, 16000}, max_error), HasOrder(1));
    CHECK_THAT(convergence(methods::verlet, {2000, 4000, 8000, 16000}, max_error), HasOrder(2));
}

TEST_CASE(
    "from perihelion and after whole orbits, semi-implicit Euler seems second order, but from elsewhere it "
    "does not") {
    // It is Verlet between half a kick and its undoing: S = K(-h/2) V K(h/2). At perihelion the half kick
    // stands at right angles to the velocity, changes neither energy nor year at first order, and is undone
    // when the planet is back.
    CHECK_THAT(convergence(methods::semi_implicit_euler, {2000, 4000, 8000, 16000}, final_error),
               HasOrder(2));

    struct FromElsewhere : Planet {
        FromElsewhere() { start = Planet::exact(1); }
        double error(const PointMass& planet, double t) const {
            return distance(planet, Planet::exact(1 + t));
        }
    };
    Convergence c;
    for (long steps : {2000L, 4000L, 8000L, 16000L}) {
        const auto m = lab::measure(FromElsewhere{}, methods::semi_implicit_euler, steps);
        c.dt.push_back(m.dt), c.error.push_back(m.final_error);
    }
    CHECK_THAT(c, HasOrder(1));
}

TEST_CASE("semi-implicit Euler is Verlet between half a kick and its undoing") {
    const Planet scene;
    const long steps = 300;
    const double dt = scene.duration / steps;
    PointMass kicked = scene.start;
    kick(kicked, scene(kicked, 0), dt / 2);
    for (long n = 0; n < steps; ++n) kicked = verlet(kicked, scene, 0, dt);
    kick(kicked, scene(kicked, 0), -dt / 2);
    const PointMass direct = lab::run(scene, methods::semi_implicit_euler, steps);
    // the same numbers but for round-off, which the orbit stretches: 300 steps of an ulp, times a few hundred
    // at perihelion
    CHECK((kicked.position - direct.position).norm() < 1e5 * ulp);
    CHECK((kicked.velocity - direct.velocity).norm() < 1e5 * ulp);
}

TEST_CASE("the planet's own exact solution starts where the scene starts") {
    const Planet scene;
    CHECK((scene.exact(0).position - scene.start.position).norm() < 2 * ulp);
    CHECK((scene.exact(0).velocity - scene.start.velocity).norm() < 4 * ulp);
}
