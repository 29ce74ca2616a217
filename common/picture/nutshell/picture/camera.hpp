// Where a picture is taken from.
#pragma once
#include <Eigen/Dense>

#include "nutshell/picture/drawing.hpp"

namespace nutshell::picture {

/// A picture's width and height [pixels].
struct Size {
    int width = 960, height = 540;
};

/// A camera with perspective.
struct Camera {
    Eigen::Vector3d eye{0, 2, 8};                      ///< [m]
    Eigen::Vector3d target = Eigen::Vector3d::Zero();  ///< the point in the picture's middle [m]
    double field_of_view = 0.5;                        ///< from the bottom edge to the top edge [rad]
    Eigen::Vector3d up = Eigen::Vector3d::UnitY();     ///< what stands upright on the picture
};

/// How a camera is fitted to a drawing.
struct Fit {
    double margin = 0.10;        ///< share of the picture left free at each edge
    double field_of_view = 0.5;  ///< [rad]; small: like a long lens, hardly any perspective
    Eigen::Vector3d up = Eigen::Vector3d::UnitY();
};

/// The camera on the side `from` of the drawing (a direction of any length, pointing from the drawing to the
/// eye) that holds all of it, as large as the margin allows; a title and a caption get room of their own.
/// @throws std::invalid_argument if from is not finite, zero or along up, or the drawing is empty
Camera fit(const Drawing& drawing, const Eigen::Vector3d& from, Size size = {}, const Fit& how = {});

/// Where a point of the world lies on the picture [pixels, from the top left corner; x right, y down],
/// and its distance in front of the eye along the view [m] (not positive: not before it, and the pixel means
/// nothing).
Eigen::Vector3d project(const Camera& camera, Size size, const Eigen::Vector3d& point);

/// @throws std::invalid_argument if a number is not finite, the eye is the target, up is zero or along the
/// view,
///         or the field of view is not in (0, pi)
void check(const Camera& camera);

}  // namespace nutshell::picture
