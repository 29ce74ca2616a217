// The ground's grid: its directions, its spacing, and how a length is written.
#pragma once
#include <string>

#include "nutshell/picture/drawing.hpp"

namespace nutshell::picture {

struct GridAxes {
    Eigen::Vector3d u, v;
};
/// On level ground x and z; on another plane, the world's axes as far as they lie in it.
GridAxes grid_axes(const Ground& ground);

/// The ground's spacing, or 1, 2 or 5 times a power of ten that suits a drawing of this radius.
double grid_spacing(const Ground& ground, double radius);

/// A length as a person writes it: "5 cm", "2 km", "0.5 AU".
std::string written_length(double length, const std::string& unit);

}  // namespace nutshell::picture
