// Chapter 6 · Meshes: the mass, centre and inertia of any shape, from its skin alone.
#pragma once
#include <algorithm>
#include <array>
#include <nutshell/inertia.hpp>
#include <nutshell/require.hpp>

namespace nutshell {

// [mesh]
/// The skin of a solid: triangles whose corners run counter-clockwise seen from outside.
struct Mesh {
    std::vector<Vector3> vertices;              ///< [m]
    std::vector<std::array<int, 3>> triangles;  ///< of indices into `vertices`
    std::vector<int> lines;  ///< where in its file each triangle stands; empty if it has no file
};
// [/mesh]

// [closed]
/// The reason why a mesh encloses nothing, or nothing if it does: along every edge as many
/// triangles must run one way as the other. Vertices at the very same place count as one.
inline std::string why_open(const Mesh& mesh) {
    const auto& place = mesh.vertices;
    std::vector<int> order(place.size()),
        same(place.size());  // same[i]: the first vertex that lies there
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    const auto key = [&](int i) {
        const Vector3& p = place[static_cast<std::size_t>(i)];
        return std::array<double, 3>{p.x(), p.y(), p.z()};
    };
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
    for (std::size_t i = 0; i < order.size(); ++i)
        same[static_cast<std::size_t>(order[i])] =
            i > 0 && key(order[i]) == key(order[i - 1])
                ? same[static_cast<std::size_t>(order[i - 1])]
                : order[i];

    struct Edge {
        int from, to;  // from < to
        int way;       // 1 if its triangle runs that way, -1 if against it
        std::size_t triangle;
    };
    std::vector<Edge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = same[static_cast<std::size_t>(mesh.triangles[t][k])],
                      b = same[static_cast<std::size_t>(mesh.triangles[t][(k + 1) % 3])];
            if (a != b) edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1, t});
        }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::array{a.from, a.to} < std::array{b.from, b.to};
    });
    for (std::size_t i = 0; i < edges.size();) {
        const Edge& edge = edges[i];
        int sum = 0, count = 0;
        for (; i < edges.size() && edges[i].from == edge.from && edges[i].to == edge.to; ++i)
            sum += edges[i].way, ++count;
        if (sum == 0) continue;
        std::ostringstream text;
        text << "the edge between vertices " << edge.from + 1 << " and " << edge.to + 1;
        if (!mesh.lines.empty())
            text << " (of the face on line " << mesh.lines[edge.triangle] << ")";
        if (count == 1)
            text << " has a face on one side only: the mesh is open";
        else if (count == 2)
            text << " has two faces that run along it the same way: one of them is inside out";
        else
            text << " has " << count << " faces that do not match in pairs";
        return text.str();
    }
    return "";
}
// [/closed]

// [integrals]
/// Mass, centre and inertia of the solid inside a closed mesh, exact: the sum over its triangles
/// of the tetrahedra between each and one fixed point, those that face it counted negative.
/// @param density  [kg/m^3]
/// @throws std::invalid_argument with the reason if the mesh is empty, open or inside out, or if
/// no body can have what comes out, as when the skin passes through itself and encloses a part
/// the wrong way round. A skin that encloses a part twice is not found out.
inline MassProperties mass_properties(const Mesh& mesh, double density) {
    require_positive(density, "mass_properties: the density [kg/m^3]");
    require(!mesh.triangles.empty(), "mass_properties: the mesh has no faces");
    const int count = static_cast<int>(mesh.vertices.size());
    for (const auto& triangle : mesh.triangles)
        for (const int corner : triangle)
            require(corner >= 0 && corner < count,
                    "mass_properties: a triangle's corner is no vertex");
    const std::string open = why_open(mesh);
    require(open.empty(), "mass_properties: " + open);

    Vector3 low = mesh.vertices[static_cast<std::size_t>(mesh.triangles[0][0])], high = low;
    for (const auto& triangle : mesh.triangles)
        for (const int corner : triangle) {
            low = low.cwiseMin(mesh.vertices[static_cast<std::size_t>(corner)]);
            high = high.cwiseMax(mesh.vertices[static_cast<std::size_t>(corner)]);
        }
    const Vector3 middle =
        low + (high - low) / 2;        // from here the numbers are small and little cancels
    double volume = 0, sizes = 0;      // of the tetrahedra, with their signs and without
    Vector3 first = Vector3::Zero();   // integral of x
    Matrix3 second = Matrix3::Zero();  // integral of x x^T
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vector3 a = mesh.vertices[static_cast<std::size_t>(i)] - middle,
                      b = mesh.vertices[static_cast<std::size_t>(j)] - middle,
                      c = mesh.vertices[static_cast<std::size_t>(k)] - middle, sum = a + b + c;
        const double six = a.dot(b.cross(c));  // six times the tetrahedron's volume
        volume += six / 6, sizes += std::abs(six) / 6;
        first += six / 24 * sum;
        second +=
            six / 120 *
            (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
    }
    require(std::isfinite(sizes) && second.allFinite(), "mass_properties: the mesh is too large");
    require(
        volume >= -1e-9 * sizes,
        "mass_properties: the volume is negative: the faces are inside out, their corners must "
        "run counter-clockwise seen from outside");
    require(volume > 1e-9 * sizes && volume > 0, "mass_properties: the mesh encloses no volume");
    const Vector3 centre = first / volume;
    second -= volume * centre * centre.transpose();
    const Matrix3 inertia = density * (second.trace() * Matrix3::Identity() - second);
    // What no body in this box can have. The volume keeps six digits at least, so do these.
    constexpr double slack = 1 + 1e-5;
    const Vector3 half = slack * (high - low) / 2;
    const Vector3 spread = second.diagonal() / volume;  // mean square distance from the centre
    std::string reason = why_impossible(symmetric_axes(inertia).moments, slack - 1);
    if (volume > slack * (high - low).prod()) reason = "it encloses more than its bounding box";
    if ((centre.cwiseAbs().array() > half.array()).any()) reason = "its centre lies outside";
    if ((spread.array() > half.array().square()).any()) reason = "its inertia is too large";
    require(reason.empty(), "mass_properties: the skin passes through itself: " + reason);
    return {density * volume, middle + centre, inertia};
}
// [/integrals]

// [mesh_moves]
/// The mesh turned by R about the origin, then moved.
inline Mesh placed(Mesh mesh, const Matrix3& rotation, const Vector3& place) {
    for (Vector3& vertex : mesh.vertices) vertex = rotation * vertex + place;
    return mesh;
}

/// One mesh out of two; the second one's triangles count its vertices after those of the first.
inline Mesh merged(Mesh a, const Mesh& b) {
    const int shift = static_cast<int>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& [i, j, k] : b.triangles)
        a.triangles.push_back({i + shift, j + shift, k + shift});
    a.lines.clear();  // they would be of two files
    return a;
}
// [/mesh_moves]

}  // namespace nutshell
