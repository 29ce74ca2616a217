// Chapter 6: the exact free top, against a run of other making in long double.
#include <nutshell/top_scenes.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

const double epsilon = std::numeric_limits<double>::epsilon();

using Real = long double;
using LongVector = Eigen::Matrix<Real, 3, 1>;
using LongQuaternion = Eigen::Quaternion<Real>;

LongQuaternion long_exponential(const LongVector& a) {
    const Real angle = a.norm(),
               scale = angle < 1e-6L ? 0.5L - angle * angle / 48 : std::sin(angle / 2) / angle;
    return {std::cos(angle / 2), scale * a.x(), scale * a.y(), scale * a.z()};
}

/// The free rotation by a commutator-free method of fourth order (Celledoni, Marthinsen and Owren 2003) in 64
/// bits of mantissa: shares nothing with the closed form.
Quaternion turned_finely(const Vector3& inertia, const Quaternion& start, const Vector3& L, double time,
                         int steps) {
    const LongVector I = inertia.cast<Real>(), l = L.cast<Real>();
    LongQuaternion q = start.cast<Real>();
    const Real h = static_cast<Real>(time) / steps;
    const auto omega = [&](const LongQuaternion& p) -> LongVector {
        return p * LongVector((p.conjugate() * l).cwiseQuotient(I));
    };
    for (int i = 0; i < steps; ++i) {
        const LongVector a = omega(q);
        const LongQuaternion half = long_exponential(h / 2 * a) * q;
        const LongVector b = omega(half), c = omega(long_exponential(h / 2 * b) * q),
                         d = omega(long_exponential(h * c - h / 2 * a) * half);
        q = long_exponential(h / 12 * (-a + 2 * b + 2 * c + 3 * d)) *
            (long_exponential(h / 12 * (3 * a + 2 * b + 2 * c - d)) * q);
        q.normalize();
    }
    return q.cast<double>();
}

}  // namespace

TEST_CASE("The exact free top agrees with a fine run in long double, for bodies and spins of every kind") {
    double value = 0.1;
    const auto next = [&] { return value = 3.9 * value * (1 - value); };
    for (int i = 0; i < 60; ++i) {
        const Vector3 parts(0.1 + next(), 0.1 + next(), 0.1 + next());
        const Vector3 inertia(parts.y() + parts.z(), parts.x() + parts.z(), parts.x() + parts.y());
        const Quaternion q = exponential(Vector3(next(), -next(), next()) * 3);
        Vector3 L = Vector3(next() - 0.5, next() - 0.5, next() - 0.5) * 6;
        if (i % 6 == 0) L = rotate(q, Vector3::Unit(i / 6 % 3) * 3);  // along a principal axis
        const FreeTop top(inertia, q, L);
        INFO("inertia " << inertia.transpose() << ", L " << L.transpose());
        CHECK(angle_between(top.pose(0), q) < 20 * epsilon);
        // the fine run: (omega h)^5 of at most 3e-13 in all; near the middle axis errors grow e-fold, there
        // by less than 1000
        CHECK(angle_between(top.pose(2), turned_finely(inertia, q, L, 2, 4000)) < 1e-10);
        CHECK((rotate(top.pose(7.3), top.in_body(7.3)) - L).norm() < 100 * epsilon * L.norm());
        // one step of it is the same as two
        Quaternion twice = q;
        exact_rotation(inertia, twice, L, 0.8), exact_rotation(inertia, twice, L, 0.3);
        CHECK(angle_between(twice, top.pose(1.1)) < 1e-12);
    }
}

TEST_CASE("A spin about a principal axis, the middle one too, stays for ever in the exact solution") {
    for (int axis = 0; axis < 3; ++axis) {
        const FreeTop top({1, 2, 3}, Quaternion::Identity(), 2 * Vector3::Unit(axis));
        const Quaternion turned = exponential(std::remainder(2e3 / (axis + 1), 4 * pi) * Vector3::Unit(axis));
        CHECK(angle_between(top.pose(1e3), turned) < 1e-12);
        CHECK_FALSE(std::isfinite(top.between_flips()));
    }
    CHECK(angle_between(FreeTop({1, 2, 3}, Quaternion::Identity(), Vector3::Zero()).pose(5),
                        Quaternion::Identity()) == 0);
}

TEST_CASE("S7 over 100 s: the exact solution and the fine run agree to 5e-12 rad") {
    const FreeBody scene = near_middle_axis();
    const Quaternion fine = turned_finely(scene.start.inertia, scene.start.orientation,
                                          scene.start.angular_momentum, 100, 360'000);
    CHECK(angle_between(scene.solution.pose(100), fine) < 5e-12);
    CHECK(scene.solution.between_flips() == Approx(7.0).epsilon(1e-3));
}
