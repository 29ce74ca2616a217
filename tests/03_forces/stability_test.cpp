// Chapter 3: where each method breaks on one spring. Three ways to know it must agree: the closed form, the
// largest eigenvalue of one step's matrix, and bisection on runs. Stable at 0.99 of the limit, unstable
// at 1.01.
#include <set>
#include "check.hpp"
#include "method_limits.hpp"

using namespace nutshell;

namespace {

const double under = 0.2, over = 4;  // g at omega = 1: damping ratios 0.1 and 2

/// A run stays bounded, or not.
template <class Method>
bool stays(const Method& method, double omega, double g, double dt, long steps, double bound) {
    return lab::stays_within(spring_of(omega, g), method, dt, steps, bound,
                             [](const auto& s) { return size_of(s); });
}

template <class Method>
void check_never(const Method& method, double omega, double g) {
    for (const double dt : {0.01, 0.1, 1.0}) {
        const double radius = lab::spectral_radius(spring_matrix(method, omega, g, dt));
        INFO("dt " << dt << ", a step multiplies by " << radius);
        CHECK(radius > 1 + 1e-10);
        const long steps = std::lround(std::ceil(std::log(1e4) / std::log(radius)));
        if (steps < 3'000'000) CHECK_FALSE(stays(method, omega, g, dt, steps, 100));
    }
}

/// Bounded at any step. (A velocity may be a half-kick of a long step: dt times the force.)
template <class Method>
void check_always(const Method& method, double omega, double g, double longest) {
    for (double dt = 1; dt <= longest; dt *= 10) {
        INFO("dt " << dt);
        CHECK(stays(method, omega, g, dt, 1000, 10 + omega * omega * dt));
    }
}

template <class Method>
void check_limit(const Method& method, double omega, double g, double limit, long steps) {
    const auto stable = [&](double dt) { return stays(method, omega, g, dt, steps, 1000); };
    CHECK(stable(0.99 * limit));
    CHECK_FALSE(stable(1.01 * limit));
    CHECK(lab::stability_limit(stable, limit / 2, limit * 1.1, 2e-3) == Approx(limit).epsilon(0.01));
}

}  // namespace

TEST_CASE("Every method, on every spring and under drag alone: closed form, eigenvalue and runs agree") {
    const auto [name, omega, g] =
        GENERATE(table<const char*, double, double>({{"undamped", 1, 0},
                                                     {"damping ratio 0.1", 1, under},
                                                     {"damping ratio 0.5", 1, 1},
                                                     {"damping ratio 0.95", 1, 1.9},
                                                     {"damping ratio 2", 1, over},
                                                     {"damping ratio 5", 1, 10},
                                                     {"drag alone", 0, 1}}));
    const std::string scene = name;
    const double w = omega, drag = g;
    each_limit([&](const auto& method, const OnSpring& theory) {
        const double limit = theory.limit(w, drag), eigenvalue = limit_by_eigenvalue(method, w, drag);
        INFO(method.name << ", " << scene << ": limit " << limit << ", by eigenvalue " << eigenvalue);
        if (limit == 0) {
            CHECK(eigenvalue == 0);
            check_never(method, w, drag);
        } else if (!std::isfinite(limit)) {
            CHECK_FALSE(std::isfinite(eigenvalue));
            check_always(method, w, drag,
                         100);  // exponential Yoshida, whose drag grows on its way back, overflows far beyond
        } else {
            CHECK(eigenvalue == Approx(limit).epsilon(1e-3));
            check_limit(method, w, drag, limit, std::max(20'000L, theory.steps_to_grow(1e7, w, drag)));
        }
    });
}

TEST_CASE("Every method that moves a body on a spring stands in the table of limits, once") {
    std::multiset<std::string> in_table, on_list{};
    each_limit([&](const auto& method, const OnSpring&) { in_table.insert(method.name); });
    each(std::tuple_cat(kick_and_drift_methods, general_methods),
         [&](const auto& method) { on_list.insert(method.name); });
    CHECK(in_table == on_list);  // the exact propagator and the planet's clocks have tests of their own
}

TEST_CASE("The limits that have a number of their own") {
    const auto of = [](const auto& method, double omega, double g) {
        return limit_by_eigenvalue(method, omega, g);
    };
    CHECK(of(methods::verlet_re_evaluated, 1, 0) == Approx(2).epsilon(1e-6));
    CHECK(of(methods::yoshida4, 1, 0) == Approx(1.5734).epsilon(1e-4));
    CHECK(of(methods::verlet, 0, 1) == Approx(2).epsilon(1e-6));  // the kept force; 4 when evaluated again
    CHECK(verlet_re_evaluated_limit(0, 1) == Approx(4).epsilon(1e-9));
    CHECK(general_limit(StabilityFunction::rk4, 1, 0) == Approx(2 * std::sqrt(2.0)).epsilon(1e-9));
    CHECK(general_limit(StabilityFunction::rk4, 0, 1) == Approx(2.78529).epsilon(2e-6));
    CHECK(general_limit(StabilityFunction::euler, 1, 0) == 0);
    CHECK(general_limit(StabilityFunction::explicit_midpoint, 1, 0) == 0);
    CHECK(euler_limit(0, 1) == 2);
    CHECK(semi_implicit_limit(0, 1) == 2);
    CHECK(euler_limit(1, under) == Approx(under));  // gamma/kappa
    CHECK(euler_limit(1, over) == Approx(4 / (over + std::sqrt(over * over - 4))));
    CHECK(semi_implicit_limit(1, under) == Approx(-under + std::sqrt(under * under + 4)));
    CHECK(exponential_verlet_inside_limit(1, under) > 2);
    CHECK(exponential_verlet_inside_limit(1, 10) ==
          std::numeric_limits<double>::infinity());  // so much drag holds any step
    for (const double g : {under, over})
        CHECK(general_limit(StabilityFunction::euler, 1, g) == Approx(euler_limit(1, g)).epsilon(1e-6));
    // Units: omega and g scale together.
    CHECK(euler_limit(7, 7 * under) == Approx(euler_limit(1, under) / 7));
    CHECK(exponential_limit(7, 7 * over) == Approx(exponential_limit(1, over) / 7).epsilon(1e-6));
}

TEST_CASE("Never stable on the undamped spring: by how much Euler and the explicit midpoint grow") {
    for (const double dt : {1e-3, 1e-2, 0.1, 1.0}) {
        CHECK(lab::spectral_radius(spring_matrix(methods::euler, 1, 0, dt)) ==
              Approx(std::sqrt(1 + dt * dt)).epsilon(1e-12));
        CHECK(lab::spectral_radius(spring_matrix(methods::explicit_midpoint, 1, 0, dt)) ==
              Approx(std::sqrt(1 + dt * dt * dt * dt / 4)).epsilon(1e-12));
    }
}

TEST_CASE("The exact propagator is stable at any step") {
    for (const double g : {0.0, under, over}) check_always(methods::exact_propagator, 1, g, 1e6);
}

TEST_CASE(
    "At g = omega re-evaluated Verlet breaks from 2 to 2 sqrt 2 and holds again to 4: a limit is where it "
    "first "
    "breaks") {
    const auto radius = [](double dt) {
        return lab::spectral_radius(spring_matrix(methods::verlet_re_evaluated, 1, 1, dt));
    };
    CHECK(verlet_re_evaluated_limit(1, 1) == Approx(2).epsilon(1e-9));
    CHECK(radius(2.5) > 1.1);
    CHECK(radius(3) < 1);
    CHECK(radius(3.99) < 1);
}

TEST_CASE("Drag alone: Euler keeps the sign of the velocity below 1") {
    const MassOnSpring drag = spring_of(0, 1);
    CHECK(euler(drag.start, drag, 0, 0.99).velocity.x() > 0);
    CHECK(euler(drag.start, drag, 0, 1.01).velocity.x() < 0);
}

TEST_CASE("drag alone, Yoshida: where 2.336 and 1.241 come from") {
    const auto w = yoshida_weights();
    const double again = first_limit(
        [&](double x) {  // each Verlet multiplies the velocity by (1 - w x/2)^2
            double factor = 1;
            for (const double wi : w) factor *= (1 - wi * x / 2) * (1 - wi * x / 2);
            return 1 + 1e-12 - factor;
        },
        0.01);
    const double kept = first_limit(
        [&](double x) {  // half a kick of one step and half of the next share a force
            double factor = 1;
            for (std::size_t i = 0; i < 3; ++i) factor *= 1 - (w[i] + w[(i + 1) % 3]) * x / 2;
            return 1 + 1e-12 - std::abs(factor);
        },
        0.01);
    CHECK(again == Approx(2.336).epsilon(3e-4));
    CHECK(kept == Approx(1.2393).epsilon(4e-5));  // measured before as 1.241
    CHECK(limit_by_eigenvalue(methods::yoshida4_re_evaluated, 0, 1) == Approx(again).epsilon(1e-4));
    CHECK(limit_by_eigenvalue(methods::yoshida4, 0, 1) == Approx(kept).epsilon(1e-4));
}
