// Chapter 7 · Hulls: convex pieces with flat faces, like the stones of an arch.
#pragma once
#include <algorithm>
#include <limits>
#include <memory>
#include <nutshell/require.hpp>
#include <nutshell/vector.hpp>
#include <utility>
#include <vector>

namespace nutshell {

// [polyhedron]
/// A convex solid with flat faces, its centre of mass in the origin.
struct Polyhedron {
    struct Edge {
        std::size_t from, to;   ///< numbers of corners
        std::size_t direction;  ///< number of its direction
    };
    std::vector<Vector3> corners;                 ///< [m], body axes
    std::vector<std::vector<std::size_t>> faces;  ///< corners, counter-clockwise from outside
    std::vector<Vector3> normals;                 ///< of the faces, unit vectors, outwards
    std::vector<Edge> edges;                      ///< each once
    std::vector<Vector3> directions;  ///< of the edges, unit vectors; parallel ones once
    double reach = 0;                 ///< radius of the sphere about the origin that holds it [m]
    double inner = 0;                 ///< of the sphere about the origin that it holds [m]
};

/// A convex shape. Bodies of one form share it.
struct Hull {
    std::shared_ptr<const Polyhedron> form;
};
// [/polyhedron]

inline double reach(const Hull& hull) {
    return hull.form->reach;
}

/// Gives the hull back if it is one, to a millionth of its reach.
/// @throws std::invalid_argument with the reason: it has no form, a number is not finite, a face is
/// not flat or has no area, the skin is open, it is not convex or flat, its centre of mass is not
/// in the origin, or it has more than 100 corners (the names of contacts are numbers of 32 bits)
inline Hull checked(const Hull& hull) {
    require(hull.form != nullptr, "a hull has no form: make it with hull_of or piece_of");
    const Polyhedron& form = *hull.form;
    const double slack = 1e-6 * form.reach;
    for (const Vector3& corner : form.corners) require_finite(corner, "a corner of a hull [m]");
    require(form.corners.size() <= 100, "a hull has 100 corners at most");
    require(form.faces.size() >= 4, "a hull has four faces at least");

    std::vector<std::pair<std::size_t, std::size_t>> sides;  // of all faces, as they run round
    double volume = 0;
    Vector3 moment = Vector3::Zero();  // of the volume, in fours
    for (std::size_t f = 0; f < form.faces.size(); ++f) {
        const auto& face = form.faces[f];
        const Vector3 &n = form.normals[f], &first = form.corners[face[0]];
        require(std::abs(n.norm() - 1) < 1e-9, "a face of a hull has no area");
        for (const Vector3& corner : form.corners)
            require(n.dot(corner - first) <= slack, "a hull has a dent: it is not convex");
        for (std::size_t k = 0; k < face.size(); ++k) {
            const Vector3 &p = form.corners[face[k]],
                          &q = form.corners[face[(k + 1) % face.size()]];
            require(std::abs(n.dot(p - first)) <= slack, "a face of a hull is not flat");
            sides.emplace_back(face[k], face[(k + 1) % face.size()]);
            const double six = first.dot(p.cross(q));  // a tetrahedron with the origin
            volume += six / 6, moment += six / 6 * (first + p + q);
        }
        for (std::size_t g = 0; g < f; ++g)
            require(n.dot(form.normals[g]) < 1 - 1e-9,
                    "two faces of a hull lie in one plane: make them one");
    }
    for (const auto& [from, to] : sides)
        require(std::count(sides.begin(), sides.end(), std::pair(to, from)) == 1,
                "a hull is open, or a face is inside out: each edge must be run along once each "
                "way");
    require(form.inner > slack && volume > 0,
            "a hull is flat, or the origin is not inside of it");
    require((moment / (4 * volume)).norm() <= slack,
            "the centre of mass of a hull is not in the origin");
    return hull;
}

// [hull_of]
/// The hull with these corners [m] and faces, each face's corners counter-clockwise seen from
/// outside, about its centre of mass. What follows from them is reckoned here, once.
/// @throws std::invalid_argument as `checked` does
inline Hull hull_of(std::vector<Vector3> corners, std::vector<std::vector<std::size_t>> faces) {
    Polyhedron form;
    form.corners = std::move(corners), form.faces = std::move(faces);
    form.inner = std::numeric_limits<double>::infinity();
    for (const Vector3& corner : form.corners) form.reach = std::max(form.reach, corner.norm());
    for (const auto& face : form.faces) {
        require(face.size() >= 3, "a face of a hull has three corners at least");
        for (const std::size_t k : face)
            require(k < form.corners.size(), "a face of a hull has a corner that is none");
        const Vector3& first = form.corners[face[0]];
        Vector3 area = Vector3::Zero();  // twice the area, along the normal
        for (std::size_t k = 0; k < face.size(); ++k) {
            const std::size_t i = face[k], j = face[(k + 1) % face.size()];
            const Vector3 &p = form.corners[i], &q = form.corners[j];
            area += (p - first).cross(q - first);
            if (i > j) continue;  // the face on the other side has it too
            const Vector3 way = (q - p).normalized();
            std::size_t same = 0;
            while (same < form.directions.size() &&
                   form.directions[same].cross(way).squaredNorm() > 1e-18)
                ++same;
            if (same == form.directions.size()) form.directions.push_back(way);
            form.edges.push_back({i, j, same});
        }
        form.normals.push_back(area.normalized());
        form.inner = std::min(form.inner, form.normals.back().dot(first));
    }
    return checked(Hull{std::make_shared<const Polyhedron>(std::move(form))});
}
// [/hull_of]

/// A box as a hull, half its edges [m].
inline Hull box_hull(const Vector3& half) {
    std::vector<Vector3> corners;
    for (int i = 0; i < 8; ++i)  // bit 0 of i says +x, bit 1 +y, bit 2 +z
        corners.push_back(
            Vector3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1).cwiseProduct(half));
    return hull_of(
        corners,
        {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}});
}

}  // namespace nutshell
