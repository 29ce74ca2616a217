// Impacts of particles: eqs. (64)-(71) along the normal, and what is wrong with them as printed.
#include <nutshell/impact_scenes.hpp>
#include <nutshell/impacts_at_once.hpp>
#include "near.hpp"

using namespace nutshell;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

double angle(const Vector3& a, const Vector3& b) {
    return std::acos(a.dot(b) / (a.norm() * b.norm())) * 180 / pi;
}

std::array<Vector3, 2> after(const TwoBalls& scene) {
    Particle a = scene.a, b = scene.b;
    collide(a, b, scene.normal(), scene.restitution);
    return {velocity(a), velocity(b)};
}

}  // namespace

TEST_CASE("Head-on: elastic, inelastic, stuck, and equal masses swap (S11)") {
    const auto [a, b] = after(TwoBalls::head_on());
    CHECK(a.x() == near(-2, 1e-12));  // by hand: the centre of mass rests, both turn round
    CHECK(b.x() == near(1, 1e-12));
    for (const double e : {0.0, 0.3, 0.9, 1.0}) {
        TwoBalls scene = TwoBalls::head_on();
        scene.restitution = e;
        const auto v = after(scene), exact = scene.exact();
        CHECK((v[0] - exact[0]).norm() < 1e-12);
        CHECK((v[1] - exact[1]).norm() < 1e-12);
        CHECK(v[1].x() - v[0].x() == near(3 * e, 1e-12));  // eq. (65*)
        // (67), (68) as printed are right here
        Particle pa = scene.a, pb = scene.b;
        collide_as_printed(pa, pb, e);
        CHECK((velocity(pa) - v[0]).norm() < 1e-12);
        CHECK((velocity(pb) - v[1]).norm() < 1e-12);
    }
    Particle p{1, {0, 0, 0}, {3, 0, 0}}, q{1, {1, 0, 0}, {-2, 0, 0}};
    collide(p, q, {1, 0, 0}, 1);
    CHECK(p.momentum.x() == -2);
    CHECK(q.momentum.x() == 3);
}

TEST_CASE("Glancing: equal balls leave at right angles, from every hit that is not head-on (S11)") {
    for (const double offset : {0.01, 0.2, 0.5, std::sqrt(0.5), 0.9, 0.999}) {
        const TwoBalls scene = TwoBalls::glancing(offset);
        const auto v = after(scene), exact = scene.exact();
        CHECK((v[0] - exact[0]).norm() < 1e-12);
        CHECK((v[1] - exact[1]).norm() < 1e-12);
        CHECK(std::abs(v[0].dot(v[1])) < 1e-15);  // right angles: of speeds up to 2 m/s
    }
    TwoBalls scene = TwoBalls::glancing(std::sqrt(0.5));  // 45 degrees
    scene.restitution = 0.9;
    const auto v = after(scene);
    // by hand: across 1, along 0.05 and 0.95 of the normal's part of the speed
    CHECK(angle(v[0], v[1]) == near(std::atan(1 / 0.05) * 180 / pi, 1e-9));
    CHECK(angle(v[0], v[1]) == near(87.1, 0.05));
}

TEST_CASE("As printed, a glancing ball stops dead and a separating pair is pulled together (E34-E37)") {
    const TwoBalls scene = TwoBalls::glancing(std::sqrt(0.5));
    Particle a = scene.a, b = scene.b;
    a.momentum = {1, 0, 0};
    collide_as_printed(a, b, 1);
    CHECK(a.momentum.norm() < 1e-15);                                  // true: (0.5, 0.5) and (0.5, -0.5)
    Particle c{1, {0, 0, 0}, {-1, 0, 0}}, d{1, {1, 0, 0}, {1, 0, 0}};  // apart already
    Particle c2 = c, d2 = d;
    collide_as_printed(c, d, 0.9);
    CHECK(c.momentum.x() == near(0.9, 1e-15));
    collide(c2, d2, {1, 0, 0}, 0.9);
    CHECK(c2.momentum.x() == -1);
    CHECK(d2.momentum.x() == 1);
    // A wall: printed (-2.7, 3.6, 0), correct (3, 3.6, 0)
    Particle wall{immovable}, ball{1, {0, 1, 0}, {3, -4, 0}};
    collide(wall, ball, {0, 1, 0}, 0.9);
    CHECK((ball.momentum - Vector3(3, 3.6, 0)).norm() < 1e-14);
    CHECK(velocity(wall).norm() == 0);
}

TEST_CASE("Any two particles: momentum, angular momentum about any point, restitution, energy") {
    Chance chance(7);
    double momentum = 0, turning = 0, restitution = 0, energy = 0;
    for (int i = 0; i < 10000; ++i) {
        const Vector3 n = chance.direction(), contact = chance.vector(2);
        Particle a{chance(0.1, 10), contact - 0.5 * n, chance.vector(5)};
        Particle b{chance(0.1, 10), contact + 0.3 * n, chance.vector(5)};
        const double e = chance(0, 1), s = separating_speed(a, b, n);
        const Particle a0 = a, b0 = b;
        collide(a, b, n, e);
        const auto spin = [](const Particle& p) { return p.position.cross(p.momentum).eval(); };
        momentum = std::max(momentum, (a.momentum + b.momentum - a0.momentum - b0.momentum).norm());
        turning = std::max(turning, (spin(a) + spin(b) - spin(a0) - spin(b0)).norm());
        if (s < 0) restitution = std::max(restitution, std::abs(separating_speed(a, b, n) + e * s));
        const double reduced = 1 / (1 / a.mass + 1 / b.mass), lost = (1 - e * e) * reduced * s * s / 2;
        const double change = kinetic_energy(a) + kinetic_energy(b) - kinetic_energy(a0) - kinetic_energy(b0);
        energy = std::max(energy, std::abs(change + (s < 0 ? lost : 0)));
    }
    // momenta up to 100 kg m/s, levers up to 5 m, speeds up to 170 m/s, energies up to 1e4 J
    CHECK(momentum < 100 * 8 * epsilon);
    CHECK(turning < 500 * 8 * epsilon);
    CHECK(restitution < 170 * 32 * epsilon);
    CHECK(energy < 1e4 * 16 * epsilon);
}

TEST_CASE("Newton's cradle: impacts one after another are exact, all at once are not (S12)") {
    for (const std::size_t balls : std::vector<std::size_t>{2, 3, 5, 12}) {
        Cradle cradle;
        cradle.balls = balls;
        auto all = cradle.start();
        CHECK(collide_one_after_another(all, cradle.touches(), 1) == static_cast<long>(balls) - 1);
        for (std::size_t i = 0; i < balls; ++i)
            CHECK(velocity(all[i]).x() == near(i + 1 == balls ? 1 : 0, 1e-12));
        // At once, the first bounces back and all others leave together: momentum and energy alone
        // do not tell. With n balls: v1 = 1 - 2 (n - 1)/n, the others 2/n.
        auto wrong = cradle.start();
        collide_at_once(wrong, cradle.touches(), 1);
        const auto n = static_cast<double>(balls);
        CHECK(velocity(wrong.front()).x() == near(1 - 2 * (n - 1) / n, 1e-12));
        CHECK(velocity(wrong.back()).x() == near(2 / n, 1e-12));
        CHECK(kinetic_energy(wrong) == near(0.5, 1e-12));
        CHECK(total_momentum(wrong).x() == near(1, 1e-12));
    }
    // Two come in, two leave.
    Cradle cradle;
    auto all = cradle.start();
    all[1].momentum = {1, 0, 0};
    collide_one_after_another(all, cradle.touches(), 1);
    for (std::size_t i = 0; i < 5; ++i) CHECK(velocity(all[i]).x() == near(i > 2 ? 1 : 0, 1e-12));
}

TEST_CASE("Newton's cradle with gaps of 2 cm: four impacts, the last ball leaves alone (S12)") {
    for (const double gap : {0.02, 0.003, 0.0}) {
        Balls row = Cradle{}.with_gaps(gap);
        CHECK(fly_by_events(row, 1) == 4);
        for (std::size_t i = 0; i < 5; ++i) CHECK(velocity(row.all[i]).x() == near(i == 4 ? 1 : 0, 1e-12));
        // the four gaps are crossed at 1 m/s one after another, then the last flies on
        CHECK(row.all[4].position.x() == near(4 * (1 + gap) + 1 - 4 * gap, 1e-12));
        CHECK(row.all[3].position.x() == near(4 * (1 + gap) - 1, 1e-12));
    }
}

TEST_CASE("One after another ends when nothing closes in, and says so when it never would") {
    Cradle cradle;
    auto all = cradle.start();
    collide_one_after_another(all, cradle.touches(), 0.5, 1e-12);
    for (std::size_t i = 0; i + 1 < 5; ++i) CHECK(separating_speed(all[i], all[i + 1], {1, 0, 0}) >= -1e-12);
    CHECK(total_momentum(all).x() == near(1, 1e-13));
    // A ball without bounce pressed between two others and a wall never gets there.
    std::vector<Particle> pressed(3);
    pressed[0].momentum = {1, 0, 0}, pressed[2].mass = immovable;
    CHECK_NOTHROW(collide_one_after_another(pressed, {{0, 1, {1, 0, 0}}, {1, 2, {1, 0, 0}}}, 0, 1e-12));
    CHECK(std::abs(velocity(pressed[0]).x()) < 2e-12);
}

TEST_CASE("The break of pool: momentum and energy kept, every impact found") {
    Balls balls = pool_break();
    balls.restitution = 1;
    const Vector3 momentum = total_momentum(balls.all);
    const double energy = kinetic_energy(balls.all);
    const long impacts = fly_by_events(balls, 0.5);
    CHECK(impacts > 15);
    CHECK((total_momentum(balls.all) - momentum).norm() <
          static_cast<double>(impacts) * momentum.norm() * epsilon);
    CHECK(kinetic_energy(balls.all) == near(energy, static_cast<double>(impacts) * 4 * energy * epsilon));
    for (std::size_t a = 0; a < balls.all.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            CHECK((balls.all[a].position - balls.all[b].position).norm() > 2 * balls.radius - 1e-12);
    Balls lossy = pool_break();
    fly_by_events(lossy, 0.5);
    CHECK(kinetic_energy(lossy.all) < energy);
    CHECK((total_momentum(lossy.all) - momentum).norm() < 1e-13);
    Balls straight = pool_break(8, 0, 0);  // everything touches, everything is symmetric
    fly_by_events(straight, 0.5);
    CHECK(total_momentum(straight.all).z() == near(0, 1e-13));
}

TEST_CASE("Too fast to see: a point test misses 1 - h/(v dt) of all starts, a swept one none") {
    // h = 0.1 m; the four cases of the errata's section 3.6
    struct Case {
        double speed, dt, percent;
    };
    for (const auto& [speed, dt, percent] : std::vector<Case>{
             {20, 0.008, 37}, {50, 0.008, 75}, {10, 1 / 60.0, 40}, {20, 1 / 60.0, 70}, {50, 1 / 60.0, 88}}) {
        const double p = miss_probability(0.1, speed, dt);
        CHECK(100 * p == near(percent, 0.6));
        const int starts = 100000;
        int missed = 0, swept_missed = 0;
        for (int i = 0; i < starts; ++i) {
            const double before = 3 + speed * dt * (i + 0.5) / starts;
            missed += !seen_inside(before, 0.1, speed, dt);
            swept_missed += !swept_inside(before, speed, dt);
        }
        CHECK(missed / static_cast<double>(starts) == near(p, 2.0 / starts));
        CHECK(swept_missed == 0);
    }
    // the limit, to 1 %: at 0.99 of h/dt every start is seen, at 1.01 one in 101 is not
    for (const double of_limit : {0.99, 1.01}) {
        const double dt = 1 / 60.0, speed = of_limit * 0.1 / dt;
        const int starts = 10100;
        int missed = 0;
        for (int i = 0; i < starts; ++i)
            missed += !seen_inside(3 + speed * dt * (i + 0.5) / starts, 0.1, speed, dt);
        CHECK(missed == (of_limit < 1 ? 0 : starts / 101));
        CHECK(miss_probability(0.1, speed, dt) == near(of_limit < 1 ? 0 : 1 / 101.0, 1e-12));
    }
}

TEST_CASE("Impacts at the door: what cannot collide is named") {
    const Particle ball{1}, wall{immovable};
    CHECK_NOTHROW(check_pair(ball, wall));
    CHECK_THROWS_WITH(check_pair(wall, wall), ContainsSubstring("immovable"));
    CHECK_THROWS_WITH(check_pair(Particle{0}, ball), ContainsSubstring("greater than zero"));
    CHECK_THROWS_WITH(check_pair(ball, Particle{1, {0, 0, 0}, {std::nan(""), 0, 0}}),
                      ContainsSubstring("momentum"));
    CHECK_THROWS_WITH(checked_restitution(1.1), ContainsSubstring("between 0 and 1"));
    CHECK_THROWS_WITH(checked_restitution(std::nan("")), ContainsSubstring("between 0 and 1"));
    CHECK_THROWS_WITH(checked_normal({0, 0, 0}), ContainsSubstring("length 0"));
    CHECK_THROWS(checked(Sphere{0}));
    CHECK_THROWS_WITH(checked(Box{{1, 0, 1}}), ContainsSubstring("box"));
    CHECK_THROWS(checked(Capsule{1, -1}));
    CHECK_THROWS_WITH(checked(Plane{{0, 2, 0}, 0}), ContainsSubstring("instead of 1"));
    CHECK_THROWS(checked(Plane{{0, 1, 0}, std::nan("")}));
}
