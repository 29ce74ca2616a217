// Chapter 6's part of the table of methods and states: the methods of chapters 1 and 3 move Body and Pinned
// from the text that moves a PointMass, each at its own order. (Those that know drag ask for decay and stop,
// which a body has not.)
#include <nutshell/rigid_methods.hpp>
#include "03_forces/study.hpp"

using namespace nutshell;

namespace {

const auto methods_of_forces =
    std::tuple_cat(newton_methods,
                   std::tuple{methods::verlet_re_evaluated, methods::yoshida4, methods::yoshida4_re_evaluated,
                              methods::kahan_li8, methods::kahan_li8_re_evaluated});
const auto all_methods = std::tuple_cat(methods_of_forces, general_methods);

const Quaternion tilted = exponential(Vector3(0.3, -1.1, 0.7));
constexpr double stiffness = 3;  // [N/m]

/// A needle of a compass turns to the field, the y axis; the torque is that of a unit of moment along its x
/// axis.
Vector3 torque_on(const Quaternion& orientation) {
    return (orientation * Vector3::UnitX()).cross(Vector3::UnitY());
}

/// A needle on a spring; its moments are equal, so its free motion is known to every drift. One and the same
/// motion for a point mass, for a body and, without the spring, about a pivot.
struct NeedleOnSpring {
    Body start{2, Vector3::Constant(0.5), {0.8, -0.3, 0.1}, {0.4, 1, -1.4}, tilted, {0.2, -0.5, 0.3}};
    double duration = 2;
    Wrench operator()(const Body& body, double) const {
        return {-stiffness * body.position, torque_on(body.orientation)};
    }
};
struct PinnedNeedle {
    Pinned start{Vector3::Constant(0.5), tilted, {0.2, -0.5, 0.3}};
    double duration = 2;
    Wrench operator()(const Pinned& body, double) const {
        return {Vector3::Zero(), torque_on(body.orientation)};
    }
};
struct PointOnSpring {
    PointMass start{2, {0.8, -0.3, 0.1}, {0.2, 0.5, -0.7}};
    double duration = 2;
    Vector3 operator()(const PointMass& body, double) const { return -stiffness * body.position; }
};

double off(const Quaternion& a, const Quaternion& b) {
    return std::min((a.coeffs() - b.coeffs()).norm(), (a.coeffs() + b.coeffs()).norm());
}

}  // namespace

TEST_CASE("The methods of chapters 1 and 3 move a body's centre as they move a point mass") {
    each(all_methods, [](const auto& method) {
        INFO(method.name);
        const PointMass point = lab::run(PointOnSpring{}, method, 200);
        const Body body = lab::run(NeedleOnSpring{}, method, 200);
        CHECK((point.position - PointOnSpring{}.start.position).norm() > 0.1);
        CHECK((body.position - point.position).norm() < 1e-12);
        CHECK((body.momentum - point.mass * point.velocity).norm() < 1e-12);
    });
}

TEST_CASE("They turn Body and Pinned alike, each at its order") {
    const auto fine = lab::run(PinnedNeedle{}, methods::kahan_li8, 3000);
    each(all_methods, [&](const auto& method) {
        INFO(method.name);
        const int order = method.order;
        Convergence c;
        for (const long n : order == 1   ? std::vector<long>{4000, 8000, 16000}
                            : order == 2 ? std::vector<long>{400, 800, 1600}
                            : order < 8  ? std::vector<long>{60, 90, 120}
                                         : std::vector<long>{10, 14, 18}) {
            const Pinned pinned = lab::run(PinnedNeedle{}, method, n);
            const Body body = lab::run(NeedleOnSpring{}, method, n);
            CHECK(off(pinned.orientation, body.orientation) < 1e-10);
            c.dt.push_back(2.0 / static_cast<double>(n));
            c.error.push_back(off(pinned.orientation, fine.orientation));
        }
        CHECK_THAT(c, HasOrder(order, order < 5 ? 0.1 : 0.4));
    });
}
