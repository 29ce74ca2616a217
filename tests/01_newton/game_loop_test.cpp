// Chapter 1: frame rates and the game loop.
#include <nutshell/game_loop.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/newton_scenes.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

/// Positions of the throw at the multiples of 1/6 s that 30, 60 and 144 Hz share.
template <class Step>
std::vector<Vector3> at_common_instants(const Step& method, int hertz) {
    std::vector<Vector3> seen;
    long n = 0;
    lab::run(ThrownBall{}, method, 3 * hertz, [&](const PointMass& ball, double) {
        if (n++ % (hertz / 6) == 0) seen.push_back(ball.position);
    });
    return seen;
}

}  // namespace

TEST_CASE("at 30, 60 and 144 Hz the same throw differs by exactly what the order says") {
    const double round_off = 500 * 25 * std::numeric_limits<double>::epsilon();  // 500 steps, |p| < 25 m
    for (auto [slow, fast] : {std::pair{30, 60}, {60, 144}, {30, 144}}) {
        const auto e1 = at_common_instants(methods::euler, slow),
                   e2 = at_common_instants(methods::euler, fast);
        const auto v1 = at_common_instants(methods::verlet, slow),
                   v2 = at_common_instants(methods::verlet, fast);
        REQUIRE(e1.size() == 19);
        REQUIRE(e2.size() == 19);
        for (std::size_t i = 0; i < e1.size(); ++i) {
            const double t = static_cast<double>(i) / 6;
            const Vector3 expected = throw_error(Kicked::after_drift, gravity, t, 1.0 / slow) -
                                     throw_error(Kicked::after_drift, gravity, t, 1.0 / fast);
            CHECK((e1[i] - e2[i] - expected).norm() < round_off);
            CHECK((v1[i] - v2[i]).norm() < round_off);
        }
    }
}

TEST_CASE("the accumulator hands out whole steps and keeps the rest") {
    GameClock clock{0.25};
    CHECK(steps_due(clock, 0.125) == 0);
    CHECK(steps_due(clock, 0.25) == 1);
    CHECK(clock.owed == 0.125);
    CHECK(steps_due(clock, 1.0) == 4);
    CHECK(steps_due(clock, 0.125) == 1);
    CHECK(clock.owed == 0);
    CHECK_THROWS_WITH(steps_due(clock, -0.1), ContainsSubstring("frame time"));
    GameClock stopped{0};
    CHECK_THROWS_WITH(steps_due(stopped, 0.1), ContainsSubstring("step"));
}

TEST_CASE("whatever the frames, the same steps are made: the physics does not see the frame rate") {
    long at_60 = 0, at_144 = 0, ragged = 0;
    GameClock a{1.0 / 128}, b{1.0 / 128}, c{1.0 / 128};
    for (int i = 0; i < 60 * 4; ++i)
        at_60 += steps_due(a, 1.0 / 64);  // binary fractions: no rounding in the sums
    for (int i = 0; i < 144 * 4; ++i) at_144 += steps_due(b, 1.0 / 256);
    for (int i = 0; i < 100; ++i) ragged += steps_due(c, (i % 7) / 256.0);
    CHECK(at_60 == 480);
    CHECK(at_144 == 288);
    CHECK(static_cast<double>(ragged) / 128 + c.owed == Approx([] {
                                                            double sum = 0;
                                                            for (int i = 0; i < 100; ++i)
                                                                sum += (i % 7) / 256.0;
                                                            return sum;
                                                        }())
                                                            .epsilon(1e-15));
}

TEST_CASE("the spiral of death: a step that costs more than it simulates, and the cap that ends it") {
    const double step = 1.0 / 60, cost = 0.020;  // [s] of machine time a step: slower than real time
    const auto frames = [&](int most_steps) {
        GameClock clock{step, 0, most_steps};
        std::vector<int> made;
        double frame = step;
        for (int i = 0; i < 40; ++i) {
            made.push_back(steps_due(clock, frame));
            frame = std::max(step, made.back() * cost);  // the machine needs this long for the frame
        }
        return made;
    };
    const auto spiral = frames(1'000'000), capped = frames(4);
    // without the cap each frame owes cost/step = 1.2 times the one before, less a fraction of a step kept
    // for later
    CHECK(spiral.back() > 100);
    for (std::size_t i = 20; i < spiral.size(); ++i)
        CHECK(spiral[i] / static_cast<double>(spiral[i - 1]) == Approx(1.2).epsilon(0.05));
    for (int made : capped) CHECK(made <= 4);
}

TEST_CASE("what is drawn lies between the last two steps, where the clock stands") {
    const GameClock clock{0.1, 0.025};
    const PointMass previous{1, {1, 0, 0}, {0, 0, 0}}, newest{1, {2, 4, 0}, {0, 0, 0}};
    CHECK((drawn_position(clock, previous, newest) - Vector3(1.25, 1, 0)).norm() < 1e-15);
}
