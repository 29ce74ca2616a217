// Poses under an angular velocity: orders on coning, what a steady spin shows of each method, and its limits.
#include <map>
#include <nutshell/spinning_methods.hpp>
#include "spin.hpp"

using namespace nutshell;

namespace {

const auto first = SPIN_METHOD(first_order_unit);
const auto exponential_start = SPIN_METHOD(exponential_map);
const auto midpoint = SPIN_METHOD(exponential_midpoint);
const auto magnus = SPIN_METHOD(magnus4);
const auto runge_kutta = SPIN_METHOD(rk4_pose);

/// The wrong sign in Magnus: body axes' term with world axes' angular velocity.
const auto magnus_wrong = [](const Quaternion& q, const auto& spin, double t, double dt) {
    const double apart = std::sqrt(3.0) / 6 * dt;
    const Vector3 one = spin(q, t + dt / 2 - apart), two = spin(q, t + dt / 2 + apart);
    return product(exponential(dt / 2 * (one + two) + std::sqrt(3.0) / 12 * dt * dt * one.cross(two)), q);
};

}  // namespace

TEST_CASE("coning is what it says: the exact pose turns at the scene's angular velocity") {
    const Coning scene;
    for (const double t : {0.0, 0.3, 1.1, 1.9}) {
        const double h = 1e-4;
        const auto turned_by = [&](double s) -> Vector3 {
            return logarithm(product(scene.exact(t + s), inverse(scene.exact(t - s)))) / (2 * s);
        };
        const Vector3 slope = (4 * turned_by(h / 2) - turned_by(h)) / 3;
        CHECK((slope - scene(scene.start, t)).norm() < 1e-9);
    }
}

TEST_CASE("orders on coning: every method has its own, and Magnus with the wrong sign falls to 2") {
    const Coning scene;
    const std::map<int, std::vector<long>> steps{
        {1, {800, 1600, 3200}}, {2, {200, 400, 800}}, {4, {100, 200, 400}}};
    each(spinning_methods, [&](const auto& method) {
        INFO(method.name << ", order " << method.order);
        CHECK_THAT(convergence(scene, method, steps.at(method.order)), HasOrder(method.order));
    });
    CHECK_THAT(convergence(scene, magnus_wrong, {200, 400, 800}), HasOrder(2));
}

TEST_CASE("the exponential at the start of each step: its n steps on coning in closed form") {
    const Coning scene;
    for (const long n : {1L, 7L, 50L}) {
        const double h = scene.duration / static_cast<double>(n);
        const Quaternion part = product(quaternion_about(Vector3::UnitZ(), -scene.turning * h),
                                        exponential(h * scene(scene.start, 0)));
        const Quaternion closed = product(quaternion_about(Vector3::UnitZ(), scene.turning * scene.duration),
                                          exponential(static_cast<double>(n) * logarithm(part)));
        CHECK(angle_between(lab::run(scene, exponential_start, n), closed) <=
              identity * static_cast<double>(n));
    }
}

TEST_CASE("S6 and S6 fast: 1000 turns at 1/60 s, the exponential to 1e-11 rad") {
    for (const SpinningWheel& wheel : {SpinningWheel::s6(), SpinningWheel::s6_fast()}) {
        const long steps = lab::steps_of(wheel.duration, 1.0 / 60);
        const auto error = lab::measure(wheel, exponential_start, steps).max_error;
        CHECK(error <= 1e-11);
        CHECK(lab::measure(wheel, midpoint, steps).max_error <= 1e-11);
        CHECK(lab::measure(wheel, magnus, steps).max_error <= 1e-11);
        // its length drifts by a rounding a step
        CHECK(std::abs(lab::run(wheel, exponential_start, steps).norm() - 1) <=
              epsilon * static_cast<double>(steps));
    }
}

#ifndef __SANITIZE_ADDRESS__  // times mean nothing under sanitizers
TEST_CASE("S6: a step of the exponential takes 60 ns at most, on a slow machine 180 cycles, 60 ns at 3 GHz") {
    // The step alone, of a spin that is known. A multiplication and an addition that wait for each other
    // take six cycles at least on the processors of these years, so 180 cycles are 30 of such links. Others
    // use this machine too: the best of several.
    const Vector3 omega = SpinningWheel::s6().omega();
    const auto steady = [&](const Quaternion&, double) { return omega; };
    const long steps = 3000;
    double step = 1, link = 0;  // [s]
    for (int attempt = 0; attempt < 12 && step > 60e-9; ++attempt) {
        const double run = lab::time_of(
            [&] {
                Quaternion q = Quaternion::Identity();
                for (long n = 0; n < steps; ++n) q = exponential_map(q, steady, 0, 1.0 / 60);
                lab::keep(q);
            },
            1);
        step = std::min(step, run / static_cast<double>(steps));
        link = std::max(link, lab::machine_floor().multiply_add);
    }
    INFO("a step " << 1e9 * step << " ns, a link " << 1e9 * link << " ns");
    CHECK(step <= std::max(60e-9, 30 * link));
}
#endif

TEST_CASE(
    "the source's rule: late by omega dt - 2 atan(omega dt/2), longer by sqrt(1 + (omega dt)^2/4) (E20)") {
    // S6 fast is 1/3 turn a step: the lag of one step shows whole in the pose
    const double dt = 1.0 / 60;
    for (const SpinningWheel& wheel : {SpinningWheel::s6(), SpinningWheel::s6_fast()}) {
        const double theta = wheel.rate * dt;
        const long steps = 100;
        Quaternion unit = wheel.start, grown = wheel.start;
        for (long n = 0; n < steps; ++n)
            unit = first_order_unit(unit, wheel, 0, dt), grown = first_order(grown, wheel, 0, dt);
        const double lag = static_cast<double>(steps) * first_order_lag(theta);
        const Quaternion late = quaternion_about(wheel.axis, static_cast<double>(steps) * theta - lag);
        CHECK(angle_between(unit, late) <= identity * static_cast<double>(steps) * theta);
        CHECK(grown.norm() == Approx(std::pow(first_order_growth(theta), static_cast<double>(steps))));
        CHECK(angle_between(grown, unit) <= identity * static_cast<double>(steps));
    }
    // S6: 5.74 rad in 1000 turns at 1/60 s (the small-angle law), 5.69 by the arctangent
    const SpinningWheel wheel = SpinningWheel::s6();
    const double theta = wheel.rate * dt;
    CHECK(60000 * theta * theta * theta / 12 == Approx(5.742).epsilon(1e-3));
    CHECK(60000 * first_order_lag(theta) == Approx(5.74).epsilon(0.01));
    const Quaternion end = lab::run(wheel, first, 60000);
    CHECK(angle_between(end, wheel.exact(wheel.duration)) ==
          Approx(std::abs(std::remainder(60000 * first_order_lag(theta), 2 * pi))).epsilon(0.01));
}

TEST_CASE("rk4 on the 4-vector: late by (omega dt)^5/1920, stable up to omega dt = 4 sqrt 2") {
    for (const double theta : {0.1, 0.5}) {
        SpinningWheel wheel;
        wheel.rate = theta;  // one step of a second
        Quaternion q = wheel.start;
        for (int n = 0; n < 100; ++n) q = rk4_pose(q, wheel, 0, 1);
        CHECK(std::abs(std::remainder(100 * theta - logarithm(q).z() - 100 * rk4_pose_lag(theta), 2 * pi)) <
              1e-12);
        CHECK(rk4_pose_lag(theta) == Approx(std::pow(theta, 5) / 1920).epsilon(theta * theta / 10));
        CHECK(q.norm() == Approx(std::pow(rk4_pose_growth(theta), 100)));
    }
    const auto stable = [](double theta) {
        SpinningWheel wheel;
        wheel.rate = theta;
        return lab::stays_within(wheel, runge_kutta, 1, 20000, 1.01,
                                 [](const Quaternion& q) { return q.norm(); });
    };
    CHECK(stable(0.99 * rk4_pose_limit));
    CHECK_FALSE(stable(1.01 * rk4_pose_limit));
    CHECK(lab::stability_limit(stable, 4, 7, 1e-4) == Approx(rk4_pose_limit).epsilon(0.01));
}

TEST_CASE("the frame: body axes' angular velocity multiplied on the left turns about the wrong axis") {
    const Coning scene;
    const auto as_if_body = [](const Quaternion& q, const auto& spin, double t, double dt) {
        return product(q, exponential(spin(q, t) * dt));  // world numbers, body side
    };
    CHECK(lab::measure(scene, as_if_body, 3200).max_error > 1);
    // the right way round: body axes' angular velocity on the right
    const auto in_body_axes = [](const Quaternion& q, const auto& spin, double t, double dt) {
        return product(q, exponential(rotate(inverse(q), spin(q, t)) * dt));
    };
    CHECK(apart(lab::run(scene, in_body_axes, 100), lab::run(scene, exponential_start, 100)) <=
          100 * identity);
}

TEST_CASE("an angular velocity that depends on the pose: the midpoint's half step keeps second order") {
    // a spin fixed in the body, so that the exact pose is a turn about the axis it begins with
    struct BodyFixed {
        Quaternion start = quaternion_about({1, 2, 3}, 0.7);
        double duration = 2;
        Vector3 body{0.4, -1.1, 0.8};
        Vector3 operator()(const Quaternion& q, double t) const { return (1 + t * t) * rotate(q, body); }
        double error(const Quaternion& q, double t) const {
            return angle_between(q, product(start, exponential(body * (t + t * t * t / 3))));
        }
    };
    // one spin fixed in the world and one in the body: the exact pose is a turn on either side
    struct Both {
        Quaternion start = quaternion_about({1, 2, 3}, 0.7);
        double duration = 2;
        Vector3 world{-0.3, 0.9, 0.5}, body{0.4, -1.1, 0.8};
        Vector3 operator()(const Quaternion& q, double) const { return world + rotate(q, body); }
        double error(const Quaternion& q, double t) const {
            return angle_between(q, product(exponential(world * t), product(start, exponential(body * t))));
        }
    };
    CHECK_THAT(convergence(Both{}, midpoint, {100, 200, 400}), HasOrder(2));
    CHECK_THAT(convergence(Both{}, runge_kutta, {50, 100, 200}), HasOrder(4));
    CHECK_THAT(convergence(BodyFixed{}, midpoint, {100, 200, 400}), HasOrder(2));
    CHECK_THAT(convergence(BodyFixed{}, runge_kutta, {50, 100, 200}), HasOrder(4));
    CHECK_THAT(convergence(BodyFixed{}, exponential_start, {400, 800, 1600}), HasOrder(1));
}

TEST_CASE("a clamp of pi/4 a step turns S6 fast into another spin") {
    const SpinningWheel wheel = SpinningWheel::s6_fast();
    CHECK(clamped(wheel.omega(), 1.0 / 60, pi / 4).norm() == Approx(60 * pi / 4));
    CHECK(clamped(wheel.omega(), 1.0 / 60, pi / 4).cross(wheel.omega()).norm() <= 1e-10);
    CHECK(clamped(wheel.omega(), 1.0 / 240, pi / 4) == wheel.omega());
    CHECK_THROWS_WITH(clamped(wheel.omega(), 0, 1), ContainsSubstring("dt"));
}
