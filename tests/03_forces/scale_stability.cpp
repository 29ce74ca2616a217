// How large a step a chain and a cloth bear: by formula, by the fastest mode, and by running the method; 1 %
// apart at most, stable at 0.99 of the limit and unstable at 1.01.
#include <nutshell/compositions.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/runge_kutta.hpp>
#include <nutshell/spring_limits.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

struct SemiImplicit {
    template <class State, class Forces>
    State operator()(State state, const Forces& forces, double t, double dt) const {
        return semi_implicit_euler(std::move(state), forces, t, dt);
    }
};
struct RungeKutta4 {
    template <class Flat, class Flow>
    Flat operator()(Flat y, const Flow& flow, double t, double dt) const {
        return rk4(std::move(y), flow, t, dt);
    }
};

/// The net as a flow y' = f(t, y) for RK4.
struct NetFlow {
    SpringNet net;
    Vector start = flat(net.start);
    explicit NetFlow(const SpringNet& of) : net(of) {}
    Vector operator()(const Vector& y, double t) const {
        const Particles all = unflat(y, net.start);
        return rate(all, net(all, t));
    }
};

/// Yoshida's limit on one spring, from the matrices of its verbs: the step's determinant is 1, so it is
/// stable while its trace is between -2 and 2.
double yoshida_limit() {
    const auto trace = [](double theta) {
        Eigen::Matrix2d step = Eigen::Matrix2d::Identity();
        for (const double w : yoshida_weights()) {
            const Eigen::Matrix2d kick{{1, 0}, {-w * theta / 2, 1}}, drift{{1, w * theta}, {0, 1}};
            step = kick * drift * kick * step;
        }
        return step.trace();
    };
    double theta = 0.1;
    while (std::abs(trace(theta)) <= 2) theta += 1e-5;
    return theta;
}

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
    const double mass = 0.2, stiffness = 50, gap = 0.1, theta4 = yoshida_limit();
    CHECK(std::abs(theta4 - 1.5734) < 1e-4);
    for (const bool free : {false, true})
        for (const std::size_t masses : std::vector<std::size_t>{1, 2, 5, 24}) {
            const double links = static_cast<double>(masses) + (free ? 0 : 1);
            const SpringNet net =
                shaken(chain(masses, mass, {stiffness, gap}, {0, 0, 0}, {gap * links, 0, 0}, free));
            const double fastest = chain_frequency(masses, mass, stiffness, free);
            INFO(masses << " masses, one end free: " << free << ", fastest " << fastest << " rad/s");
            CHECK(std::abs(fastest_mode(net, net.start).frequency / fastest - 1) < 1e-6);
            check_limit(net, SemiImplicit{}, 2 / fastest);
            check_limit(net, VerletFsal<ForceArrays>{}, 2 / fastest);
            check_limit(net, yoshida4<ForceArrays>(), theta4 / fastest);
            check_limit(NetFlow(net), RungeKutta4{}, std::sqrt(8.0) / fastest);
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
    check_limit(net, SemiImplicit{}, 2 / fastest);
    check_limit(net, VerletFsal<ForceArrays>{}, 2 / fastest);
    check_limit(net, yoshida4<ForceArrays>(), yoshida_limit() / fastest);
    check_limit(NetFlow(net), RungeKutta4{}, std::sqrt(8.0) / fastest);
}

TEST_CASE("A hanging cloth: its own fastest mode, linearised at rest, says where Verlet breaks") {
    SpringNet net = cloth(12, 1, 0.2, 40, Weave::with_shear_and_bend);
    net.held = {0, 11}, net.drag = 0.02, net.duration = 60;
    for (std::size_t i = 0; i < net.start.size(); ++i)
        net.start.position.z[i] = 0.01 * std::sin(static_cast<double>(i));
    for (const std::size_t i : net.held) net.start.position.z[i] = 0;
    net.start = lab::run(net, SemiImplicit{},
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
