// Methods and states: every method that kicks and drifts, or knows y' = f(t, y), moves every state from one
// text; a scene holds nothing that a run could change; a method that stands on no list is found.
#include <fstream>
#include <iterator>
#include <nutshell/chain_scenes.hpp>
#include <nutshell/forces_methods.hpp>
#include <nutshell/lab/run.hpp>
#include <regex>
#include <set>
#include "check.hpp"

using namespace nutshell;

namespace {

// One body of 2 kg on a spring with drag, as each of the three states.
constexpr double mass = 2, stiffness = 30, drag = 0.7;  // [kg], [N/m], [kg/s]
const Vector3 place(0.8, -0.3, 0.1), speed(0.2, 0.5, -0.7);

template <class State>
Vector3 velocity_of(const State& body) {
    if constexpr (requires { body.momentum; })
        return velocity(body);
    else
        return body.velocity;
}

template <class State>
struct Spring1 {
    State start;
    double drag = ::drag, duration = 2;
    Vector3 operator()(const State& body, double) const {
        return -stiffness * body.position - drag * velocity_of(body);
    }
};

Spring1<PointMass> as_point_mass() {
    return {{mass, place, speed}};
}
Spring1<Particle> as_particle() {
    return {{mass, place, mass * speed}};
}
AnchoredParticles as_particles() {
    AnchoredParticles scene = anchored_particles(3);
    scene.stiffness = stiffness, scene.drag = drag, scene.g = 0;
    for (std::size_t i = 0; i < 3; ++i)
        scene.anchors.set(i, Vector3::Zero()), scene.start.set(i, {mass, place, speed});
    return scene;
}

std::vector<double> numbers(const Particles& all) {
    const Vector y = flat(all);
    return {y.data(), y.data() + y.size()};
}

/// A chain with drag, hanging aslant.
SpringNet dragged_chain() {
    SpringNet net = chain(8, 0.1, {100, 0.1}, {0, 0, 0}, {0.7, 0.2, 0});
    net.drag = 0.3, net.duration = 0.5;
    return net;
}

}  // namespace

TEST_CASE("Every method moves every state from one text, to the same place but for round-off") {
    each(std::tuple_cat(kick_and_drift_methods, general_methods), [](const auto& method) {
        INFO(method.name);
        const long steps = 200;
        const PointMass body = lab::run(as_point_mass(), method, steps);
        const Particle particle = lab::run(as_particle(), method, steps);
        const Particles particles = lab::run(as_particles(), method, steps);
        CHECK((body.position - place).norm() > 0.1);
        CHECK((particle.position - body.position).norm() < 1e-12);
        CHECK((velocity(particle) - body.velocity).norm() < 1e-12);
        for (std::size_t i = 0; i < particles.size(); ++i) {
            CHECK((particles.position[i] - body.position).norm() < 1e-12);
            CHECK((particles.velocity[i] - body.velocity).norm() < 1e-12);
        }
    });
}

TEST_CASE(
    "Asking a scene for its forces changes nothing: a run that is watched has the bits of one that is not") {
    const SpringNet net = dragged_chain();
    each(kick_and_drift_methods, [&](const auto& method) {
        INFO(method.name);
        double most = 0;
        const Particles watched = lab::run(net, method, 100, [&](const Particles& all, double t) {
            most = std::max(most, net(all, t)[3].norm());
        });
        CHECK(most > 0);
        CHECK(numbers(watched) == numbers(lab::run(net, method, 100)));
    });
}

TEST_CASE("Two runs that take turns on one scene have the bits of runs alone") {
    const SpringNet net = dragged_chain();
    Particles other_start = net.start;
    other_start.velocity.set(4, {0, 0, 3});
    each(kick_and_drift_methods, [&](const auto& method) {
        INFO(method.name);
        const double dt = 0.005;
        const auto alone = [&](Particles all) {
            auto step = method.start(net);
            for (int n = 0; n < 100; ++n) all = step(std::move(all), net, n * dt, dt);
            return numbers(all);
        };
        Particles a = net.start, b = other_start;
        auto step_a = method.start(net), step_b = method.start(net);
        for (int n = 0; n < 100; ++n) {
            a = step_a(std::move(a), net, n * dt, dt);
            b = step_b(std::move(b), net, n * dt, dt);
        }
        CHECK(numbers(a) == alone(net.start));
        CHECK(numbers(b) == alone(other_start));
        CHECK(numbers(a) != numbers(b));
    });
}

TEST_CASE(
    "A method that a header names stands on the list that the order tests go through, under its one name") {
    std::set<std::string> in_headers, on_lists, with_order_test;
    for (const char* header : {"/chapters/01_newton/nutshell/newton_methods.hpp",
                               "/chapters/03_forces/nutshell/forces_methods.hpp"}) {
        std::ifstream file(std::string(PROJECT_DIR) + header);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        const std::regex value("inline constexpr Method (\\w+)\\{\\s*\"([^\"]+)\"");
        for (std::sregex_iterator at(text.begin(), text.end(), value), end; at != end; ++at)
            CHECK(in_headers.insert((*at)[2]).second);  // no name twice
    }
    each(forces_methods, [&](const auto& method) { on_lists.insert(method.name); });
    CHECK(in_headers == on_lists);
    each(std::tuple_cat(kick_and_drift_methods, general_methods),
         [&](const auto& method) { with_order_test.insert(method.name); });
    for (const auto* own_test : {methods::exact_propagator.name, methods::logarithmic_leapfrog.name,
                                 methods::logarithmic_leapfrog8.name})
        with_order_test.insert(own_test);
    CHECK(on_lists == with_order_test);
}

TEST_CASE("A method's evaluations are those it says, after its first step") {
    const Spring1<PointMass> scene = as_point_mass();
    each(std::tuple_cat(kick_and_drift_methods, general_methods), [&](const auto& method) {
        INFO(method.name);
        if (method.evaluations == as_needed) return;
        long count = 0;
        const auto counted = lab::Counted(scene, count);
        auto step = method.start(counted);
        PointMass body = step(scene.start, counted, 0.0, 0.01);
        const long first = count;
        for (int n = 1; n <= 10; ++n) body = step(body, counted, n * 0.01, 0.01);
        CHECK(count - first == 10 * method.evaluations);
    });
}
