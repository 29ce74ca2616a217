#include "geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace nutshell::picture {

namespace {

using Eigen::Vector3d;
constexpr double pi = std::numbers::pi;

struct Corner {
    Vector3d position, normal;
};

void push(Triangles& out, const Corner& a, const Corner& b, const Corner& c) {
    for (const Corner* corner : {&a, &b, &c}) {
        out.indices.push_back(std::uint32_t(out.vertices.size()));
        out.vertices.push_back({corner->position.cast<float>(), corner->normal.cast<float>()});
    }
}

/// A surface of rows x columns quads; corner(row, column) gives its (rows + 1) x (columns + 1) corners. Seen
/// from outside, a row below another is the next one and columns run to the right.
template <class CornerAt>
void push_grid(Triangles& out, int rows, int columns, const CornerAt& corner) {
    const auto first = std::uint32_t(out.vertices.size());
    for (int i = 0; i <= rows; ++i) {
        for (int j = 0; j <= columns; ++j) {
            const Corner c = corner(i, j);
            out.vertices.push_back({c.position.cast<float>(), c.normal.cast<float>()});
        }
    }
    auto index = [&](int i, int j) { return first + std::uint32_t(i * (columns + 1) + j); };
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) {
            const std::uint32_t a = index(i, j), b = index(i + 1, j), c = index(i + 1, j + 1),
                                d = index(i, j + 1);
            for (std::uint32_t k : {a, b, c, a, c, d}) out.indices.push_back(k);
        }
    }
}

/// Direction number i of n round y, anticlockwise as seen from above.
Vector3d round_y(int i, int n) {
    const double angle = 2 * pi * i / n;
    return {std::cos(angle), 0, -std::sin(angle)};
}

}  // namespace

Triangles unit_ball(int rings) {
    Triangles out;
    push_grid(out, rings, 2 * rings, [&](int ring, int side) {
        const double polar = pi * ring / rings;
        const Vector3d p = std::sin(polar) * round_y(side, 2 * rings) + std::cos(polar) * Vector3d::UnitY();
        return Corner{p, p};
    });
    return out;
}

Triangles unit_octants(int rings, bool even) {
    const int quarter = (rings + 1) / 2;
    Triangles out;
    for (int octant = 0; octant < 8; ++octant) {
        const int lower = octant / 4,
                  turn = octant % 4;  // z is positive in the quarters 2 and 3: round_y turns that way
        const bool positive = (turn == 0 || turn == 3) == (turn >= 2) ? lower == 0 : lower == 1;
        if (positive != even) continue;
        push_grid(out, quarter, quarter, [&](int ring, int side) {
            const double polar = pi / 2 * (lower + double(ring) / quarter);
            const Vector3d p = std::sin(polar) * round_y(turn * quarter + side, 4 * quarter) +
                               std::cos(polar) * Vector3d::UnitY();
            return Corner{p, p};
        });
    }
    return out;
}

Triangles unit_rod(int sides) {
    Triangles out;
    const Vector3d y = Vector3d::UnitY(), origin = Vector3d::Zero();
    push_grid(out, 1, sides, [&](int row, int side) {
        const Vector3d p = round_y(side, sides);
        return Corner{p + (1 - row) * y, p};
    });
    for (int i = 0; i < sides; ++i) {
        const Vector3d a = round_y(i, sides), b = round_y(i + 1, sides);
        push(out, {y, y}, {a + y, y}, {b + y, y});
        push(out, {origin, -y}, {b, -y}, {a, -y});
    }
    return out;
}

Triangles unit_cone(int sides) {
    Triangles out;
    const Vector3d y = Vector3d::UnitY(), origin = Vector3d::Zero();
    for (int i = 0; i < sides; ++i) {
        const Vector3d a = round_y(i, sides), b = round_y(i + 1, sides);
        const Vector3d na = (a + y).normalized(), nb = (b + y).normalized();
        push(out, {a, na}, {b, nb}, {y, (na + nb).normalized()});
        push(out, {origin, -y}, {b, -y}, {a, -y});
    }
    return out;
}

/// Every point is pulled back onto an inner box and pushed out again by the bevel, along its normal.
Triangles rounded_box(const Vector3d& half, double bevel) {
    const Vector3d inner = half - Vector3d::Constant(bevel);
    Triangles out;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        auto cut = [&](int i, int k) {
            const double outer = half[i], middle = half[i] - 0.4 * bevel;
            return std::array<double, 6>{-outer, -middle, -inner[i], inner[i], middle, outer}[std::size_t(k)];
        };
        for (double side : {-1.0, 1.0}) {
            push_grid(out, 5, 5, [&](int row, int column) {
                Vector3d on_face;
                on_face[axis] = side * half[axis];
                on_face[u] = side * cut(u, row);  // mirrored on the far side, which keeps it anticlockwise
                on_face[v] = cut(v, column);
                const Vector3d inside = on_face.cwiseMin(inner).cwiseMax(-inner);
                const Vector3d normal = (on_face - inside).normalized();
                return Corner{inside + bevel * normal, normal};
            });
        }
    }
    return out;
}

Triangles tube(const std::vector<Vector3d>& given, double radius, int sides) {
    std::vector<Vector3d> points;
    for (const Vector3d& point : given) {
        if (points.empty() || (point - points.back()).norm() > 1e-6 * radius) points.push_back(point);
    }
    Triangles out;
    const int n = int(points.size());
    if (n < 2) return out;
    auto at = [&](int i) -> const Vector3d& { return points[std::size_t(std::clamp(i, 0, n - 1))]; };
    std::vector<std::array<Vector3d, 3>> frames;  // along, across, and the third
    Vector3d across = (at(1) - at(0)).unitOrthogonal();
    for (int i = 0; i < n; ++i) {
        const Vector3d before = at(i) - at(i - 1), after = at(i + 1) - at(i);
        const Vector3d sum = before.normalized() + after.normalized();
        const Vector3d along = sum.norm() > 1e-6 ? sum.normalized() : before.normalized();
        const Vector3d carried =
            across - along * along.dot(across);  // carried along, so that it does not twist
        across = carried.norm() > 1e-6 ? carried.normalized() : along.unitOrthogonal();
        frames.push_back({along, across, along.cross(across)});
    }
    auto corner = [&](int i, int side) {
        const auto& [along, first, second] = frames[std::size_t(i)];
        const double angle = 2 * pi * side / sides;
        const Vector3d normal = std::cos(angle) * first - std::sin(angle) * second;
        return Corner{at(i) + radius * normal, normal};
    };
    push_grid(out, n - 1, sides, corner);
    for (int k = 0; k < sides; ++k) {
        const Vector3d back = -frames.front()[0], front = frames.back()[0];
        push(out, {at(0), back}, {corner(0, k).position, back}, {corner(0, k + 1).position, back});
        push(out, {at(n - 1), front}, {corner(n - 1, k + 1).position, front},
             {corner(n - 1, k).position, front});
    }
    return out;
}

Triangles triangles_of(const Mesh& mesh) {
    auto cross = [&](const std::array<int, 3>& t) -> Vector3d {
        const Vector3d& a = mesh.points[std::size_t(t[0])];
        return (mesh.points[std::size_t(t[1])] - a).cross(mesh.points[std::size_t(t[2])] - a);
    };
    Triangles out;
    if (!mesh.smooth) {
        for (const auto& t : mesh.triangles) {
            const Vector3d normal = cross(t).normalized();
            auto corner = [&](int k) { return Corner{mesh.points[std::size_t(t[std::size_t(k)])], normal}; };
            push(out, corner(0), corner(1), corner(2));
        }
        return out;
    }
    std::vector<Vector3d> normals(mesh.points.size(), Vector3d::Zero());
    for (const auto& t : mesh.triangles) {
        const Vector3d weighted_by_area = cross(t);
        for (int index : t) {
            normals[std::size_t(index)] += weighted_by_area;
            out.indices.push_back(std::uint32_t(index));
        }
    }
    for (std::size_t i = 0; i < normals.size(); ++i) {
        out.vertices.push_back({mesh.points[i].cast<float>(), normals[i].normalized().cast<float>()});
    }
    return out;
}

}  // namespace nutshell::picture
