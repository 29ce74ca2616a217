// The names this course uses for Eigen's types. World frame unless said: right-handed, Y up, SI units.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>

namespace nutshell {

using Vector3 = Eigen::Vector3d;        ///< a point or a direction in space
using Matrix3 = Eigen::Matrix3d;        ///< a linear map of space
using Quaternion = Eigen::Quaterniond;  ///< an orientation, stored x, y, z, w
using Vector = Eigen::VectorXd;         ///< any number of numbers

inline constexpr double pi = 3.14159265358979323846;

}  // namespace nutshell
