// What engines make of a fast spin, and where a method must not be looked at.
#include "spin.hpp"

using namespace nutshell;

TEST_CASE("a clamp made by halves is neither the turn asked for nor the one it is cut to") {
    const double most = pi / 4;
    for (const double theta : {0.0, 0.3, most, 1.0, 2 * pi / 3, 5.0}) {
        // as Bullet writes it: the cut angle under the sine and in the divisor, the whole speed before it
        const double dt = 1.0 / 60, speed = theta / dt, cut = std::min(speed, most / dt);
        const double vector = cut > 0 ? speed * std::sin(0.5 * cut * dt) / cut : 0;
        const Quaternion q = normalised(four_vector({0, 0, vector}, std::cos(0.5 * cut * dt)));
        CHECK(std::abs(clamped_by_halves(theta, most) - logarithm(q).z()) <= identity);
        CHECK((theta <= most ||
               (clamped_by_halves(theta, most) > most && clamped_by_halves(theta, most) < theta)));
    }
    CHECK_THROWS_WITH(clamped_by_halves(1, 0), ContainsSubstring("largest turn"));
    CHECK_THROWS_WITH(clamped_by_halves(1, pi), ContainsSubstring("largest turn"));
}

TEST_CASE("S6 fast at 1/60 s by the rules of engines: 772, 797, 375 and 375 of its 1000 turns") {
    const SpinningWheel wheel = SpinningWheel::s6_fast();
    const double dt = 1.0 / 60, theta = wheel.rate * dt;
    CHECK(1000 - 1000 * first_order_lag(theta) / theta == Approx(772.01).epsilon(1e-5));
    CHECK(1000 * clamped_by_halves(theta, pi / 4) / theta == Approx(797.408).epsilon(1e-5));
    CHECK(1000 * clamped(wheel.omega(), dt, pi / 4).norm() / wheel.rate == Approx(375));
    CHECK(1000 * clamped(wheel.omega(), 1, 47.1).norm() / wheel.rate == Approx(374.81).epsilon(1e-5));
}

TEST_CASE("Magnus with a spin that depends on the pose: both looks at the start's pose fall to first order") {
    struct Both {  // one spin fixed in the world and one in the body
        Quaternion start = quaternion_about({1, 2, 3}, 0.7);
        double duration = 2;
        Vector3 world{-0.3, 0.9, 0.5}, body{0.4, -1.1, 0.8};
        Vector3 operator()(const Quaternion& q, double) const { return world + rotate(q, body); }
        double error(const Quaternion& q, double t) const {
            return angle_between(q, product(exponential(world * t), product(start, exponential(body * t))));
        }
    };
    CHECK_THAT(convergence(Both{}, SPIN_METHOD(magnus4), {400, 800, 1600}), HasOrder(1));
}

TEST_CASE("after a whole round of coning the start's exponential is as far off as the middle's") {
    // n steps from the middles are R_z(Omega h/2) times those from the starts times R_z(-Omega h/2), and the
    // exact end is no turn at all: an angle does not see the half step between
    const Coning scene;
    for (const long n : {8L, 24L, 100L}) {
        const auto start = lab::measure(scene, SPIN_METHOD(exponential_map), n),
                   middle = lab::measure(scene, SPIN_METHOD(exponential_midpoint), n);
        CHECK(std::abs(start.final_error - middle.final_error) <= identity * static_cast<double>(n));
        CHECK(start.max_error > 2 * middle.max_error);
    }
}
