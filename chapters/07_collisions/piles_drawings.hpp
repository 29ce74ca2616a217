// What the second half's figures show. All of it in this header, because the page's module is
// compiled from live/ alone.
#pragma once
#include <nutshell/picture/camera.hpp>
#include <nutshell/picture/drawing.hpp>
#include <nutshell/rest_scenes.hpp>

namespace nutshell {

namespace pic = picture;

/// A world's body number i, in a colour.
inline void add_body(pic::Drawing& drawing, const World& world, std::size_t i,
                     pic::Colour colour) {
    const Body& body = world.bodies[i];
    if (const auto* ball = std::get_if<Sphere>(&world.shapes[i])) {
        drawing.add(pic::Ball{.centre = body.position,
                              .radius = ball->radius,
                              .colour = colour,
                              .orientation = body.orientation});
        return;
    }
    if (const auto* box = std::get_if<Box>(&world.shapes[i])) {
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.linear() = rotation_matrix(body.orientation), pose.translation() = body.position;
        drawing.add(
            pic::Box{.pose = pose, .half_extents = box->half, .colour = colour, .marked = true});
    }
}

/// The colour of layer number i of n: steps from blue to gold, told apart in grey too.
inline pic::Colour layer_colour(std::size_t i, std::size_t n) {
    const float part = n > 1 ? static_cast<float>(i) / static_cast<float>(n - 1) : 0.0f;
    return pic::mix(pic::palette::body, pic::palette::gold, part);
}

}  // namespace nutshell
