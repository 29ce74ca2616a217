// Triangles of the things a drawing holds, ready for OpenGL. Triangle lists: three vertices each, outward
// normals.
#pragma once
#include <Eigen/Dense>
#include <vector>

#include "nutshell/picture/drawing.hpp"

namespace nutshell::picture {

struct Vertex {
    Eigen::Vector3f position, normal;
};
using Vertices = std::vector<Vertex>;

/// Radius 1 about the origin; `rings` from pole to pole.
Vertices unit_ball(int rings);
/// Radius 1 about y from 0 to 1, without and with its end discs.
Vertices unit_rod(int sides);
/// Base of radius 1 at y = 0, tip at y = 1.
Vertices unit_cone(int sides);
/// A box with edges rounded by a small share of its smallest half extent; lengths as given.
Vertices rounded_box(const Eigen::Vector3d& half_extents);
/// A round tube through points.
Vertices tube(const std::vector<Eigen::Vector3d>& points, double radius, int sides);
/// The mesh in its own frame.
Vertices triangles(const Mesh& mesh);

}  // namespace nutshell::picture
