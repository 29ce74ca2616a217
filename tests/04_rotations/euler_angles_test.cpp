// Three angles: there and back, the lock, and the speeds they need near it.
#include <nutshell/euler_angles.hpp>
#include "group.hpp"

using namespace nutshell;

TEST_CASE("three angles: the order is roll, pitch, yaw about the world's z, x, y") {
    const EulerAngles angles{0.4, -0.7, 1.9};
    const Matrix3 r = rotation_y(angles.yaw) * rotation_x(angles.pitch) * rotation_z(angles.roll);
    CHECK(largest(rotation_matrix(orientation_of(angles)) - r) <= identity);
}

TEST_CASE("three angles there and back, over the whole group") {
    for_all_turns([](const Vector3& n, double angle) {
        const Quaternion q = quaternion_about(n, angle);
        const EulerAngles e = euler_angles(q);
        CHECK(std::abs(e.pitch) <= pi / 2);
        CHECK(angle_between(q, orientation_of(e)) <= 2 * identity);
    });
    for (const double yaw : {-3.0, -0.4, 0.0, 1.0, 2.9})
        for (const double pitch : {-1.5, -0.6, 0.0, 0.9, 1.57})
            for (const double roll : {-2.8, 0.3, 1.6}) {
                const EulerAngles e = euler_angles(orientation_of({yaw, pitch, roll}));
                const double condition = 1 / std::cos(pitch);
                CHECK(std::abs(e.yaw - yaw) <= identity * condition);
                CHECK(std::abs(e.pitch - pitch) <= identity);
                CHECK(std::abs(e.roll - roll) <= identity * condition);
            }
}

TEST_CASE("gimbal lock: at a pitch of 90 degrees yaw and roll are one turn, given as yaw alone") {
    for (const double sign : {1.0, -1.0}) {
        const Quaternion a = orientation_of({0.5, sign * pi / 2, 0.2}),
                         b = orientation_of({0.9, sign * pi / 2, 0.2 + sign * 0.4});
        CHECK(angle_between(a, b) <= identity);
        const EulerAngles e = euler_angles(a);
        CHECK(e.roll == 0);
        CHECK(std::abs(e.yaw - (0.5 - sign * 0.2)) <= identity);
        CHECK(angle_between(a, orientation_of(e)) <= identity);
    }
}

TEST_CASE("rates of three angles: what they turn by is omega, and at the lock they are refused") {
    const EulerAngles e{0.4, 1.2, -0.8};
    const Vector3 omega(0.3, -0.5, 0.9);
    const EulerAngles rate = euler_rates(e, omega);
    const double h = 1e-4;
    const auto later = [&](double t) {
        return orientation_of({e.yaw + rate.yaw * t, e.pitch + rate.pitch * t, e.roll + rate.roll * t});
    };
    // central difference: the error is of order h^2 times the cube of the rates
    CHECK((logarithm(product(later(h), inverse(later(-h)))) / (2 * h) - omega).norm() < 1e-6);
    CHECK(euler_rates({0, pi / 2 - 1e-3, 0}, {0, 0, 1}).yaw == Approx(1000).epsilon(1e-3));
    CHECK_THROWS_WITH(euler_rates({0, std::asin(1.0), 0}, omega), ContainsSubstring("90 degrees"));
}
