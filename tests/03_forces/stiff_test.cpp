// Steps for stiff nets: what implicit Euler and position-based dynamics keep, and what they lose.
#include <nutshell/forces_methods.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/spring_limits.hpp>
#include <nutshell/stiff_steps.hpp>

#include "check.hpp"

using namespace nutshell;

namespace {

/// One mass between two springs of rest length zero, no gravity: linear, omega^2 = 2 kappa/m.
SpringNet one_mass(double stiffness, double mass) {
    SpringNet net = chain(1, mass, {stiffness, 0}, {-1, 0, 0}, {1, 0, 0});
    net.g = 0;
    net.start.position.set(1, {0, 0.3, 0});
    return net;
}

double hangs(const SpringNet& net, PositionBased step, double dt) {
    Particles all = net.start;
    for (long i = std::lround(20 / dt); i > 0; --i) all = step(std::move(all), net, 0.0, dt);
    return -*std::min_element(all.position.y.begin(), all.position.y.end());
}

}  // namespace

TEST_CASE(
    "linearised implicit Euler on linear springs is implicit Euler: energy times 1/(1 + theta^2) a step") {
    for (const double theta : {0.1, 1.0, 30.0}) {
        const double mass = 0.7, stiffness = 50, dt = theta / std::sqrt(2 * stiffness / mass);
        const SpringNet net = one_mass(stiffness, mass);
        const double rest = net.energy([&] {
            Particles middle = net.start;
            middle.position.set(1, Vector3::Zero());
            return middle;
        }());
        LinearImplicitEuler step;
        Particles all = net.start;
        for (int i = 0; i < 3; ++i) {
            const double before = net.energy(all) - rest;
            all = step(std::move(all), net, 0.0, dt);
            // energies are differences of numbers of the size of `rest`
            CHECK(std::abs((net.energy(all) - rest) - before / (1 + theta * theta)) < 1e-12 * rest);
        }
    }
}

TEST_CASE("linearised implicit Euler comes to the true motion of a chain at first order") {
    SpringNet net = chain(4, 0.1, {40, 0.2}, {0, 0, 0}, {0.9, 0, 0});
    net.drag = 0.05;
    const double time = 0.5;
    const Particles truth = lab::run(
        [&] {
            SpringNet run = net;
            run.duration = time;
            return run;
        }(),
        methods::exponential_verlet, 40000);
    std::vector<double> dts, errors;
    for (const long steps : {2000, 4000, 8000}) {
        LinearImplicitEuler step;
        Particles all = net.start;
        const double dt = time / static_cast<double>(steps);
        for (long i = 0; i < steps; ++i) all = step(std::move(all), net, 0.0, dt);
        double worst = 0;
        for (std::size_t i = 0; i < all.size(); ++i)
            worst = std::max(worst, (all.position[i] - truth.position[i]).norm());
        dts.push_back(dt), errors.push_back(worst);
    }
    CHECK(std::abs(lab::observed_order(dts, errors) - 1) < 0.05);
}

TEST_CASE("implicit Euler and position-based dynamics hold a cloth at forty times Verlet's limit") {
    SpringNet net = cloth(8, 1, 0.2, 500, Weave::with_shear);
    for (std::size_t i = 0; i < 8; ++i) net.held.push_back(i);
    for (std::size_t i = 8; i < 64; ++i)  // folds, so that springs are pressed together too
        net.start.position.z[i] = 0.05 * std::sin(3.0 * static_cast<double>(i));
    const double dt = 40 * 2 / fastest_mode(net, net.start).frequency;
    const auto farthest = [&](auto step) {
        Particles all = net.start;
        double most = 0;
        for (int i = 0; i < 300; ++i) {
            all = step(std::move(all), net, 0.0, dt);
            for (std::size_t k = 0; k < all.size(); ++k) {
                const double from = all.position[k].norm();
                most = from > most || !std::isfinite(from) ? from : most;
            }
        }
        return most;
    };
    CHECK(farthest(LinearImplicitEuler{}) < 3);  // nothing is farther than twice the cloth's diagonal
    CHECK(farthest(PositionBased{20}) < 3);
    CHECK_FALSE(farthest(methods::verlet.start(net)) < 1e6);
}

TEST_CASE(
    "implicit Euler comes to rest where the springs do, position-based dynamics where its iterations end") {
    SpringNet net = chain(6, 0.1, {60, 0.2}, {0, 0, 0}, {0, -1.4, 0}, true);
    net.start = chain(6, 0.1, {60, 0.2}, {0, 0, 0}, {0, -1.2, 0}, true).start;
    net.drag = 0.3;
    // link k carries the masses below it: its stretch is (6 - k) m g / kappa
    const double exact = 1.2 + (6 + 5 + 4 + 3 + 2 + 1) * 0.1 * net.g / 60;
    LinearImplicitEuler step;
    Particles all = net.start;
    for (int i = 0; i < 3000; ++i) all = step(std::move(all), net, 0.0, 1.0 / 60);
    CHECK(std::abs(-all.position.y[6] - exact) < 1e-9);

    const double few = hangs(net, PositionBased{4}, 1.0 / 60), many = hangs(net, PositionBased{16}, 1.0 / 60),
                 finer = hangs(net, PositionBased{4}, 1.0 / 240);
    CHECK(few > many + 1e-4);   // more iterations: a stiffer chain
    CHECK(few > finer + 1e-4);  // smaller steps too
    CHECK(many > 1.2);
    SpringNet stiffer = net;  // ...and the springs' own stiffness is not asked
    for (auto& kind : stiffer.springs.kinds) kind.spring.stiffness *= 100;
    CHECK(hangs(stiffer, PositionBased{4}, 1.0 / 60) == few);
}
