// One turn in all its clothes: conventions, and every representation against Eigen and against the others.
#include "group.hpp"

using namespace nutshell;

TEST_CASE("+90 degrees about z takes x to y, for every representation") {
    const double quarter = pi / 2;
    const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ();
    const auto takes_x_to_y = [&](const Vector3& image) { CHECK((image - y).norm() <= identity); };
    takes_x_to_y(rotation_z(quarter) * x);
    takes_x_to_y(rotation_about(z, quarter) * x);
    takes_x_to_y(rotation_matrix(quaternion_about(z, quarter)) * x);
    takes_x_to_y(rotation_matrix(exponential(quarter * z)) * x);
    takes_x_to_y(rotate(quaternion_about(z, quarter), x));
    takes_x_to_y(turned(x, z, quarter));
    CHECK((rotation_x(quarter) * y - z).norm() <= identity);
    CHECK((rotation_y(quarter) * z - x).norm() <= identity);
    // the 4-vector is stored x, y, z, w
    const Quaternion q = quaternion_about(z, quarter);
    CHECK(q.coeffs()[2] == Approx(std::sqrt(0.5)).epsilon(identity));
    CHECK(q.coeffs()[3] == Approx(std::sqrt(0.5)).epsilon(identity));
    CHECK(four_vector({1, 2, 3}, 4).coeffs() == Eigen::Vector4d(1, 2, 3, 4));
}

TEST_CASE("the three elementary turns are turns about x, y and z") {
    for (const double angle : angles()) {
        CHECK(largest(rotation_x(angle) - rotation_about(Vector3::UnitX(), angle)) <= identity);
        CHECK(largest(rotation_y(angle) - rotation_about(Vector3::UnitY(), angle)) <= identity);
        CHECK(largest(rotation_z(angle) - rotation_about(Vector3::UnitZ(), angle)) <= identity);
        CHECK(largest(rotation_y(angle) - Eigen::AngleAxisd(angle, Vector3::UnitY()).matrix()) <= identity);
    }
}

TEST_CASE("axis and angle, 4-vector and matrix agree with Eigen and with each other over the whole group") {
    const Vector3 p(0.3, -1.1, 0.7);
    for_all_turns([&](const Vector3& n, double angle) {
        const Matrix3 r = rotation_about(n, angle);
        const Quaternion q = quaternion_about(n, angle);
        const double eigen = largest(r - Eigen::AngleAxisd(angle, n).toRotationMatrix());
        const double worst = std::max(
            {eigen, apart(q, Quaternion(Eigen::AngleAxisd(angle, n))), largest(rotation_matrix(q) - r),
             largest(rotation_matrix(q) - q.toRotationMatrix()), (rotate(q, p) - r * p).norm(),
             (turned(p, n, angle) - r * p).norm(), largest(r.transpose() * r - Matrix3::Identity()),
             std::abs(r.determinant() - 1), (r * n - n).norm(), std::abs(q.norm() - 1)});
        CAPTURE(n.transpose(), angle);
        CHECK(worst <= identity);
    });
}

TEST_CASE("q and -q are one pose, and so are the axis and its opposite with the opposite angle") {
    for_all_turns([](const Vector3& n, double angle) {
        const Quaternion q = quaternion_about(n, angle), minus(-q.coeffs());
        CHECK(rotation_matrix(q) == rotation_matrix(minus));
        CHECK((logarithm(q) - logarithm(minus)).norm() <= (q.w() == 0 ? 2 * pi + identity : 0.0));
        CHECK(rotation_about(n, angle) == rotation_about(-n, -angle));
    });
}

TEST_CASE("the length of the axis does not matter, however long or short") {
    const Matrix3 r = rotation_about({1, 2, 3}, 0.7);
    for (const double length : {2.0, 1e-200, 1e200})
        CHECK(largest(rotation_about(Vector3(1, 2, 3) * length, 0.7) - r) <= identity);
}

TEST_CASE("the exponential is the turn about its direction by its length, tiny ones included") {
    for_all_turns([](const Vector3& n, double angle) {
        const Quaternion q = exponential(angle * n);
        // condition: the rounding of angle * n turns the end by up to |angle| epsilon
        CHECK(apart(q, quaternion_about(n, angle)) <= identity * std::max(1.0, std::abs(angle)));
        const long double half = std::sqrt(static_cast<long double>((angle * n).squaredNorm())) / 2;
        if (std::abs(angle) > 1e-100 && std::abs(angle) < 1) {  // the small part to its own last digits
            const double sine = static_cast<double>(std::sin(half));
            CHECK(std::abs(q.vec().norm() - sine) <= identity * sine);
        }
    });
    CHECK(exponential(Vector3::Zero()).coeffs() == Eigen::Vector4d(0, 0, 0, 1));
    CHECK(exponential({1e-300, 0, 0}).x() == 0.5e-300);  // its square is zero
}

TEST_CASE("the logarithm undoes the exponential: the shorter way, to the last digits of small angles too") {
    const long double full = 2 * std::acos(-1.0L);
    for_all_turns([&](const Vector3& n, double angle) {
        const Vector3 a = logarithm(quaternion_about(n, angle));
        const auto shorter = static_cast<double>(std::remainder(static_cast<long double>(angle), full));
        const double size = std::abs(shorter);
        CHECK(a.norm() <= pi * (1 + identity));
        if (pi - size < 1e-12)  // both ways are as short
            CHECK(std::min((a - shorter * n).norm(), (a + shorter * n).norm()) <= identity * size);
        else if (size > 1e-100)
            CHECK((a - shorter * n).norm() <= identity * size + 1e-18);  // 1e-18: the digits of 2 pi
        else
            CHECK(a.norm() <= 4 * size);
    });
    CHECK(logarithm(four_vector({0, 0, 0}, 1)) == Vector3::Zero());
    CHECK(logarithm(four_vector({0, 0, 0}, -1)) == Vector3::Zero());
    CHECK(logarithm(four_vector({0.5e-300, 0, 0}, 1)).x() == 1e-300);
    CHECK(logarithm(four_vector({0, 1, 0}, 0)).isApprox(Vector3(0, pi, 0), identity));
    // the length of q does not matter
    const Quaternion q = quaternion_about({1, 2, 3}, 0.7);
    for (const double length : {0.5, 3.0, 1e-100, 1e100})
        CHECK((logarithm(Quaternion(q.coeffs() * length)) - logarithm(q)).norm() <= identity);
}

TEST_CASE("the angle between two poses: exact where the arc cosine of the dot product has lost everything") {
    const Quaternion a = quaternion_about({1, 2, 3}, 2.1);
    for (const double angle : {1e-12, 1e-8, 1e-3, 1.0, 3.0, pi}) {
        const Quaternion b = product(quaternion_about({-1, 0.4, 2}, angle), a);
        // condition: the two 4-vectors are rounded, so an absolute error of a few epsilon
        CHECK(std::abs(angle_between(a, b) - angle) <= identity);
        CHECK(angle_between(a, b) == Approx(angle_between(b, a)).margin(identity));
    }
    const Quaternion near = product(quaternion_about({-1, 0.4, 2}, 1e-8), a);
    CHECK(std::abs(2 * std::acos(std::min(1.0, a.dot(near))) - 1e-8) > 0.4e-8);  // what it is instead of
}

TEST_CASE("bad input is refused in words") {
    const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH(rotation_about(Vector3::Zero(), 1), ContainsSubstring("zero vector"));
    CHECK_THROWS_WITH(quaternion_about(Vector3::Zero(), 1), ContainsSubstring("zero vector"));
    CHECK_THROWS_WITH(rotation_about({nan, 0, 1}, 1), ContainsSubstring("not finite"));
    CHECK_THROWS_WITH(quaternion_about({1, 0, 0}, infinity), ContainsSubstring("angle"));
    CHECK_THROWS_WITH(rotation_about({1, 0, 0}, nan), ContainsSubstring("angle"));
    CHECK_THROWS_WITH(checked(four_vector({0, 0, 0}, 1.1)), ContainsSubstring("length 1.1"));
    CHECK_THROWS_WITH(checked(four_vector({nan, 0, 0}, 1)), ContainsSubstring("not finite"));
    CHECK_THROWS_WITH(normalised(four_vector({0, 0, 0}, 0)), ContainsSubstring("no orientation"));
    CHECK_THROWS_WITH(normalised(four_vector({0, infinity, 0}, 0)), ContainsSubstring("not finite"));
    for (const double length : {1e-170, 1e170})  // its square is zero, or infinite
        CHECK_THROWS_WITH(normalised(four_vector({0, length, 0}, 0)), ContainsSubstring("no orientation"));
    CHECK(checked(four_vector({0, 0, 0}, 1)).w() == 1);
    CHECK(apart(normalised(four_vector({0, 3, 0}, 4)), four_vector({0, 0.6, 0}, 0.8)) <= identity);
}

TEST_CASE("past the door nothing is checked: what is not a number stays none, and never looks like a pose") {
    const Quaternion good = quaternion_about({1, 2, 3}, 0.9);
    for (int part = 0; part < 4; ++part) {
        Quaternion bad = good;
        bad.coeffs()[part] = std::nan("");
        CHECK(rotation_matrix(bad).hasNaN());
        CHECK(rotate(bad, {0.3, -1.1, 0.7}).hasNaN());
        CHECK(product(bad, good).coeffs().hasNaN());
        CHECK(product(good, bad).coeffs().hasNaN());
        CHECK(small_turn(bad, {0.1, 0.2, 0.3}).coeffs().hasNaN());
        CHECK(logarithm(bad).hasNaN());
        CHECK(slerp(bad, good, 0.3).coeffs().hasNaN());
        CHECK(slerp(good, bad, 0.3).coeffs().hasNaN());
        CHECK(nlerp(good, bad, 0.3).coeffs().hasNaN());
        CHECK(std::isnan(angle_between(good, bad)));
        if (part == 3) continue;
        Vector3 vector(0.1, 0.2, 0.3);
        vector[part] = std::nan("");
        CHECK(exponential(vector).coeffs().hasNaN());
        CHECK(small_turn(good, vector).coeffs().hasNaN());
    }
}

TEST_CASE("a 4-vector of length 1.1 makes a matrix that is no rotation (E15)") {
    // (28*) of a longer 4-vector is s R + (s - 1), s the squared length: 2 s - 1 along the axis
    const double s = 1.1 * 1.1, along = (2 * s - 1) * (2 * s - 1) - 1;
    for_all_turns([&](const Vector3& n, double angle) {
        const Matrix3 r = rotation_matrix(Quaternion(1.1 * quaternion_about(n, angle).coeffs()));
        const double across = s * s + (s - 1) * (s - 1) - 1 + 2 * s * (s - 1) * std::cos(angle);
        const double predicted = std::sqrt(along * along + 2 * across * across);
        CHECK(std::abs((r.transpose() * r - Matrix3::Identity()).norm() - predicted) <= identity * 4);
        CHECK(predicted > 1);
    });
}
