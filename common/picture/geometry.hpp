// Triangles of the things a drawing holds, ready for OpenGL; anticlockwise as seen from outside, outward
// normals.
#pragma once
#include <Eigen/Dense>
#include <cstdint>
#include <vector>

#include "nutshell/picture/drawing.hpp"

namespace nutshell::picture {

struct Vertex {
    Eigen::Vector3f position, normal;
};

/// Vertices, and three indices into them a triangle.
struct Triangles {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// Radius 1 about the origin; `rings` from pole to pole.
Triangles unit_ball(int rings);
/// The four octants of the ball in which x y z is positive, or the other four.
Triangles unit_octants(int rings, bool even);
/// Radius 1 about y, from y = 0 to 1, with its end discs.
Triangles unit_rod(int sides);
/// Base of radius 1 at y = 0, tip at y = 1.
Triangles unit_cone(int sides);
/// A box about the origin with edges rounded by `bevel`, less than the smallest half extent.
Triangles rounded_box(const Eigen::Vector3d& half_extents, double bevel);
/// A round tube through points.
Triangles tube(const std::vector<Eigen::Vector3d>& points, double radius, int sides);
/// The mesh in its own frame.
Triangles triangles_of(const Mesh& mesh);

}  // namespace nutshell::picture
