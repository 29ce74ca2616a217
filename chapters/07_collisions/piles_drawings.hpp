// What the second half's figures show. All of it in this header, because the page's module is
// compiled from live/ alone.
#pragma once
#include <nutshell/picture/camera.hpp>
#include <nutshell/picture/drawing.hpp>
#include <nutshell/rest_scenes.hpp>

namespace nutshell {

namespace pic = picture;

/// The box's edges on the floor and upright.
inline void add_room(pic::Drawing& drawing, double half_width, double height) {
    for (const int x : {-1, 1})
        for (const int z : {-1, 1}) {
            const Vector3 foot(x * half_width, 0, z * half_width);
            drawing.add(
                pic::Rod{.from = foot, .to = foot + Vector3(0, height, 0), .radius = 0.012});
        }
    for (const double y : {0.0, height})
        drawing.add(pic::Tube{.points = {{-half_width, y, -half_width},
                                         {half_width, y, -half_width},
                                         {half_width, y, half_width},
                                         {-half_width, y, half_width},
                                         {-half_width, y, -half_width}},
                              .radius = 0.012});
}

/// A world's body number i, in a colour; with marks that show how it is turned.
inline void add_body(pic::Drawing& drawing, const World& world, std::size_t i, pic::Colour colour,
                     bool marked = true) {
    const Body& body = world.bodies[i];
    if (const auto* ball = std::get_if<Sphere>(&world.shapes[i])) {
        pic::Ball shown{.centre = body.position, .radius = ball->radius, .colour = colour};
        if (marked) shown.orientation = body.orientation;
        drawing.add(shown);
        return;
    }
    if (const auto* box = std::get_if<Box>(&world.shapes[i])) {
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.linear() = rotation_matrix(body.orientation), pose.translation() = body.position;
        drawing.add(pic::Box{
            .pose = pose, .half_extents = box->half, .colour = colour, .marked = marked});
    }
    if (const auto* hull = std::get_if<Hull>(&world.shapes[i])) {
        pic::Mesh shown{.points = hull->form->corners, .colour = colour};
        shown.pose.linear() = rotation_matrix(body.orientation);
        shown.pose.translation() = body.position;
        for (const auto& face : hull->form->faces)
            for (std::size_t k = 2; k < face.size(); ++k)
                shown.triangles.push_back({static_cast<int>(face[0]),
                                           static_cast<int>(face[k - 1]),
                                           static_cast<int>(face[k])});
        drawing.add(shown);
    }
}

/// The colour of layer number i of n: steps from blue to gold, told apart in grey too.
inline pic::Colour layer_colour(std::size_t i, std::size_t n) {
    const float part = n > 1 ? static_cast<float>(i) / static_cast<float>(n - 1) : 0.0f;
    return pic::mix(pic::palette::body, pic::palette::gold, part);
}

}  // namespace nutshell
