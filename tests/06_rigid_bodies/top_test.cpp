// Chapter 6: the heavy top: exact solution, orders, steady precession, the sleeping top, scene S8.
#include <nutshell/lab/run.hpp>
#include <nutshell/rigid_methods.hpp>
#include <nutshell/top_scenes.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

template <class Method>
Convergence errors_of(const HeavyTopScene& scene, const Method& method, const std::vector<long>& steps) {
    Convergence c;
    for (const long n : steps) {
        const auto m = lab::measure(scene, method, n);
        c.dt.push_back(m.dt), c.error.push_back(m.max_error);
    }
    return c;
}

}  // namespace

TEST_CASE("The exact heavy top agrees with a fine run in pose, for starts of every kind") {
    double value = 0.3;
    const auto next = [&] { return value = 3.9 * value * (1 - value); };
    for (int i = 0; i < 30; ++i) {
        const Top top{0.2 + next(), 0.05 + 0.3 * next(), 5 * next()};
        Pinned start = leaning(top, 0.2 + 2.5 * next());
        start.orientation = product(exponential({0, 6 * next(), 0}),
                                    product(start.orientation, exponential({0, 0, 6 * next()})));
        start = spinning(start, Vector3(next() - 0.5, next() - 0.5, next() - 0.5) * 6 +
                                    20 * (next() - 0.5) * rotate(start.orientation, {0, 0, 1}));
        const HeavyTopScene scene{"some", 1, top, start, 2};
        INFO("I1 " << top.across << ", I3 " << top.along << ", mgl " << top.weight);
        CHECK(angle_between(scene.solution.pose(0), start.orientation) < 1e-7);  // arccosine of a cosine
        const Pinned fine = lab::run(scene, methods::lie_rk4, 8000);
        CHECK(angle_between(scene.solution.pose(2), fine.orientation) < 1e-7);
        CHECK((scene.centre(scene.exact(2)) - scene.centre(fine)).norm() < 1e-9);
    }
    const Top top = standard_top();
    CHECK_THROWS_WITH(HeavyTop(top, leaning(top, 0)), ContainsSubstring("upright"));
    CHECK_THROWS_WITH(HeavyTop(top, Pinned{{1, 2, 2.5}}), ContainsSubstring("another"));
}

TEST_CASE("S8: the exact centre agrees with a method of eighth order to 1e-10 m over 10 s") {
    const HeavyTopScene scene = nodding_top();
    const auto fine = lab::measure(scene, methods::kahan_li8, 6000);
    CHECK(fine.max_error < 1e-10);
    const auto [low, high] = scene.solution.swing();
    CHECK(high == Approx(pi / 6).epsilon(1e-12));  // let go at rest: it can only fall
    CHECK(low > pi / 6);
}

TEST_CASE("S8 at 1/60: Yoshida's method of chapter 3 and the method on the group within a millimetre") {
    const HeavyTopScene scene = nodding_top();
    CHECK(lab::measure(scene, methods::yoshida4, 600).max_error < 1e-4);
    CHECK(lab::measure(scene, methods::lie_rk4, 600).max_error < 2e-4);
    CHECK(lab::measure(scene, methods::verlet_re_evaluated, 600).max_error == Approx(1.6e-3).epsilon(0.05));
    CHECK(lab::measure(scene, methods::rk4, 600).max_error > 0.01);
    CHECK(lab::measure(scene, methods::corrected_step, 600).max_error > 0.5);
}

TEST_CASE("Heavy tops: every method's order") {
    const HeavyTopScene scene = nodding_top();
    CHECK_THAT(errors_of(scene, methods::semi_implicit_euler, {20'000, 40'000, 80'000}), HasOrder(1));
    CHECK_THAT(errors_of(scene, methods::corrected_step, {400'000, 800'000}), HasOrder(1));
    CHECK_THAT(errors_of(scene, methods::verlet_re_evaluated, {600, 1200, 2400}), HasOrder(2));
    CHECK_THAT(errors_of(scene, methods::verlet, {600, 1200, 2400}), HasOrder(2));
    CHECK_THAT(errors_of(scene, methods::kick_split_kick, {600, 1200, 2400}), HasOrder(2));
    CHECK_THAT(errors_of(scene, methods::yoshida4, {600, 1200, 2400}), HasOrder(4));
    CHECK_THAT(errors_of(scene, methods::lie_rk4, {9600, 19'200, 38'400}), HasOrder(4, 0.08));
    CHECK_THAT(errors_of(scene, methods::rk4, {9600, 19'200}), HasOrder(4));
}

TEST_CASE("What a top keeps: energy, L about the vertical, L about its own axis") {
    const HeavyTopScene scene = nodding_top();
    const auto change = [&](const auto& method, const auto& quantity) {
        return lab::largest_change(scene, method, 600, quantity);
    };
    const auto vertical = [&](const Pinned& b) { return scene.about_vertical(b); };
    const auto own = [&](const Pinned& b) { return scene.about_axis(b); };
    const auto energy = [&](const Pinned& b) { return scene.energy(b); };
    const double round_off = 1e-12;  // 600 steps of a few epsilon of |L| = 3
    CHECK(change(methods::verlet_re_evaluated, vertical) < round_off);
    CHECK(change(methods::verlet_re_evaluated, own) < round_off);
    CHECK(change(methods::verlet_re_evaluated, energy) < 0.01 * scene.energy(scene.start));
    CHECK(change(methods::yoshida4, energy) < 1e-4 * scene.energy(scene.start));
    CHECK(change(methods::engine_step, energy) > scene.energy(scene.start));  // blows up
}

TEST_CASE("Steady precession: the two rates of the formula are the motion's, slow and fast") {
    const Top top = standard_top();
    const auto [slow, fast] = steady_precession(top, 3, pi / 6);
    CHECK(slow * fast == Approx(top.weight / (top.across * std::cos(pi / 6))));  // Vieta
    for (const std::size_t which : {0u, 1u}) {
        const HeavyTopScene scene = steady_top(which);
        const double rate = which == 0 ? slow : fast;
        for (const double t : {0.5, 3.0, 10.0}) {
            const Vector3 c = scene.centre(scene.exact(t));
            CHECK(c.y() == Approx(0.5 * std::cos(pi / 6)).epsilon(1e-13));
            const double azimuth = std::atan2(-c.z(), c.x());
            CHECK(std::abs(std::remainder(azimuth - rate * t, 2 * pi)) < 1e-12);
        }
        CHECK(lab::measure(scene, methods::yoshida4, 600).max_error < scene.need.tolerance);
    }
    CHECK_THROWS_WITH(steady_precession(top, 1, pi / 6), ContainsSubstring("falls"));
    CHECK(steady_precession(top, 1, 2.5)[0] * steady_precession(top, 1, 2.5)[1] <
          0);  // hanging: either way round
}

TEST_CASE("Without the gyroscopic term a top is a ball on a stick: it nods, and goes round too slowly") {
    // The weight twists across the axis only, and across it omega' = torque/I1 then, in the world too: the
    // motion of a body with I1 about every axis, which has no gyroscopic term. Its exact solution is the
    // reference, and it is another motion than the top's.
    const HeavyTopScene top = steady_top(0);
    const Top ball{top.top.across, top.top.across, top.top.weight};
    Pinned start = top.start;
    start.inertia = Vector3::Constant(ball.across);
    start = spinning(start, angular_velocity(top.start));
    const HeavyTop exact(ball, start);
    Convergence c;
    for (const long steps : {6000, 12'000, 24'000}) {
        double worst = 0;
        lab::run(top, methods::engine_step_without_gyroscopic, steps, [&](const Pinned& b, double t) {
            const Vector3 axis = rotate(exact.pose(t), {0, 0, 1});
            worst = std::max(worst, (top.centre(b) - 0.5 * axis).norm());
        });
        c.dt.push_back(10. / static_cast<double>(steps)), c.error.push_back(worst);
    }
    CHECK_THAT(c, HasOrder(1));
    const auto [largest, smallest] = exact.swing();
    CHECK(largest == Approx(pi / 6).epsilon(1e-9));
    // Euler's equations less the term, integrated elsewhere (SciPy's DOP853, 1e-12)
    CHECK(smallest * 180 / pi == Approx(27.135276).epsilon(1e-6));
    CHECK(lab::measure(top, methods::engine_step_without_gyroscopic, 6000).max_error > 0.3);
}

TEST_CASE("The sleeping top wakes where L3^2 = 4 I1 m g l: found by running to 1 %") {
    const Top top = standard_top();
    // 1 % below the limit the lean grows by a factor e in 1.8 s; above it swings
    struct Asleep {
        Top top;
        Pinned start;
        Wrench operator()(const Pinned& b, double) const {
            return {Vector3::Zero(), weight_torque(top, rotate(b.orientation, {0, 0, 1}))};
        }
    };
    const auto sleeps = [&](double slowness) {  // 1/L3
        const Pinned body = leaning(top, 1e-6);
        const Asleep scene{top, spinning(body, rotate(body.orientation, {0, 0, 1 / slowness / top.along}))};
        return lab::stays_within(scene, methods::verlet, 1. / 120, 4800, 1e-3, [](const Pinned& b) {
            const Vector3 axis = rotate(b.orientation, {0, 0, 1});
            return axis.y() > 0 ? std::hypot(axis.x(), axis.z()) : 1;
        });
    };
    const double limit = sleeping_limit(top);
    CHECK(sleeps(1 / (1.01 * limit)));
    CHECK_FALSE(sleeps(1 / (0.99 * limit)));
    CHECK(1 / lab::stability_limit(sleeps, 0.5 / limit, 2 / limit) == Approx(limit).epsilon(0.01));
}
