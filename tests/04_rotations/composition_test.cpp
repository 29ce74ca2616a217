// One turn after another: the product by three ways, world and body axes, small turns, and the way between
// two poses.
#include <nutshell/reflections.hpp>
#include "group.hpp"

using namespace nutshell;

TEST_CASE("the product turns first by the first, then by the second") {
    for (const Quaternion& a : some_turns())
        for (const Quaternion& b : some_turns()) {
            const Quaternion both = product(b, a);
            CHECK(largest(rotation_matrix(both) - rotation_matrix(b) * rotation_matrix(a)) <= identity);
            CHECK(apart(both, b * a) <= identity);
            CHECK(std::abs(both.norm() - 1) <= identity);
            CHECK(apart(product_by_mirrors(b, a), both) <= identity);
        }
}

TEST_CASE("it does not matter how three turns are grouped, and a turn and its inverse are none") {
    const auto all = some_turns();
    for (std::size_t i = 0; i + 2 < all.size(); ++i) {
        CHECK(apart(product(product(all[i], all[i + 1]), all[i + 2]),
                    product(all[i], product(all[i + 1], all[i + 2]))) <= identity);
        CHECK(apart(product(all[i], inverse(all[i])), four_vector({0, 0, 0}, 1)) <= identity);
        CHECK(apart(inverse(product(all[i], all[i + 1])), product(inverse(all[i + 1]), inverse(all[i]))) <=
              identity);
    }
}

TEST_CASE("two mirrors turn by twice the angle between them") {
    const Vector3 p(0.3, -1.1, 0.7);
    for (const Vector3& n : axes())
        for (const double angle : angles()) {
            const Vector3 a = any_perpendicular(n), b = turned(a, n, angle / 2);
            const Quaternion q = quaternion_about(n, angle);
            CHECK(apart(two_mirrors(a, b), q) <= identity);
            CHECK((reflected(reflected(p, a), b) - rotate(q, p)).norm() <= 2 * identity);
            const auto [c, d] = mirrors_ending_at(any_perpendicular(q.vec()), q);
            CHECK(apart(two_mirrors(c, d), q) <= identity);
            const auto [e, f] = mirrors_beginning_at(any_perpendicular(q.vec()), q);
            CHECK(apart(two_mirrors(e, f), q) <= identity);
        }
    CHECK(reflected({1, 2, 3}, Vector3::UnitX()) == Vector3(-1, 2, 3));
}

TEST_CASE("a factor on the left turns about the world's axes, on the right about the body's") {
    const Quaternion pose = quaternion_about({1, 2, 3}, 1.1);
    const Vector3 axis(0.2, -0.9, 0.5);
    const Quaternion about_world = product(quaternion_about(axis, 0.6), pose),
                     about_body = product(pose, quaternion_about(axis, 0.6));
    CHECK(apart(about_body, product(quaternion_about(rotate(pose, axis), 0.6), pose)) <= identity);
    CHECK(angle_between(about_world, about_body) > 0.5);
    CHECK((rotate(about_world, rotate(inverse(pose), axis)) - axis).norm() <= identity);
    CHECK((rotate(about_body, axis) - rotate(pose, axis)).norm() <= identity);
}

TEST_CASE("two quarter turns in either order end a third of a turn apart") {
    const Quaternion x = quaternion_about(Vector3::UnitX(), pi / 2),
                     z = quaternion_about(Vector3::UnitZ(), pi / 2);
    CHECK(std::abs(angle_between(product(z, x), product(x, z)) - 2 * pi / 3) <= identity);
    CHECK((rotate(product(z, x), Vector3::UnitY()) - Vector3::UnitZ()).norm() <= identity);
    CHECK((rotate(product(x, z), Vector3::UnitY()) + Vector3::UnitX()).norm() <= identity);
}

TEST_CASE("equation (31*) is the product with (beta, 0), its rows in the order x, y, z, w (E19)") {
    const Vector3 b(0.3, -0.7, 0.4);
    for (const Quaternion& q : some_turns()) {
        const Eigen::Vector4d t = q.coeffs();
        const Eigen::Vector4d rows(
            b[0] * t[3] + b[1] * t[2] - b[2] * t[1], b[1] * t[3] + b[2] * t[0] - b[0] * t[2],
            b[2] * t[3] + b[0] * t[1] - b[1] * t[0], -(b[0] * t[0] + b[1] * t[1] + b[2] * t[2]));
        CHECK((vector_product(b, q).coeffs() - rows).norm() <= identity);
    }
}

TEST_CASE(
    "a small turn turns by 2 atan(beta/2), and without the division grows by sqrt(1 + beta^2/4) (E18)") {
    for (const Vector3& n : axes())
        for (const double beta : {1e-6, 0.01, 0.1, 1.0, 3.0, 20.0}) {
            const Quaternion q = quaternion_about({1, 2, 3}, 0.9);
            const Quaternion grown(q.coeffs() + vector_product(beta * n, q).coeffs() / 2);
            CHECK(std::abs(grown.norm() - std::sqrt(1 + beta * beta / 4)) <= identity * grown.norm());
            const Quaternion exact = product(quaternion_about(n, 2 * std::atan(beta / 2)), q);
            CHECK(apart(small_turn(q, beta * n), exact) <= identity);
        }
    // the error of one small turn: beta^2/8 as printed, beta^3/12 in angle once normalised
    const double beta = 0.1;
    const Quaternion q = quaternion_about({1, 2, 3}, 0.9), exact = product(exponential({0, 0, beta}), q);
    const Quaternion printed(q.coeffs() + vector_product({0, 0, beta}, q).coeffs() / 2);
    CHECK(apart(printed, exact) == Approx(beta * beta / 8).epsilon(0.01));
    CHECK(angle_between(small_turn(q, {0, 0, beta}), exact) == Approx(beta * beta * beta / 12).epsilon(0.01));
}

TEST_CASE("slerp: the ends, Eigen's, one axis, one speed, the shorter way") {
    const auto all = some_turns();
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        const Quaternion &a = all[i], &b = all[i + 1];
        const double way = angle_between(a, b);
        for (const double part : {0.0, 0.1, 0.5, 0.9, 1.0}) {
            const Quaternion q = slerp(a, b, part);
            CHECK(std::abs(angle_between(a, q) - part * way) <= identity);
            CHECK(std::abs(angle_between(q, b) - (1 - part) * way) <= identity);
            // near half a turn apart both ways are as short, and rounding chooses
            if (way < 3.1) CHECK(angle_between(q, a.slerp(part, b)) <= 4 * identity);
            CHECK(angle_between(q, slerp(a, Quaternion(-b.coeffs()), part)) <= (way < 3.1 ? identity : 7.0));
        }
    }
    const Quaternion a = quaternion_about({1, 2, 3}, 0.9);
    CHECK(apart(slerp(a, a, 0.3), a) <= identity);  // no way at all: 0/0 for the formula of sines
    const Quaternion near = product(exponential({1e-9, 0, 0}), a);
    CHECK(std::abs(angle_between(a, slerp(a, near, 0.5)) - 0.5e-9) <= identity);
}

TEST_CASE("nlerp goes the same way, faster in the middle by 1/cos^2(angle/4)") {
    for (const double angle : {0.01, 0.5, 1.0, 2.0, 3.0}) {
        const Quaternion a = quaternion_about({1, 2, 3}, 0.9),
                         b = product(quaternion_about({0.3, -1, 0.2}, angle), a);
        const double tiny = 1e-4;
        const double middle = angle_between(nlerp(a, b, 0.5 - tiny), nlerp(a, b, 0.5 + tiny)) / (2 * tiny);
        // speed at the end by a one-sided difference of second order
        const double end =
            (4 * angle_between(a, nlerp(a, b, tiny)) - angle_between(a, nlerp(a, b, 2 * tiny))) / (2 * tiny);
        const double cosine = std::cos(angle / 4);
        CHECK(middle / end == Approx(1 / (cosine * cosine)).epsilon(1e-6));
        for (const double part : {0.0, 0.2, 0.7, 1.0}) {
            const Quaternion q = nlerp(a, b, part);
            CHECK(std::abs(angle_between(a, q) + angle_between(q, b) - angle) <= 2 * identity);  // on the way
            CHECK(angle_between(q, nlerp(a, Quaternion(-b.coeffs()), part)) <= identity);
        }
    }
}
