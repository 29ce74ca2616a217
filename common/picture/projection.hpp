// What the eye sees and what the sun sees, as matrices.
#pragma once
#include <Eigen/Dense>
#include <vector>

#include "nutshell/picture/drawing.hpp"
#include "pieces.hpp"
#include "view.hpp"

namespace nutshell::picture {

/// From the frame to clip coordinates.
struct Projection {
    Eigen::Matrix4d matrix;
    double near;  ///< what is nearer than this is not drawn
};
/// @param eye, near, far  in the frame's units
Projection projection(const View& view, const Eigen::Vector3d& eye, double near, double far);

/// Between which depths before the eye things lie, in the frame's units; nothing lies between infinity
/// and zero.
struct Depths {
    double nearest, farthest;
};
Depths depths_of(const std::vector<Extent>& things, const Frame& frame, const View& view,
                 const Eigen::Vector3d& eye);

/// How the sun sees what casts shadows: a map from the frame to the cube from 0 to 1, and how long the
/// cube's sides are in the frame.
struct SunView {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    Eigen::Vector3d sides = Eigen::Vector3d::Ones();
};
/// Holds the casters, tightly: all of the map's texels serve. @param sun unit vector towards it
SunView sun_view(const std::vector<Extent>& casters, const Eigen::Vector3d& sun);

}  // namespace nutshell::picture
