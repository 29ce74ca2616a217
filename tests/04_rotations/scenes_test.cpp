// The scenes of chapter 4: what their pages say of them.
#include <nutshell/rotation_scenes.hpp>
#include "group.hpp"

using namespace nutshell;

TEST_CASE("a full turn of small ones: late by n (beta - 2 atan(beta/2)), long by (1 + beta^2/4)^(n/2)") {
    for (const Vector3& axis : {Vector3(1, 2, 3), Vector3(0, 1, 0), Vector3(-3, 0.2, 1)})
        for (const long n : {7L, 40L, 79L, 500L}) {
            const FullTurn scene{axis};
            const double steps = static_cast<double>(n), beta = 2 * pi / steps;
            // condition: n roundings
            CHECK(std::abs(scene.error(n) - steps * (beta - 2 * std::atan(beta / 2))) <= identity * steps);
            CHECK(scene.length(n) ==
                  Approx(std::pow(1 + beta * beta / 4, steps / 2)).epsilon(identity * steps));
        }
    const FullTurn scene;
    CHECK(scene.error(79) <= scene.need.tolerance);
    CHECK(scene.error(78) > scene.need.tolerance);
}

TEST_CASE("two quarter turns: a third of a turn apart, small ones by the product of their angles") {
    CHECK(std::abs(TwoQuarterTurns{}.apart() - 2 * pi / 3) <= identity);
    for (const double angle : {0.1, 0.01, 0.001}) {
        const TwoQuarterTurns turns{quaternion_about(Vector3::UnitX(), angle),
                                    quaternion_about(Vector3::UnitZ(), angle)};
        CHECK(turns.apart() == Approx(angle * angle).epsilon(angle * angle));
    }
}

TEST_CASE("ways between two poses: all three have the same ends, and three angles make a detour") {
    const TwoPoses scene;
    const double whole = angle_between(scene.from, scene.to);
    CHECK(angle_between(scene.by_angles(0), scene.from) <= 2 * identity);
    CHECK(angle_between(scene.by_angles(1), scene.to) <= 2 * identity);
    double length = 0;
    for (int i = 1; i <= 500; ++i)
        length += angle_between(scene.by_angles((i - 1) / 500.0), scene.by_angles(i / 500.0));
    CHECK(length > 1.5 * whole);
    CHECK(nlerp_speed_ratio(pi) == Approx(2));
    // nlerp leads where its angle, measured in the plane of the two 4-vectors, runs ahead of an even one
    for (const double angle : {0.5, 1.5, 2.5}) {
        double most = 0;
        for (int i = 0; i <= 200; ++i) {
            const double part = i / 200.0, half = angle / 2;
            const double reached = std::atan2(part * std::sin(half), 1 - part + part * std::cos(half));
            most = std::max(most, std::abs(2 * reached - part * angle));
        }
        CHECK(std::abs(TwoPoses::apart(angle).largest_lead() - most) <= 2 * identity);
    }
}

TEST_CASE(
    "a bird overhead: the yaw turns at speed over distance aside, the line of sight by its true distance") {
    for (const double aside : {0.5, 2.0, 5.0}) {
        Overhead scene;
        scene.aside = aside;
        const double h = 1e-6;
        const double yaw = (scene.angles(h).yaw - scene.angles(-h).yaw) / (2 * h);
        CHECK(yaw == Approx(scene.yaw_rate()).epsilon(1e-8));
        const Vector3 before = scene.bird(-h).normalized(), after = scene.bird(h).normalized();
        CHECK(before.cross(after).norm() / (2 * h) == Approx(scene.sight_rate()).epsilon(1e-8));
        for (const double t : {-1.0, 0.0, 0.3}) {  // the camera looks at the bird
            const Vector3 sight = rotate(scene.pose(t), Vector3::UnitZ());
            CHECK((sight - scene.bird(t).normalized()).norm() <= identity);
        }
    }
}
