// A million turns: the source's 0.087, whose it is, and what the other ways keep.
#include <nutshell/many_turns.hpp>
#include "group.hpp"

using namespace nutshell;

namespace {

/// The axes of the chapter's table.
const std::vector<Vector3> stated_axes{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 2, 3}, {0.1, 1, 0.2}};

}  // namespace

TEST_CASE("the printed Rotation turns by -v, and a body at rest becomes NaN (E51, E52)") {
    const Eigen::Vector3f v(0.3F, -0.8F, 0.5F);
    const Matrix3 back = rotation_matrix(exponential(-v.cast<double>()));
    CHECK(largest(printed::rotation(v).cast<double>() - back) < 1e-6);
    CHECK(
        (printed::rotation({0, 0, 1.57079633F}).cast<double>() * Vector3::UnitX() + Vector3::UnitY()).norm() <
        1e-6);
    CHECK(printed::rotation(Eigen::Vector3f::Zero()).hasNaN());
    CHECK(printed::rotation({2e-23F, 0, 0}).hasNaN());  // its square is zero in float
}

TEST_CASE("1 - cos in float: all wrong at 1e-4 rad, and every turn stretches (E53)") {
    const float t = 1 - std::cos(1e-4F);
    CHECK(t == 0);
    // below 2.4e-4 rad the printed cosine is 1, so each turn multiplies lengths by sqrt(1 + angle^2)
    const ManyTurns scene{{1, 2, 3}, 2e-4, 1'000'000};
    CHECK(wear(scene, Keeper::printed_matrix).volume == Approx(std::exp(1e6 * 2e-4 * 2e-4)).epsilon(1e-3));
}

TEST_CASE("a million turns: the printed float matrix about (1,2,3) is worn by 0.087 (E60)") {
    const Wear worn = wear({{1, 2, 3}}, Keeper::printed_matrix);
    CHECK(worn.stretch == Approx(0.087).epsilon(0.02));
    CHECK(worn.volume == Approx(0.927).epsilon(0.002));
}

TEST_CASE(
    "a million turns, by kind: float stretches by per cents, a division keeps it straight, double keeps "
    "all") {
    for (const Vector3& axis : stated_axes) {
        CAPTURE(axis.transpose());
        const ManyTurns scene{axis};
        const auto check = [&](Keeper keeper, double least, double most, double angle) {
            const Wear worn = wear(scene, keeper);
            CAPTURE(name_of(keeper));
            CHECK(worn.stretch >= least);
            CHECK(worn.stretch <= most);
            CHECK(worn.angle <= angle);
        };
        // Theory: what is rounded once, in the step, counts a million times. Float rounds by up to 6e-8, so
        // a squared length is wrong by up to 2 * 6e-8 a turn for each of three directions, twice (step and
        // product): 0.4 at most; an angle by 0.008 * 6e-8 and a rounding of the pose, 6e-8 at random or a
        // part of it always.
        check(Keeper::printed_matrix, 0.01, 0.4, 2e-3);
        check(Keeper::float_matrix, 0.01, 0.4, 2e-3);
        check(Keeper::float_four_vector, 0.01, 0.4, 2e-3);
        check(Keeper::float_four_vector_unit, 1e-9, 8 * 6e-8 * 2, 2e-3);
        check(Keeper::double_matrix, 1e-12, 1e-9, 4e-12);
        check(Keeper::double_four_vector, 1e-12, 1e-9, 4e-12);
        check(Keeper::double_four_vector_unit, 0, 16 * epsilon, 4e-12);
    }
}

TEST_CASE("where a float stretches by itself it is the one rounding of its step, made a million times") {
    // The rest is the rounding of a million products. Always one way, they would make 1e6 * 6e-8; less than a
    // tenth of that is left of them.
    const double rest = 0.1 * 1e6 * 6e-8;
    double least = 1, most = 0;
    for (const Vector3& axis : stated_axes) {
        CAPTURE(axis.transpose());
        for (const Keeper keeper :
             {Keeper::printed_matrix, Keeper::float_matrix, Keeper::float_four_vector}) {
            CAPTURE(name_of(keeper));
            const Wear worn = wear({axis}, keeper), step = wear_by_step_alone({axis}, keeper);
            CHECK(std::abs(worn.stretch - step.stretch) <= rest);
            CHECK(std::abs(worn.volume - step.volume) <= rest);
            CHECK(step.stretch > 2 * rest);
        }
        // of a float 4-vector it is that of w = cos(0.004), whatever the axis
        const double stretch = wear_by_step_alone({axis}, Keeper::float_four_vector).stretch;
        least = std::min(least, stretch), most = std::max(most, stretch);
    }
    CHECK(most - least <= 0.01 * most);
}

TEST_CASE("wear is measured: a stretched, turned matrix tells its stretch, its volume and its angle") {
    const Quaternion q = quaternion_about({1, 2, 3}, 0.8);
    const Wear turned_on = wear_of(Matrix3(1.1 * rotation_matrix(product(exponential({0.02, 0, 0}), q))), q);
    CHECK(turned_on.angle == Approx(0.02).epsilon(1e-9));
    CHECK(turned_on.volume == Approx(1.1 * 1.1 * 1.1));
    CHECK(turned_on.stretch == Approx(std::sqrt(3.0) * 0.21));
    CHECK(wear_of(Quaternion(1.1 * q.coeffs()), q).angle <= identity);
    CHECK(wear_of(q, q).stretch <= identity);
}

TEST_CASE("a division once in a thousand turns keeps a double 4-vector from stretching") {
    const ManyTurns scene;
    const Quaternion step = quaternion_about(scene.axis, scene.angle);
    Quaternion q = four_vector({0, 0, 0}, 1);
    double worst = 0;
    for (long n = 1; n <= scene.turns; ++n) {
        q = product(step, q);
        worst = std::max(worst, std::abs(q.norm() - 1));
        if (n % 1000 == 0) q = normalised(q);
    }
    CHECK(worst <= 1000 * 2 * epsilon);  // the roundings of a thousand turns, all the same way
    CHECK(angle_between(q, scene.exact(scene.turns)) <= 4e-12);
}
