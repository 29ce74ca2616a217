// One small drawing with something of everything; the tests and their helper programs draw it.
#pragma once
#include <cmath>

#include "nutshell/picture/picture.hpp"

namespace small_scene {

namespace pic = nutshell::picture;
using Eigen::Vector3d;

inline constexpr pic::Size size{320, 180};

/// @param shift of the gold box along x [m]: what the reference picture must notice
inline pic::Drawing drawing(double shift = 0) {
    pic::Drawing d;
    d.add(pic::Ball{.centre = {-1, 0.5, 0}, .radius = 0.5});
    d.add(pic::Ball{
        .centre = {-1, 0.5, 1}, .radius = 0.4, .colour = pic::palette::exact, .look = pic::Look::ghost});
    d.add(pic::Ball{.centre = {0, 1.6, -1}, .radius = 0.2, .colour = pic::palette::star, .shines = true});
    const Eigen::Isometry3d pose =
        Eigen::Translation3d(0.8 + shift, 0.5, 0) * Eigen::AngleAxisd(0.5, Vector3d::UnitY());
    d.add(pic::Box{.pose = pose, .half_extents = {0.4, 0.5, 0.4}});
    d.add(pic::Tube{.points = pic::coil({-0.6, 0.4, 0}, {0.5, 0.4, 0}, 0.15, 6), .radius = 0.03});
    std::vector<Vector3d> path;
    for (int i = 0; i <= 40; ++i)
        path.push_back({-1.8 + 0.09 * i, 1.5 - 0.9 * (i / 20.0 - 1) * (i / 20.0 - 1), 0.5});
    d.add(pic::Trail{.points = path, .colour = pic::palette::explicit_euler, .shadow = true});
    d.add(pic::Trail{.points = {{-1.8, 0, 1}, {1.8, 0, 1}}, .colour = pic::palette::exact, .dashed = true});
    pic::Mesh sheet;
    sheet.points = {{-0.3, 1.2, -0.8}, {0.5, 1.2, -0.8}, {0.5, 0.4, -0.5}, {-0.3, 0.4, -0.5}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    sheet.colour = pic::palette::symplectic;
    d.add(sheet);
    d.add(pic::Arrow{.from = {0.8, 1, 0}, .vector = {0.5, 0.5, 0}, .colour = pic::palette::force});
    return d;
}

inline pic::Camera camera() {
    return {.eye = {1.2, 2.2, 5.5}, .target = {0, 0.7, 0}};
}

inline pic::Image image(double shift = 0) {
    return pic::render(drawing(shift), camera(), size);
}

}  // namespace small_scene
