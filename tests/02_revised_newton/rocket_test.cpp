// Chapter 2: the rocket, its exhaust, and the books of momentum.
#include "check.hpp"
#include "near.hpp"

using namespace nutshell;

TEST_CASE("Tsiolkovsky's formula is the limit of many parcels: first order, midway second", "[rocket]") {
    const Rocket rocket;
    each(newton_methods, [&](const auto& method) {
        INFO(method.name);
        CHECK_THAT(convergence(rocket, method, {60, 120, 240, 480}), HasOrder(1));
        CHECK_THAT(convergence(Rocket::with_midway(rocket), method, {60, 120, 240, 480}), HasOrder(2));
    });
}

TEST_CASE("N parcels give exactly u times the sum of parcel over what is left", "[rocket]") {
    const long n = 30;
    const Rocket rocket;
    const double parcel = 7.5 / n, u = 100;
    double sum = 0, midway_sum = 0;
    for (long k = 1; k <= n; ++k) {
        sum += parcel / (10 - static_cast<double>(k) * parcel);
        midway_sum += parcel / (10 - (static_cast<double>(k) - 0.5) * parcel);
    }
    const double bound = 8 * epsilon * n * u * 2;
    CHECK(velocity(lab::run(rocket, methods::euler, n)).x() == near(u * sum, bound));
    CHECK(velocity(lab::run(Rocket::with_midway(rocket), methods::euler, n)).x() ==
          near(u * midway_sum, bound));
    CHECK(u * sum > rocket_gain(u, 10, 2.5));
    CHECK(u * midway_sum < rocket_gain(u, 10, 2.5));
}

TEST_CASE("rocket plus exhaust: the momentum books balance to round-off, with and without gravity",
          "[rocket][books]") {
    for (const Rocket& flight : {Rocket{}, water_rocket()})
        for (const bool midway_parcels : {false, true})
            for (const long steps : {1L, 30L, 300L})
                each(newton_methods, [&](const auto& method) {
                    INFO(flight.name << ", " << method.name << ", " << steps << " steps, midway "
                                     << midway_parcels);
                    RocketBooks books{midway_parcels ? Rocket::with_midway(flight) : flight};
                    // Every entry is a momentum of at most m0 u (the exhaust's), rounded by epsilon/2; there
                    // is one for each kick of each parcel (or the rocket), and the final sum rounds once per
                    // parcel.
                    const double entries = static_cast<double>(steps + 1) + 2 * static_cast<double>(steps);
                    const double bound =
                        epsilon * entries * flight.start.mass * flight.start.flow.velocity.norm();
                    double worst = 0, exhaust = 0;
                    lab::run(books, method, steps, [&](const RocketAndExhaust& all, double t) {
                        worst = std::max(worst, (total_momentum(all) - books.exact_momentum(t)).norm());
                        exhaust = exhaust_momentum(all).norm();
                        CHECK(total_mass(all) == near(10, 2 * epsilon * 10 * static_cast<double>(steps + 1)));
                    });
                    CHECK(worst <= bound);
                    CHECK(exhaust > 50);  // there was something to balance
                });
}

TEST_CASE("balanced books are no proof of the right speed", "[rocket][books]") {
    const RocketBooks one_shot;
    const RocketAndExhaust end =
        lab::run(one_shot, methods::euler, 1);  // three quarters of the rocket in one parcel
    CHECK(total_momentum(end).norm() <= epsilon * 1000);
    CHECK(velocity(end.rocket).x() == near(300, 1e-12));  // the truth is 138.6
}

TEST_CASE("the centre of mass of rocket and exhaust moves like chapter 1's ball", "[rocket][books]") {
    const RocketBooks books{water_rocket()};
    const long steps = 60;
    const double T = books.duration, dt = T / steps;
    const Vector3 parabola = gravity * T * T / 2;
    const auto off = [&](auto method) -> Vector3 {
        return centre_of_mass(lab::run(books, method, steps)) - parabola;
    };
    // the sum of mass x position has terms up to m0 u T, each rounded once or twice a step
    const double bound = 4 * epsilon * steps * 40 * T;
    CHECK((off(methods::euler) - throw_error(Kicked::after_drift, gravity, T, dt)).norm() <= bound);
    CHECK((off(methods::semi_implicit_euler) - throw_error(Kicked::before_drift, gravity, T, dt)).norm() <=
          bound);
    CHECK((off(methods::verlet) - throw_error(Kicked::half_and_half, gravity, T, dt)).norm() <= bound);
}

TEST_CASE("the rocket with its exhaust is the rocket alone, bit for bit", "[rocket][books]") {
    const Rocket launch = water_rocket();
    each(newton_methods, [&](const auto& method) {
        INFO(method.name);
        const VariableMass alone = lab::run(launch, method, 90);
        const RocketAndExhaust all = lab::run(RocketBooks{launch}, method, 90);
        CHECK(all.rocket.mass == alone.mass);
        CHECK(all.rocket.position == alone.position);
        CHECK(all.rocket.momentum == alone.momentum);
        CHECK(all.exhaust.size() == 90);
    });
}

TEST_CASE("launch: place at its order, and second needs Verlet and midway parcels both", "[rocket]") {
    const Rocket launch = water_rocket();
    const Rocket midway_launch = Rocket::with_midway(launch);
    CHECK_THAT(convergence(launch, methods::euler, {200, 400, 800, 1600}), HasOrder(1));
    CHECK_THAT(convergence(launch, methods::verlet, {200, 400, 800, 1600}), HasOrder(1));
    CHECK_THAT(convergence(midway_launch, methods::euler, {200, 400, 800, 1600}), HasOrder(1));
    CHECK_THAT(convergence(midway_launch, methods::verlet, {50, 100, 200, 400}), HasOrder(2));
}

TEST_CASE("the exact rocket: gain, height, and m a = F + w dm/dt", "[rocket][exact]") {
    const Rocket rocket;
    CHECK(velocity(rocket.exact(15)).x() == near(rocket_gain(100, 10, 2.5), 1e-12));
    CHECK(rocket_gain(100, 10, 2.5) == near(138.62943611198906, 1e-12));

    Rocket up = water_rocket();  // straight up: the curriculum's formulas
    up.start.flow.velocity = {0, -40, 0};
    const double t = 1.2, m = 10 - 5 * t, g = 9.81, log = std::log(10 / m);
    CHECK(velocity(up.exact(t)).y() == near(40 * log - g * t, 1e-13));
    CHECK(up.exact(t).position.y() == near(40 * (t - m / 5 * log) - g * t * t / 2, 1e-13));

    const Rocket launch = water_rocket();
    const auto v = [&](double s) -> Vector3 { return velocity(launch.exact(s)); };
    CHECK((launch.exact(1.5).position - launch.start.position - simpson(v, 1.5, 4000)).norm() <= 1e-11);
    const double h = 1e-5;
    const Vector3 a = (v(t + h) - v(t - h)) / (2 * h);
    const Vector3 law = acceleration(m * gravity, m, launch.start.flow.velocity, launch.start.flow.rate);
    CHECK((a - law).norm() <=
          1e-7);  // h^2/6 of the jerk's rate (about 2500 m/s^4 here), and round-off 1e-15 v/h
}

TEST_CASE("propellant_for undoes rocket_gain", "[rocket]") {
    for (const double m : {9.9, 5.0, 2.5, 0.1}) {
        const double propellant = propellant_for(rocket_gain(100, 10, m), 100, 10);
        CHECK(propellant == near(10 - m, 16 * epsilon * 10));
    }
    CHECK(propellant_for(0, 100, 10) == 0);
}

TEST_CASE("midway parcels leave at w from the mean of the velocities before and after", "[rocket]") {
    const Particle before{10, {0, 0, 0}, {30, -20, 10}};
    const Vector3 w{-100, 5, 40};
    Particle body = before;
    const Particle parcel = eject(body, 3, midway(10, -3, w));
    const Vector3 mean = (velocity(before) + velocity(body)) / 2;
    CHECK((velocity(parcel) - mean - w).norm() <= 8 * epsilon * w.norm());
}
