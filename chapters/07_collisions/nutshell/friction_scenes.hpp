// Chapter 7 · Scenes of friction: a block on a slope, a bowling ball. Run by the engine's
// contacts on a body free to turn; no formula for sliding is in them.
#pragma once
#include <nutshell/rest_scenes.hpp>

namespace nutshell {

/// What a scene of rigid contacts needs of the engine: nothing overlaps, so nothing is pushed
/// out, and many passes until the impulses stand still.
inline Switches rigid_contacts() {
    Switches switches;
    switches.sub_steps = 1, switches.passes = 500, switches.relaxing = 0, switches.soft = false;
    return switches;
}

// [slope]
/// A unit box on a slope (scene S13). The floor stays level and gravity leans: downhill is the
/// direction `heading` [rad] from the box's edge along x.
struct BlockOnSlope {
    std::string name = "block_on_slope";
    double slope = 30 * pi / 180;  // [rad]
    double heading = 0;            // [rad]
    double friction = 0.5;
    double g = earth_gravity;
    double duration = 2;  // [s]
    Switches switches = rigid_contacts();

    Vector3 downhill() const { return {std::cos(heading), 0, std::sin(heading)}; }
    World start() const {
        World world;
        world.walls = {Plane{}};
        world.surface.friction = friction;
        world.gravity = g * (std::sin(slope) * downhill() - Vector3(0, std::cos(slope), 0));
        const Box cube{{0.5, 0.5, 0.5}};
        world.add(solid_box(1, cube, {0, 0.5, 0}), cube);
        return world;
    }
    /// It sticks if mu >= tan(slope). It does not tip while tan(slope) < width over height.
    bool sticks() const { return friction >= std::tan(slope); }
    /// Speed [m/s] after t seconds: g (sin - mu cos) t, in every direction alike.
    double exact_speed(double t) const {
        return sticks() ? 0 : g * (std::sin(slope) - friction * std::cos(slope)) * t;
    }
    /// The coefficient of friction that explains the speed after t seconds.
    double effective_friction(const World& world, double t) const {
        const double speed = velocity(world.bodies[0]).dot(downhill());
        return (std::sin(slope) - speed / (g * t)) / std::cos(slope);
    }
};
// [/slope]

// [bowling]
/// A bowling ball without spin: it slides, then rolls at 5/7 of its speed. 7 kg, radius 0.11 m.
struct BowlingBall {
    std::string name = "bowling_ball";
    double speed = 7;  // [m/s], along x
    double friction = 0.1;
    double radius = 0.11;
    double duration = 4;  // [s]
    Switches switches = rigid_contacts();

    World start() const {
        World world;
        world.walls = {Plane{}};
        world.surface.friction = friction;
        Body ball = solid_ball(7, radius, {0, radius, 0});
        ball.momentum.x() = ball.mass * speed;
        world.add(ball, Sphere{radius});
        return world;
    }
    double rolls_after() const { return 2 * speed / (7 * friction * earth_gravity); }
    double rolls_from() const { return 12 * speed * speed / (49 * friction * earth_gravity); }
    /// Speed [m/s] at time t.
    double exact_speed(double t) const {
        return t < rolls_after() ? speed - friction * earth_gravity * t : 5 * speed / 7;
    }
};
// [/bowling]

// [rolling]
/// A solid ball on a slope rolls at 5/7 of g sin(slope) if mu >= 2/7 tan(slope), else it slips.
inline double rolling_acceleration(double slope, double friction, double g = earth_gravity) {
    const double rolls = 5.0 / 7 * g * std::sin(slope);
    const double slips = g * (std::sin(slope) - friction * std::cos(slope));
    return friction >= 2.0 / 7 * std::tan(slope) ? rolls : slips;
}
// [/rolling]

/// The way [m] that a block (or a solid ball that does not turn yet) has slid and rolled down a
/// slope in t seconds, from `speed` [m/s] downhill: Coulomb's law in closed form. What friction
/// stops stays where tan(slope) <= mu.
inline double way_down(double slope, double friction, bool ball, double speed, double t,
                       double g = earth_gravity) {
    const double pull = g * std::sin(slope), grip = friction * g * std::cos(slope);
    const double slides = pull - grip;  // how its speed grows [m/s^2] while it slides
    // how fast the sliding of its lowest point shrinks: friction turns a ball as well
    const double shrinks = ball ? 7.0 / 2 * grip - pull : grip - pull;
    const double until = shrinks > 0 ? speed / shrinks : t;
    if (shrinks <= 0 || t <= until) return speed * t + slides * t * t / 2;
    const double way = speed * until + slides * until * until / 2;
    if (!ball) return way;
    const double rolls_at = speed + slides * until, left = t - until;
    return way + rolls_at * left + 5.0 / 7 * pull * left * left / 2;
}

}  // namespace nutshell
