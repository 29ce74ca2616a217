// Chapter 6 · Thrown things: made of blocks, thrown end over end or in disorder.
#pragma once
#include <nutshell/free_top.hpp>
#include <nutshell/joined.hpp>
#include <nutshell/mesh_shapes.hpp>
#include <nutshell/need.hpp>
#include <nutshell/newton_scenes.hpp>

namespace nutshell {

// [thrown_thing]
/// A thing of blocks, thrown. Gravity pulls at its centre and twists nothing.
/// exact: the centre's parabola, and FreeTop.
struct ThrownThing {
    std::string name;
    std::vector<Block> blocks;
    MassProperties thing;  ///< in the axes in which its blocks are given
    Vector3 tip;           ///< a point of it that the eye follows [m], in these axes
    Body start;
    double duration;  ///< [s]: until the centre is back at its height
    Need need{3.0 / 960, "m", "one pixel of its snapshot, 3 m across 960 pixels"};
    FreeTop solution;

    /// @param velocity  of the centre [m/s]    @param omega  [rad/s], axes of the blocks = world
    ThrownThing(std::string called, std::vector<Block> made_of, const Vector3& its_tip,
                const Vector3& velocity, const Vector3& omega)
        : name(std::move(called)),
          blocks(std::move(made_of)),
          thing(by_boxes(blocks)),
          tip(its_tip),
          start(thrown(thing, velocity, omega)),
          duration(-2 * velocity.y() / gravity.y()),
          solution(start.inertia, start.orientation, start.angular_momentum) {}

    Wrench operator()(const Body& body, double) const {
        return {body.mass * gravity, Vector3::Zero()};
    }
    /// A point of the thing, p [m] in the axes of its blocks, in the body's own axes.
    Vector3 in_body(const Vector3& p) const {
        return rotate(inverse(start.orientation), p - thing.centre);
    }
    Body exact(double t) const {
        Body body = start;
        body.position += velocity(start) * t + gravity * t * t / 2;
        body.momentum += start.mass * gravity * t;
        body.orientation = solution.pose(t);
        return body;
    }
    /// Distance [m] between computed and exact tip.
    double error(const Body& body, double t) const {
        return (point_of(body, in_body(tip)) - point_of(exact(t), in_body(tip))).norm();
    }
    double energy(const Body& body) const {
        return kinetic_energy(body) - body.mass * gravity.dot(body.position);
    }

  private:
    static Body thrown(const MassProperties& thing, const Vector3& velocity,
                       const Vector3& omega) {
        Body body = spinning(body_of(thing), omega);
        body.position.setZero(), body.momentum = body.mass * velocity;
        return body;
    }
};

/// Thrown end over end, about the axis that points at you; the eye follows one end.
inline ThrownThing thrown_dumbbell() {
    return {"dumbbell", dumbbell(), {0.4, 0, 0}, {2.5, 4.5, 0}, {0, 0, -9}};
}
inline ThrownThing thrown_hammer() {
    return {"hammer", hammer(), {0, -0.15, 0}, {2.5, 4.5, 0}, {0, 0, -9}};
}
inline ThrownThing thrown_t_handle() {
    return {"t_handle", t_handle(), {0, 0.07, 0}, {2.5, 4.5, 0}, {0, 0, -9}};
}
/// The hammer thrown badly: about no principal axis.
inline ThrownThing tumbling_hammer() {
    return {"tumbling_hammer", hammer(), {0, -0.15, 0}, {2.5, 4.5, 0}, {3, 2, -8}};
}
// [/thrown_thing]

}  // namespace nutshell
