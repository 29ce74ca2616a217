// How large a step a chain and a cloth bear: by formula, by the fastest mode, and by running the method; 1 %
// apart at most, stable at 0.99 of the limit and unstable at 1.01.
#include <Eigen/Eigenvalues>
#include "check.hpp"
#include "method_limits.hpp"

using namespace nutshell;

namespace {

/// The largest stable step by running: a shake of 1e-9 m/s must not grow a thousandfold in 600 steps.
template <class Scene, class Method>
double measured_limit(const Scene& scene, const Method& method, double expected) {
    const auto stable = [&](double dt) {
        return lab::stays_within(scene, method, dt, 600, 1e-6,
                                 [](const auto& state) { return fastest_speed(state); });
    };
    CHECK(stable(0.99 * expected));
    CHECK(!stable(1.01 * expected));
    return lab::stability_limit(stable, 0.9 * expected, 1.1 * expected, 1e-3);
}

template <class Scene, class Method>
void check_limit(const Scene& scene, const Method& method, double expected) {
    CHECK(std::abs(measured_limit(scene, method, expected) / expected - 1) < 0.01);
}

}  // namespace

namespace {

/// A net at rest whose particles move in its fastest mode, a little.
SpringNet in_fastest_mode(SpringNet net, double speed = 1e-7) {
    net.g = 0;
    const Mode mode = fastest_mode(net, net.start);
    for (std::size_t i = 0; i < net.start.size(); ++i) net.start.velocity.set(i, speed * mode.shape[i]);
    return net;
}

/// What a step multiplies the energy by: the n-th root of what n steps do.
template <class Method>
double energy_factor(const SpringNet& net, const Method& method, double dt, int steps = 20) {
    auto step = method.start(net);
    Particles all = net.start;
    for (int n = 0; n < steps; ++n) all = step(std::move(all), net, n * dt, dt);
    return std::pow(net.energy(all) / net.energy(net.start), 1.0 / steps);
}

}  // namespace

TEST_CASE("Chain: the closed forms are the fastest mode, and every method breaks at its theta over it") {
    const double mass = 0.2, stiffness = 50, gap = 0.1, theta4 = composed_limit(yoshida_weights());
    CHECK(std::abs(theta4 - 1.5734) < 1e-4);
    for (const bool free : {false, true})
        for (const std::size_t masses : std::vector<std::size_t>{1, 2, 5, 24}) {
            const double links = static_cast<double>(masses) + (free ? 0 : 1);
            const SpringNet net =
                shaken(chain(masses, mass, {stiffness, gap}, {0, 0, 0}, {gap * links, 0, 0}, free));
            const double fastest = chain_frequency(masses, mass, stiffness, free);
            INFO(masses << " masses, one end free: " << free << ", fastest " << fastest << " rad/s");
            CHECK(std::abs(fastest_mode(net, net.start).frequency / fastest - 1) < 1e-6);
            check_limit(net, methods::semi_implicit_euler, 2 / fastest);
            check_limit(net, methods::verlet, 2 / fastest);
            check_limit(net, methods::yoshida4, theta4 / fastest);
            check_limit(net, methods::kahan_li8, composed_limit(kahan_li_weights()) / fastest);
            check_limit(net, methods::rk4, std::sqrt(8.0) / fastest);
        }
}

namespace {

/// The frequency whose mode breaks first as the step grows, and the step [s] at which it does.
struct Weakest {
    double omega, limit;
};
Weakest weakest_of(const std::vector<double>& frequencies, double g, const OnSpring& theory) {
    Weakest first{0, std::numeric_limits<double>::infinity()};
    for (const double omega : frequencies)
        if (const double its = theory.limit(omega, g); its < first.limit) first = {omega, its};
    return first;
}

/// The frequencies [rad/s] of all modes in the plane of the net: the roots of the eigenvalues of stiffness
/// over mass, here by pulling every particle along x and y in turn.
std::vector<double> frequencies_of(const SpringNet& net) {
    const std::size_t n = net.start.size();
    const std::vector<Link> links = list_of(net.springs).links;
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(Eigen::Index(2 * n), Eigen::Index(2 * n));
    for (const auto& [a, b, spring] : links)
        for (Eigen::Index axis = 0; axis < 2; ++axis) {
            const Vector3 change =
                spring_slope(spring, net.start.position[a], net.start.position[b]).col(axis);
            for (Eigen::Index other = 0; other < 2; ++other) {
                const auto i = 2 * Eigen::Index(a), j = 2 * Eigen::Index(b);
                stiffness(i + other, i + axis) -= change[other],
                    stiffness(j + other, j + axis) -= change[other];
                stiffness(i + other, j + axis) += change[other],
                    stiffness(j + other, i + axis) += change[other];
            }
        }
    std::vector<double> frequencies;
    for (const double square : Vector(stiffness.selfadjointView<Eigen::Lower>().eigenvalues()))
        frequencies.push_back(std::sqrt(std::max(0.0, square) / net.start.mass[0]));
    return frequencies;  // in rising order
}

/// A net with drag is as many damped springs as it has modes: a method breaks where the first of them does.
void check_every_method(const SpringNet& net, const std::vector<double>& frequencies) {
    const double fastest = frequencies.back(), g = net.drag / net.start.mass[0];
    each_limit([&](const auto& method, const OnSpring& theory) {
        const Weakest first = weakest_of(frequencies, g, theory);
        INFO(method.name << " on a " << net.name << ", g " << g << ", fastest " << fastest
                         << " rad/s, breaks at " << first.omega << " rad/s with dt " << first.limit);
        const auto stays = [&](double dt, long steps) {
            return lab::stays_within(net, method, dt, steps, 1e-6,
                                     [](const auto& state) { return fastest_speed(state); });
        };
        if (first.limit == 0) {
            CHECK_FALSE(stays(1 / fastest, 2000));
        } else if (!std::isfinite(first.limit)) {
            CHECK(stays(100 / fastest, 20));
        } else if (const long steps = theory.steps_to_grow(1e9, first.omega, g); steps < 200'000) {
            CHECK(stays(0.99 * first.limit, steps));
            CHECK_FALSE(stays(1.01 * first.limit, steps));
            CHECK(lab::stability_limit([&](double dt) { return stays(dt, steps); }, 0.9 * first.limit,
                                       1.1 * first.limit, 2e-3) == Approx(first.limit).epsilon(0.01));
        } else {
            CHECK(method.name == methods::dormand_prince.name);  // has a test of its own, below
        }
    });
}

}  // namespace

TEST_CASE("Chain: every method, without and with drag, breaks where the first of the chain's modes does") {
    const std::size_t masses = 6;
    const double mass = 0.2, stiffness = 50, gap = 0.1, fastest = chain_frequency(masses, mass, stiffness);
    SpringNet net = shaken(chain(masses, mass, {stiffness, gap}, {0, 0, 0}, {gap * 7, 0, 0}));
    net.drag = GENERATE(0., 0.3, 3.) * fastest * mass;
    std::vector<double> frequencies;  // of all waves along the chain: sines, as the fastest is
    for (std::size_t k = 1; k <= masses; ++k)
        frequencies.push_back(2 * std::sqrt(stiffness / mass) *
                              std::sin(static_cast<double>(k) * pi / (2 * (masses + 1.))));
    REQUIRE(frequencies.back() == Approx(fastest).epsilon(1e-14));
    check_every_method(net, frequencies);
}

TEST_CASE("Cloth: every method, without and with drag, breaks where the first of the cloth's modes does") {
    SpringNet net = shaken(cloth(5, 1, 0.5, 30, Weave::with_shear_and_bend));
    const std::vector<double> frequencies = frequencies_of(net);
    REQUIRE(frequencies.back() == Approx(fastest_mode(net, net.start).frequency).epsilon(1e-6));
    net.drag = GENERATE(0., 0.6) * frequencies.back() * net.start.mass[0];
    check_every_method(net, frequencies);
}

TEST_CASE(
    "Chain: Dormand-Prince leaves stability so gently that the energy of the fastest mode has to tell") {
    const SpringNet net = in_fastest_mode(chain(6, 0.2, {50, 0.1}, {0, 0, 0}, {0.7, 0, 0}));
    const double theta = general_limit(StabilityFunction::dormand_prince, 1, 0),
                 limit = theta / chain_frequency(6, 0.2, 50);
    const auto stable = [&](double dt) { return energy_factor(net, methods::dormand_prince, dt, 2000) < 1; };
    CHECK(stable(0.99 * limit));
    CHECK_FALSE(stable(1.01 * limit));
    CHECK(lab::stability_limit(stable, 0.95 * limit, 1.05 * limit, 1e-3) == Approx(limit).epsilon(0.01));
}

TEST_CASE("Cloth of 24 x 24: the endless cloth's fastest wave, the fastest mode and the run agree to 1 %") {
    const double stiffness = 30, mass = 0.5;
    const auto [weave, in_structural_steps] = GENERATE(table<Weave, double>(
        {{Weave::structural, 1}, {Weave::with_shear, 0.707}, {Weave::with_shear_and_bend, 0.629}}));
    const SpringNet net = shaken(cloth(24, 1, mass, stiffness, weave));
    const double each = net.start.mass[0], structural = std::sqrt(each / stiffness);
    const double fastest = cloth_frequency(net.springs.kinds, each);
    CHECK(std::abs(2 / fastest / structural - in_structural_steps) < 5e-4);  // the figures as printed
    CHECK(std::abs(fastest_mode(net, net.start).frequency / fastest - 1) < 0.01);
    check_limit(net, methods::semi_implicit_euler, 2 / fastest);
    check_limit(net, methods::verlet, 2 / fastest);
    check_limit(net, methods::yoshida4, composed_limit(yoshida_weights()) / fastest);
    check_limit(net, methods::kahan_li8, composed_limit(kahan_li_weights()) / fastest);
    check_limit(net, methods::rk4, std::sqrt(8.0) / fastest);
}

TEST_CASE(
    "Chain and cloth: Euler and midpoint are never stable, and the fastest mode grows as one spring does") {
    const double theta = GENERATE(0.05, 0.3, 1.);
    for (const SpringNet& net : {in_fastest_mode(chain(10, 0.2, {50, 0.1}, {0, 0, 0}, {1.1, 0, 0})),
                                 in_fastest_mode(cloth(5, 1, 0.5, 30, Weave::with_shear_and_bend))}) {
        const double dt = theta / fastest_mode(net, net.start).frequency;
        INFO(net.name << ", theta " << theta);
        CHECK(std::abs(energy_factor(net, methods::euler, dt) - (1 + theta * theta)) < 1e-5);
        CHECK(std::abs(energy_factor(net, methods::explicit_midpoint, dt) - (1 + std::pow(theta, 4) / 4)) <
              1e-5);
    }
}

TEST_CASE("Chain and cloth: the implicit methods are stable far beyond every limit") {
    for (const SpringNet& net : {in_fastest_mode(chain(10, 0.2, {50, 0.1}, {0, 0, 0}, {1.1, 0, 0})),
                                 in_fastest_mode(cloth(4, 1, 0.5, 30, Weave::with_shear_and_bend))}) {
        const double theta = 100, dt = theta / fastest_mode(net, net.start).frequency;
        INFO(net.name);
        CHECK(std::abs(energy_factor(net, methods::implicit_euler, dt / 100) - 1 / (1 + 1.0)) < 1e-4);
        CHECK(energy_factor(net, methods::implicit_euler, dt) < 0.5);
        CHECK(std::abs(energy_factor(net, methods::implicit_midpoint, dt) - 1) < 1e-4);
    }
}

TEST_CASE("A hanging cloth: its own fastest mode, linearised at rest, says where Verlet breaks") {
    SpringNet net = cloth(12, 1, 0.2, 40, Weave::with_shear_and_bend);
    net.held = {0, 11}, net.drag = 0.02, net.duration = 60;
    for (std::size_t i = 0; i < net.start.size(); ++i)
        net.start.position.z[i] = 0.01 * std::sin(static_cast<double>(i));
    for (const std::size_t i : net.held) net.start.position.z[i] = 0;
    net.start = lab::run(net, methods::semi_implicit_euler,
                         20000);  // flat it would be pushed together; it folds, and comes to rest
    REQUIRE(fastest_speed(net.start) < 1e-9);
    net.drag = 0;
    for (std::size_t i = 0; i < net.start.size(); ++i) {
        const auto k = static_cast<double>(i);
        if (i != 0 && i != 11)
            net.start.velocity.set(
                i, 1e-9 * Vector3(std::sin(k * k), std::sin(1 + 2 * k * k), std::sin(2 + 3 * k * k)));
    }
    check_limit(net, methods::verlet, 2 / fastest_mode(net, net.start, 5000).frequency);
}
