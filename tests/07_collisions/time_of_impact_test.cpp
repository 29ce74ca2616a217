// Times of impact against fine stepping and closed forms; the bouncing ball by events and by steps.
#include <nutshell/bouncing_methods.hpp>
#include "near.hpp"

using namespace nutshell;

namespace {

/// The first time that `distance(t)` falls through zero, found without the quadratic: by steps and bisection.
template <class Distance>
std::optional<double> by_bisection(const Distance& distance, double until, int steps) {
    for (int i = 0; i < steps; ++i) {
        double from = until * i / steps, to = until * (i + 1) / steps;
        if (!(distance(from) > 0 && distance(to) <= 0)) continue;
        for (int k = 0; k < 80; ++k) {
            const double middle = (from + to) / 2;
            (distance(middle) > 0 ? from : to) = middle;
        }
        return to;
    }
    return {};
}

double distance_to_box(const Vector3& p, const Box& box) {
    return (p - p.cwiseMax(-box.half).cwiseMin(box.half)).norm();
}

template <class Method>
double rms_error(const BouncingBall& scene, const Method& method, double dt) {
    Particle body = scene.start;
    auto step = method.start(scene);
    double sum = 0;
    long n = 0;
    for (; static_cast<double>(n) * dt < 3 - dt / 2; ++n) {
        body = step(body, scene, 0, dt);
        const double error = scene.error(body, static_cast<double>(n + 1) * dt);
        sum += error * error;
    }
    return std::sqrt(sum / static_cast<double>(n));
}

}  // namespace

TEST_CASE("Time of impact: a ball under gravity and a plane, a ball and a ball") {
    Chance chance(3);
    int hits = 0;
    for (int i = 0; i < 300; ++i) {
        const Plane plane{chance.direction(), chance(-1, 1)};
        const Sphere ball{chance(0.1, 1)};
        const Vector3 g = chance.vector(10), v = chance.vector(10);
        const Vector3 p = plane.normal * (plane.offset + ball.radius + chance(0.01, 3)) +
                          plane.normal.cross(chance.vector(3));
        const auto t = time_of_impact(ball, p, v, g, plane);
        const auto found = by_bisection(
            [&](double s) { return distance_to(plane, p + v * s + g * s * s / 2) - ball.radius; }, 20, 4000);
        if (found) {
            REQUIRE(t);
            CHECK(*t == near(*found, 1e-10 * (1 + *found)));
            ++hits;
        }
        if (!found && t) CHECK(*t > 20);
        const auto u = time_of_impact(p, v, 0.4);
        const auto seen = by_bisection([&](double s) { return (p + v * s).norm() - 0.4; }, 5, 4000);
        if (p.norm() > 0.4 && seen) {
            REQUIRE(u);
            CHECK(*u == near(*seen, 1e-9));
        }
    }
    CHECK(hits > 100);
}

TEST_CASE("Time of impact: a ball and a box at rest, on faces, edges and corners") {
    Chance chance(5);
    int faces = 0, edges = 0, corners = 0, misses = 0;
    for (int i = 0; i < 3000; ++i) {
        const Box box{{chance(0.2, 1), chance(0.2, 1), chance(0.2, 1)}};
        const Sphere ball{chance(0.05, 1)};
        Vector3 p = chance.direction() * 4;
        const Vector3 v = (chance.vector(1.5) - p) * chance(0.5, 2);
        const auto t = time_of_impact(ball, p, v, box);
        const auto found =
            by_bisection([&](double s) { return distance_to_box(p + v * s, box) - ball.radius; }, 6, 3000);
        if (!found) {
            if (t)
                CHECK(distance_to_box(p + v * *t, box) == near(ball.radius, 1e-6));  // a graze between looks
            ++misses;
            continue;
        }
        REQUIRE(t);
        CHECK(*t == near(*found, 1e-9));
        p += v * *t;
        const int beyond = static_cast<int>((p.cwiseAbs().array() > box.half.array()).count());
        ++(beyond == 1 ? faces : beyond == 2 ? edges : corners);
    }
    CHECK(faces > 100);
    CHECK(edges > 100);
    CHECK(corners > 30);
    CHECK(misses > 30);
    // along the faces, grazing, starting inside, at rest: no NaN, no hit that is none
    const Box box{{1, 1, 1}};
    CHECK(*time_of_impact(Sphere{0.5}, {0, 3, 0}, {0, -1, 0}, box) == near(1.5, 1e-15));
    CHECK_FALSE(time_of_impact(Sphere{0.5}, {0, 3, 0}, {0, 1, 0}, box));
    CHECK_FALSE(time_of_impact(Sphere{0.5}, {0, 3, 0}, {0, 0, 0}, box));
    CHECK_FALSE(time_of_impact(Sphere{0.5}, {-5, 1.6, 0}, {1, 0, 0}, box));
    CHECK(*time_of_impact(Sphere{0.5}, {0, 1.5, 0}, {1, -1, 0}, box) == 0);
}

TEST_CASE("The bouncing ball by events is exact: height, every bounce, rest (S9)") {
    const BouncingBall scene;
    CHECK(scene.rest_time() == near(8.579, 5e-4));
    double largest = 0;
    for (int i = 0; i <= 1200; ++i) {
        const double t = i * 0.01;
        largest = std::max(largest, scene.error(bounce_by_events(scene, scene.start, t), t));
    }
    CHECK(largest < 1e-9);
    // from state to state, as a game would: round-off of the many restarts only
    Particle body = scene.start;
    double last = 0, path = 0, before = scene.start.position.y();
    long bounces = 0;
    for (int i = 0; i < 720; ++i) {
        body = bounce_by_events(scene, body, 1 / 60.0, [&](double t, const Particle& ball) {
            if (ball.momentum.norm() > 0) last = i / 60.0 + t, ++bounces;
        });
        CHECK(scene.error(body, (i + 1) / 60.0) < 1e-9);
    }
    CHECK(last == near(scene.rest_time(), 1e-9));
    CHECK(bounces > 200);
    CHECK(body.momentum.norm() == 0);
    // the path it has gone: flights of v^2/2g up and down
    bounce_by_events(scene, scene.start, 12, [&](double, const Particle& ball) {
        path += before == scene.start.position.y() ? scene.drop() : 0, before = 0;
        path += ball.momentum.squaredNorm() / scene.g;
    });
    CHECK(path == near(scene.path(), 1e-9));
    BouncingBall half;
    half.restitution = 0.5;
    CHECK(half.rest_time() == near(1.3546, 1e-3));
}

TEST_CASE("Zeno: each tenth of the time that is left has 22 bounces, until the clock stands still") {
    const BouncingBall scene;
    std::vector<double> at;
    bounce_by_events(scene, scene.start, 12, [&](double t, const Particle&) { at.push_back(t); });
    const double fall = std::sqrt(2 / scene.g);
    double sum = fall, flight = 2 * 0.9 * fall;  // by hand: the row of flights, each 0.9 of the last
    for (std::size_t n = 0; n < 100; ++n, sum += flight, flight *= 0.9) CHECK(at[n] == near(sum, 1e-12));
    for (const double left : {1.0, 0.1, 1e-3, 1e-6}) {
        const auto later = std::lower_bound(at.begin(), at.end(), scene.rest_time() - left);
        CHECK(static_cast<double>(later - at.begin()) == near(scene.bounces_until(left), 1));
    }
    CHECK(scene.bounces_until(1e-4) - scene.bounces_until(1e-3) ==
          near(std::log(10.0) / std::log(1 / 0.9), 1e-9));
    // Without an end the clock stands still: a flight is shorter than half the last digit of 8.58 s.
    double now = fall, flown = 2 * 0.9 * fall;
    int bounces = 1;
    for (; now + flown > now; ++bounces) now += flown, flown *= 0.9;
    CHECK(bounces == near(std::log(0.5 * 0x1p-49 / (2 * fall)) / std::log(0.9), 2));
    CHECK(scene.rest_time() - now < 1e-13);
}

TEST_CASE("The bouncing ball by steps: order 1, because an impact comes up to a step late") {
    // The mean over many steps near dt: a single one hits the floor by chance early or late.
    Convergence c;
    for (const double dt : {1 / 60.0, 1 / 120.0, 1 / 240.0, 1 / 480.0, 1 / 960.0}) {
        double sum = 0;
        const int steps = 20;
        for (int i = 0; i < steps; ++i)
            sum += rms_error(BouncingBall{}, methods::bounce_steps, dt * (0.8 + 0.4 * i / steps));
        c.dt.push_back(dt), c.error.push_back(sum / steps);
    }
    CHECK_THAT(c, HasOrder(1, 0.1));
    CHECK(c.error.front() == near(0.112, 0.001));  // 11 cm rms at 60 steps a second
}

TEST_CASE("Smaller steps mend neither a floor that pushes nor the printed one") {
    for (const double dt : {1 / 60.0, 1 / 960.0}) {
        CHECK(rms_error(BouncingBall{}, methods::bounce_events, dt) < 1e-9);
        CHECK(rms_error(BouncingBall{}, methods::bounce_pushed, dt) > 0.2);
        CHECK(rms_error(BouncingBall{}, methods::bounce_printed, dt) > 0.1);  // it sinks in by its radius
    }
}

TEST_CASE("Pushing a ball out of the floor through its velocity makes it bounce higher than it fell") {
    BouncingBall scene;
    scene.restitution = 1;
    const double dt = 1 / 60.0, start = scene.drop() * scene.g;
    const auto highest_energy = [&](double push) {
        Particle body = scene.start;
        double highest = 0;
        for (int i = 0; i < 1200; ++i) {
            body = verlet(body, scene, 0, dt);
            bounce_with_push(scene, body, dt, push);
            const double height = body.position.y() - scene.ball.radius;
            highest = std::max(highest, scene.g * height + kinetic_energy(body));
        }
        return highest / start;
    };
    // Without a push an elastic bounce at any depth keeps the energy of the parabola, to round-off.
    CHECK(highest_energy(0) == near(1, 1e-12));
    CHECK(highest_energy(0.2) == near(10.477, 0.001));  // a fifth of the depth a step, for 20 s
}

TEST_CASE("The printed floor never rests: 44 mm at dt = 0.008 s, started at rest on the floor (E62, E64)") {
    BouncingBall scene;
    scene.g = 9.8;
    for (const auto& [dt, millimetres] :
         std::vector<std::pair<double, double>>{{0.004, 11.0}, {0.008, 44.2}, {1 / 60.0, 191.7}}) {
        Particle body{1};
        double highest = 0;
        int contacts = 0;
        for (int i = 0; i < 21000; ++i) {
            body = euler(body, scene, 0, dt);
            const double before = body.momentum.y();
            bounce_as_printed(body);
            if (i < 1000) continue;  // it jumps a little higher before it has found its rhythm
            highest = std::max(highest, body.position.y());
            contacts += body.momentum.y() != before;
        }
        CHECK(contacts / 20000.0 == near(0.042, 0.0005));  // one step in 24
        CHECK(1000 * highest == near(millimetres, 0.05 + 0.001 * millimetres));
    }
    // the approach test: a body on its way up below the floor is sent down by the printed rule
    Particle rising{1, {0, -0.5, 0}, {0, 1, 0}};
    bounce_as_printed(rising);
    CHECK(rising.momentum.y() == -0.9);
    Particle mended{1, {0, -0.5, 0}, {0, 1, 0}};
    bounce_off_floor(scene, mended);
    CHECK(mended.momentum.y() == 1);
}
