// How fast points move: omega x the turned point (E22), the cycloid, and what an eye can see of a turn.
#include "spin.hpp"

using namespace nutshell;

TEST_CASE("the velocity of a point is omega x where it is now, not where it began (E22)") {
    const Vector3 p(0.3, -1.1, 0.7);
    const SpinningWheel wheel = SpinningWheel::s6();
    const auto at = [&](double t) { return rotate(wheel.exact(t), p); };
    for (const double t : {0.0, 0.13, 0.5, 7.7}) {
        const double h =
            1e-4;  // a difference of fourth order: error (omega h)^4 omega |p|/30, round-off epsilon/h
        const Vector3 slope = (8 * (at(t + h) - at(t - h)) - (at(t + 2 * h) - at(t - 2 * h))) / (12 * h);
        CHECK((slope - point_velocity(wheel.omega(), wheel.exact(t), p)).norm() < 1e-10);
        CHECK(at(t).norm() == Approx(p.norm()).epsilon(identity));
    }
    // the source's forward difference, eqs (35)-(36), is half a step ahead: off by omega^2 |p| dt/2
    const double dt = 1e-5;
    const Vector3 forward = (at(0.5 + dt) - at(0.5)) / dt;
    CHECK((forward - point_velocity(wheel.omega(), wheel.exact(0.5 + dt / 2), p)).norm() < 1e-7);
    // half a turn later the printed formula points the wrong way
    CHECK(point_velocity({0, 0, 1}, exponential({0, 0, pi}), {1, 0, 0}).y() == Approx(-1));
    CHECK(Vector3(0, 0, 1).cross(Vector3(1, 0, 0)).y() == 1);
}

TEST_CASE("a rolling wheel: the contact point is at rest, the top at twice the speed, the path a cycloid") {
    const RollingWheel wheel;
    const double r = wheel.radius;
    for (const double t : {0.0, 0.4, 1.0, 2.3}) {
        const Quaternion q = wheel.exact(t);
        const Vector3 down = rotate(inverse(q), Vector3(0, -r, 0));  // the wheel's point that is lowest now
        CHECK(wheel.point(q, t, down).y() == Approx(0).margin(identity));
        CHECK(wheel.velocity(q, down).norm() <= identity * wheel.speed);
        CHECK((wheel.velocity(q, -down) - Vector3(2 * wheel.speed, 0, 0)).norm() <=
              2 * identity * wheel.speed);
        const double angle = wheel.speed / r * t;
        const Vector3 cycloid(r * (angle - std::sin(angle)), r * (1 - std::cos(angle)), 0);
        CHECK((wheel.point(q, t, {0, -r, 0}) - cycloid).norm() <= identity * (1 + angle));
    }
}

TEST_CASE("the mean angular velocity between two poses: exact for a steady spin up to half a turn") {
    const Vector3 omega(0.3, -0.8, 0.5);
    const Quaternion q = quaternion_about({1, 2, 3}, 0.7);
    for (const double dt : {1e-3, 0.1, 1.0, 3.0})
        CHECK((angular_velocity_between(q, product(exponential(omega * dt), q), dt) - omega).norm() <=
              identity * std::max(1.0, 1 / dt));
    const double full = 2 * pi / omega.norm();
    CHECK((angular_velocity_between(q, product(exponential(omega * 0.9 * full), q), 0.9 * full) + omega / 9)
              .norm() <= identity);
    CHECK_THROWS_WITH(angular_velocity_between(q, q, 0), ContainsSubstring("dt"));
}

TEST_CASE("wagon wheel: backwards from half a spoke to a whole one, still at a whole one") {
    for (const int spokes : {1, 4, 8}) {
        const double spoke = 2 * pi / spokes;
        CHECK(seen_turn(0.3 * spoke, spokes) == Approx(0.3 * spoke));
        CHECK(seen_turn(0.6 * spoke, spokes) == Approx(-0.4 * spoke));
        CHECK(seen_turn(0.99 * spoke, spokes) == Approx(-0.01 * spoke));
        CHECK(std::abs(seen_turn(spoke, spokes)) <= identity);
        CHECK(seen_turn(7.2 * spoke, spokes) == Approx(0.2 * spoke));
        CHECK(seen_turn(-0.6 * spoke, spokes) == Approx(0.4 * spoke));
    }
    CHECK_THROWS_WITH(seen_turn(1, 0), ContainsSubstring("spoke"));
    // a picture of a wheel cannot tell more: the poses of one spoke further look alike
    const Quaternion now = exponential({0, 0, 0.6 * pi / 2}),
                     seen = exponential({0, 0, seen_turn(0.6 * pi / 2, 4)});
    CHECK(angle_between(product(exponential({0, 0, -pi / 2}), now), seen) <= identity);
}
