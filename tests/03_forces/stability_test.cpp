// Chapter 3: where each method breaks. Three ways to know it must agree: the closed form, the largest eigenvalue of one
// step's matrix, and bisection on runs. Stable at 0.99 of the limit, unstable at 1.01.
#include <nutshell/forces_methods.hpp>
#include <nutshell/forces_scenes.hpp>
#include <nutshell/stability_limits.hpp>
#include "study.hpp"

using namespace nutshell;

namespace {

/// An undamped, a damped or an overdamped spring, or drag alone (omega = 0), started so that every mode takes part.
MassOnSpring scene_of(double omega, double g) {
    MassOnSpring scene;
    scene.stiffness = omega * omega, scene.drag = g;
    scene.start = {1, {1, 0, 0}, {0.7, 0, 0}};
    return scene;
}

double size_of(const PointMass& s) { return std::max(std::abs(s.position.x()), std::abs(s.velocity.x())); }
double size_of(const FlatPoint& y) { return y.cwiseAbs().maxCoeff(); }

/// Bisection on runs: bounded for a long time, or not. Long enough to see 9e-5 of growth a step.
template <class Scene, class Method>
void check_runs(const Scene& scene, const Method& method, double predicted, long steps, double bound = 200) {
    const auto stable = [&](double dt) {
        return lab::stays_within(scene, method, dt, steps, bound, [](const auto& s) { return size_of(s); });
    };
    CHECK(stable(0.99 * predicted));
    CHECK_FALSE(stable(1.01 * predicted));
    CHECK(lab::stability_limit(stable, predicted / 2, predicted * 1.1, 2e-3) == Approx(predicted).epsilon(0.01));
}

/// For kick-and-drift methods.
template <class Method>
void check_limit(double omega, double g, const Method& method, double predicted, long steps = 60000) {
    INFO("omega " << omega << ", g " << g << ", predicted " << predicted);
    const MassOnSpring scene = scene_of(omega, g);
    CHECK(lab::spectral_limit([&](double dt) { return matrix_of(scene, method, dt); }, predicted / 2, predicted * 1.1) ==
          Approx(predicted).epsilon(1e-3));
    check_runs(scene, method, predicted, steps);
}
/// For flows.
template <class Method>
void check_flow_limit(double omega, double g, const Method& method, double predicted, long steps = 60000) {
    INFO("omega " << omega << ", g " << g << ", predicted " << predicted);
    const MassOnSpring scene = scene_of(omega, g);
    CHECK(lab::spectral_limit([&](double dt) { return matrix_of_flow(scene, method, dt); }, predicted / 2, predicted * 1.1) ==
          Approx(predicted).epsilon(1e-3));
    check_runs(Flow(scene), method, predicted, steps);
}

/// One step of a method that keeps its force, on (x, v, kept force).
template <class Method, class Kept>
Eigen::MatrixXd matrix_with_memory(const MassOnSpring& scene, const Method& method, const Kept& kept, double dt) {
    return lab::step_matrix(Eigen::VectorXd::Zero(3), [&](const Eigen::VectorXd& y) -> Eigen::VectorXd {
        Method fresh = method;
        kept(fresh) = Vector3(y[2], 0, 0);
        const PointMass body = fresh(PointMass{1, {y[0], 0, 0}, {y[1], 0, 0}}, scene, 0.0, dt);
        return Vector3(body.position.x(), body.velocity.x(), kept(fresh)->x());
    });
}

const double under = 0.2, over = 4;   // g at omega = 1: damping ratios 0.1 and 2

}  // namespace

TEST_CASE("undamped spring") {
    check_limit(1, 0, semi_implicit_euler_method, 2);
    check_limit(1, 0, verlet_method, 2);
    check_limit(1, 0, VerletFsal<Vector3>{}, 2);
    check_limit(1, 0, exponential_verlet_method, 2);
    check_limit(1, 0, yoshida4(), 1.5734);
    check_flow_limit(1, 0, rk4_method, 2 * std::sqrt(2.0));
    CHECK(general_limit(Amplification::rk4, 1, 0) == Approx(2 * std::sqrt(2.0)).epsilon(1e-9));
    CHECK(general_limit(Amplification::euler, 1, 0) == 0);
    CHECK(general_limit(Amplification::midpoint, 1, 0) == 0);
    const MassOnSpring scene = scene_of(1, 0);
    // Dormand-Prince leaves stability so gently (7e-6 a step at 1.01 of its limit) that it takes two million steps to see.
    const double dormand_prince = general_limit(Amplification::dormand_prince, 1, 0);
    CHECK(lab::spectral_limit([&](double dt) { return matrix_of_flow(scene, dormand_prince_method, dt); }, 0.5, 1.1, 1e-10) ==
          Approx(dormand_prince).epsilon(1e-3));
    const auto stable = [&](double dt) {
        return lab::stays_within(Flow(scene), dormand_prince_method, dt, 2000000, 3, [](const auto& y) { return size_of(y); });
    };
    CHECK(lab::stability_limit(stable, 0.99 * dormand_prince, 1.01 * dormand_prince, 5e-3) == Approx(dormand_prince).epsilon(0.01));
    // Kahan-Li has no closed form: the eigenvalue predicts, the runs confirm.
    const double kahan_li = lab::spectral_limit([&](double dt) { return matrix_of(scene, kahan_li8(), dt); }, 0.5, 5);
    INFO("Kahan-Li limit " << kahan_li);
    check_runs(scene, kahan_li8(), kahan_li, 60000);
}

TEST_CASE("never stable on the undamped spring: Euler and the explicit midpoint, at any step") {
    const MassOnSpring scene = scene_of(1, 0);
    for (const double dt : {1e-3, 1e-2, 0.1, 1.0}) {
        CHECK(lab::spectral_radius(matrix_of(scene, euler_method, dt)) == Approx(std::sqrt(1 + dt * dt)).epsilon(1e-12));
        CHECK(lab::spectral_radius(matrix_of_flow(scene, explicit_midpoint_method, dt)) ==
              Approx(std::sqrt(1 + dt * dt * dt * dt / 4)).epsilon(1e-12));
    }
    const auto size = [](const auto& s) { return size_of(s); };
    CHECK_FALSE(lab::stays_within(scene, euler_method, 0.01, 300000, 1e4, size));
    CHECK_FALSE(lab::stays_within(Flow(scene), explicit_midpoint_method, 0.2, 300000, 1e4, size));
}

TEST_CASE("always stable: the implicit methods, the exact propagator, the exponential kick under drag") {
    const auto size = [](const auto& s) { return size_of(s); };
    for (const double g : {0.0, under, over}) {
        const MassOnSpring scene = scene_of(1, g);
        for (const double dt : {1.0, 10.0, 100.0, 1e4}) {
            CHECK(lab::stays_within(Flow(scene), implicit_euler_method, dt, 1000, 2, size));
            CHECK(lab::stays_within(Flow(scene), implicit_midpoint_method, dt, 1000, 2, size));
            CHECK(lab::stays_within(scene, SpringPropagator{1, g}, dt, 1000, 2, size));
        }
    }
    for (const double dt : {1.0, 100.0, 1e4})
        CHECK(lab::stays_within(scene_of(0, 3), exponential_kick_method, dt, 1000, 2, size));
}

TEST_CASE("damped spring: Euler and semi-implicit Euler with drag in the kick") {
    CHECK(euler_limit(1, under) == Approx(under));                       // gamma/kappa
    CHECK(euler_limit(1, over) == Approx(4 / (over + std::sqrt(over * over - 4))));
    CHECK(semi_implicit_limit(1, under) == Approx(-under + std::sqrt(under * under + 4)));
    for (const double g : {under, 1.0, over}) {
        const long steps = g < 2 ? 60000 : 20000;
        check_limit(1, g, euler_method, euler_limit(1, g), steps);
        check_limit(1, g, semi_implicit_euler_method, semi_implicit_limit(1, g), steps);
        check_limit(1, g, semi_implicit_division_method, division_limit(1, g), steps);
        check_limit(1, g, semi_implicit_exponential_method, exponential_limit(1, g), steps);
    }
    // Units: omega and g scale together.
    CHECK(euler_limit(7, 7 * under) == Approx(euler_limit(1, under) / 7));
    CHECK(exponential_limit(7, 7 * over) == Approx(exponential_limit(1, over) / 7).epsilon(1e-6));
}

TEST_CASE("damped spring: Verlet with drag in the kick, and with exponential half-kicks") {
    for (const double g : {under, 1.0, 1.9, over, 10.0}) {
        const long steps = g < 2 ? 60000 : 20000;
        check_limit(1, g, verlet_method, naive_verlet_limit(1, g), steps);
        check_limit(1, g, exponential_verlet_method, exponential_verlet_limit(1), steps);
        if (g <= 1) check_limit(1, g, ExponentialVerlet<>{}, exponential_verlet_inside_limit(1, g), steps);
    }
    // At g = omega naive Verlet is unstable from 2 to 2 sqrt 2, then stable again to 4: a limit is where it first breaks.
    CHECK(naive_verlet_limit(1, 1) == Approx(2).epsilon(1e-9));
    CHECK(lab::spectral_radius(matrix_of(scene_of(1, 1), verlet_method, 2.5)) > 1.1);
    CHECK(lab::spectral_radius(matrix_of(scene_of(1, 1), verlet_method, 3)) < 1);
    CHECK(lab::spectral_radius(matrix_of(scene_of(1, 1), verlet_method, 3.99)) < 1);
    CHECK(exponential_verlet_inside_limit(1, 10) == std::numeric_limits<double>::infinity());   // so much drag holds any step
    CHECK(exponential_verlet_inside_limit(1, under) > 2);
}

TEST_CASE("damped spring: the general-purpose methods by |R(lambda dt)| = 1") {
    for (const double g : {under, over}) {
        const long steps = g < 2 ? 60000 : 20000;
        check_flow_limit(1, g, explicit_midpoint_method, general_limit(Amplification::midpoint, 1, g), steps);
        check_flow_limit(1, g, rk4_method, general_limit(Amplification::rk4, 1, g), steps);
        check_flow_limit(1, g, dormand_prince_method, general_limit(Amplification::dormand_prince, 1, g), steps);
        CHECK(general_limit(Amplification::euler, 1, g) == Approx(euler_limit(1, g)).epsilon(1e-6));
        CHECK(general_limit(Amplification::implicit_euler, 1, g) == std::numeric_limits<double>::infinity());
        CHECK(general_limit(Amplification::implicit_midpoint, 1, g) == std::numeric_limits<double>::infinity());
    }
}

TEST_CASE("damped spring: Yoshida, naive and exponential, and the kept force, by eigenvalue and by runs") {
    for (const double g : {under, 1.0}) {
        const MassOnSpring scene = scene_of(1, g);
        const Composed<Verlet, 3> naive{{}, yoshida_weights()};
        const auto limit = [&](const auto& method) {
            return lab::spectral_limit([&](double dt) { return matrix_of(scene, method, dt); }, 0.2, 3);
        };
        check_runs(scene, naive, limit(naive), 60000);
        check_runs(scene, exponential_yoshida4(), limit(exponential_yoshida4()), 60000);
        const auto limit_kept = [&](const auto& method, const auto& kept) {
            return lab::spectral_limit([&](double dt) { return matrix_with_memory(scene, method, kept, dt); }, 0.05, 3);
        };
        const auto verlet_kept = [](VerletFsal<Vector3>& m) -> auto& { return m.kept; };
        check_runs(scene, VerletFsal<Vector3>{}, limit_kept(VerletFsal<Vector3>{}, verlet_kept), 60000);
        const auto yoshida_kept = [](decltype(yoshida4())& m) -> auto& { return m.method.kept; };
        check_runs(scene, yoshida4(), limit_kept(yoshida4(), yoshida_kept), 60000);
    }
}

TEST_CASE("drag alone") {
    check_limit(0, 1, euler_method, 2, 20000);
    check_limit(0, 1, semi_implicit_euler_method, 2, 20000);
    check_limit(0, 1, verlet_method, 4, 20000);                                      // evaluated again at the end
    check_runs(scene_of(0, 1), VerletFsal<Vector3>{}, 2, 20000);                     // the kept force
    check_flow_limit(0, 1, explicit_midpoint_method, 2, 20000);
    check_flow_limit(0, 1, rk4_method, 2.78529, 20000);
    CHECK(general_limit(Amplification::rk4, 0, 1) == Approx(2.78529).epsilon(2e-6));
    check_flow_limit(0, 1, dormand_prince_method, general_limit(Amplification::dormand_prince, 0, 1), 20000);
    CHECK(euler_limit(0, 1) == 2);
    CHECK(semi_implicit_limit(0, 1) == 2);
    // Without overshoot: Euler keeps the sign of the velocity below 1.
    const MassOnSpring drag = scene_of(0, 1);
    CHECK(euler(drag.start, drag, 0, 0.99).velocity.x() > 0);
    CHECK(euler(drag.start, drag, 0, 1.01).velocity.x() < 0);
}

TEST_CASE("drag alone, Yoshida: where 2.336 and 1.241 come from") {
    const auto w = yoshida_weights();
    const double again = first_limit([&](double x) {   // each Verlet multiplies the velocity by (1 - w x/2)^2
        double factor = 1;
        for (const double wi : w) factor *= (1 - wi * x / 2) * (1 - wi * x / 2);
        return 1 + 1e-12 - factor;
    }, 0.01);
    const double kept = first_limit([&](double x) {    // half a kick of one step and half of the next share a force
        double factor = 1;
        for (std::size_t i = 0; i < 3; ++i) factor *= 1 - (w[i] + w[(i + 1) % 3]) * x / 2;
        return 1 + 1e-12 - std::abs(factor);
    }, 0.01);
    CHECK(again == Approx(2.336).epsilon(3e-4));
    CHECK(kept == Approx(1.2393).epsilon(4e-5));   // measured before as 1.241
    check_limit(0, 1, Composed<Verlet, 3>{{}, w}, again, 20000);
    check_runs(scene_of(0, 1), yoshida4(), kept, 20000);
}
