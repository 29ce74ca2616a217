// Trails as ribbons of constant width on the picture.
#pragma once
#include <Eigen/Dense>
#include <utility>
#include <vector>

namespace nutshell::picture {

struct RibbonVertex {
    Eigen::Vector4f place;   ///< clip coordinates
    Eigen::Vector2f ribbon;  ///< across and along [pixels]
    Eigen::Vector4f colour;  ///< linear, with opacity
};

/// What a ribbon is made from: a point in clip coordinates and how opaque it is there.
struct RibbonPoint {
    Eigen::Vector4d clip;
    double opacity;
};

/// A line's points with their opacities as clip coordinates, cut where it comes nearer to the eye than
/// `nearest`.
std::vector<std::vector<RibbonPoint>> cut_runs(const std::vector<std::pair<Eigen::Vector3d, double>>& points,
                                               const Eigen::Matrix4d& to_clip, double nearest);

/// A triangle strip through the points. @param half_width, size [pixels]
std::vector<RibbonVertex> ribbon(const std::vector<RibbonPoint>& points, const Eigen::Vector3f& colour,
                                 double half_width, const Eigen::Vector2d& size);

}  // namespace nutshell::picture
