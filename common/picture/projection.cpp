#include "projection.hpp"

#include <algorithm>
#include <limits>

namespace nutshell::picture {

using Eigen::Matrix4d, Eigen::Vector3d;

Projection projection(const View& view, const Vector3d& eye, double near, double far) {
    Matrix4d look = Matrix4d::Identity();
    look.row(0).head<3>() = view.right.transpose();
    look.row(1).head<3>() = view.up.transpose();
    look.row(2).head<3>() = view.back.transpose();
    look.topRightCorner<3, 1>() = -(look.topLeftCorner<3, 3>() * eye);
    Matrix4d lens = Matrix4d::Zero();
    lens(0, 0) = 1 / (view.tangent * view.aspect);
    lens(1, 1) = 1 / view.tangent;
    lens(2, 2) = (far + near) / (near - far);
    lens(2, 3) = 2 * far * near / (near - far);
    lens(3, 2) = -1;
    return {lens * look, near};
}

Depths depths_of(const std::vector<Extent>& things, const Frame& frame, const View& view,
                 const Vector3d& eye) {
    Depths depths{std::numeric_limits<double>::infinity(), 0};
    for (const Extent& thing : things) {
        const double depth = -view.back.dot(frame(thing.centre) - eye), radius = thing.radius / frame.unit;
        depths.nearest = std::min(depths.nearest, depth - radius);
        depths.farthest = std::max(depths.farthest, depth + radius);
    }
    return depths;
}

SunView sun_view(const std::vector<Extent>& casters, const Vector3d& sun) {
    SunView out;
    if (casters.empty()) {
        out.matrix(0, 3) = 10;  // everything lies outside, so everything is lit
        return out;
    }
    const Vector3d right = sun.unitOrthogonal(), up = sun.cross(right);
    Eigen::Matrix3d axes;
    axes << right.transpose(), up.transpose(), -sun.transpose();
    Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Extent& caster : casters) {
        const Vector3d p = axes * caster.centre;
        low = low.cwiseMin(p - Vector3d::Constant(caster.radius));
        high = high.cwiseMax(p + Vector3d::Constant(caster.radius));
    }
    const Vector3d air = 0.02 * (high - low) + Vector3d::Constant(0.01);
    low -= air;
    high += air;
    out.sides = high - low;
    out.matrix.topLeftCorner<3, 3>() = out.sides.cwiseInverse().asDiagonal() * axes;
    out.matrix.topRightCorner<3, 1>() = -low.cwiseQuotient(out.sides);
    return out;
}

}  // namespace nutshell::picture
