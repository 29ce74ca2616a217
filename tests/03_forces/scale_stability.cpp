// How large a step a chain and a cloth bear: by formula, by the fastest mode, and by running the method; 1 %
// apart at most, stable at 0.99 of the limit and unstable at 1.01.
#include <nutshell/forces_methods.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/spring_limits.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

/// A small shift of every particle in the plane of the net, that has a little of every mode.
SpringNet shaken(SpringNet net) {
    net.g = 0;
    std::size_t next = 0;
    for (std::size_t i = 0; i < net.start.size(); ++i) {
        if (next < net.held.size() && net.held[next] == i) {
            ++next;
            continue;
        }
        const auto k = static_cast<double>(i);
        const bool plane = net.springs.rows > 1;
        net.start.velocity.set(
            i, 1e-9 * Vector3(std::sin(1 + 7 * k * k), plane ? std::sin(2 + 5 * k * k) : 0, 0));
    }
    return net;
}

double fastest_speed(const Particles& all) {
    double most = 0;
    for (std::size_t i = 0; i < all.size(); ++i) most = std::max(most, all.velocity[i].norm());
    return most;
}
double fastest_speed(const Vector& y) {
    return y.tail(y.size() / 2).lpNorm<Eigen::Infinity>();
}

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
            check_limit(net, semi_implicit_euler_method, 2 / fastest);
            check_limit(net, VerletFsal<ForceArrays>{}, 2 / fastest);
            check_limit(net, yoshida4<ForceArrays>(), theta4 / fastest);
            check_limit(net, kahan_li8<ForceArrays>(), composed_limit(kahan_li_weights()) / fastest);
            check_limit(NetFlow(net), rk4_method, std::sqrt(8.0) / fastest);
        }
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
    check_limit(net, semi_implicit_euler_method, 2 / fastest);
    check_limit(net, VerletFsal<ForceArrays>{}, 2 / fastest);
    check_limit(net, yoshida4<ForceArrays>(), composed_limit(yoshida_weights()) / fastest);
    check_limit(net, kahan_li8<ForceArrays>(), composed_limit(kahan_li_weights()) / fastest);
    check_limit(NetFlow(net), rk4_method, std::sqrt(8.0) / fastest);
}

namespace {

/// A net at rest whose particles move in its fastest mode, a little.
SpringNet in_fastest_mode(SpringNet net, double speed = 1e-7) {
    net.g = 0;
    const Mode mode = fastest_mode(net, net.start);
    for (std::size_t i = 0; i < net.start.size(); ++i) net.start.velocity.set(i, speed * mode.shape[i]);
    return net;
}

/// What a step multiplies the energy by: the twentieth root of what twenty steps do.
template <class Method>
double energy_factor(const SpringNet& net, const Method& method, double dt) {
    const NetFlow flow(net);
    Vector y = flow.start;
    for (int n = 0; n < 20; ++n) y = method(y, flow, n * dt, dt);
    return std::pow(net.energy(unflat(y, net.start)) / net.energy(net.start), 1.0 / 20);
}

}  // namespace

TEST_CASE(
    "Chain and cloth: Euler and midpoint are never stable, and the fastest mode grows as one spring does") {
    const double theta = GENERATE(0.05, 0.3, 1.);
    for (const SpringNet& net : {in_fastest_mode(chain(10, 0.2, {50, 0.1}, {0, 0, 0}, {1.1, 0, 0})),
                                 in_fastest_mode(cloth(5, 1, 0.5, 30, Weave::with_shear_and_bend))}) {
        const double dt = theta / fastest_mode(net, net.start).frequency;
        const auto euler_flow = [](const Vector& y, const NetFlow& flow, double t, double step) {
            return Vector(y + step * flow(y, t));
        };
        INFO(net.name << ", theta " << theta);
        CHECK(std::abs(energy_factor(net, euler_flow, dt) - (1 + theta * theta)) < 1e-5);
        CHECK(std::abs(energy_factor(net, explicit_midpoint_method, dt) - (1 + std::pow(theta, 4) / 4)) <
              1e-5);
    }
}

TEST_CASE("Chain and cloth: the implicit methods are stable far beyond every limit") {
    for (const SpringNet& net : {in_fastest_mode(chain(10, 0.2, {50, 0.1}, {0, 0, 0}, {1.1, 0, 0})),
                                 in_fastest_mode(cloth(4, 1, 0.5, 30, Weave::with_shear_and_bend))}) {
        const double theta = 100, dt = theta / fastest_mode(net, net.start).frequency;
        INFO(net.name);
        CHECK(std::abs(energy_factor(net, implicit_euler_method, dt / 100) - 1 / (1 + 1.0)) < 1e-4);
        CHECK(energy_factor(net, implicit_euler_method, dt) < 0.5);
        CHECK(std::abs(energy_factor(net, implicit_midpoint_method, dt) - 1) < 1e-4);
    }
}

TEST_CASE("A hanging cloth: its own fastest mode, linearised at rest, says where Verlet breaks") {
    SpringNet net = cloth(12, 1, 0.2, 40, Weave::with_shear_and_bend);
    net.held = {0, 11}, net.drag = 0.02, net.duration = 60;
    for (std::size_t i = 0; i < net.start.size(); ++i)
        net.start.position.z[i] = 0.01 * std::sin(static_cast<double>(i));
    for (const std::size_t i : net.held) net.start.position.z[i] = 0;
    net.start = lab::run(net, semi_implicit_euler_method,
                         20000);  // flat it would be pushed together; it folds, and comes to rest
    REQUIRE(fastest_speed(net.start) < 1e-9);
    net.drag = 0;
    for (std::size_t i = 0; i < net.start.size(); ++i) {
        const auto k = static_cast<double>(i);
        if (i != 0 && i != 11)
            net.start.velocity.set(
                i, 1e-9 * Vector3(std::sin(k * k), std::sin(1 + 2 * k * k), std::sin(2 + 3 * k * k)));
    }
    check_limit(net, VerletFsal<ForceArrays>{}, 2 / fastest_mode(net, net.start, 5000).frequency);
}
