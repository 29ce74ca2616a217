// Chapter 7 · Hulls out of meshes: a stone as it is cut becomes a body and its shape.
#pragma once
#include <nutshell/hull.hpp>
#include <nutshell/joined.hpp>
#include <nutshell/mesh.hpp>

namespace nutshell {

/// A prism: a polygon, its corners (x, y) [m] counter-clockwise, drawn out along z from -depth/2
/// to depth/2.
inline Mesh prism_mesh(const std::vector<std::array<double, 2>>& polygon, double depth) {
    require(polygon.size() >= 3, "prism_mesh: three corners at least");
    require_positive(depth, "prism_mesh: the depth [m]");
    Mesh mesh;
    for (const double z : {-depth / 2, depth / 2})
        for (const auto& [x, y] : polygon) mesh.vertices.push_back({x, y, z});
    const int n = static_cast<int>(polygon.size());
    for (int i = 0; i < n; ++i) {
        const int next = (i + 1) % n;
        mesh.triangles.push_back({i, next, n + next}),
            mesh.triangles.push_back({i, n + next, n + i});
        if (i < 2) continue;
        mesh.triangles.push_back({0, i, i - 1}), mesh.triangles.push_back({n, n + i - 1, n + i});
    }
    return mesh;
}

// [faces]
/// The faces of a convex mesh as loops of corners: triangles that lie in one plane are one face.
/// Every vertex must be a corner of its own.
/// @throws std::invalid_argument if the outline of a face is not one loop
inline std::vector<std::vector<std::size_t>> faces_of(const Mesh& mesh) {
    struct Side {
        std::size_t from, to;
    };
    std::vector<Vector3> normals;
    std::vector<std::vector<Side>> outlines;  // one for each normal
    for (const auto& triangle : mesh.triangles) {
        std::array<std::size_t, 3> corner{};
        for (std::size_t k = 0; k < 3; ++k) corner[k] = static_cast<std::size_t>(triangle[k]);
        const Vector3& a = mesh.vertices[corner[0]];
        const Vector3 n =
            (mesh.vertices[corner[1]] - a).cross(mesh.vertices[corner[2]] - a).normalized();
        std::size_t f = 0;
        while (f < normals.size() && n.dot(normals[f]) < 1 - 1e-9) ++f;
        if (f == normals.size()) normals.push_back(n), outlines.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {  // a side run along both ways is inside the face
            const std::size_t from = corner[k], to = corner[(k + 1) % 3];
            auto& outline = outlines[f];
            const auto back = std::find_if(outline.begin(), outline.end(), [&](const Side& side) {
                return side.from == to && side.to == from;
            });
            if (back == outline.end())
                outline.push_back({from, to});
            else
                outline.erase(back);
        }
    }
    std::vector<std::vector<std::size_t>> faces;
    for (const auto& outline : outlines) {
        std::vector<std::size_t> loop;
        std::size_t at = outline.empty() ? 0 : outline[0].from;
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const auto next = std::find_if(outline.begin(), outline.end(),
                                           [&](const Side& side) { return side.from == at; });
            require(next != outline.end(), "faces_of: a face has no closed outline");
            loop.push_back(at), at = next->to;
        }
        require(loop.size() >= 3 && at == loop[0], "faces_of: a face has no closed outline");
        faces.push_back(loop);
    }
    return faces;
}
// [/faces]

// [piece]
/// A piece of stone: a body and its shape.
struct Piece {
    Body body;
    Hull hull;
};

/// The piece that a convex mesh is, at rest where the mesh lies: its mass, centre and principal
/// axes are the body's (chapter 6), and its corners are moved into the body's axes.
/// @param density  [kg/m^3]
/// @throws std::invalid_argument with the reason if the mesh is open, not convex or flat
inline Piece piece_of(const Mesh& mesh, double density) {
    const Body body = body_of(mass_properties(mesh, density));
    std::vector<Vector3> corners;
    for (const Vector3& point : mesh.vertices)
        corners.push_back(rotate(inverse(body.orientation), point - body.position));
    return {body, hull_of(corners, faces_of(mesh))};
}
// [/piece]

}  // namespace nutshell
