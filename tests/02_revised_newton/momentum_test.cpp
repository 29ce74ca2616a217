// Chapter 2: momentum as the state; superposition; the verbs' contracts.
#include <algorithm>
#include "check.hpp"
#include "near.hpp"

using namespace nutshell;

TEST_CASE("the same throw in momentum: bit for bit where the mass is a power of two", "[throw]") {
    const double mass = GENERATE(0.25, 1.0, 2.0, 1024.0);
    MomentumThrow scene = MomentumThrow::of_mass(mass);
    each(newton_methods, [&](const auto& method) {
        INFO(method.name << ", mass " << mass);
        const PointMass in_velocity = lab::run(scene.ball, method, 180);
        const Particle body = lab::run(scene, method, 180);
        CHECK(body.position == in_velocity.position);
        CHECK(velocity(body) == in_velocity.velocity);
    });
}

TEST_CASE("the same throw in momentum: to round-off for any mass", "[throw]") {
    const double mass = GENERATE(0.3, 7.0, 1e-5, 6e24);
    const long steps = 180;
    MomentumThrow scene = MomentumThrow::of_mass(mass);
    each(newton_methods, [&](const auto& method) {
        INFO(method.name << ", mass " << mass);
        const PointMass in_velocity = lab::run(scene.ball, method, steps);
        const Particle body = lab::run(scene, method, steps);
        // A step rounds the velocity a few times by at most epsilon/2 of its size; the drift adds that up
        // over T.
        const double fastest = 25, bound = 4 * epsilon * steps * fastest;
        CHECK((velocity(body) - in_velocity.velocity).norm() <= bound);
        CHECK((body.position - in_velocity.position).norm() <= bound * scene.duration);
    });
}

TEST_CASE("the throw in momentum obeys chapter 1's error law", "[throw]") {
    const MomentumThrow scene = MomentumThrow::of_mass(3);
    const long steps = 90;
    const double dt = scene.duration / steps, T = scene.duration;
    const auto off = [&](auto method) -> Vector3 {
        return lab::run(scene, method, steps).position - scene.exact(T).position;
    };
    const double bound = 4 * epsilon * steps * 25 * T;
    CHECK((off(methods::euler) - throw_error(Kicked::after_drift, gravity, T, dt)).norm() <= bound);
    CHECK((off(methods::semi_implicit_euler) - throw_error(Kicked::before_drift, gravity, T, dt)).norm() <=
          bound);
    CHECK((off(methods::verlet) - throw_error(Kicked::half_and_half, gravity, T, dt)).norm() <= bound);
}

TEST_CASE("many forces are one force: the order of the list changes nothing beyond round-off",
          "[superposition]") {
    ManyForces scene;
    const long steps = 240;
    double sum_of_sizes = scene.shake.norm();
    for (const Vector3& rope : scene.ropes) sum_of_sizes += rope.norm();
    // Five terms, four roundings of at most epsilon/2 of the sum of sizes, in either order; and each step of
    // either run rounds its own momentum once and its position twice.
    const double force_bound = 4 * epsilon * sum_of_sizes, T = scene.duration;
    const double momentum_bound = force_bound * T + epsilon * steps * 60;
    const double position_bound = momentum_bound / scene.start.mass * T + 2 * epsilon * steps * 10;
    const Particle first = lab::run(scene, methods::verlet, steps);
    const Vector3 first_force = scene(scene.start, 0.3);
    int orders = 0;
    double largest = 0;
    do {
        ++orders;
        const Particle other = lab::run(scene, methods::verlet, steps);
        CHECK((scene(scene.start, 0.3) - first_force).norm() <= force_bound);
        CHECK((other.momentum - first.momentum).norm() <= momentum_bound);
        CHECK((other.position - first.position).norm() <= position_bound);
        largest = std::max(largest, (other.position - first.position).norm());
    } while (std::next_permutation(scene.order.begin(), scene.order.end()));
    CHECK(orders == 120);
    CHECK(largest > 0);  // the orders do differ in their last bits: the test is not empty
}

TEST_CASE("forces that depend on time only: the motions add as the forces do", "[superposition]") {
    const ManyForces scene;
    const long steps = 600;
    struct Alone {
        ManyForces all;
        std::size_t i;
        Particle start = all.start;
        double duration = all.duration;
        Vector3 operator()(const Particle&, double t) const { return all.force(i, t); }
    };
    Vector3 sum = Vector3::Zero();
    double sum_of_paths = 0;
    for (std::size_t i = 0; i < 5; ++i) {
        const Vector3 path = lab::run(Alone{scene, i}, methods::verlet, steps).position;
        sum += path, sum_of_paths += path.norm();
    }
    const Particle together = lab::run(scene, methods::verlet, steps);
    CHECK((together.position - sum).norm() <= epsilon * steps * sum_of_paths);
}

TEST_CASE("many forces: exact solution and orders", "[superposition]") {
    const ManyForces scene;
    // exact: its second difference is the force; h = 1e-3 leaves h^2/12 of the fourth derivative and
    // round-off/h^2
    const double h = 1e-3, t = 2.35;
    const Vector3 a =
        (scene.exact(t + h).position - 2 * scene.exact(t).position + scene.exact(t - h).position) / (h * h);
    const double shake_a = scene.shake.norm() / scene.start.mass, w = scene.shake_rate;
    CHECK((a - scene(scene.start, t) / scene.start.mass).norm() <=
          1.1 * h * h / 12 * shake_a * w * w + 4e-16 * 40 / (h * h));
    CHECK((scene.exact(0).position - scene.start.position).norm() == 0);

    CHECK_THAT(convergence(scene, methods::euler, {1200, 2400, 4800, 9600}), HasOrder(1));
    CHECK_THAT(convergence(scene, methods::semi_implicit_euler, {1200, 2400, 4800, 9600}), HasOrder(1));
    CHECK_THAT(convergence(scene, methods::verlet, {120, 240, 480, 960}), HasOrder(2));
}

TEST_CASE("total_force: none, one, and a list of any kind", "[superposition]") {
    CHECK(total_force({}) == Vector3::Zero());
    const std::vector<Vector3> two{{1, 2, 3}, {10, 20, 30}};
    CHECK(total_force(two) == Vector3(11, 22, 33));
    CHECK(total_force(std::span(two).first(1)) == two[0]);
}

TEST_CASE("contracts of chapter 2", "[contracts]") {
    Particle body{2, {0, 0, 0}, {4, 0, 0}};
    CHECK_NOTHROW(checked(body));
    CHECK_THROWS_WITH(checked(Particle{0, Vector3::Zero(), Vector3::Zero()}),
                      ContainsSubstring("mass of a particle"));
    CHECK_THROWS_WITH(checked(Particle{1, Vector3::Zero(), {NAN, 0, 0}}), ContainsSubstring("momentum"));
    CHECK_THROWS_WITH(checked(Particle{1, {INFINITY, 0, 0}, Vector3::Zero()}), ContainsSubstring("position"));
    CHECK_THROWS_WITH(exchange(body, -2, Vector3::Zero()), ContainsSubstring("mass left"));
    CHECK(body.mass == 2);  // a refused exchange changes nothing
    CHECK(body.momentum == Vector3(4, 0, 0));
    CHECK_THROWS_AS(midway(1, -1, Vector3::Zero()), std::invalid_argument);
    CHECK_THROWS_AS(acceleration(Vector3::Zero(), 0, Vector3::Zero(), 1), std::invalid_argument);
    CHECK_THROWS_AS(rocket_gain(1, 0, 1), std::invalid_argument);
    CHECK_THROWS_AS(rocket_gain(1, 1, -1), std::invalid_argument);
    CHECK_THROWS_AS(propellant_for(1, 0, 1), std::invalid_argument);
    CHECK_THROWS_AS(propellant_for(1, 1, NAN), std::invalid_argument);
    // a rocket burnt past empty says so instead of flying on with a negative mass
    Rocket rocket;
    rocket.duration = 30;
    CHECK_THROWS_WITH(lab::run(rocket, methods::euler, 60), ContainsSubstring("mass left"));
}
