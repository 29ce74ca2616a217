// What the arch's figures show. All of it in this header, because the page's module is compiled
// from live/ alone.
#pragma once
#include <nutshell/arch_statics.hpp>
#include "piles_drawings.hpp"

namespace nutshell {

/// The stones in two greys in turn, and what else is in the world in a colour.
inline void add_arch(pic::Drawing& drawing, const Arch& arch, const World& world,
                     std::size_t stones) {
    drawing.stage({{0, arch.radius / 2, 0}, 1.6 * arch.radius});
    drawing.ground({.height = 0, .spacing = 1});
    const pic::Colour other = pic::mix(pic::palette::steel, pic::palette::paper, 0.45f);
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
        add_body(drawing, world, i,
                 i >= stones  ? pic::palette::explicit_euler
                 : i % 2 == 0 ? pic::palette::steel
                              : other);
}

/// The line of thrust: through the points of the joints at which an engine's contacts press, on the
/// front of the arch. A joint that passes nothing on breaks it.
inline void add_thrust(pic::Drawing& drawing, const Arch& arch,
                       const std::vector<Passed>& joints) {
    pic::Trail line{.points = {}, .colour = pic::palette::force, .width = 5};
    const auto finish = [&] {
        if (line.points.size() > 1) drawing.add(line);
        line.points.clear();
    };
    for (const Passed& joint : joints) {
        if (joint.force.norm() > 0)
            line.points.push_back({joint.at.x(), joint.at.y(), arch.depth / 2 + 0.02});
        else
            finish();
    }
    finish();
}

/// A dot at each joint that has opened by more than two degrees: the hinge, where it still presses.
inline void add_hinges(pic::Drawing& drawing, const Arch& arch, const World& world,
                       const std::vector<Passed>& joints) {
    const Body floor;
    const World start = arch.start();
    const auto turned = [&](std::size_t i) {
        return world.bodies[i].orientation * inverse(start.bodies[i].orientation);
    };
    for (std::size_t k = 0; k < joints.size(); ++k) {
        const Quaternion left = k > 0 ? turned(k - 1) : floor.orientation,
                         right = k < world.bodies.size() ? turned(k) : floor.orientation;
        if (joints[k].force.norm() > 0 && angle_between(left, right) > 2 * pi / 180)
            drawing.add(pic::Ball{.centre = {joints[k].at.x(), joints[k].at.y(), arch.depth / 2},
                                  .radius = 0.06,
                                  .colour = pic::palette::force});
    }
}

/// From the front, the whole arch and a little beside it.
inline pic::Camera arch_camera(const Arch& arch, pic::Size size) {
    pic::Drawing room;
    const double r = arch.radius;
    room.add(pic::Box{.pose = Eigen::Isometry3d(Eigen::Translation3d(0, 0.58 * r, 0)),
                      .half_extents = {1.25 * r, 0.58 * r, arch.depth / 2}});
    return pic::fit(room, {0.14, 0.12, 1}, size, {.margin = 0.02});
}

}  // namespace nutshell
