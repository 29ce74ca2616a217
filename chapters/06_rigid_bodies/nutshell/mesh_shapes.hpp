// Chapter 6 · Meshes of simple solids, and three things made of them.
#pragma once
#include <nutshell/assembly.hpp>
#include <nutshell/mesh.hpp>

namespace nutshell {

// [box_mesh]
/// A box of edges `size` [m] about the origin.
inline Mesh box_mesh(const Vector3& size) {
    require_positive(size.minCoeff(), "box_mesh: the shortest edge [m]");
    Mesh mesh;
    for (int i = 0; i < 8; ++i)  // bit 0 of i says +x, bit 1 +y, bit 2 +z
        mesh.vertices.push_back(
            Vector3(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5)
                .cwiseProduct(size));
    constexpr std::array<std::array<int, 4>, 6> faces = {
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& [a, b, c, d] : faces) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    }
    return mesh;
}
// [/box_mesh]

/// A solid turned about z: the corners of `profile`, (distance from the axis, height) [m], from
/// the bottom to the top, on rings of `sides` vertices. The first and last corner are on the
/// axis.
/// @throws std::invalid_argument for a profile of fewer than three corners or fewer than 3 sides
inline Mesh turned_mesh(const std::vector<std::array<double, 2>>& profile, int sides) {
    require(profile.size() >= 3 && sides >= 3,
            "turned_mesh: three corners and three sides at least");
    require(profile.front()[0] == 0 && profile.back()[0] == 0,
            "turned_mesh: the profile must begin and end on the axis, or the mesh is open");
    Mesh mesh;
    const int rings = static_cast<int>(profile.size()) - 2, top = 1 + rings * sides;
    mesh.vertices.push_back({0, 0, profile.front()[1]});
    for (std::size_t ring = 1; ring + 1 < profile.size(); ++ring)
        for (int side = 0; side < sides; ++side) {
            const double angle = 2 * pi * side / sides, r = profile[ring][0];
            mesh.vertices.push_back({r * std::cos(angle), r * std::sin(angle), profile[ring][1]});
        }
    mesh.vertices.push_back({0, 0, profile.back()[1]});
    const auto at = [&](int ring, int side) { return 1 + ring * sides + side % sides; };
    for (int side = 0; side < sides; ++side) {
        mesh.triangles.push_back({0, at(0, side + 1), at(0, side)});
        for (int ring = 0; ring + 1 < rings; ++ring) {
            mesh.triangles.push_back({at(ring, side), at(ring, side + 1), at(ring + 1, side)});
            mesh.triangles.push_back(
                {at(ring, side + 1), at(ring + 1, side + 1), at(ring + 1, side)});
        }
        mesh.triangles.push_back({at(rings - 1, side), at(rings - 1, side + 1), top});
    }
    return mesh;
}

/// A cylinder about z with `sides` flat sides, corners on the true cylinder [m].
inline Mesh cylinder_mesh(double radius, double height, int sides) {
    require_positive(radius, "cylinder_mesh: the radius [m]");
    require_positive(height, "cylinder_mesh: the height [m]");
    return turned_mesh(
        {{0, -height / 2}, {radius, -height / 2}, {radius, height / 2}, {0, height / 2}}, sides);
}

/// A ball of `rings` bands and twice as many sides, corners on the true ball [m].
inline Mesh ball_mesh(double radius, int rings) {
    require_positive(radius, "ball_mesh: the radius [m]");
    require(rings >= 2, "ball_mesh: two bands at least");
    std::vector<std::array<double, 2>> profile;
    for (int i = 0; i <= rings; ++i) {
        const double angle = pi * i / rings;
        const bool pole = i == 0 || i == rings;
        profile.push_back({pole ? 0 : radius * std::sin(angle), -radius * std::cos(angle)});
    }
    return turned_mesh(profile, 2 * rings);
}

// [block]
/// A box of an assembly: its edges and its centre [m], its rotation and its density [kg/m^3].
struct Block {
    Vector3 size, place;
    Matrix3 rotation = Matrix3::Identity();
    double density = 1000;
    double mass() const { return density * size.prod(); }
};
// [/block]

// [three_things]
/// Two cubes of 0.2 m joined by a bar of 0.4 m.
inline std::vector<Block> dumbbell() {
    return {{{0.2, 0.2, 0.2}, {-0.3, 0, 0}},
            {{0.4, 0.05, 0.05}, {0, 0, 0}},
            {{0.2, 0.2, 0.2}, {0.3, 0, 0}}};
}

/// An iron head across the end of a wooden shaft.
inline std::vector<Block> hammer() {
    const Matrix3 upright = Matrix3::Identity();
    return {{{0.03, 0.3, 0.03}, {0, 0, 0}, upright, 700},
            {{0.12, 0.04, 0.04}, {0.01, 0.17, 0}, upright, 7800}};
}

/// The handle that turns over in a space station: a bar, and a stem from its middle.
inline std::vector<Block> t_handle() {
    return {{{0.12, 0.02, 0.02}, {0, 0, 0}}, {{0.02, 0.06, 0.02}, {0, 0.04, 0}}};
}
// [/three_things]

/// One mesh of blocks.
inline Mesh mesh_of(const std::vector<Block>& blocks) {
    Mesh mesh;
    for (const Block& b : blocks)
        mesh = merged(mesh, placed(box_mesh(b.size), b.rotation, b.place));
    return mesh;
}

/// The meshes in assets/: name and mesh, each of one material.
inline std::vector<std::pair<std::string, Mesh>> course_meshes() {
    const std::vector<Block> parts = hammer();
    return {{"dumbbell", mesh_of(dumbbell())},
            {"hammer_head", mesh_of({parts[1]})},
            {"hammer_shaft", mesh_of({parts[0]})},
            {"t_handle", mesh_of(t_handle())}};
}

/// The first line of such a file.
inline std::string mesh_comment(const std::string& name) {
    return name + ", metres, made by assets/make_meshes.cpp; licence: LICENSE";
}

// [three_ways]
/// Of blocks, by the formula of a box for each. Exact.
inline MassProperties by_boxes(const std::vector<Block>& blocks) {
    std::vector<Part> parts;
    for (const Block& b : blocks)
        parts.push_back(solid(b.mass(), box_inertia(b.mass(), b.size), b.place, b.rotation));
    return assemble(parts);
}

/// Of blocks, by the integrals over the skin of each. Exact.
inline MassProperties by_meshes(const std::vector<Block>& blocks) {
    std::vector<Part> parts;
    for (const Block& b : blocks)
        parts.push_back(
            {mass_properties(placed(box_mesh(b.size), b.rotation, b.place), b.density)});
    return assemble(parts);
}

/// Of blocks, cut into cells of about `cell` [m], each a particle. A particle has no inertia of
/// its own, a cell has: too little by the sum of those, an error of order two in the cell.
inline MassProperties by_particles(const std::vector<Block>& blocks, double cell) {
    require_positive(cell, "by_particles: the size of a cell [m]");
    std::vector<Particle> cloud;
    for (const Block& b : blocks) {
        const Eigen::Array3d counts = (b.size.array() / cell).round().max(1);
        const Vector3 step = b.size.array() / counts;
        for (double i = 0; i < counts.x(); ++i)
            for (double j = 0; j < counts.y(); ++j)
                for (double k = 0; k < counts.z(); ++k) {
                    const Vector3 in_box =
                        (Eigen::Array3d(i, j, k) + 0.5).matrix().cwiseProduct(step) - b.size / 2;
                    cloud.push_back({b.mass() / counts.prod(), b.rotation * in_box + b.place,
                                     Vector3::Zero()});
                }
    }
    return mass_properties(cloud);
}
// [/three_ways]

}  // namespace nutshell
