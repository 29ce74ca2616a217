// Chapter 7 · The bouncing ball: infinitely many bounces in finite time, from impact to impact,
// step by step, and as printed.
#pragma once
#include <nutshell/forces.hpp>
#include <nutshell/impacts.hpp>
#include <nutshell/need.hpp>
#include <nutshell/time_of_impact.hpp>

namespace nutshell {

// [bouncing_ball]
/// A ball dropped on a floor (scene S9): radius 0.1 m, its lowest point 1 m up, restitution 0.9.
/// exact: closed form; accurate to about 1e-14 s in the time of each bounce.
struct BouncingBall {
    std::string name = "bouncing_ball";
    Sphere ball{0.1};
    Plane floor{{0, 1, 0}, 0};
    double restitution = 0.9;
    double g = earth_gravity;  // [m/s^2]
    Particle start{1, {0, 1.1, 0}, {0, 0, 0}};
    double duration = 12;  // [s]
    Need need{0.005, "m", "half a pixel of a picture 5 m across 480 pixels, rms of 3 s"};

    Vector3 operator()(const Particle& body, double) const { return gravity_force(body.mass, g); }
    /// How far [m] its lowest point falls.
    double drop() const { return distance_to(floor, start.position) - ball.radius; }
    /// When it has bounced for the last time [s]: sqrt(2 h/g) (1 + e)/(1 - e). Eq. (7.b).
    double rest_time() const {
        return std::sqrt(2 * drop() / g) * (1 + restitution) / (1 - restitution);
    }
    /// The way it has gone by then [m]: h (1 + e^2)/(1 - e^2).
    double path() const {
        return drop() * (1 + restitution * restitution) / (1 - restitution * restitution);
    }
    /// How many bounces are over when `left` [s] are left until the rest: after n of them that is
    /// 2 sqrt(2 h/g) e^n/(1 - e), so each tenth of the time takes as many as the one before.
    double bounces_until(double left) const {
        const double fall = std::sqrt(2 * drop() / g);
        return std::log(left * (1 - restitution) / (2 * fall)) / std::log(restitution);
    }
    Particle exact(double t) const {
        const double fall = std::sqrt(2 * drop() / g);
        if (t < fall) return at(drop() - g * t * t / 2, -g * t);
        double speed = restitution * g * fall, since = t - fall;  // of the flight that t is in
        while (since > 2 * speed / g && t < rest_time() && speed > 1e-12 * g * fall)
            since -= 2 * speed / g, speed *= restitution;
        if (t >= rest_time() || since > 2 * speed / g) return at(0, 0);
        return at(since * (speed - g * since / 2), speed - g * since);
    }
    double error(const Particle& body, double t) const {
        return std::abs(body.position.y() - exact(t).position.y());
    }

  private:
    Particle at(double height, double speed) const {
        const double rest = floor.offset + ball.radius;
        return {start.mass, {0, rest + height, 0}, {0, start.mass * speed, 0}};
    }
};
// [/bouncing_ball]

// [event_driven]
/// What is left of an endless row of bounces is over when it would take less than this [s].
inline constexpr double zeno = 1e-10;

/// The ball after `dt` seconds, from impact to impact: each flight is a parabola, each time of
/// impact exact. Bounces that are all over within `zeno` seconds end in rest on the floor.
/// @param at_impact  called as at_impact(seconds since the start, ball) after each
template <class Visit>
Particle bounce_by_events(const BouncingBall& scene, Particle body, double dt,
                          const Visit& at_impact) {
    const Vector3 fall{0, -scene.g, 0}, n = scene.floor.normal;
    Particle earth{immovable};
    const auto fly = [&](double t) {
        body.position += velocity(body) * t + fall * t * t / 2;
        body.momentum += body.mass * fall * t;
    };
    for (double now = 0;;) {
        const auto t =
            time_of_impact(scene.ball, body.position, velocity(body), fall, scene.floor);
        if (!t || now + *t > dt) return fly(dt - now), body;
        fly(*t);
        now += *t;
        collide(earth, body, n, scene.restitution);
        at_impact(now, body);
        const double up = n.dot(velocity(body));
        if (2 * up < zeno * scene.g * (1 - scene.restitution)) {  // the row's sum, 2 v/g/(1 - e)
            body.momentum -= n * n.dot(body.momentum);
            body.position += n * (scene.ball.radius - distance_to(scene.floor, body.position));
            return body;
        }
    }
}
inline Particle bounce_by_events(const BouncingBall& scene, const Particle& body, double dt) {
    return bounce_by_events(scene, body, dt, [](double, const Particle&) {});
}
// [/event_driven]

// [floor_rule]
/// The floor for a method that steps: where a step ends below it, an impact if the ball still
/// goes down, and the ball is set on the floor. The impact is up to a step late: order 1.
inline void bounce_off_floor(const BouncingBall& scene, Particle& body) {
    // exercise 7.4
    const double depth = scene.ball.radius - distance_to(scene.floor, body.position);
    if (depth < 0) return;
    Particle earth{immovable};
    collide(earth, body, scene.floor.normal, scene.restitution);
    body.position += depth * scene.floor.normal;
    // end 7.4
}
// [/floor_rule]

// [pushing_floor]
/// The floor of many engines (Baumgarte's): an impact, and `push` times the depth over dt as
/// extra speed, to be out of the floor in 1/push steps. The speed stays: the ball gains energy.
/// @param push  0 to 1
inline void bounce_with_push(const BouncingBall& scene, Particle& body, double dt, double push) {
    const double depth = scene.ball.radius - distance_to(scene.floor, body.position);
    if (depth < 0) return;
    Particle earth{immovable};
    collide(earth, body, scene.floor.normal, scene.restitution);
    body.momentum += body.mass * push * depth / dt * scene.floor.normal;
}
// [/pushing_floor]

// [printed_floor]
/// The floor as printed in `Universe::evolve`: the centre, not the lowest point, is tested; a
/// ball on its way up is sent down again; depth is lost (E62, E64).
inline void bounce_as_printed(Particle& body) {
    if (body.position.y() < 0) {
        body.position.y() = 0;
        body.momentum.y() = -0.9 * body.momentum.y();
    }
}
// [/printed_floor]

}  // namespace nutshell
