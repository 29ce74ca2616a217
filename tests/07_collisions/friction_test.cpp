// Friction by contact impulses on bodies that are free to turn, against closed forms; the universe.
#include <nutshell/friction_scenes.hpp>
#include <nutshell/universe_scene.hpp>
#include "near.hpp"

using namespace nutshell;

namespace {

template <class Scene>
World run(const Scene& scene, double duration) {
    World world = checked(scene.start());
    Engine engine(scene.switches);
    for (int i = 0; i < std::lround(60 * duration); ++i) engine.step(world, 1 / 60.0);
    return world;
}

}  // namespace

TEST_CASE("A block on a slope of 30 degrees slides with the mu it has, in every direction (S13)") {
    for (const double heading : {0.0, 17.0, 30.0, 45.0, 80.0}) {
        BlockOnSlope scene;
        scene.heading = heading * pi / 180;
        REQUIRE_FALSE(scene.sticks());
        const World world = run(scene, scene.duration);
        INFO("towards " << heading << " degrees");
        CHECK(scene.effective_friction(world, scene.duration) == near(0.5, 1e-9));
        CHECK(velocity(world.bodies[0]).norm() == near(scene.exact_speed(2), 1e-9));
        CHECK(angular_velocity(world.bodies[0]).norm() < 1e-9);  // it neither turns nor tips
    }
}

TEST_CASE("A block on a slope of 26 degrees sticks: creep below a nanometre in 5 s (S13)") {
    for (const double heading : {0.0, 30.0, 45.0}) {
        BlockOnSlope scene;
        scene.slope = 26 * pi / 180, scene.heading = heading * pi / 180;
        REQUIRE(scene.sticks());
        World world = scene.start();
        Engine engine(scene.switches);
        double creep = 0;
        for (int i = 0; i < 300; ++i) {
            engine.step(world, 1 / 60.0);
            creep = std::max(creep, (world.bodies[0].position - Vector3(0, 0.5, 0)).norm());
        }
        CHECK(creep <= 1e-9);
    }
}

TEST_CASE("A pyramid for friction's cone: a block that must slide stands still at 30 and 45 degrees") {
    for (const double heading : {0.0, 10.0, 25.0, 30.5, 45.0, 59.5, 80.0}) {
        BlockOnSlope scene;
        scene.heading = heading * pi / 180, scene.switches.pyramid = true;
        const World world = run(scene, scene.duration);
        // along each edge by itself: friction of up to mu times the weight against its part of the pull
        const auto along = [&](double part) {
            return scene.duration * scene.g *
                   std::max(0.0, part * std::sin(scene.slope) - scene.friction * std::cos(scene.slope));
        };
        INFO("towards " << heading << " degrees");
        CHECK(velocity(world.bodies[0]).x() == near(along(std::cos(scene.heading)), 1e-9));
        CHECK(velocity(world.bodies[0]).z() == near(along(std::sin(scene.heading)), 1e-9));
        if (heading > 30 && heading < 60) CHECK(velocity(world.bodies[0]).norm() < 1e-9);
    }
}

TEST_CASE("A block sticks from mu = tan(slope) on, to 1 %: it holds at 1.01 of it and slides at 0.99") {
    for (const double degrees : {5.0, 26.0, 40.0})
        for (const double heading : {0.0, 30.0, 45.0}) {
            BlockOnSlope scene;
            scene.slope = degrees * pi / 180, scene.heading = heading * pi / 180;
            INFO(degrees << " degrees, towards " << heading);
            scene.friction = 0.99 * std::tan(scene.slope);
            REQUIRE_FALSE(scene.sticks());
            const double law = scene.exact_speed(scene.duration);
            CHECK(velocity(run(scene, scene.duration).bodies[0]).norm() == near(law, 1e-6 * law));
            scene.friction = 1.01 * std::tan(scene.slope);
            REQUIRE(scene.sticks());
            const Vector3 way = run(scene, scene.duration).bodies[0].position - Vector3(0, 0.5, 0);
            CHECK(way.norm() < 1e-6 * law * scene.duration / 2);  // a millionth of what it slides at 0.99
        }
}

TEST_CASE("A block tips where the slope is steeper than its width over its height, to 1 %") {
    for (const double wide : {0.5, 0.3})
        for (const double of_limit : {0.99, 1.01}) {
            BlockOnSlope scene;
            scene.friction = 2;
            scene.slope = std::atan(of_limit * wide / 0.5);  // it is 1 m high
            World world = scene.start();
            const Box block{{wide, 0.5, wide}};
            world.bodies[0] = solid_box(1, block, {0, 0.5, 0}), world.shapes[0] = block;
            Engine engine(scene.switches);
            for (int i = 0; i < 60; ++i) engine.step(world, 1 / 60.0);
            const double turns = angular_velocity(world.bodies[0]).norm();
            INFO("half width " << wide << " m, " << of_limit << " of the limit");
            if (of_limit < 1)
                CHECK(turns < 1e-9);
            else
                CHECK(turns > 0.01);
        }
}

TEST_CASE("A bowling ball slides, then rolls at 5/7 of its speed") {
    for (const double friction : {0.05, 0.1, 0.3}) {
        BowlingBall scene;
        scene.friction = friction;
        World world = scene.start();
        Engine engine(scene.switches);
        for (int i = 1; i <= 600; ++i) {
            engine.step(world, 1 / 60.0);
            const double t = i / 60.0;
            // within the one step in which it begins to roll, friction ends
            CHECK(velocity(world.bodies[0]).x() == near(scene.exact_speed(t), 1e-9));
        }
        CHECK(scene.rolls_after() < 10);
        const Body& ball = world.bodies[0];
        CHECK(velocity(ball).x() + angular_velocity(ball).z() * scene.radius == near(0, 1e-9));
        // where: the way it slid and the way it rolled; each step is taken at its last speed, order 1
        const double way = scene.rolls_from() + 5.0 / 7 * scene.speed * (10 - scene.rolls_after());
        CHECK(ball.position.x() == near(way, scene.speed / 60));
    }
}

TEST_CASE("A ball rolls down a slope without slipping if mu >= 2/7 tan(slope)") {
    for (const double friction : {0.1, 0.2, 0.5}) {
        BlockOnSlope scene;
        scene.friction = friction;
        World world = scene.start();
        world.bodies[0] = solid_ball(1, 0.5, {0, 0.5, 0}), world.shapes[0] = Sphere{0.5};
        Engine engine(scene.switches);
        for (int i = 0; i < 120; ++i) engine.step(world, 1 / 60.0);
        CHECK(velocity(world.bodies[0]).x() == near(2 * rolling_acceleration(scene.slope, friction), 1e-9));
    }
}

TEST_CASE("A ball on a slope rolls from mu = 2/7 tan(slope) on, to 1 %") {
    for (const double degrees : {5.0, 30.0, 60.0})
        for (const double of_limit : {0.99, 1.01}) {
            BlockOnSlope scene;
            scene.slope = degrees * pi / 180;
            scene.friction = of_limit * 2 / 7 * std::tan(scene.slope);
            World world = scene.start();
            world.bodies[0] = solid_ball(1, 0.5, {0, 0.5, 0}), world.shapes[0] = Sphere{0.5};
            Engine engine(scene.switches);
            for (int i = 0; i < 120; ++i) engine.step(world, 1 / 60.0);
            const Body& ball = world.bodies[0];
            const double slips = velocity(ball).x() + angular_velocity(ball).z() * 0.5;
            // friction lacks 1 % of what rolling takes, 2/7 of the pull, and a point answers 7/2 of it
            const double lacks = of_limit < 1 ? 2 * 0.01 * scene.g * std::sin(scene.slope) : 0;
            INFO(degrees << " degrees, " << of_limit << " of the limit");
            CHECK(slips == near(lacks, 1e-9));
        }
}

TEST_CASE("Down a slope with a start: slides, stops, rolls where Coulomb's law in closed form has it") {
    struct Case {
        double degrees, friction, speed;
    };
    for (const auto& [degrees, friction, speed] : std::vector<Case>{
             {30, 0.5, 0}, {30, 0.1, 1}, {10, 0.5, 2}, {0, 0.1, 3}, {20, 0.3, 1.5}, {26, 0.5, 0}})
        for (const bool ball : {false, true}) {
            BlockOnSlope scene;
            scene.slope = degrees * pi / 180, scene.friction = friction;
            World world = scene.start();
            if (ball) world.bodies[0] = solid_ball(1, 0.5, {0, 0.5, 0}), world.shapes[0] = Sphere{0.5};
            world.bodies[0].momentum = speed * scene.downhill();
            Engine engine(scene.switches);
            const double step = 1 / 960.0;
            for (int i = 0; i < 960; ++i) engine.step(world, step);
            INFO(degrees << " degrees, mu " << friction << ", " << speed << " m/s, ball " << ball);
            // each step moves on with its last speed: order 1, half a step of what the speed has changed
            const double changed = std::max(speed, 1.0 * scene.g);
            CHECK(world.bodies[0].position.x() ==
                  near(way_down(scene.slope, friction, ball, speed, 1), 0.6 * changed * step));
        }
}

TEST_CASE("The printed program: first contact at step 2501, R not a number from step 59493 (E45, E52, E63)") {
    PrintedUniverse printed;
    long first_contact = 0, first_nan = 0;
    for (long i = 1; i <= 60000 && first_nan == 0; ++i) {
        printed.evolve(0.008f);
        if (printed.contacts == 1 && first_contact == 0) first_contact = i;
        if (!printed.R.allFinite()) first_nan = i;
    }
    CHECK(first_contact == 2501);
    CHECK(first_nan == 59493);
    CHECK(printed.contacts == 404);
    CHECK(printed.L.norm() < 1e-19f);  // 0.01 * 0.9^404: gone, without any friction
}

TEST_CASE("The universe repaired: bounces on time, comes to rest, keeps its spin") {
    const Universe scene;
    World world = checked(world_of(scene));
    Engine engine(universe_switches);
    const double before = energy(world), low = scene.radius;
    double touched = 0, highest_energy = 0, highest_at_rest = 0, fastest_at_rest = 0;
    for (long i = 1; i <= 60000; ++i) {
        engine.step(world, scene.dt);
        const double t = static_cast<double>(i) * scene.dt;
        const Body& ball = world.bodies[0];
        REQUIRE(ball.orientation.coeffs().allFinite());
        highest_energy = std::max(highest_energy, energy(world) / before);
        if (touched == 0 && ball.momentum.y() > 0) touched = t;
        if (t < scene.rest_time() + 10) continue;
        highest_at_rest = std::max(highest_at_rest, std::abs(ball.position.y() - low));
        fastest_at_rest = std::max(fastest_at_rest, std::abs(ball.momentum.y()));
    }
    CHECK(touched == near(scene.first_contact(), scene.dt));
    CHECK(highest_energy <= 1);
    CHECK(highest_at_rest < 1e-6);  // the weight of one step moves it g dt^2 = 0.64 um
    CHECK(fastest_at_rest < 1e-4);
    CHECK(world.bodies[0].angular_momentum == scene.spin);  // no friction: not one bit of it changes
    CHECK(std::abs(world.bodies[0].orientation.norm() - 1) < 1e-12);
}
