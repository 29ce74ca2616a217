// Chapter 7 · Scenes of one impact with spin: a ball on the floor, a rod on its end.
#pragma once
#include <nutshell/contacts.hpp>
#include <nutshell/impulse.hpp>
#include <nutshell/need.hpp>

namespace nutshell {

// [spinning_ball]
/// A ball with back-spin meets the floor (scene S10): 1 kg, radius 0.1 m, restitution 0.5. With
/// mu = 0.2 it slides all through the impact, with 0.8 it ends up rolling.
struct SpinningBall {
    std::string name = "spinning_ball";
    Surface surface{0.5, 0.2};
    double radius = 0.1;         // [m]
    Vector3 velocity{3, -4, 0};  // [m/s]
    Vector3 spin{0, 0, 20};      // [rad/s], about z
    Need need{1e-12, "of the impact's speed", "round-off: an impact is one formula"};

    SpinningBall() = default;
    explicit SpinningBall(double friction) : surface{0.5, friction} {}

    Body ball() const {
        Body body;
        body.inertia = Vector3::Constant(0.4 * body.mass * radius * radius);
        body.position = {0, radius, 0}, body.momentum = body.mass * velocity;
        return spinning(body, spin);
    }
    Contact contact() const { return {{0, 0, 0}, {0, 1, 0}, 0, 0}; }
    Body after(const ImpactLaw& law) const {
        Body floor = immovable_body(), body = ball();
        collide(floor, body, contact(), surface, law);
        return body;
    }
    /// Closed form of the clamped law, in the plane of the drawing: sticking takes 2/7 of the
    /// point's tangential momentum, sliding mu (1 + e) of the normal one.
    Body exact() const {
        Body body = ball();
        const double down = -velocity.y(), point = velocity.x() + radius * spin.z();
        const double normal = body.mass * (1 + surface.restitution) * down;
        const double stick = 2.0 / 7 * body.mass * std::abs(point);
        const double pull = -std::copysign(std::min(stick, surface.friction * normal), point);
        body.momentum += Vector3(pull, normal, 0);
        body.angular_momentum += Vector3(0, 0, radius * pull);
        return body;
    }
};
// [/spinning_ball]

// [falling_rod]
/// A rod falls on its end, smooth unless said (scene S10): half length 0.5 m, radius 0.05 m, 30
/// degrees to the floor, 5 m/s down, restitution 1.
struct FallingRod {
    std::string name = "falling_rod";
    Capsule shape{0.5, 0.05};
    Surface surface{1, 0};
    double slope = pi / 6;  // [rad]
    double speed = 5;       // [m/s], down
    double sideways = 0;    // [m/s], along x
    double spin = 0;        // [rad/s], about z

    /// A rough one, at 40 degrees, turning: restitution as a wish gives it energy.
    static FallingRod rough() {
        FallingRod rod;
        rod.surface = {0.9, 0.4}, rod.slope = 40 * pi / 180, rod.speed = 1, rod.spin = 4;
        return rod;
    }

    Body rod() const {
        Body body;
        body.inertia = {0.09, 0.00125, 0.09};
        body.orientation = quaternion_about({0, 0, 1}, slope - pi / 2);
        body.position.y() = shape.half_length * std::sin(slope) + shape.radius;
        body.momentum = body.mass * Vector3(sideways, -speed, 0);
        return spinning(body, {0, 0, spin});
    }
    Body after(const ImpactLaw& law) const {
        Body floor = immovable_body(), body = rod();
        std::vector<Contact> found;
        find_contacts(Plane{}, shape, body, 1e-9, found);
        collide(floor, body, found.at(0), surface, law);
        return body;
    }
    /// Closed form of the smooth one that does not turn yet: j = 2 v / (1/m + x^2/I), x how far
    /// the end is beside the centre.
    Body exact() const {
        Body body = rod();
        const double x = -shape.half_length * std::cos(slope);
        const double j =
            (1 + surface.restitution) * speed / (1 / body.mass + x * x / body.inertia.z());
        body.momentum.y() += j, body.angular_momentum.z() += x * j;
        return body;
    }
};
// [/falling_rod]

}  // namespace nutshell
