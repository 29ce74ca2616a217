// What the second half's parts do alone: one contact's turn, softness, memory, grid; dominoes, cubes and the
// universe against closed forms and finer runs.
#include <nutshell/domino_scenes.hpp>
#include <nutshell/universe_scene.hpp>
#include <set>
#include "near.hpp"

using namespace nutshell;

namespace {

constexpr double dt = 1 / 60.0;

/// A ball of 1 kg and radius 0.1 m over the floor, and its contact.
struct OneBall {
    World world;
    PressedContact c{};
    Mobility earth, ball;
    explicit OneBall(double gap) {
        world.add(solid_ball(1, 0.1, {0, 0.1 + gap, 0}), Sphere{0.1});
        std::vector<Contact> found;
        find_contacts(Plane{}, Sphere{0.1}, world.bodies[0], 1, found);
        REQUIRE(found.size() == 1);
        earth = mobility_of(world.earth), ball = mobility_of(world.bodies[0]);
        c.a = -1, c.b = 0, c.radius_a = 0, c.radius_b = 0.1, c.balls = false;
        prepare(c, found[0], world.earth, world.bodies[0], earth, ball);
    }
    void turn(const Press& want) { press(c, world.earth, world.bodies[0], earth, ball, want); }
};

}  // namespace

TEST_CASE("A soft contact is implicit Euler's damped spring: speed after one turn and after ten") {
    // References: the two equations s' = s + h (omega^2 (d - h s') - 2 zeta omega s') solved for s'.
    for (const double frequency : {1.0, 12.0, 48.0})
        for (const double damping : {0.5, 1.0, 10.0}) {
            const double h = 1 / 240.0, d = 0.002, s = -0.3, omega = 2 * pi * frequency;
            const double exact =
                (s + h * omega * omega * d) / (1 + 2 * damping * omega * h + h * h * omega * omega);
            OneBall one(-d);
            one.world.bodies[0].momentum.y() = s;
            Press want{h, 0, 0, 0};
            want.soft = softness(frequency, damping, h), want.fastest_out = 1e9;
            one.turn(want);
            CHECK(one.world.bodies[0].momentum.y() == near(exact, 1e-14));
            for (int i = 0; i < 9; ++i) one.turn(want);  // it has its impulse: nothing more to give
            CHECK(one.world.bodies[0].momentum.y() == near(exact, 1e-14));
            CHECK(one.c.normal_impulse == near(exact - s, 1e-14));
        }
}

TEST_CASE("One turn: it may take back what it gave, never pulls, and friction stays in its cone") {
    const Press want{1 / 240.0, 0.5, 0, 0};
    OneBall one(0);
    one.c.normal_impulse = 2, one.world.bodies[0].momentum.y() = 1.5;  // given too much
    one.turn(want);
    CHECK(one.c.normal_impulse == near(0.5, 1e-15));
    CHECK(one.world.bodies[0].momentum.y() == near(0, 1e-15));
    one.world.bodies[0].momentum.y() = 5;
    one.turn(want);
    CHECK(one.c.normal_impulse == 0);
    CHECK(one.world.bodies[0].momentum.y() == near(4.5, 1e-15));
    // A gap of 1 mm may close in at 0.24 m/s in 1/240 s, not faster.
    OneBall gap(0.001);
    gap.world.bodies[0].momentum.y() = -3;
    gap.turn(want);
    CHECK(gap.world.bodies[0].momentum.y() == near(-0.24, 1e-12));
    // Sliding at 7 m/s (sticking would take 2 N s): friction is half of the normal impulse of 3 N s, against
    // the sliding, and turns the ball.
    OneBall slides(0);
    slides.world.bodies[0].momentum = {7, -3, 0};
    slides.turn(want);
    CHECK(slides.c.friction.x() == near(-1.5, 1e-15));
    CHECK(slides.world.bodies[0].momentum.x() == near(5.5, 1e-14));
    CHECK(slides.world.bodies[0].angular_momentum.z() == near(-0.15, 1e-15));
    CHECK((slides.world.earth.momentum + slides.world.bodies[0].momentum - Vector3(7, -3, 0)).norm() < 1e-14);
}

TEST_CASE("One turn with levers: a rolling start sticks at once, a box on its corner stops closing in") {
    const Press want{1 / 240.0, 0.5, 0, 0};
    OneBall sticks(0);  // 1 m/s of sliding takes 2/7 N s: a ball answers there as 2/7 of its mass
    sticks.world.bodies[0].momentum = {1, -3, 0};
    sticks.turn(want);
    CHECK(sticks.c.friction.x() == near(-2.0 / 7, 1e-14));
    CHECK(contact_velocity(sticks.c, sticks.world.earth, sticks.world.bodies[0], sticks.earth, sticks.ball)
              .norm() < 1e-14);
    const Box cube{{0.5, 0.5, 0.5}};
    Body earth = immovable_body(), box = solid_box(2, cube, {0, 0.5, 0});
    box.momentum = {0, -2, 0};
    PressedContact c{};
    c.a = -1, c.b = 0;
    const Mobility of_earth = mobility_of(earth), of_box = mobility_of(box);
    prepare(c, {{0.5, 0, 0.5}, {0, 1, 0}, 0, 0}, earth, box, of_earth, of_box);
    // 1/m + (r x n)^2/I with I = m/6: 1/2 + (1/4 + 1/4) 3 = 2 per kg
    CHECK(c.normal_mass == near(0.5, 1e-15));
    press(c, earth, box, of_earth, of_box, {1 / 240.0, 0, 0, 0});
    CHECK(c.normal_impulse == near(0.5, 1e-15));
    CHECK(c.normal.dot(contact_velocity(c, earth, box, of_earth, of_box)) == near(0, 1e-15));
}

TEST_CASE("Going round converges: the floor carries all ten boxes, each contact layer what is above it") {
    const Stack stack;
    World world = stack.start();
    Switches many{.sub_steps = 1, .passes = 20000, .relaxing = 0, .warm_start = false};
    many.soft = false;
    Engine engine(many);
    engine.step(world, dt);
    std::vector<double> carried(10, 0);
    for (const PressedContact& c : engine.contacts())
        carried[static_cast<std::size_t>(std::max(c.a, c.b))] += c.normal_impulse;
    for (std::size_t i = 0; i < 10; ++i)  // what lies under box i carries boxes i to 9
        CHECK(carried[i] == near(static_cast<double>(10 - i) * earth_gravity * dt, 1e-6));  // still 6e-7 off
}

TEST_CASE("Warm start takes impulses over, whichever body was found first") {
    PressedContact old{}, now{};
    old.a = 2, old.b = 7, old.normal_impulse = 3, old.friction = {1, 0, 0.5}, old.normal = {0, 1, 0};
    now.a = 7, now.b = 2, now.normal = {0, -1, 0};
    take_over(now, old);
    CHECK(now.normal_impulse == 3);
    CHECK((now.friction + old.friction).norm() < 1e-15);
    now.a = 2, now.b = 7, now.normal = Vector3(0.6, 0.8, 0);
    take_over(now, old);
    CHECK(std::abs(now.friction.dot(now.normal)) < 1e-15);
    CHECK((now.friction - Vector3(0.64, -0.48, 0.5)).norm() < 1e-15);
}

TEST_CASE("The grid: every pair nearer than a cell is visited once, and none twice") {
    Chance chance(5);
    for (int round = 0; round < 50; ++round) {
        std::vector<Vector3> points;
        const double size = 1 + round % 7;
        for (int i = 0; i < 60; ++i) points.push_back(chance.vector(size));
        Grid grid;
        grid.sort(points, 1);
        std::set<std::pair<int, int>> seen;
        int twice = 0;
        visit_pairs(grid, [&](int i, int j) {
            twice += !seen.insert({std::min(i, j), std::max(i, j)}).second;
        });
        CHECK(twice == 0);
        int missed = 0;
        for (int i = 0; i < 60; ++i)
            for (int j = i + 1; j < 60; ++j)
                missed +=
                    (points[static_cast<std::size_t>(i)] - points[static_cast<std::size_t>(j)]).norm() < 1 &&
                    seen.count({i, j}) == 0;
        CHECK(missed == 0);
    }
}

TEST_CASE(
    "Dominoes: the first turns as its energy says, and the wave is that of a far finer run within 5 %") {
    const auto run = [](const DominoRow& row, double step) {
        World world = checked(row.start());
        Engine engine(row.switches);
        DominoWave wave(row);
        double off = 0;
        bool alone = true;
        for (long i = 1; i <= std::lround(row.duration / step); ++i) {
            engine.step(world, step);
            wave.look(world, static_cast<double>(i) * step);
            const double lean = DominoRow::lean_of(world.bodies[0]);
            alone = alone && lean < 0.9 * row.touches_at();
            if (alone && lean > 1.2 * row.lean)
                off = std::max(off,
                               std::abs(angular_velocity(world.bodies[0]).norm() / row.exact_rate(lean) - 1));
        }
        REQUIRE(wave.all_fell());
        return std::pair(wave.speed(), off);
    };
    DominoRow row;
    const auto [coarse, off_coarse] = run(row, 1 / 30.0);
    const auto [usual, off_usual] = run(row, 1 / 60.0);
    const auto [fine, off_fine] = run(row, 1 / 480.0);
    CHECK(std::abs(coarse / fine - 1) < row.need.tolerance);
    CHECK(std::abs(usual / fine - 1) < row.need.tolerance / 2);
    CHECK(off_fine < 0.003);
    CHECK(off_usual < 0.02);
    CHECK(off_fine < off_usual / 3);  // first order: an eighth of the step
}

TEST_CASE(
    "Cubes fall into a box: nobody escapes, no energy gained, at rest they overlap by a tenth of an edge") {
    Pile pile;
    pile.cubes = true, pile.wide = 4;
    World world = checked(pile.start());
    CHECK(deepest_overlap(world) == 0);
    Engine engine(pile.switches);
    const double before = energy(world);
    double highest = 0;
    for (int i = 0; i < 240; ++i) {
        engine.step(world, dt);
        highest = std::max(highest, energy(world));
        REQUIRE(escaped(world) == 0);
    }
    CHECK(highest <= before);
    CHECK(deepest_overlap(world) < 0.0116);
    double moving = 0;  // at rest but for a cube that still tumbles: a thousandth of what the fall had
    for (const Body& body : world.bodies) moving += kinetic_energy(body);
    CHECK(moving < 1e-3 * before);
}

TEST_CASE("The universe's bounces: each leaves with 0.9 of its speed, on time, by the engine and mended") {
    const Universe scene;
    const double g = -scene.force.y() / scene.mass;
    for (const bool by_engine : {true, false}) {
        World world = world_of(scene);
        Engine engine(universe_switches);
        Body& ball = world.bodies[0];
        double last = 0, at = scene.first_contact(), speed = scene.restitution * g * at;
        int bounces = 0;
        for (long i = 1; bounces < 8; ++i) {
            if (by_engine)
                engine.step(world, scene.dt);
            else
                evolve_mended(scene, ball, scene.dt);
            if (last < 0 && ball.momentum.y() > 0) {
                ++bounces;
                // up to g dt of speed is lost before a bounce and after it: each next one is 4 dt earlier
                CHECK(static_cast<double>(i) * scene.dt == near(at, 2 * scene.dt * bounces * bounces));
                CHECK(ball.momentum.y() == near(speed, 2 * g * scene.dt * bounces));
                at += 2 * speed / g, speed *= scene.restitution;
            }
            last = ball.momentum.y();
        }
        CHECK(ball.angular_momentum == scene.spin);
    }
}
