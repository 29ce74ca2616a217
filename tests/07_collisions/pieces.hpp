// Convex pieces by chance, for the tests of hulls.
#pragma once
#include <nutshell/hull_shapes.hpp>
#include <nutshell/mesh_shapes.hpp>
#include "near.hpp"

namespace nutshell {

inline Body turned_body(Chance& chance, const Vector3& place) {
    Body body;
    body.position = place;
    const Vector3 axis = chance.direction();  // first: arguments are evaluated in any order
    body.orientation = quaternion_about(axis, chance(0, 2 * pi));
    return body;
}

/// A tetrahedron by chance, not too flat.
inline Mesh tetrahedron(Chance& chance, double size) {
    for (;;) {
        Mesh mesh;
        for (int i = 0; i < 4; ++i) mesh.vertices.push_back(chance.vector(size));
        const auto& v = mesh.vertices;
        const double six = (v[1] - v[0]).dot((v[2] - v[0]).cross(v[3] - v[0]));
        if (std::abs(six) < 0.5 * size * size * size) continue;
        mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
        if (six < 0)
            for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
        return mesh;
    }
}

/// A prism over a regular polygon, its first corner moved a little outwards: no symmetry.
inline Mesh prism(int sides, double radius, double depth) {
    std::vector<std::array<double, 2>> polygon;
    for (int i = 0; i < sides; ++i) {
        const double r = i == 0 ? 1.1 * radius : radius, angle = 2 * pi * i / sides;
        polygon.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return prism_mesh(polygon, depth);
}

inline Piece any_piece(Chance& chance, double size) {
    const int kind = static_cast<int>(chance(0, 3));
    if (kind == 0) return piece_of(tetrahedron(chance, size), 1000);
    return piece_of(prism(kind == 1 ? 3 : 5, size, chance(0.5, 1.5) * size), 1000);
}

}  // namespace nutshell
