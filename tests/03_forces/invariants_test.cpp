// Chapter 3: what each method does to an undamped spring in one step, exactly. A wrong coefficient or a stale
// force fails here.
#include <complex>
#include <nutshell/forces_methods.hpp>
#include <nutshell/forces_scenes.hpp>
#include <nutshell/stability_limits.hpp>
#include "study.hpp"

using namespace nutshell;

namespace {

const MassOnSpring spring;
const double omega = spring.omega();

double amplitude2(const PointMass& s) {
    return s.position.squaredNorm() + s.velocity.squaredNorm() / (omega * omega);
}

PointMass start() {
    return {1, {0.8, -0.3, 0.1}, Vector3(0.2, 0.5, -0.7) * omega};
}

/// What `step` multiplies the squared amplitude by, in one step with omega dt = theta.
template <class Method>
double growth(const Method& method, double theta) {
    return amplitude2(method.start(spring)(start(), spring, 0.0, theta / omega)) / amplitude2(start());
}
/// The largest relative change of a quantity over many steps.
template <class Method, class Quantity>
double change(const Method& method, double theta, const Quantity& quantity) {
    PointMass s = start();
    const double first = quantity(s);
    double largest = 0;
    auto step = method.start(spring);
    for (int n = 0; n < 5000; ++n) {
        s = step(s, spring, 0.0, theta / omega);
        largest = std::max(largest, std::abs(quantity(s) / first - 1));
    }
    return largest;
}

}  // namespace

TEST_CASE("the table's factors of the squared amplitude, to round-off") {
    for (const double theta : {0.01, 0.1, 0.5, 1.0, 2.0, 3.0}) {
        INFO("omega dt = " << theta);
        const double t2 = theta * theta, t4 = t2 * t2;
        CHECK(growth(methods::euler, theta) == Approx(1 + t2).epsilon(1e-14));
        CHECK(growth(methods::explicit_midpoint, theta) == Approx(1 + t4 / 4).epsilon(1e-14));
        CHECK(growth(methods::rk4, theta) == Approx(1 - t4 * t2 / 72 + t4 * t4 / 576).epsilon(1e-13));
        CHECK(growth(methods::dormand_prince, theta) ==
              Approx(std::norm(StabilityFunction::dormand_prince(Complex(0, theta)))).epsilon(1e-13));
    }
    for (const double theta :
         {0.01, 0.1, 1.0, 10.0, 100.0, 1e4}) {  // far beyond where repetition would diverge (1)
        INFO("omega dt = " << theta);
        CHECK(growth(methods::implicit_euler, theta) == Approx(1 / (1 + theta * theta)).epsilon(1e-12));
        CHECK(growth(methods::implicit_midpoint, theta) == Approx(1).epsilon(1e-12));
    }
}

TEST_CASE(
    "Putting the guess back in diverges beyond theta = 1 for implicit Euler, beyond 2 for the midpoint") {
    // x' = v, v' = -omega^2 x, in units of dt and with v in units of omega x: the rate turns by a right angle
    const auto gap_after = [](double theta, double share_of_end, int turns) {
        const std::complex<double> start(1, 0.3), turn(0, -theta);
        std::complex<double> guess = start, last = start;
        for (int i = 0; i < turns; ++i) {
            last = guess;
            guess = start + turn * ((1 - share_of_end) * start + share_of_end * last);
        }
        return std::abs(guess - last);
    };
    for (const auto& [limit, share_of_end] : {std::pair{1.0, 1.0}, std::pair{2.0, 0.5}}) {
        INFO("limit " << limit);
        CHECK(gap_after(0.99 * limit, share_of_end, 1000) < 1e-3);
        CHECK(gap_after(1.01 * limit, share_of_end, 1000) > 1e3);
    }
}

TEST_CASE("what semi-implicit Euler and Verlet keep, to round-off") {
    for (const double theta : {0.1, 1.0, 1.9}) {
        INFO("omega dt = " << theta);
        const double t2 = theta * theta, round_off = 1e-12 / (1 - t2 / 4);
        CHECK(change(methods::semi_implicit_euler, theta, [&](const PointMass& s) {
                  return s.velocity.squaredNorm() + omega * omega * s.position.squaredNorm() -
                         omega * theta * s.position.dot(s.velocity);
              }) < round_off);
        const auto kept = [&](const PointMass& s) {
            return s.velocity.squaredNorm() + omega * omega * s.position.squaredNorm() * (1 - t2 / 4);
        };
        CHECK(change(methods::verlet_re_evaluated, theta, kept) < round_off);
        CHECK(change(methods::verlet, theta, kept) < round_off);
        PointMass s{1, {1, 0, 0}, {0, 0, 0}};
        for (int n = 1; n <= 1000; ++n) {
            s = verlet(s, spring, 0, theta / omega);
            CHECK(std::abs(s.position.x() - std::cos(2 * n * std::asin(theta / 2))) < 1e-11);
        }
    }
}

TEST_CASE("compositions keep the energy in a band, and step back what they step") {
    for (const double theta : {0.1, 1.0, 1.5}) {
        CHECK(change(methods::yoshida4, theta, amplitude2) < (theta < 0.5 ? 1e-4 : 8));
        CHECK(change(methods::kahan_li8, theta, amplitude2) < (theta < 0.5 ? 1e-10 : 8));
        const double dt = theta / omega;
        PointMass s = methods::yoshida4.start(spring)(start(), spring, 0.0, dt);
        s = methods::yoshida4.start(spring)(s, spring, dt, -dt);
        CHECK(distance(s, start()) < 1e-14);
        s = methods::kahan_li8.start(spring)(start(), spring, 0.0, dt);
        s = methods::kahan_li8.start(spring)(s, spring, dt, -dt);
        CHECK(distance(s, start()) < 1e-13);
    }
    double sum = 0, cubes = 0;
    for (const double w : yoshida_weights()) sum += w, cubes += w * w * w;
    CHECK(std::abs(sum - 1) < 1e-15);
    CHECK(std::abs(cubes) < 1e-14);
    double p1 = 0, p3 = 0, p5 = 0, p7 = 0;
    for (const double w : kahan_li_weights())
        p1 += w, p3 += std::pow(w, 3), p5 += std::pow(w, 5), p7 += std::pow(w, 7);
    CHECK(std::abs(p1 - 1) < 1e-15);
    CHECK(std::abs(p3) < 1e-14);
    CHECK(std::abs(p5) < 1e-14);
    CHECK(std::abs(p7) < 1e-14);
}

TEST_CASE("first same as last: the numbers of Verlet, for one evaluation") {
    const MassOnSpring scene;
    const auto two = lab::measure(scene, methods::verlet_re_evaluated, 100),
               one = lab::measure(scene, methods::verlet, 100);
    CHECK(two.max_error == one.max_error);
    CHECK(two.evaluations == 200);
    CHECK(one.evaluations == 101);
    CHECK(lab::measure(scene, methods::yoshida4, 100).evaluations == 301);
    CHECK(lab::measure(scene, methods::kahan_li8, 100).evaluations == 1501);
    CHECK(lab::measure(scene, methods::exponential_verlet_inside, 100).evaluations == 101);
    CHECK(lab::measure(scene, methods::dormand_prince, 100).evaluations == 601);
    CHECK(lab::measure(scene, methods::rk4, 100).evaluations == 400);
    CHECK(lab::measure(scene, methods::explicit_midpoint, 100).evaluations == 200);
}

TEST_CASE("Euler's energy overflows after about 1135 periods at omega dt = 0.1, its state after about 2270") {
    MassOnSpring scene;
    scene.stiffness = 1;  // omega = 1
    PointMass s = scene.start;
    const double dt = 0.1;
    long energy_gone = 0, state_gone = 0;
    for (long n = 1; state_gone == 0; ++n) {
        s = euler(s, scene, 0, dt);
        if (energy_gone == 0 && !std::isfinite(scene.energy(s))) energy_gone = n;
        if (!s.position.allFinite() || !s.velocity.allFinite()) state_gone = n;
    }
    const double periods = dt / (2 * pi);
    CHECK(static_cast<double>(energy_gone) * periods == Approx(1135).epsilon(0.002));
    CHECK(static_cast<double>(state_gone) * periods == Approx(2270).epsilon(0.002));
}

TEST_CASE(
    "E04, table 3.1: Euler's spring gains (omega dt)^2 of its energy a step, semi-implicit stays in its "
    "band") {
    struct Row {
        double omega, dt, factor, after_10_s, low, high;
    };
    for (const Row& row :
         {Row{1, 0.008, 1.000064, 1.083, 0.996, 1.004}, Row{1, 1. / 60, 1.0002777778, 1.181, 0.992, 1.008},
          Row{10, 0.008, 1.0064, 2906, 0.962, 1.042}, Row{10, 1. / 60, 1.0277777778, 1.38e7, 0.923, 1.091},
          Row{30, 0.008, 1.0576, 2.5e30, 0.893, 1.136}, Row{30, 1. / 60, 1.25, 1.4e58, 0.800, 1.333}}) {
        INFO("omega " << row.omega << ", dt " << row.dt);
        MassOnSpring scene;
        scene.stiffness = row.omega * row.omega;
        const double start_energy = scene.energy(scene.start);
        CHECK(scene.energy(euler(scene.start, scene, 0, row.dt)) / start_energy ==
              Approx(row.factor).epsilon(1e-9));
        PointMass s = scene.start, t = scene.start;
        double low = 1, high = 1;
        for (long n = 0; n < std::lround(10 / row.dt); ++n) {
            s = euler(s, scene, 0, row.dt), t = semi_implicit_euler(t, scene, 0, row.dt);
            low = std::min(low, scene.energy(t) / start_energy),
            high = std::max(high, scene.energy(t) / start_energy);
        }
        CHECK(scene.energy(s) / start_energy == Approx(row.after_10_s).epsilon(0.02));
        CHECK(low == Approx(row.low).epsilon(0.002));
        CHECK(high == Approx(row.high).epsilon(0.002));
    }
}
