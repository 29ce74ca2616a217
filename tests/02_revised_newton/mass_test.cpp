// Chapter 2: mass that comes and goes. When K = m v with a changing mass may be used, and when not (E05).
#include <random>
#include "check.hpp"
#include "near.hpp"

using namespace nutshell;

TEST_CASE("an exchange keeps the momentum of body and parcel, whatever its speed", "[exchange]") {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto vector = [&](double size) {
        return Vector3(size * number(random), size * number(random), size * number(random));
    };
    for (int i = 0; i < 1000; ++i) {
        const Particle before{2 + number(random), vector(5), vector(20)};
        const Vector3 w = vector(100);
        Particle body = before;
        const double lost = before.mass * 0.45 * (1 + number(random));
        const Particle parcel = eject(body, lost, w);
        // one rounding of a momentum each way
        CHECK((body.momentum + parcel.momentum - before.momentum).norm() <=
              2 * epsilon * (before.momentum.norm() + parcel.momentum.norm()));
        CHECK(body.mass + parcel.mass == near(before.mass, epsilon * before.mass));
        CHECK((velocity(parcel) - velocity(before) - w).norm() <=
              4 * epsilon * (w.norm() + velocity(before).norm()));
        CHECK(body.position == before.position);
        // the exchange undone: the parcel comes back at the velocity at which it left
        exchange(body, parcel.mass, velocity(parcel) - velocity(body));
        CHECK((body.momentum - before.momentum).norm() <=
              16 * epsilon * (before.momentum.norm() + before.mass * (w.norm() + velocity(before).norm())) *
                  before.mass / (before.mass - lost));
    }
}

TEST_CASE("the limit of small exchanges is m a = F + w dm/dt, at first order", "[exchange]") {
    const Particle start{3, {0, 0, 0}, {6, -3, 1}};
    const Vector3 w{-7, 2, 5}, force{1, 4, -2};
    const double rate = -0.4;
    Convergence c;
    for (double dt = 1e-2; dt > 1e-3; dt /= 2) {
        Particle body = start;
        exchange(body, rate * dt, w);
        kick(body, force, dt);
        const Vector3 a = (velocity(body) - velocity(start)) / dt;
        c.dt.push_back(dt), c.error.push_back((a - acceleration(force, start.mass, w, rate)).norm());
    }
    CHECK_THAT(c, HasOrder(1));
}

TEST_CASE("leaky cart: the truth is constant speed, at any step", "[cart]") {
    const LeakyCart cart;
    for (const long steps : {1L, 7L, 600L})
        each(newton_methods, [&](const auto& method) {
            INFO(method.name << ", " << steps << " steps");
            const VariableMass end = lab::run(cart, method, steps);
            CHECK(end.mass == near(1, epsilon * 2 * static_cast<double>(steps)));
            // a step rounds the momentum twice, the position four times
            CHECK(velocity(end).x() == near(10, 4 * epsilon * 10 * static_cast<double>(steps + 1)));
            CHECK(cart.error(end, cart.duration) <= 4 * epsilon * 100 * static_cast<double>(steps + 1));
        });
}

TEST_CASE("E05: eqs. 11-15 read with K = m v speed the leaky cart up from 10 to 20 m/s", "[cart][erratum]") {
    const LeakyCart printed = LeakyCart::as_printed();
    each(newton_methods, [&](const auto& method) {
        INFO(method.name);
        const VariableMass end = lab::run(printed, method, 1000);
        CHECK(end.momentum == printed.start.momentum);  // "F = 0, so K is constant"
        CHECK(velocity(end).x() == near(20, 1e-11));
    });
    // and it goes 200 ln 2 m instead of 100 m: position by the trapezium rule for 1/m, error <= dt^2/12 T
    // max|v''|
    const double dt = 0.01, bound = dt * dt / 12 * 10 * (20 * 2 * 0.01 * 1.01);
    CHECK(lab::run(printed, methods::euler, 1000).position.x() == near(200 * std::log(2), bound));
}

TEST_CASE("E05: the truth is the same for every observer, the printed reading is not", "[cart][erratum]") {
    const Vector3 frame{10, 0, 0};                         // moves along with the cart
    const auto final_speed = [&](const LeakyCart& cart) {  // as told by the observer on the ground
        return velocity(lab::run(cart.seen_from(frame), methods::euler, 1000)).x() + frame.x();
    };
    CHECK(final_speed(LeakyCart{}) == 10.0);
    CHECK(final_speed(LeakyCart::as_printed()) == 10.0);  // beside 20.0 when the ground does its own sums
    const LeakyCart slower = LeakyCart::as_printed().seen_from({4, 0, 0});
    CHECK(velocity(lab::run(slower, methods::euler, 1000)).x() + 4 ==
          near(16, 1e-11));  // any speed is on offer
    const LeakyCart truth = LeakyCart{}.seen_from({4, 0, 0});
    CHECK(velocity(lab::run(truth, methods::euler, 1000)).x() + 4 == near(10, 1e-11));
}

TEST_CASE("E05: the printed reading is a rocket whose exhaust is as fast as itself", "[cart][erratum]") {
    // What leaves is left at rest in the world: relative to the cart it goes backwards at the cart's own
    // speed.
    VariableMass cart = LeakyCart::as_printed().start;
    const Vector3 v = velocity(cart);
    CHECK(relative_velocity(cart.flow, cart, -0.1) == -v);
    const Particle sand = eject(cart, 0.1, relative_velocity(cart.flow, cart, -0.1));
    CHECK(sand.momentum == Vector3::Zero());
    CHECK(cart.momentum + sand.momentum ==
          LeakyCart::as_printed().start.momentum);  // these books balance, too
    const Vector3 a = acceleration(Vector3::Zero(), 2, -v, -0.1);
    CHECK(a.x() == near(0.5, 2 * epsilon));                                             // a thrust of 1 N
    CHECK(acceleration(Vector3::Zero(), 2, Vector3::Zero(), -0.1) == Vector3::Zero());  // the leak: none
}

TEST_CASE("raindrop: momentum by the printed equations, to round-off of its sums", "[raindrop]") {
    const Raindrop drop;
    const long steps = GENERATE(1L, 40L, 1000L);
    const double T = drop.duration, dt = T / static_cast<double>(steps);
    const double bound = 4 * epsilon * static_cast<double>(steps + 1) * drop.exact(T).momentum.norm();
    const Vector3 euler_K = drop.start.momentum + gravity * (drop.m0 * T + drop.beta * T * (T - dt) / 2);
    const Vector3 half_kick_K = drop.start.momentum + gravity * (drop.m0 * T + drop.beta * T * T / 2);
    CHECK((lab::run(drop, methods::euler, steps).momentum - euler_K).norm() <= bound);
    CHECK((lab::run(drop, methods::semi_implicit_euler, steps).momentum - euler_K).norm() <= bound);
    CHECK((lab::run(drop, methods::verlet, steps).momentum - half_kick_K).norm() <= bound);
    CHECK((euler_K - half_kick_K).norm() > 10 * bound);  // the two are not the same number

    // eqs. (12), (13), (15) as printed, by hand, with the mass of the moment
    Vector3 K = drop.start.momentum;
    double m = drop.m0;
    for (long n = 0; n < steps; ++n) {
        K += m * gravity * dt;
        m += drop.beta * dt;
    }
    CHECK(K == lab::run(drop, methods::euler, steps).momentum);
}

TEST_CASE("raindrop: position at its order, and sideways it slows as 1/m", "[raindrop]") {
    const Raindrop drop;
    CHECK_THAT(convergence(drop, methods::euler, {200, 400, 800, 1600}), HasOrder(1));
    CHECK_THAT(convergence(drop, methods::semi_implicit_euler, {200, 400, 800, 1600}), HasOrder(1));
    CHECK_THAT(convergence(drop, methods::verlet, {50, 100, 200, 400}), HasOrder(2));
    const VariableMass end = lab::run(drop, methods::verlet, 100);
    CHECK(end.momentum.x() == drop.start.momentum.x());
    CHECK(velocity(end).x() == near(3.0 / 5, 1e-13));
    // read with K constant per mass instead (w = 0): what arrives would bring the drop's own velocity, a free
    // fall
    Raindrop moving = drop;
    moving.start.flow.relative_to = RelativeTo::body;
    const VariableMass fallen = lab::run(moving, methods::verlet, 100);
    CHECK((velocity(fallen) - (Vector3(3, 0, 0) + gravity * 4)).norm() <= 1e-12);
}

TEST_CASE("raindrop: the exact position is the integral of the exact velocity", "[raindrop][exact]") {
    const Raindrop drop;
    const auto v = [&](double t) -> Vector3 { return velocity(drop.exact(t)); };
    CHECK((drop.exact(4).position - drop.start.position - simpson(v, 4, 4000)).norm() <= 1e-11);
    CHECK((drop.exact(1e-6).position - drop.start.position - v(0) * 1e-6).norm() <= 1e-11);
    // long after the start the drop falls with half of g
    const Vector3 late = (velocity(drop.exact(1000)) - velocity(drop.exact(999)));
    CHECK(late.y() == near(gravity.y() / 2, 1e-4));
}
