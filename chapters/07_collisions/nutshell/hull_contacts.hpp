// Chapter 7 · Convex pieces: the separating-axis test and the cut face of two boxes, for any
// number of faces. Boxes among themselves have their own, faster way.
#pragma once
#include <nutshell/box_contacts.hpp>

namespace nutshell {

// [placed_hull]
/// A hull, or a box as one, where it lies: all in world axes.
struct PlacedHull {
    const Polyhedron& form;
    std::vector<Vector3> corners, normals, directions;
    double inner;  ///< radius of a sphere inside [m]
};
inline PlacedHull placed(const Hull& hull, const Body& body,
                         const Vector3& stretch = Vector3::Ones()) {
    const Matrix3 turn = rotation_matrix(body.orientation);
    const Polyhedron& form = *hull.form;
    PlacedHull there{form, form.corners, form.normals, form.directions, form.inner};
    for (Vector3& p : there.corners) p = body.position + turn * stretch.cwiseProduct(p);
    for (Vector3& n : there.normals) n = turn * n;
    for (Vector3& d : there.directions) d = turn * d;
    return there;
}
/// A box is a cube, stretched: its faces and edges keep their directions.
inline PlacedHull placed(const Box& box, const Body& body) {
    static const Hull cube = box_hull(Vector3::Ones());
    PlacedHull there = placed(cube, body, box.half);
    there.inner = box.half.minCoeff();
    return there;
}
// [/placed_hull]

// [hulls_apart]
/// The direction in which two hulls are farthest apart.
struct HullsApart {
    double gap = -immovable;           ///< [m]; negative: they overlap by as much
    Vector3 normal = Vector3::Zero();  ///< from a to b, world axes
    bool edges = false;                ///< it is across an edge of a and one of b; else:
    std::size_t face = 0;              ///< number of a face of a, or after those of a, of b
};

/// How far b begins behind the end of a, along n [m].
inline double gap_along(const Vector3& n, const PlacedHull& a, const PlacedHull& b) {
    double end = -immovable, begin = immovable;
    for (const Vector3& p : a.corners) end = std::max(end, n.dot(p));
    for (const Vector3& p : b.corners) begin = std::min(begin, n.dot(p));
    return begin - end;
}

/// The separating-axis test: the faces of a, the faces of b, and what is across an edge of each,
/// both ways. Faces are preferred by `slack` [m], as with boxes.
inline HullsApart farthest_apart(const PlacedHull& a, const PlacedHull& b, double slack) {
    HullsApart best;
    const std::size_t faces_a = a.normals.size();
    for (std::size_t f = 0; f < faces_a + b.normals.size(); ++f) {
        const Vector3 n = f < faces_a ? a.normals[f] : Vector3(-b.normals[f - faces_a]);
        const double gap = gap_along(n, a, b);
        if (gap > best.gap + (f > 0 ? slack : 0)) best = {gap, n, false, f};
    }
    for (const Vector3& x : a.directions)
        for (const Vector3& y : b.directions) {
            const Vector3 across = x.cross(y);
            const double square = across.squaredNorm();
            if (square < 1e-6) continue;  // parallel edges: a face tells as much
            for (const double sign : {1.0, -1.0}) {
                const Vector3 n = sign / std::sqrt(square) * across;
                const double gap = gap_along(n, a, b);
                if (gap > best.gap + slack) best = {gap, n, true, 0};
            }
        }
    return best;
}
// [/hulls_apart]

// [outline]
/// A corner of a convex outline, and the number of the edge that leaves it.
struct OutlineCorner {
    Vector3 point;
    int edge;
};

/// What is left of an outline where n . x <= limit, as `clipped` does it for boxes; the cut is
/// edge number `side`.
inline std::vector<OutlineCorner> cut_off(const std::vector<OutlineCorner>& from,
                                          const Vector3& n, double limit, int side) {
    std::vector<OutlineCorner> left;
    for (std::size_t k = 0; k < from.size(); ++k) {
        const OutlineCorner &p = from[k], &q = from[(k + 1) % from.size()];
        const double over_p = n.dot(p.point) - limit, over_q = n.dot(q.point) - limit;
        if (over_p <= 0) left.push_back(p);
        if ((over_p < 0 && over_q > 0) || (over_p > 0 && over_q < 0))
            left.push_back({p.point + over_p / (over_p - over_q) * (q.point - p.point),
                            over_p < 0 ? side : p.edge});
    }
    return left;
}
// [/outline]

// [hull_face_contacts]
/// The contacts on a face: of the other hull, the face that looks at it most, cut to fit above it.
/// A contact is named after that face and the two edges that meet in its corner.
inline void face_contacts(const PlacedHull& a, const PlacedHull& b, const HullsApart& apart,
                          double slack, double margin, std::vector<Contact>& found) {
    const std::size_t faces_a = a.normals.size();
    const bool on_a = apart.face < faces_a;
    const PlacedHull &own = on_a ? a : b, &other = on_a ? b : a;
    const auto& face = own.form.faces[on_a ? apart.face : apart.face - faces_a];
    const Vector3 up = on_a ? apart.normal : Vector3(-apart.normal);

    int edge = 0;  // edges are numbered through: of the other's faces, then of this face
    std::size_t facing = 0;
    for (std::size_t f = 1; f < other.normals.size(); ++f)
        if (up.dot(other.normals[f]) < up.dot(other.normals[facing])) facing = f;
    for (std::size_t f = 0; f < facing; ++f) edge += static_cast<int>(other.form.faces[f].size());
    std::vector<OutlineCorner> outline;
    for (const std::size_t k : other.form.faces[facing])
        outline.push_back({other.corners[k], edge++});

    edge = static_cast<int>(2 * other.form.edges.size());
    Vector3 middle = Vector3::Zero();
    for (const std::size_t k : face) middle += own.corners[k] / static_cast<double>(face.size());
    for (std::size_t k = 0; k < face.size(); ++k) {
        const Vector3 &p = own.corners[face[k]], &q = own.corners[face[(k + 1) % face.size()]];
        const Vector3 out = (q - p).cross(up).normalized();
        const double limit = out.dot(middle) + over_the_edge * out.dot(p - middle);
        outline = cut_off(outline, out, limit, edge++);
    }

    // Of more than four corners, the outermost along two diagonals; and the lowest, if it is lower
    // than these by more than a tremor.
    const Vector3 x = (own.corners[face[1]] - own.corners[face[0]]).normalized(), y = up.cross(x);
    const std::array<Vector3, 5> ways{x + y, x - y, y - x, -x - y, -up};
    std::vector<bool> chosen(outline.size(), outline.size() <= 4);
    double lowest = immovable;
    for (std::size_t w = 0; w < 5 && outline.size() > 4; ++w) {
        std::size_t best = 0;
        for (std::size_t k = 1; k < outline.size(); ++k)
            if (ways[w].dot(outline[k].point - outline[best].point) > 0) best = k;
        const double height = up.dot(outline[best].point);
        if (w == 4 && height > lowest - slack) break;
        chosen[best] = true, lowest = std::min(lowest, height);
    }
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const double height = up.dot(outline[k].point - middle);
        if (!chosen[k] || height >= margin) continue;
        const int before = outline[(k + outline.size() - 1) % outline.size()].edge;
        found.push_back(
            {outline[k].point - height / 2 * up, apart.normal, height,
             (static_cast<int>(apart.face) * edge + before) * edge + outline[k].edge});
    }
}
// [/hull_face_contacts]

// [hull_edge_contact]
/// The contact of two edges, where they are nearest to each other: of all that are not parallel,
/// the edge of a farthest along the normal and the edge of b farthest against it.
inline void edge_contact(const PlacedHull& a, const PlacedHull& b, const HullsApart& apart,
                         std::vector<Contact>& found) {
    double least = immovable;
    Contact nearest;
    int number = 0;
    for (const Polyhedron::Edge& of_a : a.form.edges)
        for (const Polyhedron::Edge& of_b : b.form.edges) {
            --number;
            const Vector3 &p = a.corners[of_a.from], &q = b.corners[of_b.from];
            const Vector3 x = a.corners[of_a.to] - p, y = b.corners[of_b.to] - q;
            const double xx = x.squaredNorm(), yy = y.squaredNorm(), xy = x.dot(y);
            const double square = xx * yy - xy * xy,
                         between = apart.normal.dot(q - p + (y - x) / 2);
            if (square < 1e-6 * xx * yy || between >= least) continue;
            const double from = x.dot(q - p), to = y.dot(q - p);
            const double s = std::clamp((yy * from - xy * to) / square, 0.0, 1.0),
                         t = std::clamp((xy * from - xx * to) / square, 0.0, 1.0);
            least = between;
            nearest = {(p + s * x + q + t * y) / 2, apart.normal, apart.gap, number};
        }
    found.push_back(nearest);
}
// [/hull_edge_contact]

// [hull_contacts]
/// All contacts of two convex pieces, hulls or boxes, with a gap below `margin` [m].
inline void find_contacts(const PlacedHull& a, const PlacedHull& b, double margin,
                          std::vector<Contact>& found) {
    const double slack = 0.01 * std::min(a.inner, b.inner);
    const HullsApart apart = farthest_apart(a, b, slack);
    if (apart.gap >= margin) return;
    if (apart.edges)
        edge_contact(a, b, apart, found);
    else
        face_contacts(a, b, apart, slack, margin, found);
}
// [/hull_contacts]

}  // namespace nutshell
