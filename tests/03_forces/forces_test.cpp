// Chapter 3: the forces, their energies, the scenes' exact solutions, and the door.
#include <nutshell/forces_methods.hpp>
#include <nutshell/forces_scenes.hpp>
#include <nutshell/log_hamiltonian.hpp>
#include <nutshell/stability_limits.hpp>
#include <nutshell/stale_drag.hpp>
#include "study.hpp"

using namespace nutshell;

namespace {

const Vector3 p{0.3, -1.2, 0.7}, q{-0.4, 0.9, 1.6}, v{2, -3, 0.5};

/// Minus the gradient of an energy by central differences.
template <class Energy>
Vector3 minus_gradient(const Energy& energy, const Vector3& at) {
    const double h = 1e-5;
    Vector3 force;
    for (int i = 0; i < 3; ++i)
        force[i] = -(energy(at + h * Vector3::Unit(i)) - energy(at - h * Vector3::Unit(i))) / (2 * h);
    return force;
}

}  // namespace

TEST_CASE("E07: weight is m g in newton, down, and the slope of its energy") {
    CHECK(gravity_force(2) == Vector3(0, -19.62, 0));
    CHECK(gravity_force(2, 9.8) == Vector3(0, -19.6, 0));
    CHECK((minus_gradient([](const Vector3& at) { return gravity_energy(2, at); }, p) - gravity_force(2))
              .norm() < 1e-8);
}

TEST_CASE(
    "E08: a spring pulls when long, pushes when short, on both ends alike, and does nothing where its ends "
    "meet") {
    for (const double rest : {0.0, 1.0, 5.0}) {
        const Spring spring{3, rest};
        const auto energy = [&](const Vector3& at) { return spring_energy(spring, at, q); };
        CHECK((minus_gradient(energy, p) - spring_force(spring, p, q)).norm() < 1e-8);
        CHECK((spring_force(spring, p, q) + spring_force(spring, q, p)).norm() == 0);
        CHECK(spring_force(spring, p, p) == Vector3::Zero());
        CHECK(spring_energy(spring, p, p) == Approx(3 * rest * rest / 2));
    }
    CHECK(spring_force({3, 1}, {2, 0, 0}, {0, 0, 0}).isApprox(Vector3(-3, 0, 0)));
    CHECK(spring_force({3, 1}, {0.5, 0, 0}, {0, 0, 0}).isApprox(Vector3(1.5, 0, 0)));
    // The smallest lengths: the direction is still there, and nothing is NaN.
    for (const double tiny : {1e-3, 1e-100, 1e-160, 1e-200, 5e-324})
        CHECK(spring_force({3, 1}, {tiny, 0, 0}, {0, 0, 0}).allFinite());
}

TEST_CASE("E08: the ends of a spring that meet during a run feel no force there, and part again") {
    struct ToAnchor {  // binary numbers, so that the mass is at the anchor exactly after two steps
        std::string name = "to the anchor";
        PointMass start{1, {1, 0, 0}, {-2, 0, 0}};
        double duration = 1;
        Spring spring{0.0, 0.5};
        Vector3 operator()(const PointMass& mass, double) const {
            return spring_force(spring, mass.position, {0, 0, 0});
        }
    };
    ToAnchor slack;  // no stiffness: it coasts through the anchor
    PointMass s = slack.start;
    for (int n = 0; n < 2; ++n) s = verlet(s, slack, 0, 0.25);
    REQUIRE(s.position == Vector3::Zero());
    for (const double stiffness : {1.0, 100.0, 1e6}) {  // now stiff, from the very point where the ends meet
        ToAnchor stiff;
        stiff.spring.stiffness = stiffness;
        stiff.start = s;
        CHECK(stiff(s, 0) == Vector3::Zero());
        for (const double dt : {1e-2, 1e-4}) {
            const PointMass a = euler(s, stiff, 0, dt), b = semi_implicit_euler(s, stiff, 0, dt),
                            c = verlet(s, stiff, 0, dt);
            CHECK((a.velocity.allFinite() && b.velocity.allFinite() && c.velocity.allFinite()));
            CHECK(a.position == Vector3(-2 * dt, 0, 0));
            const auto y = rk4(flat(s), right_hand_side(s, stiff), 0, dt);
            CHECK(y.allFinite());
        }
    }
}

TEST_CASE("E09: drag takes energy out, against the velocity, and quadratic drag with its square") {
    CHECK(linear_drag_force(0.5, v).dot(v) == Approx(-0.5 * v.squaredNorm()));
    CHECK(quadratic_drag_force(0.5, v).dot(v) == Approx(-0.5 * std::pow(v.norm(), 3)));
    CHECK(quadratic_drag_force(0.5, v).cross(v).norm() < 1e-14);
    CHECK(quadratic_drag_force(0.5, Vector3(0, 0, 0)) == Vector3::Zero());
    CHECK((quadratic_drag_force(0.5, 2 * v) - 4 * quadratic_drag_force(0.5, v)).norm() < 1e-12);
    CHECK(air_drag(1.2, 0.47, 0.1) == Approx(0.0282));
}

TEST_CASE("forces add, and the order of the sum does not matter beyond round-off") {
    const Vector3 a = gravity_force(2), b = spring_force({3, 1}, p, q), c = linear_drag_force(0.4, v),
                  d = quadratic_drag_force(0.1, v);
    const double round_off = 4e-16 * (a.norm() + b.norm() + c.norm() + d.norm());
    CHECK(((a + b + c + d) - (d + c + b + a)).norm() <= round_off);
    CHECK(((a + b + c + d) - (c + a + d + b)).norm() <= round_off);
}

TEST_CASE("the door: springs, drags, steps and limits say what is wrong") {
    CHECK_THROWS_WITH(checked(Spring{-1, 0}),
                      ContainsSubstring("stiffness") && ContainsSubstring("not negative"));
    CHECK_THROWS_WITH(checked(Spring{1, -0.5}), ContainsSubstring("rest length"));
    CHECK_THROWS_WITH(checked(Spring{std::nan(""), 0}), ContainsSubstring("stiffness"));
    CHECK_THROWS_WITH(checked(Spring{1, INFINITY}), ContainsSubstring("rest length"));
    CHECK_THROWS_WITH(checked_drag(-1), ContainsSubstring("drag"));
    CHECK_THROWS_WITH(MassOnSpring::with_damping(-0.1), ContainsSubstring("drag"));
    CHECK_THROWS_WITH(checked(PointMass{0, {0, 0, 0}, {0, 0, 0}}), ContainsSubstring("mass"));
    CHECK_THROWS_WITH(checked(PointMass{1, {0, NAN, 0}, {0, 0, 0}}), ContainsSubstring("position"));
    CHECK_NOTHROW(checked(Spring{0, 0}));
    CHECK(checked(Spring{2, 3}).rest_length == 3);
    const MassOnSpring spring;
    const FlatPoint start = flat(spring.start);
    const auto f = right_hand_side(spring.start, spring);
    const auto nothing = [](const FlatPoint&, double) {};
    CHECK_THROWS_WITH(adaptive(start, f, 0, 1, {0, 1e-6}, 0.1, nothing),
                      ContainsSubstring("absolute tolerance"));
    CHECK_THROWS_WITH(adaptive(start, f, 0, 1, {1e-6, -1}, 0.1, nothing),
                      ContainsSubstring("relative tolerance"));
    CHECK_THROWS_WITH(adaptive(start, f, 0, 1, {}, 0, nothing), ContainsSubstring("first step"));
    CHECK_THROWS_WITH(adaptive(start, f, 1, 1, {}, 0.1, nothing),
                      ContainsSubstring("time from start to end"));
    CHECK_THROWS_WITH(lab::run(MassOnSpring{}, methods::verlet_re_evaluated, 0),
                      ContainsSubstring("at least one step"));
    CHECK_THROWS_WITH(run_until({Planet{}.start}, LogHamiltonian(1, Planet{}.start), 1, NAN),
                      ContainsSubstring("ds"));
}

TEST_CASE("falling: the exact solutions solve their equations, and have their terminal velocities") {
    const FallingWithDrag linear;
    const FallingInAir air;
    const auto solves = [](const auto& scene,
                           double t) {  // m dv/dt = F and dp/dt = v, by a five-point difference
        const double h = 1e-3;
        const auto slope = [&](auto part) -> Vector3 {
            return (8 * (part(t + h) - part(t - h)) - (part(t + 2 * h) - part(t - 2 * h))) / (12 * h);
        };
        const PointMass now = scene.exact(t);
        CHECK((slope([&](double s) -> Vector3 { return scene.exact(s).position; }) - now.velocity).norm() <
              1e-9);
        CHECK((slope([&](double s) -> Vector3 { return scene.exact(s).velocity; }) * now.mass - scene(now, t))
                  .norm() < 1e-9);
    };
    for (const double t : {0.1, 1.0, 4.0}) solves(linear, t), solves(air, t);
    for (const double ratio : {0.0, 0.1, 0.999999, 1.0, 1.000001, 2.0, 20.0})
        for (const double t : {0.1, 0.7}) {
            const MassOnSpring spring = MassOnSpring::with_damping(ratio);
            const double h = 1e-3;
            const Vector3 slope = (8 * (spring.exact(t + h).velocity - spring.exact(t - h).velocity) -
                                   (spring.exact(t + 2 * h).velocity - spring.exact(t - 2 * h).velocity)) /
                                  (12 * h);
            CHECK((slope - spring(spring.exact(t), t)).norm() < 1e-5);
        }
    CHECK(linear.exact(100).velocity.isApprox(linear.terminal_velocity(), 1e-12));
    CHECK(linear.terminal_velocity().y() == Approx(-9.81 / 0.5));
    CHECK(-air.exact(100).velocity.y() == Approx(air.terminal_speed()).epsilon(1e-12));
    CHECK(air.terminal_speed() == Approx(std::sqrt(9.81 / air.air)));
}

TEST_CASE("exact solutions against another method run tight, so that exact is not the same method again") {
    const auto tight = [](const auto& scene) { return lab::run(scene, methods::rk4, 20000); };
    CHECK(distance(tight(FallingWithDrag{}), FallingWithDrag{}.exact(5)) < 1e-10);
    CHECK(distance(tight(FallingInAir{}), FallingInAir{}.exact(5)) < 1e-10);
    for (const double ratio : {0.0, 0.1, 1.0, 2.0})
        CHECK(distance(tight(MassOnSpring::with_damping(ratio)),
                       MassOnSpring::with_damping(ratio).exact(10)) < 1e-10);
    ThrowInAir air, linear;
    linear.air = 0, linear.drag = 0.3;
    CHECK(distance(tight(air), air.exact(3)) < 1e-11);  // the accuracy the scene states
    CHECK(distance(tight(linear), linear.exact(3)) < 1e-11);
}

TEST_CASE("the exact propagator: any step, all three regimes, to a few units of round-off") {
    for (const double ratio : {0.0, 0.1, 0.9999999, 1.0, 1.0000001, 2.0, 50.0}) {
        const MassOnSpring spring = MassOnSpring::with_damping(ratio);
        for (const long steps : {1, 10, 1000})
            CHECK(lab::measure(spring, methods::exact_propagator, steps).max_error < 2e-13);
        CHECK(lab::measure(spring, methods::exact_propagator, 10).evaluations == 0);
        // Two half steps are a whole one.
        const double w = spring.omega(), g = spring.damping_rate();
        CHECK((oscillation(w, g, 0.07) * oscillation(w, g, 0.07) - oscillation(w, g, 0.14)).norm() < 1e-13);
        CHECK(oscillation(w, g, 0).isApprox(Eigen::Matrix2d::Identity()));
    }
    CHECK(oscillation(0, 0, 3).isApprox((Eigen::Matrix2d() << 1, 3, 0, 1).finished()));  // no force at all
    CHECK(oscillation(2, 1000, 50).allFinite());                                         // no cosh overflows
}

TEST_CASE("the exponential kick: exact under gravity at any step, from no drag to a great deal") {
    for (const double drag : {0.0, 1e-12, 1e-3, 0.5, 20.0, 1e4}) {
        INFO("gamma " << drag);
        FallingWithDrag scene;
        scene.drag = drag;
        scene.start.velocity = {3, 4, 0};
        const PointMass once = exponential_kick(scene.start, scene, 0, 5);
        const PointMass often = lab::run(scene, methods::exponential_kick, 640);
        CHECK((once.position - often.position).norm() < 1e-11);
        CHECK((once.velocity - often.velocity).norm() < 1e-11);
        if (drag == 0)
            CHECK((once.position - Vector3(15, 20 - 9.81 * 12.5, 0)).norm() < 1e-12);
        else if (drag > 1e-3)
            CHECK(scene.error(once, 5) < 1e-12 * 100);
    }
    for (const double x : {1e-9, 1e-3, 0.4999, 0.5001, 3.0}) {
        CHECK(phi_1(-x) == Approx((1 - std::exp(-x)) / x).epsilon(1e-6));
        CHECK(phi_2(-x) ==
              Approx(x < 0.1 ? 0.5 - x / 6 + x * x / 24 : (x - 1 + std::exp(-x)) / (x * x)).epsilon(1e-9));
    }
    CHECK(phi_2(-0.4999999999) == Approx(phi_2(-0.5000000001)).epsilon(1e-9));
}

TEST_CASE("E59, table 3.8: drag from the last step's velocity is stable to 1 only, and swings beyond 1/4") {
    struct Drag {
        PointMass start{1, {0, 0, 0}, {1, 0, 0}};
        double gamma;
        Vector3 operator()(const PointMass& s, double) const { return linear_drag_force(gamma, s.velocity); }
    };
    const auto largest = [](const auto& method, double x) {  // of |v| in steps 300 to 400
        const Drag drag{{1, {0, 0, 0}, {1, 0, 0}}, x};
        PointMass s = drag.start;
        double most = 0;
        auto step = method.start(drag);
        for (int n = 1; n <= 400; ++n) {
            s = step(s, drag, 0.0, 1.0);
            if (n >= 300) most = std::max(most, s.velocity.norm());
        }
        return std::log10(most);
    };
    using mistakes::stale_euler;
    CHECK(largest(methods::euler, 0.5) == Approx(std::log10(1e-91)).margin(1));
    CHECK(largest(stale_euler, 0.5) == Approx(std::log10(2e-46)).margin(1));
    CHECK(largest(stale_euler, 0.9) == Approx(std::log10(1e-7)).margin(0.6));
    CHECK(largest(stale_euler, 1.0) == Approx(0).margin(1e-12));
    CHECK(largest(stale_euler, 1.1) == Approx(std::log10(2e8)).margin(0.6));
    CHECK(largest(stale_euler, 1.9) == Approx(std::log10(8e55)).margin(1));
    CHECK(largest(stale_euler, 2.1) == Approx(std::log10(3e64)).margin(1));
    CHECK(largest(methods::euler, 1.9) == Approx(std::log10(1.5e-14)).margin(1));
    CHECK(largest(methods::euler, 2.1) == Approx(std::log10(3.6e16)).margin(1));

    const auto swings = [](double x) {  // does the velocity ever turn round?
        const Drag drag{{1, {0, 0, 0}, {1, 0, 0}}, x};
        auto step = stale_euler.start(drag);
        PointMass s = drag.start;
        for (int n = 0; n < 2000; ++n) {
            s = step(s, drag, 0.0, 1.0);
            if (s.velocity.x() < 0) return true;
        }
        return false;
    };
    CHECK_FALSE(swings(0.25 * 0.99));
    CHECK(swings(0.25 * 1.01));
    CHECK(lab::stability_limit([&](double x) { return !swings(x); }, 0.1, 1.0) == Approx(0.25).epsilon(0.01));
    CHECK(lab::stability_limit([&](double x) { return largest(stale_euler, x) <= 0; }, 0.5, 1.5) ==
          Approx(1).epsilon(0.01));
}

TEST_CASE("step control: the error follows the tolerance, and trouble is said, not looped over") {
    const Planet scene = Planet::for_orbits(10);
    double last = 1e9;
    for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-11}) {
        long steps = 0;
        const FlatPoint end =
            adaptive(flat(scene.start), right_hand_side(scene.start, scene), 0, scene.duration,
                     {tolerance, tolerance}, 0.01, [&](const FlatPoint&, double) { ++steps; });
        const double error = scene.error(unflat(end, scene.start), scene.duration);
        CHECK(error < last / 10);
        CHECK(error < 1e5 * tolerance);
        CHECK(steps < 4000);
        last = error;
    }
    struct Breaks {
        FlatPoint operator()(const FlatPoint& y, double t) const {
            return FlatPoint::Constant(t > 0.5 ? NAN : 1) + 0 * y;
        }
    };
    CHECK_THROWS_WITH(
        adaptive(FlatPoint(FlatPoint::Zero()), Breaks{}, 0, 1, {}, 0.1, [](const FlatPoint&, double) {}),
        ContainsSubstring("shrank to nothing"));
    struct NoRoot {  // z = y + dt (z^2 + 1) has no solution for dt = 1
        Eigen::Matrix<double, 1, 1> operator()(const Eigen::Matrix<double, 1, 1>& y, double) const {
            return Eigen::Matrix<double, 1, 1>(y[0] * y[0] + 1);
        }
    };
    CHECK_THROWS_WITH(implicit_euler(Eigen::Matrix<double, 1, 1>(0.3), NoRoot{}, 0, 1.0),
                      ContainsSubstring("smaller dt"));
}

TEST_CASE("general-purpose methods take right-hand sides of any size, also one not known beforehand") {
    const auto f = [](const Vector& y, double) -> Vector { return -y; };
    const Vector start = Vector::LinSpaced(5, 1, 5);
    CHECK((rk4(start, f, 0, 0.1) - std::exp(-0.1) * start).norm() < 1e-6);
    CHECK((implicit_midpoint(start, f, 0, 0.1) - 0.95 / 1.05 * start).norm() < 1e-12);
    CHECK((adaptive(start, f, 0, 1, {1e-10, 1e-10}, 0.1, [](const Vector&, double) {}) - std::exp(-1) * start)
              .norm() < 1e-8);
}
