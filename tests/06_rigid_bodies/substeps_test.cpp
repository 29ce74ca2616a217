// Chapter 6: how far one step may turn a body, and the body of the pictures.
#include <nutshell/assembly.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/rigid_methods.hpp>
#include <nutshell/top_scenes.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

const double epsilon = std::numeric_limits<double>::epsilon();

/// The largest error [rad] of Magnus' step at 60 frames a second, each cut into `parts`.
double error_of(const FreeBody& scene, int parts) {
    return lab::measure(scene, methods::kick_magnus_kick, std::lround(scene.duration) * 60 * parts).max_error;
}

}  // namespace

TEST_CASE("The handle of the flip, two thin rods, has moments as 1 to 2 to 3 about its centre of mass") {
    const Handle handle;
    const double m = handle.bar, n = handle.stem;  // one kilogram a metre
    const auto rod = [](double length, int axis) -> Vector3 {
        Vector3 moments = Vector3::Constant(length * length * length / 12);
        moments[axis] = 0;
        return moments;
    };
    const MassProperties whole = assemble(std::array{solid(m, rod(m, 0), {0, handle.foot(), 0}),
                                                     solid(n, rod(n, 1), {0, handle.foot() + n / 2, 0})});
    CHECK(whole.centre.norm() < 4 * epsilon);
    const Vector3 moments = whole.inertia.diagonal() / whole.inertia(2, 2);
    CHECK(moments.x() == Approx(1. / 3).epsilon(1e-9));  // of the ten digits that Handle has
    CHECK(moments.y() == Approx(2. / 3).epsilon(1e-9));
}

TEST_CASE("The rule of sub-steps: 0.3 rad a step keep any body within a fifth of a pixel for ten turns") {
    double value = 0.1;
    const auto next = [&] { return value = 3.9 * value * (1 - value); };
    double at_rule = 0, twice = 0;
    for (int i = 0; i < 200; ++i) {
        const Vector3 part = Vector3::Constant(0.1) + Vector3(next(), next(), next());
        const Vector3 inertia = Vector3::Constant(part.sum()) - part;
        const Vector3 axis = Vector3(next() - 0.5, next() - 0.5, next() - 0.5).normalized();
        for (const double theta : {longest_turn, 2 * longest_turn}) {
            const double steps = std::ceil(20 * pi / theta);  // of one second
            const FreeBody body("some", inertia, theta * axis, steps, {1, "rad", ""});
            double& worst = theta == longest_turn ? at_rule : twice;
            worst =
                std::max(worst, lab::measure(body, methods::kick_magnus_kick, std::lround(steps)).max_error);
        }
    }
    const double pixel = 1. / 960;
    CHECK(at_rule < pixel / 5);
    CHECK(twice > 16 * 0.9 * at_rule);  // fourth order
    CHECK(twice > pixel);

    Pinned ball{{1, 1, 1}};
    CHECK(substeps(spinning(ball, {0, 17.9, 0}), 1. / 60) == 1);
    CHECK(substeps(spinning(ball, {0, 18.1, 0}), 1. / 60) == 2);
    CHECK(substeps(spinning(Pinned{{1, 2, 2.5}, exponential({0.3, 1, 0.2})}, {0, 0, 0}), 1. / 60) == 1);
    CHECK_THROWS_WITH(substeps(ball, 0), ContainsSubstring("substeps"));
    // 20 turns a second with a wobble: lost at 1/60, right in seven parts
    const FreeBody wobble = fast_wobble();
    REQUIRE(substeps(wobble.start, 1. / 60) == 7);
    CHECK(error_of(wobble, 1) > 100 * wobble.need.tolerance);
    CHECK(error_of(wobble, 7) < 0.1 * wobble.need.tolerance);
}
