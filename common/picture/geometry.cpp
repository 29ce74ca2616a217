#include "geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nutshell::picture {

namespace {

using Eigen::Vector3d, Eigen::Vector3f;
constexpr double pi = std::numbers::pi;

struct Corner {
    Vector3d position, normal;
};

void push(Vertices& out, const Corner& c) {
    out.push_back({c.position.cast<float>(), c.normal.cast<float>()});
}

/// Corners a, b, c, d anticlockwise as seen from outside.
void push_quad(Vertices& out, const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
    for (const Corner* corner : {&a, &b, &c, &a, &c, &d}) push(out, *corner);
}

/// Direction number i of n round y.
Vector3d round_y(int i, int n) {
    const double angle = 2 * pi * i / n;
    return {std::cos(angle), 0, -std::sin(angle)};
}

}  // namespace

Vertices unit_ball(int rings) {
    const int sides = 2 * rings;
    auto corner = [&](int ring, int side) {
        const double polar = pi * ring / rings;
        const Vector3d p = std::sin(polar) * round_y(side, sides) + std::cos(polar) * Vector3d::UnitY();
        return Corner{p, p};
    };
    Vertices out;
    out.reserve(std::size_t(rings * sides * 6));
    for (int i = 0; i < rings; ++i) {
        for (int j = 0; j < sides; ++j) {
            push_quad(out, corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
        }
    }
    return out;
}

Vertices unit_rod(int sides) {
    Vertices out;
    const Vector3d y = Vector3d::UnitY();
    for (int i = 0; i < sides; ++i) {
        const Vector3d a = round_y(i, sides), b = round_y(i + 1, sides);
        push_quad(out, {a, a}, {b, b}, {b + y, b}, {a + y, a});
        for (const Corner& c : {Corner{y, y}, Corner{a + y, y}, Corner{b + y, y}}) push(out, c);
        for (const Corner& c : {Corner{0 * y, -y}, Corner{b, -y}, Corner{a, -y}}) push(out, c);
    }
    return out;
}

Vertices unit_cone(int sides) {
    Vertices out;
    const Vector3d y = Vector3d::UnitY(), lean = 0.35 * y;
    for (int i = 0; i < sides; ++i) {
        const Vector3d a = round_y(i, sides), b = round_y(i + 1, sides);
        const Vector3d na = (a + lean).normalized(), nb = (b + lean).normalized();
        for (const Corner& c : {Corner{a, na}, Corner{b, nb}, Corner{y, (na + nb).normalized()}})
            push(out, c);
        for (const Corner& c : {Corner{0 * y, -y}, Corner{b, -y}, Corner{a, -y}}) push(out, c);
    }
    return out;
}

Vertices rounded_box(const Vector3d& half) {
    const double bevel = 0.07 * half.minCoeff();
    const Vector3d core = half - Vector3d::Constant(bevel);
    auto corner = [&](const Vector3d& on_face) {
        const Vector3d inside = on_face.cwiseMin(core).cwiseMax(-core);
        const Vector3d normal = (on_face - inside).normalized();
        return Corner{inside + bevel * normal, normal};
    };
    Vertices out;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        auto cuts = [&](int i) {
            return std::array<double, 6>{-half[i], -half[i] + 0.4 * bevel, -core[i],
                                         core[i],  half[i] - 0.4 * bevel,  half[i]};
        };
        const auto us = cuts(u), vs = cuts(v);
        for (double side : {-1.0, 1.0}) {
            auto at = [&](std::size_t i, std::size_t j) {
                Vector3d p;
                p[axis] = side * half[axis];
                p[u] = side * us[i];  // mirrored on the far side, which keeps the corners anticlockwise
                p[v] = vs[j];
                return corner(p);
            };
            for (std::size_t i = 0; i < 5; ++i) {
                for (std::size_t j = 0; j < 5; ++j) {
                    push_quad(out, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
                }
            }
        }
    }
    return out;
}

Vertices tube(const std::vector<Vector3d>& given, double radius, int sides) {
    std::vector<Vector3d> points;
    for (const Vector3d& point : given) {
        if (points.empty() || (point - points.back()).norm() > 1e-6 * radius) points.push_back(point);
    }
    Vertices out;
    if (points.size() < 2) return out;
    const std::size_t n = points.size();
    auto direction = [&](std::size_t i) {
        const Vector3d before =
            i > 0 ? (points[i] - points[i - 1]).normalized().eval() : Vector3d::Zero().eval();
        const Vector3d after =
            i + 1 < n ? (points[i + 1] - points[i]).normalized().eval() : Vector3d::Zero().eval();
        const Vector3d sum = before + after;
        return sum.norm() > 1e-6 ? sum.normalized().eval() : after;
    };
    Vector3d across = direction(0).unitOrthogonal();  // carried along, so that the tube does not twist
    std::vector<Corner> previous;
    for (std::size_t i = 0; i < n; ++i) {
        const Vector3d along = direction(i);
        const Vector3d carried = across - along * along.dot(across);
        across = carried.norm() > 1e-6 ? carried.normalized().eval() : along.unitOrthogonal().eval();
        const Vector3d other = along.cross(across);
        std::vector<Corner> ring;
        for (int k = 0; k <= sides; ++k) {
            const double angle = 2 * pi * k / sides;
            const Vector3d normal = std::cos(angle) * across + std::sin(angle) * other;
            ring.push_back({points[i] + radius * normal, normal});
        }
        for (std::size_t k = 0; k + 1 < ring.size(); ++k) {
            if (i > 0) push_quad(out, previous[k], previous[k + 1], ring[k + 1], ring[k]);
            if (i == 0 || i + 1 == n) {
                const Vector3d outward = i == 0 ? (-along).eval() : along;
                const Corner& a = ring[i == 0 ? k + 1 : k];
                const Corner& b = ring[i == 0 ? k : k + 1];
                for (const Vector3d& p : {points[i], a.position, b.position}) push(out, {p, outward});
            }
        }
        previous = std::move(ring);
    }
    return out;
}

Vertices triangles(const Mesh& mesh) {
    auto cross = [&](const std::array<int, 3>& t) -> Vector3d {
        const Vector3d& a = mesh.points[std::size_t(t[0])];
        return (mesh.points[std::size_t(t[1])] - a).cross(mesh.points[std::size_t(t[2])] - a);
    };
    std::vector<Vector3d> normals(mesh.points.size(), Vector3d::Zero());
    for (const auto& t : mesh.triangles) {
        for (int index : t) normals[std::size_t(index)] += cross(t);
    }
    Vertices out;
    for (const auto& t : mesh.triangles) {
        const Vector3d flat = cross(t).normalized();
        for (int index : t) {
            const Vector3d& sum = normals[std::size_t(index)];
            const bool smooth = mesh.smooth && sum.norm() > 0;
            push(out, {mesh.points[std::size_t(index)], smooth ? sum.normalized().eval() : flat});
        }
    }
    return out;
}

}  // namespace nutshell::picture
