// Chapter 1: the laws of the straight line and of the thrown ball, held to round-off.
#include <nutshell/lab/run.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/newton_scenes.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

const double ulp = std::numeric_limits<double>::epsilon();

/// Constant acceleration in a general direction: no component of a law may hide.
struct Push {
    Vector3 acceleration{1.3, -9.81, 0.7};
    PointMass start{2.5, {1, 2, 3}, {4, -5, 6}};
    double duration = 2;
    Vector3 operator()(const PointMass& body, double) const { return body.mass * acceleration; }
    Vector3 exact_position(double t) const {
        return start.position + start.velocity * t + acceleration * t * t / 2;
    }
};

template <class Step>
Vector3 computed_minus_exact(const Step& method, long steps) {
    const Push scene;
    return lab::run(scene, method, steps).position - scene.exact_position(scene.duration);
}

}  // namespace

TEST_CASE("without a force every method goes straight, to round-off") {
    const StraightLine scene;
    const double bound = 200 * ulp * 10;  // 200 additions, each half an ulp of at most 10 m
    CHECK(lab::measure(scene, methods::euler, 200).max_error < bound);
    CHECK(lab::measure(scene, methods::semi_implicit_euler, 200).max_error < bound);
    CHECK(lab::measure(scene, methods::verlet, 200).max_error < bound);
}

TEST_CASE("eqs. (1)-(3): velocity and acceleration come back from positions") {
    const Vector3 p0(1, 2, 3), v(4, -5, 6), a(1.3, -9.81, 0.7);
    const auto position = [&](double t) -> Vector3 { return p0 + v * t + a * t * t / 2; };
    const double t = 0.7, dt = 0.25;
    // the forward difference is the velocity at the middle of the interval: exact for constant acceleration
    CHECK((velocity_between(position(t), position(t + dt), dt) - (v + a * (t + dt / 2))).norm() < 100 * ulp);
    CHECK((acceleration_at(position(t - dt), position(t), position(t + dt), dt) - a).norm() < 1000 * ulp);
    // eq. (3): at constant velocity the acceleration is zero
    CHECK(acceleration_at({0, 0, 0}, {1, 2, 3}, {2, 4, 6}, 0.5) == Vector3::Zero());
    CHECK_THROWS_WITH(velocity_between(p0, p0, 0), ContainsSubstring("dt"));
    CHECK_THROWS_WITH(acceleration_at(p0, p0, p0, -1), ContainsSubstring("dt"));
    CHECK_THROWS_WITH(velocity_between(p0, p0, std::nan("")), ContainsSubstring("finite"));
}

TEST_CASE(
    "the error of a throw is -aTdt/2 for Euler, +aTdt/2 for semi-implicit Euler, 0 for Verlet, to "
    "round-off") {
    const Push scene;
    for (long steps : {1L, 2L, 7L, 60L, 1000L}) {
        const double dt = scene.duration / static_cast<double>(steps), T = scene.duration;
        const double bound = static_cast<double>(steps) * 30 * ulp;  // an ulp of |p| < 30 m for every step
        const Vector3 lag = scene.acceleration * T * dt / 2;
        CHECK((computed_minus_exact(methods::euler, steps) + lag).norm() < bound);
        CHECK((computed_minus_exact(methods::semi_implicit_euler, steps) - lag).norm() < bound);
        CHECK(computed_minus_exact(methods::verlet, steps).norm() < bound);
        CHECK((throw_error(Kicked::after_drift, scene.acceleration, T, dt) + lag).norm() < ulp * 20);
        CHECK((throw_error(Kicked::before_drift, scene.acceleration, T, dt) - lag).norm() < ulp * 20);
        CHECK(throw_error(Kicked::half_and_half, scene.acceleration, T, dt) == Vector3::Zero());
    }
}

TEST_CASE("with Y up, Euler's ball is too high and semi-implicit Euler's too low") {
    const ThrownBall scene;
    CHECK(lab::run(scene, methods::euler, 90).position.y() > scene.exact(3).position.y());
    CHECK(lab::run(scene, methods::semi_implicit_euler, 90).position.y() < scene.exact(3).position.y());
}

TEST_CASE("erratum E04: Euler is wrong by g T dt/2 even where the force never changes") {
    // The source's figures: 1 s of free fall at dt = 0.008 s and g = 9.8: 0.0392 m.
    CHECK(throw_error(Kicked::after_drift, {0, -9.8, 0}, 1, 0.008).y() == Approx(0.0392).epsilon(1e-12));
    struct Fall {
        PointMass start{};
        double duration = 1;
        Vector3 operator()(const PointMass& body, double) const { return body.mass * Vector3(0, -9.8, 0); }
    };
    CHECK(lab::run(Fall{}, methods::euler, 125).position.y() - -4.9 == Approx(0.0392).epsilon(1e-10));
}

TEST_CASE("the step that keeps Euler within a pixel does, and one step fewer does not") {
    const ThrownBall scene;
    const double dt = euler_step_within(scene.need.tolerance, gravity, scene.duration);
    const long steps = lab::steps_of(scene.duration, dt);
    CHECK(lab::measure(scene, methods::euler, steps).final_error <= scene.need.tolerance);
    CHECK(lab::measure(scene, methods::euler, steps - 1).final_error > scene.need.tolerance);
    CHECK(euler_step_within(1e6, gravity, 3) == 3);          // one step is enough
    CHECK(euler_step_within(0.1, Vector3::Zero(), 3) == 3);  // nothing to get wrong
    CHECK_THROWS_WITH(euler_step_within(0, gravity, 3), ContainsSubstring("tolerance"));
    CHECK_THROWS_WITH(euler_step_within(0.1, gravity, -3), ContainsSubstring("duration"));
}

TEST_CASE("mass matters: twice the mass, half the acceleration") {
    PointMass light{1, {0, 0, 0}, {0, 0, 0}}, heavy{2, {0, 0, 0}, {0, 0, 0}};
    kick(light, {3, 0, 0}, 0.5), kick(heavy, {3, 0, 0}, 0.5);
    CHECK(light.velocity == Vector3(1.5, 0, 0));
    CHECK(heavy.velocity == Vector3(0.75, 0, 0));
}

TEST_CASE("Verlet with the kept force gives the same bits as Verlet") {
    const Planet scene;
    const long steps = 700;
    const double dt = scene.duration / static_cast<double>(steps);
    PointMass a = scene.start;
    for (long n = 0; n < steps; ++n) a = verlet(a, scene, static_cast<double>(n) * dt, dt);
    const PointMass b = lab::run(scene, methods::verlet, steps);
    CHECK(a.position == b.position);
    CHECK(a.velocity == b.velocity);
}

TEST_CASE("a force may depend on time: each method asks for it at the right moment") {
    std::vector<double> asked;
    const auto forces = [&](const PointMass&, double t) -> Vector3 {
        asked.push_back(t);
        return {t, 0, 0};
    };
    const PointMass start;
    euler(start, forces, 1, 0.5);
    semi_implicit_euler(start, forces, 1, 0.5);
    verlet(start, forces, 1, 0.5);
    CHECK(asked == std::vector<double>{1, 1, 1, 1.5});
}

TEST_CASE("a point mass that cannot be simulated is refused at the door") {
    CHECK_THROWS_WITH(checked({0, {0, 0, 0}, {0, 0, 0}}), ContainsSubstring("mass"));
    CHECK_THROWS_WITH(checked({-1, {0, 0, 0}, {0, 0, 0}}), ContainsSubstring("mass"));
    CHECK_THROWS_WITH(checked({1, {0, std::nan(""), 0}, {0, 0, 0}}), ContainsSubstring("position"));
    CHECK_THROWS_WITH(checked({1, {0, 0, 0}, {std::numeric_limits<double>::infinity(), 0, 0}}),
                      ContainsSubstring("velocity"));
    CHECK(checked({2, {1, 2, 3}, {4, 5, 6}}).mass == 2);
}
