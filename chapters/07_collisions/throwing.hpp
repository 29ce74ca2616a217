// A ball thrown by the pointer: press on a body and let go, and it flies there along the line of
// sight. All of it in this header, because the page's module is compiled from live/ alone.
#pragma once
#include <nutshell/live/figure.hpp>
#include <optional>
#include "piles_drawings.hpp"

namespace nutshell {

/// What the pointer holds; a figure passes its own grab, drag and release on.
class Throw {
  public:
    bool grab(const World& world, const live::Ray& ray) {
        held_ = false, drag(world, ray);
        return held_;
    }
    void drag(const World& world, const live::Ray& ray) {
        const std::optional<Vector3> at = aimed_at(world, ray);
        if (at) held_ = true, aim_ = *at, eye_ = ray.eye;
    }
    /// The ball starts 6 m before what it flies at. After the first `keep` bodies a world takes
    /// twelve balls; a further one takes the last one's place.
    void release(World& world, std::size_t keep, double mass, double radius, double speed) {
        if (!held_) return;
        held_ = false;
        const Vector3 way = (aim_ - eye_).normalized();
        const Vector3 from = aim_ - std::min(6.0, (aim_ - eye_).norm()) * way;
        Body ball =
            solid_ball(mass, radius, {from.x(), std::max(radius + 0.01, from.y()), from.z()});
        ball.momentum = ball.mass * speed * way;
        if (world.bodies.size() < keep + 12)
            world.add(ball, Sphere{radius});
        else
            world.bodies.back() = ball;
    }
    /// Where it will hit, as a ghost.
    void show(pic::Drawing& drawing, double radius) const {
        if (held_)
            drawing.add(pic::Ball{.centre = aim_,
                                  .radius = radius,
                                  .colour = pic::palette::explicit_euler,
                                  .look = pic::Look::ghost});
    }

  private:
    /// The point on the pointer's line nearest to the first body whose surrounding sphere it meets.
    static std::optional<Vector3> aimed_at(const World& world, const live::Ray& ray) {
        std::optional<Vector3> nearest;
        double way = immovable;
        for (std::size_t i = 0; i < world.bodies.size(); ++i) {
            const Vector3 to = world.bodies[i].position - ray.eye;
            const double along = to.dot(ray.direction);
            const double across = (to - along * ray.direction).norm();
            if (along > 0 && across < reach(world.shapes[i]) && along < way)
                way = along, nearest = ray.eye + along * ray.direction;
        }
        return nearest;
    }
    bool held_ = false;
    Vector3 aim_ = Vector3::Zero(), eye_ = Vector3::Zero();
};

}  // namespace nutshell
