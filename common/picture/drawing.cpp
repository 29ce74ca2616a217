#include "nutshell/picture/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace nutshell::picture {

namespace {

using Eigen::Vector3d;

[[noreturn]] void refuse(const std::string& what, const std::string& why) {
    throw std::invalid_argument("picture: " + what + " " + why);
}

void need_finite(const Vector3d& v, const char* what) {
    if (!v.allFinite()) refuse(what, "is not finite");
}

void need_finite(const std::vector<Vector3d>& points, const char* what) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].allFinite())
            refuse(what, "has a point that is not finite: number " + std::to_string(i));
    }
}

void need_positive(double x, const char* what) {
    if (!(std::isfinite(x) && x > 0)) refuse(what, "must be positive and finite, not " + std::to_string(x));
}

void need_points(const std::vector<Vector3d>& points, const char* what) {
    if (points.size() < 2) refuse(what, "needs at least two points, not " + std::to_string(points.size()));
    need_finite(points, what);
}

}  // namespace

Drawing& Drawing::add(const Ball& thing) {
    need_finite(thing.centre, "Ball::centre");
    need_positive(thing.radius, "Ball::radius");
    if (thing.orientation && !(std::abs(thing.orientation->norm() - 1) < 1e-6)) {
        refuse("Ball::orientation", "is no rotation: its quaternion must have length 1");
    }
    balls_.push_back(thing);
    return *this;
}

Drawing& Drawing::add(const Box& thing) {
    if (!thing.pose.matrix().allFinite()) refuse("Box::pose", "is not finite");
    for (int i = 0; i < 3; ++i) need_positive(thing.half_extents[i], "Box::half_extents");
    boxes_.push_back(thing);
    return *this;
}

Drawing& Drawing::add(const Rod& thing) {
    need_finite(thing.from, "Rod::from");
    need_finite(thing.to, "Rod::to");
    need_positive(thing.radius, "Rod::radius");
    rods_.push_back(thing);
    return *this;
}

Drawing& Drawing::add(Tube thing) {
    need_points(thing.points, "Tube::points");
    need_positive(thing.radius, "Tube::radius");
    tubes_.push_back(std::move(thing));
    return *this;
}

Drawing& Drawing::add(Mesh thing) {
    need_finite(thing.points, "Mesh::points");
    if (!thing.pose.matrix().allFinite()) refuse("Mesh::pose", "is not finite");
    if (thing.triangles.empty()) refuse("Mesh::triangles", "is empty");
    for (const auto& triangle : thing.triangles) {
        for (int index : triangle) {
            if (index < 0 || std::size_t(index) >= thing.points.size()) {
                refuse("Mesh::triangles", "has index " + std::to_string(index) + " but there are " +
                                              std::to_string(thing.points.size()) + " points");
            }
        }
    }
    meshes_.push_back(std::move(thing));
    return *this;
}

Drawing& Drawing::add(Trail thing) {
    need_points(thing.points, "Trail::points");
    need_positive(thing.width, "Trail::width");
    need_positive(thing.opacity, "Trail::opacity");
    if (!std::isfinite(thing.opacity_at_start)) refuse("Trail::opacity_at_start", "is not finite");
    trails_.push_back(std::move(thing));
    return *this;
}

Drawing& Drawing::add(Arrow thing) {
    need_finite(thing.from, "Arrow::from");
    need_finite(thing.vector, "Arrow::vector");
    need_positive(thing.width, "Arrow::width");
    arrows_.push_back(std::move(thing));
    return *this;
}

Drawing& Drawing::add(const Axes& thing) {
    if (!thing.pose.matrix().allFinite()) refuse("Axes::pose", "is not finite");
    need_positive(thing.length, "Axes::length");
    for (int i = 0; i < 3; ++i) {
        add(Arrow{.from = thing.pose.translation(),
                  .vector = thing.pose.linear().col(i) * thing.length,
                  .colour = palette::exact,
                  .label = thing.names[std::size_t(i)],
                  .width = 3.5});
    }
    return *this;
}

Drawing& Drawing::add(Label thing) {
    need_finite(thing.at, "Label::at");
    labels_.push_back(std::move(thing));
    return *this;
}

Drawing& Drawing::ground(const Ground& ground) {
    need_finite(ground.normal, "Ground::normal");
    if (ground.normal.norm() == 0) refuse("Ground::normal", "has length zero");
    if (!std::isfinite(ground.height)) refuse("Ground::height", "is not finite");
    if (!(std::isfinite(ground.spacing) && ground.spacing >= 0))
        refuse("Ground::spacing", "must not be negative");
    ground_ = ground;
    ground_.normal.normalize();
    return *this;
}

Drawing& Drawing::no_ground() {
    ground_.visible = false;
    return *this;
}

Drawing& Drawing::sky(const Sky& sky) {
    sky_ = sky;
    return *this;
}

Drawing& Drawing::sun(const Vector3d& direction) {
    need_finite(direction, "the sun's direction");
    if (direction.norm() == 0) refuse("the sun's direction", "has length zero");
    sun_ = direction.normalized();
    return *this;
}

Drawing& Drawing::stage(const Extent& ball) {
    stage_ = ball;
    return *this;
}

Drawing& Drawing::theme(Theme theme) {
    theme_ = theme;
    return *this;
}

Drawing& Drawing::title(std::string text) {
    title_ = std::move(text);
    return *this;
}

Drawing& Drawing::caption(std::string text) {
    caption_ = std::move(text);
    return *this;
}

Vector3d Drawing::sun() const {
    if (sun_) return *sun_;
    const Vector3d high_left_in_front = Vector3d(-0.38, 0.82, 0.42).normalized();
    return Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitY(), ground_.normal) * high_left_in_front;
}

std::array<Vector3d, 8> corners_of(const Box& box) {
    std::array<Vector3d, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) {
        const Vector3d sign(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        corners[i] = box.pose * sign.cwiseProduct(box.half_extents);
    }
    return corners;
}

std::vector<Extent> Drawing::extents() const {
    std::vector<Extent> all;
    auto add_points = [&all](const std::vector<Vector3d>& points, double radius, bool shadow) {
        for (const Vector3d& point : points) all.push_back({point, radius, shadow});
    };
    auto solid = [](const auto& thing) { return thing.look == Look::solid; };
    for (const Ball& ball : balls_) add_points({ball.centre}, ball.radius, solid(ball) && !ball.shines);
    for (const Box& box : boxes_) {
        for (const Vector3d& corner : corners_of(box)) add_points({corner}, 0, solid(box));
    }
    for (const Rod& rod : rods_) add_points({rod.from, rod.to}, rod.radius, solid(rod));
    for (const Tube& tube : tubes_) add_points(tube.points, tube.radius, solid(tube));
    for (const Mesh& mesh : meshes_) {
        for (const Vector3d& point : mesh.points) add_points({mesh.pose * point}, 0, solid(mesh));
    }
    for (const Trail& trail : trails_) add_points(trail.points, 0, trail.shadow);
    for (const Arrow& arrow : arrows_) add_points({arrow.from, arrow.from + arrow.vector}, 0, false);
    for (const Label& label : labels_) add_points({label.at}, 0, false);
    return all;
}

std::vector<Vector3d> coil(const Vector3d& a, const Vector3d& b, double radius, int turns) {
    need_finite(a, "coil: an end");
    need_finite(b, "coil: an end");
    need_positive(radius, "coil: radius");
    if (turns < 1) refuse("coil: turns", "must be at least 1, not " + std::to_string(turns));
    const double length = (b - a).norm();
    if (length == 0) refuse("coil:", "its two ends are one point");
    const int points_a_turn = 24;
    const double straight = 0.08;  // share of the length at each end
    const Vector3d along = (b - a) / length;
    const Vector3d side = along.unitOrthogonal(), other = along.cross(side);
    std::vector<Vector3d> points{a};
    const int n = points_a_turn * turns;
    for (int i = 0; i <= n; ++i) {
        const double share = double(i) / n, angle = 2 * std::numbers::pi * turns * share;
        const double grow = std::min({1.0, 4.0 * i / points_a_turn, 4.0 * (n - i) / points_a_turn});
        points.push_back(a + along * length * (straight + (1 - 2 * straight) * share) +
                         grow * radius * (std::cos(angle) * side + std::sin(angle) * other));
    }
    points.push_back(b);
    return points;
}

void add(Drawing& drawing, const Stroboscope& s) {
    const auto& path = s.exact_path.empty() ? s.exact : s.exact_path;
    if (path.size() > 1) {
        drawing.add(
            Trail{.points = path, .colour = palette::exact, .dashed = true, .width = 3, .shadow = false});
    }
    for (const Vector3d& centre : s.exact) {
        drawing.add(
            Ball{.centre = centre, .radius = s.radius, .colour = palette::exact, .look = Look::ghost});
    }
    for (std::size_t i = 0; s.error_lines && i < std::min(s.exact.size(), s.computed.size()); ++i) {
        drawing.add(Trail{.points = {s.exact[i], s.computed[i]},
                          .colour = s.colour,
                          .width = 1.6,
                          .opacity = 0.7,
                          .shadow = false});
    }
    if (s.computed.size() > 1) drawing.add(Trail{.points = s.computed, .colour = s.colour});
    for (const Vector3d& centre : s.computed) {
        drawing.add(Ball{.centre = centre, .radius = s.radius, .colour = s.colour, .contact_shadow = true});
    }
}

}  // namespace nutshell::picture
