// The same bits from every compiler: impacts and their times use + - * / and square roots only.
#include <cstring>
#include <nutshell/bouncing_ball.hpp>
#include <nutshell/impact_scenes.hpp>
#include <nutshell/impulse.hpp>
#include "near.hpp"

using namespace nutshell;

namespace {

/// FNV-1a of the bits of all numbers.
class Hash {
  public:
    void add(double x) {
        std::uint64_t bits;
        static_assert(sizeof bits == sizeof x);
        std::memcpy(&bits, &x, sizeof x);
        for (int i = 0; i < 8; ++i) value_ = (value_ ^ (bits >> (8 * i) & 0xff)) * 0x100000001b3u;
    }
    void add(const Vector3& v) {
        for (const double x : v) add(x);
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace

TEST_CASE("The break of pool and the bouncing ball have the same bits from every compiler") {
    Hash pool, bounce;
    Balls balls = pool_break();
    for (int i = 0; i < 100; ++i) {
        fly_by_events(balls, 1 / 256.0);
        for (const Particle& ball : balls.all) pool.add(ball.position), pool.add(ball.momentum);
    }
    const BouncingBall scene;
    Particle events = scene.start, steps = scene.start;
    for (int i = 0; i < 1000; ++i) {
        events = bounce_by_events(scene, events, 1 / 128.0);
        steps = verlet(steps, scene, 0, 1 / 128.0);
        bounce_off_floor(scene, steps);
        bounce.add(events.position), bounce.add(steps.position);
    }
    CHECK(pool.value() == 0x8e1696700291af68u);
    CHECK(bounce.value() == 0xbb5f877e39458eceu);
}
