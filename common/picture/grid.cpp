#include "grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace nutshell::picture {

using Eigen::Vector3d;

GridAxes grid_axes(const Ground& ground) {
    const Vector3d& n = ground.normal;
    const Vector3d x = Vector3d::UnitX() - n.x() * n;
    const Vector3d u = x.norm() > 0.5 ? x.normalized() : (Vector3d::UnitZ() - n.z() * n).normalized();
    return {u, u.cross(n)};
}

double grid_spacing(const Ground& ground, double radius) {
    if (ground.spacing > 0) return ground.spacing;
    const double wanted = radius / 4, power = std::pow(10, std::floor(std::log10(wanted)));
    const double digit = wanted / power;
    return power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
}

std::string written_length(double length, const std::string& unit) {
    double number = length;
    std::string name = unit;
    if (unit == "m" && length >= 999.5) {
        number = length / 1000;
        name = "km";
    } else if (unit == "m" && length < 0.00995) {
        number = length * 1000;
        name = "mm";
    } else if (unit == "m" && length < 0.995) {
        number = length * 100;
        name = "cm";
    }
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.3g", number);
    return digits + (name.empty() ? "" : " " + name);
}

}  // namespace nutshell::picture
