// Chapter 6: free bodies. The flip's times, the methods' orders, what each keeps, and the failures with
// their numbers.
#include <complex>
#include <nutshell/lab/run.hpp>
#include <nutshell/rigid_methods.hpp>
#include <nutshell/top_scenes.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

const double epsilon = std::numeric_limits<double>::epsilon();

template <class Scene, class Method>
Convergence errors_of(const Scene& scene, const Method& method, const std::vector<long>& steps) {
    Convergence c;
    for (const long n : steps) {
        const auto m = lab::measure(scene, method, n);
        c.dt.push_back(m.dt), c.error.push_back(m.max_error);
    }
    return c;
}

template <class Method>
double error_of(const FreeBody& scene, const Method& method, long steps_a_second = 60) {
    return lab::measure(scene, method, std::lround(scene.duration) * steps_a_second).max_error;
}

/// Relative changes of a run: of the energy, of L's length, and of L as a vector.
struct Kept {
    double energy, length, vector;
};
template <class Method>
Kept kept(const FreeBody& scene, const Method& method, long steps_a_second = 60) {
    const long steps = std::lround(scene.duration) * steps_a_second;
    const double size = scene.start.angular_momentum.norm();
    const auto L = [](const Pinned& b) { return b.angular_momentum; };
    return {lab::largest_change(scene, method, steps, [&](const Pinned& b) { return scene.energy(b); }) /
                scene.energy(scene.start),
            lab::largest_change(scene, method, steps, [&](const Pinned& b) { return L(b).norm(); }) / size,
            lab::largest_change(scene, method, steps, L) / size};
}

}  // namespace

TEST_CASE("The flip: 4.058030 s, then every 6.976516 s, to all digits, in a run too, and as printed never") {
    const FreeBody scene = flip();
    const auto printed = [](double value) { return std::round(value * 1e6) / 1e6; };
    CHECK(printed(scene.solution.first_flip()) == 4.058030);
    CHECK(printed(scene.solution.between_flips()) == 6.976516);
    // The zeros of omega_2 in a run, between two steps by a straight line: h^2/8 of its curvature off
    const auto zeros = [&](const auto& method) {
        std::vector<double> found;
        double before = 1;
        const double dt = 1e-3;
        lab::run(scene, method, 30'000, [&](const Pinned& body, double t) {
            const double now = rotate(inverse(body.orientation), angular_velocity(body)).y();
            if (t > 0 && (now < 0) != (before < 0)) found.push_back(t - dt * now / (now - before));
            before = now;
        });
        return found;
    };
    const std::vector<double> times = zeros(methods::kick_magnus_kick);
    REQUIRE(times.size() == 4);
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(times[i] == Approx(4.058030 + 6.976516 * static_cast<double>(i)).margin(2e-6));
    // As printed omega_2 of the world frame never changes at all: L does not, nor does the inertia
    const Pinned first = scene.start, last = lab::run(scene, methods::printed_step, 1800);
    CHECK(last.angular_momentum == first.angular_momentum);
    CHECK(error_of(scene, methods::printed_step) > 3);
    // ... and neither does omega: the printed pose is a steady turn, off the truth by 4.38 degrees after a
    // second and by 86 after four (Euler's equations by SciPy's DOP853, 1e-13)
    for (const auto& [seconds, off] : {std::pair{1., 4.38001}, {4., 85.96438}}) {
        FreeBody start = scene;
        start.duration = seconds;
        const Pinned run = lab::run(start, methods::printed_step, std::lround(60 * seconds));
        CHECK(angle_between(run.orientation, exponential(seconds * Vector3(0.1, 2, 0.1))) < 1e-12);
        CHECK(scene.error(run, seconds) * 180 / pi == Approx(off).epsilon(1e-6));
    }
}

TEST_CASE("Free bodies: every method's order") {
    FreeBody scene = flip();
    scene.duration = 6;  // over the first flip
    CHECK_THAT(errors_of(scene, methods::corrected_step, {40'000, 80'000, 160'000}), HasOrder(1));
    CHECK_THAT(errors_of(scene, methods::engine_step, {20'000, 40'000, 80'000}), HasOrder(1));
    CHECK_THAT(errors_of(scene, methods::verlet_re_evaluated, {500, 1000, 2000}), HasOrder(2));
    CHECK_THAT(errors_of(scene, methods::kick_split_kick, {500, 1000, 2000}), HasOrder(2));
    CHECK_THAT(errors_of(scene, methods::yoshida4, {500, 1000, 2000}), HasOrder(4));
    CHECK_THAT(errors_of(scene, methods::kick_magnus_kick, {200, 400, 800}), HasOrder(4));
    CHECK_THAT(errors_of(scene, methods::lie_rk4, {500, 1000, 2000}), HasOrder(4));
    CHECK_THAT(errors_of(scene, methods::rk4, {200, 400, 800}), HasOrder(4));
    CHECK(lab::measure(scene, methods::kick_exact_kick, 100).max_error < 1e-11);
}

TEST_CASE("S7 at 1/60: 1e-6 rad over 100 s with L to the bit, where flat RK4 is five times worse") {
    const FreeBody scene = near_middle_axis();
    CHECK(error_of(scene, methods::kick_magnus_kick) < 1e-6);
    CHECK(kept(scene, methods::kick_magnus_kick).vector == 0);
    // what L the pose and the body's own motion stand for, not only the one that is stored
    const Pinned last = lab::run(scene, methods::kick_magnus_kick, 6000);
    CHECK((rotate(last.orientation, scene.solution.in_body(100)) - last.angular_momentum).norm() <
          1e-5 * last.angular_momentum.norm());
    CHECK(kept(scene, methods::kick_magnus_kick).energy < 1e-9);
    CHECK(error_of(scene, methods::rk4) > 3e-6);
    CHECK(error_of(scene, methods::rk4) < 1e-5);
    CHECK(error_of(scene, methods::verlet_re_evaluated) == Approx(0.076).epsilon(0.05));
}

TEST_CASE("20 turns a second about a principal axis, 1000 turns: right to 1e-9, where flat RK4 is lost") {
    const FreeBody scene = fast_spin();
    CHECK(error_of(scene, methods::kick_magnus_kick) < 1e-11);
    CHECK(error_of(scene, methods::verlet_re_evaluated) < 1e-11);
    CHECK(error_of(scene, methods::lie_rk4) < 1e-11);
    CHECK(error_of(scene, methods::rk4) > 1);
}

TEST_CASE("Flat RK4 on a spin: late by the angle that its four rates make on a circle") {
    // A spin about a principal axis is a point on the unit circle of (q.z, q.w), going round at omega/2. Each
    // rate of the seven numbers is taken at the 4-vector made as long as one.
    using Complex = std::complex<double>;
    FreeBody scene = fast_spin();
    scene.duration = 1;
    for (const long steps : {120L, 240L, 960L}) {
        const double half = 20 * pi / static_cast<double>(steps);  // of the angle of a step [rad]
        const auto rate = [&](const Complex& z) { return Complex(0, half) * (z / std::abs(z)); };
        const Complex k1 = rate(1), k2 = rate(1. + k1 / 2.), k3 = rate(1. + k2 / 2.), k4 = rate(1. + k3),
                      end = 1. + (k1 + 2. * k2 + 2. * k3 + k4) / 6.;
        const double late = 2 * (half - std::arg(end)) * static_cast<double>(steps);
        CHECK(lab::measure(scene, methods::rk4, steps).max_error == Approx(std::abs(late)).epsilon(1e-7));
    }
}

TEST_CASE("Limit of the Magnus step and of flat RK4: a wobble of 2 sqrt(2) rad a step, predicted and found") {
    // M goes by RK4, which bears Omega dt up to 2 sqrt(2): a small wobble dies out below and grows above.
    const Vector3 inertia(1, 1, 2), omega(1e-6, 0, 10);
    const double Omega = omega.z() * inertia.z() * (1 / inertia.x() - 1 / inertia.z());
    const auto dies_out = [&](const auto& method, double turn) {
        const FreeBody scene("wobble", inertia, omega, 1, {1, "rad", ""});
        return lab::stays_within(scene, method, turn / Omega, 4000, 2 * omega.x(), [](const Pinned& body) {
            const Vector3 M = rotate(inverse(body.orientation), body.angular_momentum);
            return std::hypot(M.x(), M.y());
        });
    };
    const double limit = 2 * std::sqrt(2.0);
    each(std::tuple{methods::kick_magnus_kick, methods::rk4}, [&](const auto& method) {
        INFO(method.name);
        CHECK(dies_out(method, 0.99 * limit));
        CHECK_FALSE(dies_out(method, 1.01 * limit));
        const auto stable = [&](double turn) { return dies_out(method, turn); };
        CHECK(lab::stability_limit(stable, 2, 3) == Approx(limit).epsilon(0.01));
    });
}

TEST_CASE("Magnus' step on S7: the same bits from every compiler, since no function of a library enters") {
    Pinned body = near_middle_axis().start;
    for (int i = 0; i < 6000; ++i)
        magnus_rotation(body.inertia, body.orientation, body.angular_momentum, 1. / 60);
    CHECK(body.orientation.x() == -0x1.1fce317c46d6dp-8);
    CHECK(body.orientation.y() == -0x1.3123c235fda4ep-1);
    CHECK(body.orientation.z() == -0x1.710acfb9a5836p-6);
    CHECK(body.orientation.w() == 0x1.9af8204bfa406p-1);
}

TEST_CASE("Failure: a constant omega as the drift keeps Verlet from converging near the middle axis") {
    const FreeBody scene = near_middle_axis();
    for (const long steps_a_second : {60L, 240L, 960L})
        CHECK(error_of(scene, methods::kick_constant_kick, steps_a_second) > 2);
    CHECK(error_of(scene, methods::corrected_step) > 2);
}

TEST_CASE(
    "Failure: L in body axes taken from the pose at every stage is 10^4 times worse near the middle axis") {
    const FreeBody scene = near_middle_axis();
    const double from_pose = error_of(scene, methods::lie_rk4),
                 own = error_of(scene, methods::kick_magnus_kick);
    CHECK(from_pose == Approx(0.07).epsilon(0.05));
    CHECK(from_pose > 1e4 * own);
    // |L| is right in both; what the pose's error spoils is the energy, and that is when the body flips
    CHECK(kept(scene, methods::lie_rk4).energy == Approx(1.05e-7).epsilon(0.05));
    CHECK(kept(scene, methods::kick_magnus_kick).energy < 1e-4 * kept(scene, methods::lie_rk4).energy);
}

TEST_CASE("Failure: the body-frame Euler of game engines gains energy without bound") {
    // In the body the wobble of a round plate goes round at M3 (1/I1 - 1/I3) = 10 rad/s, as a spring swings:
    // Euler's method makes its energy of 0.5 J larger by 1 + (10 dt)^2 a step; the spin keeps its 100 J.
    const FreeBody scene = wobbling_plate();
    for (const long steps_a_second : {60L, 240L}) {
        const double dt = 1.0 / static_cast<double>(steps_a_second), factor = 1 + 100 * dt * dt;
        double law = 0.5, worst = 0;
        lab::run(scene, methods::engine_step, 10 * steps_a_second, [&](const Pinned& body, double t) {
            if (t > 0) law *= factor;
            worst = std::max(worst, std::abs(scene.energy(body) / (100 + law) - 1));
        });
        // A step's round-off is 8 epsilon of |L| = 20, beside a wobble of 1 that grows away from it: what the
        // first 1/(growth - 1) steps leave counts, twice in an energy.
        CHECK(worst < 2 * 8 * epsilon * 20 / (std::sqrt(factor) - 1));
    }
    CHECK(kept(scene, methods::engine_step).energy > 6e4);
    CHECK(kept(scene, methods::kick_split_kick).energy < 0.01);
}

TEST_CASE("Failure: without the gyroscopic term energy and the length of L are perfect, and L turns") {
    for (const FreeBody& scene : {near_middle_axis(), flip(), wobbling_plate()}) {
        INFO(scene.name);
        const Kept missing = kept(scene, methods::engine_step_without_gyroscopic);
        const double round_off = 600 * epsilon * scene.duration;  // ten a step
        CHECK(missing.energy < round_off);
        CHECK(missing.length < round_off);
        CHECK(missing.vector > 0.01);
        CHECK(error_of(scene, methods::engine_step_without_gyroscopic) > 0.3);
    }
    // with the wrong sign, or twice: the same, in the motion itself: RK4 of M' = factor (M x omega)
    const FreeBody scene = flip();
    for (const double factor : {-1.0, 2.0}) {
        FlatPinned y = flat(scene.start);
        const Vector3 J = scene.start.inertia.cwiseInverse();
        double energy = 0, length = 0, vector = 0;
        for (int i = 0; i < 3000; ++i) {
            y = rk4(
                y,
                [&](const FlatPinned& at, double) {
                    FlatPinned rate = rate_in_body(at, J, Vector3::Zero());
                    rate.tail<3>() *= factor;
                    return rate;
                },
                0, 0.01);
            const Pinned body = unflat(y, scene.start);
            energy = std::max(energy, std::abs(scene.energy(body) / scene.energy(scene.start) - 1));
            const Vector3 &L = body.angular_momentum, &L0 = scene.start.angular_momentum;
            length = std::max(length, std::abs(L.norm() / L0.norm() - 1));
            vector = std::max(vector, (L - L0).norm() / L0.norm());
        }
        CHECK(energy < 1e-6);
        CHECK(length < 1e-6);
        CHECK(vector > 0.5);
    }
}

TEST_CASE("A thrown spanner: its centre is a parabola to round-off, its tip within a pixel") {
    const ThrownSpanner scene;
    const auto run = lab::measure(scene, methods::kick_magnus_kick, 60);
    CHECK(run.max_error < 0.01 * scene.need.tolerance);
    const Body last = lab::run(scene, methods::verlet_re_evaluated, 60);
    CHECK((last.position - scene.exact(1).position).norm() < 100 * epsilon);
    CHECK(lab::measure(scene, methods::verlet_re_evaluated, 60).max_error < scene.need.tolerance);
}

TEST_CASE("A torque that depends on time is asked for at its time: every method at its order") {
    // A ball that nothing but its torque turns, about one axis: I theta'' = sin t, so theta = (t - sin t)/I
    struct Driven {
        Pinned start{Vector3::Constant(2), Quaternion::Identity(), Vector3::Zero()};
        double duration = 3;
        Wrench operator()(const Pinned&, double t) const { return {{}, {0, 0, std::sin(t)}}; }
        double error(const Pinned& body, double t) const {
            return angle_between(body.orientation, exponential({0, 0, (t - std::sin(t)) / 2}));
        }
    };
    const auto order = [](const auto& method, const std::vector<long>& steps) {
        return errors_of(Driven{}, method, steps);
    };
    CHECK_THAT(order(methods::printed_step, {400, 800, 1600}), HasOrder(1));  // a ball: right, for once
    CHECK_THAT(order(methods::corrected_step, {400, 800, 1600}), HasOrder(1));
    CHECK_THAT(order(methods::kick_constant_kick, {100, 200, 400}), HasOrder(2));
    CHECK_THAT(order(methods::kick_split_kick, {100, 200, 400}), HasOrder(2));
    CHECK_THAT(order(methods::kick_exact_kick, {100, 200, 400}), HasOrder(2));
    CHECK_THAT(order(methods::kick_magnus_kick, {100, 200, 400}), HasOrder(2));
    CHECK_THAT(order(methods::lie_rk4, {25, 50, 100}), HasOrder(4));
    CHECK_THAT(order(methods::rk4, {25, 50, 100}), HasOrder(4));
}
