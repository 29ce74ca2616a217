// Chapter 7 · Two boxes: a plane between them if there is one, else where they touch. Up to five
// points, because a box rests on a face, not on a point.
#pragma once
#include <array>
#include <nutshell/contact.hpp>
#include <nutshell/shapes.hpp>

namespace nutshell {

/// The corner number 0 to 7 of a box, as signs along its axes.
inline Vector3 corner_signs(int corner) {
    return {corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0};
}

// [box_pair]
/// Two boxes, seen once from each.
struct BoxPair {
    const Vector3 &half_a, &half_b, &place_a, &place_b;
    Matrix3 axes_a, axes_b;  ///< their columns are the boxes' axes, world axes
};

/// The direction in which two boxes are farthest apart, of the fifteen that can matter: the faces
/// of a, the faces of b, and what is across an edge of each.
struct Apart {
    double gap = -immovable;           ///< [m]; negative: they overlap by as much
    Vector3 normal = Vector3::Zero();  ///< from a to b, world axes
    int face = -1;                     ///< axis of a 0-2, of b 3-5; -1: two edges
    int edge_a = -1, edge_b = -1;      ///< their axes, then
};
// [/box_pair]

// [separating_axes]
/// The separating-axis test. Two convex things are apart if and only if a plane fits between
/// them, and for boxes it is across one of fifteen directions. Faces are preferred by `slack` [m]
/// over other faces and edges that are as good: the choice shall not change from step to step.
/// Source: S. Gottschalk, M. Lin, D. Manocha, SIGGRAPH 1996.
inline Apart farthest_apart(const BoxPair& pair, double slack) {
    const Matrix3 turn = pair.axes_a.transpose() * pair.axes_b, size = turn.cwiseAbs();
    const Vector3 between = pair.place_b - pair.place_a, in_a = pair.axes_a.transpose() * between,
                  in_b = pair.axes_b.transpose() * between;
    const Vector3 gaps_a = in_a.cwiseAbs() - pair.half_a - size * pair.half_b;
    const Vector3 gaps_b = in_b.cwiseAbs() - pair.half_b - size.transpose() * pair.half_a;
    Apart best;
    for (int i = 0; i < 3; ++i)
        if (gaps_a[i] > best.gap + (i > 0 ? slack : 0))
            best = {gaps_a[i], std::copysign(1.0, in_a[i]) * pair.axes_a.col(i), i, -1, -1};
    for (int i = 0; i < 3; ++i)
        if (gaps_b[i] > best.gap + slack)
            best = {gaps_b[i], std::copysign(1.0, in_b[i]) * pair.axes_b.col(i), 3 + i, -1, -1};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double c = turn(i, j), square = 1 - c * c;
            if (square < 1e-6) continue;  // parallel edges: a face tells as much
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            const double along = in_a[i2] * turn(i1, j) - in_a[i1] * turn(i2, j);
            const double reach_a = pair.half_a[i1] * size(i2, j) + pair.half_a[i2] * size(i1, j);
            const double reach_b = pair.half_b[j1] * size(i, j2) + pair.half_b[j2] * size(i, j1);
            const double length = std::sqrt(square);
            const double gap = (std::abs(along) - reach_a - reach_b) / length;
            if (gap <= best.gap + slack) continue;
            const Vector3 across = pair.axes_a.col(i).cross(pair.axes_b.col(j)) / length;
            best = {gap, std::copysign(1.0, across.dot(between)) * across, -1, i, j};
        }
    return best;
}
// [/separating_axes]

// [clip]
/// A convex polygon with at most eight corners, in the plane of a face: x and y along its edges,
/// z the height above it; each corner with a name that stays the same while it stays: 5, 10, 15,
/// 20, or where an edge is cut, of its inner end, of the side that cuts, and which way round.
struct Polygon {
    std::array<Vector3, 8> corner;
    std::array<int, 8> name;
    int size = 0;
    void add(const Vector3& point, int its_name) {
        corner[static_cast<std::size_t>(size)] = point;
        name[static_cast<std::size_t>(size++)] = its_name;
    }
};

/// What is left of a polygon where sign * coordinate `axis` is at most `limit`. A corner that
/// stays keeps its name. A new one has its name from the inner corner n of its edge and the
/// `side` that cuts: 10 n + side where the polygon leaves, 10 n + 5 + side where it comes back.
/// Source: I. Sutherland, G. Hodgman, Commun. ACM 17 (1974) 32.
inline Polygon clipped(const Polygon& from, int axis, double sign, double limit, int side) {
    // exercise 7.9
    Polygon left;
    for (int k = 0; k < from.size; ++k) {
        const auto here = static_cast<std::size_t>(k),
                   next = static_cast<std::size_t>((k + 1) % from.size);
        const Vector3 &p = from.corner[here], &q = from.corner[next];
        const double over_p = sign * p[axis] - limit, over_q = sign * q[axis] - limit;
        if (over_p <= 0) left.add(p, from.name[here]);
        if ((over_p < 0 && over_q > 0) || (over_p > 0 && over_q < 0))
            left.add(p + over_p / (over_p - over_q) * (q - p),
                     over_p < 0 ? 10 * from.name[here] + side : 10 * from.name[next] + 5 + side);
    }
    return left;
    // end 7.9
}
// [/clip]

/// How far a corner may hang over the edge of the face it stands on and still be its own contact,
/// in halves of that face: a box that lies flush shall not change its contacts at every tremor.
inline constexpr double over_the_edge = 1.01;

// [face_contacts]
/// The contacts on a face: of the other box, the face that looks at it most, cut to fit above it.
inline void face_contacts(const BoxPair& pair, const Apart& apart, double margin,
                          std::vector<Contact>& found) {
    const bool on_a = apart.face < 3;
    const Vector3 &half = on_a ? pair.half_a : pair.half_b,
                  &other_half = on_a ? pair.half_b : pair.half_a;
    const Matrix3 &axes = on_a ? pair.axes_a : pair.axes_b,
                  &other = on_a ? pair.axes_b : pair.axes_a;
    const Vector3 &place = on_a ? pair.place_a : pair.place_b,
                  &other_place = on_a ? pair.place_b : pair.place_a;
    const int z = apart.face % 3, x = (z + 1) % 3, y = (z + 2) % 3;
    const Vector3 up = on_a ? apart.normal : Vector3(-apart.normal);

    const Vector3 facing = other.transpose() * up;
    int w = 0;
    facing.cwiseAbs().maxCoeff(&w);
    const int u = (w + 1) % 3, v = (w + 2) % 3;
    const Vector3 centre = other_place - std::copysign(other_half[w], facing[w]) * other.col(w) -
                           place - half[z] * up;
    const auto in_face = [&](const Vector3& p) {
        return Vector3(axes.col(x).dot(p), axes.col(y).dot(p), up.dot(p));
    };
    const Vector3 middle = in_face(centre), eu = in_face(other_half[u] * other.col(u)),
                  ev = in_face(other_half[v] * other.col(v));
    Polygon face;
    face.add(middle - eu - ev, 5), face.add(middle + eu - ev, 10);
    face.add(middle + eu + ev, 15), face.add(middle - eu + ev, 20);
    const double x_end = over_the_edge * half[x], y_end = over_the_edge * half[y];
    face = clipped(face, 0, 1, x_end, 1), face = clipped(face, 0, -1, x_end, 2);
    face = clipped(face, 1, 1, y_end, 3), face = clipped(face, 1, -1, y_end, 4);

    // Of up to eight corners, the outermost along both diagonals and the lowest.
    const std::array<Vector3, 5> outermost{
        {{1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {0, 0, -1}}};
    std::array<bool, 8> chosen{};
    if (face.size <= 4) chosen.fill(true);
    for (const Vector3& way : outermost) {
        std::size_t best = 0;
        for (std::size_t k = 1; k < static_cast<std::size_t>(face.size); ++k)
            if (way.dot(face.corner[k]) > way.dot(face.corner[best])) best = k;
        chosen[best] = true;
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(face.size); ++k) {
        const Vector3& p = face.corner[k];
        if (!chosen[k] || p.z() >= margin) continue;
        const Vector3 point =
            place + (half[z] + p.z() / 2) * up + p.x() * axes.col(x) + p.y() * axes.col(y);
        found.push_back({point, apart.normal, p.z(), 8 * face.name[k] + apart.face});
    }
}
// [/face_contacts]

// [edge_contact]
/// The contact of two edges: where they are nearest to each other.
inline void edge_contact(const BoxPair& pair, const Apart& apart, std::vector<Contact>& found) {
    const Vector3 a = pair.axes_a.col(apart.edge_a), b = pair.axes_b.col(apart.edge_b);
    Vector3 p = pair.place_a, q = pair.place_b;  // a point of either edge: its middle
    for (int k = 0; k < 3; ++k) {
        const Vector3 x = pair.axes_a.col(k), y = pair.axes_b.col(k);
        if (k != apart.edge_a) p += std::copysign(pair.half_a[k], x.dot(apart.normal)) * x;
        if (k != apart.edge_b) q -= std::copysign(pair.half_b[k], y.dot(apart.normal)) * y;
    }
    const double c = a.dot(b), from = a.dot(q - p), to = b.dot(q - p);
    const double s = (from - c * to) / (1 - c * c), t = (c * from - to) / (1 - c * c);
    found.push_back({(p + s * a + q + t * b) / 2, apart.normal, apart.gap,
                     -1 - 3 * apart.edge_a - apart.edge_b});
}
// [/edge_contact]

// [box_contacts]
/// All contacts of two boxes with a gap below `margin` [m], added to `found`.
[[gnu::flatten]] inline void find_contacts(const Box& box_a, const Body& a, const Box& box_b,
                                           const Body& b, double margin,
                                           std::vector<Contact>& found) {
    const double near = reach(box_a) + reach(box_b) + margin;
    if ((b.position - a.position).squaredNorm() >= near * near) return;
    const BoxPair pair{box_a.half,
                       box_b.half,
                       a.position,
                       b.position,
                       rotation_matrix(a.orientation),
                       rotation_matrix(b.orientation)};
    const double slack = 0.01 * std::min(box_a.half.minCoeff(), box_b.half.minCoeff());
    const Apart apart = farthest_apart(pair, slack);
    if (apart.gap >= margin) return;
    if (apart.face >= 0)
        face_contacts(pair, apart, margin, found);
    else
        edge_contact(pair, apart, found);
}
// [/box_contacts]

}  // namespace nutshell
