// A camera's axes, as drawing needs them.
#pragma once
#include "nutshell/picture/camera.hpp"

namespace nutshell::picture {

struct View {
    View(const Camera& camera, double aspect_ratio);
    Eigen::Vector3d eye, right, up, back;  ///< back: from the target to the eye
    double tangent;                        ///< of half the field of view, upwards
    double aspect;                         ///< width / height
    /// In the camera's frame: right, up, back (so what is in front has negative z).
    Eigen::Vector3d to_camera(const Eigen::Vector3d& point) const;
};

}  // namespace nutshell::picture
