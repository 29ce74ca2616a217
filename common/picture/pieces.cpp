#include "pieces.hpp"

#include <algorithm>
#include <cmath>

namespace nutshell::picture {

using Eigen::Matrix3d, Eigen::Vector3d, Eigen::Vector3f;

Frame frame_of(const Drawing& drawing, const Camera& camera) {
    if (drawing.stage()) return {drawing.stage()->centre, drawing.stage()->radius};
    const double least = 0.05 * (camera.eye - camera.target).norm();
    const std::vector<Extent> extents = drawing.extents();
    if (extents.empty()) return {camera.target, 0.4 * (camera.eye - camera.target).norm()};
    Vector3d low = extents.front().centre, high = low;
    for (const Extent& extent : extents) {
        low = low.cwiseMin(extent.centre - Vector3d::Constant(extent.radius));
        high = high.cwiseMax(extent.centre + Vector3d::Constant(extent.radius));
    }
    const Vector3d middle = (low + high) / 2;
    double radius = least;
    for (const Extent& extent : extents)
        radius = std::max(radius, (extent.centre - middle).norm() + extent.radius);
    return {middle, radius};
}

Vector3f linear(const Colour& colour) {
    return Vector3f(colour.red, colour.green, colour.blue).array().max(0.0F).min(1.0F).pow(2.2F);
}

Run Pieces::append(const Triangles& more) {
    const Run run{int(triangles_.indices.size()), int(more.indices.size())};
    const auto start = std::uint32_t(triangles_.vertices.size());
    triangles_.vertices.insert(triangles_.vertices.end(), more.vertices.begin(), more.vertices.end());
    for (std::uint32_t index : more.indices) triangles_.indices.push_back(start + index);
    return run;
}

Run Pieces::shared(Shape shape, int detail) {
    const auto key = std::make_pair(shape, detail);
    if (const auto found = shared_.find(key); found != shared_.end()) return found->second;
    const Run run = append(shape == Shape::ball  ? unit_ball(detail)
                           : shape == Shape::rod ? unit_rod(2 * detail)
                                                 : unit_cone(2 * detail));
    return shared_[key] = run;
}

double Pieces::depth(const Vector3d& at) const {
    return -view_.to_camera(frame_.origin + frame_.unit * at).z() / frame_.unit;
}

/// As many rings as make the outline's corners smaller than a quarter of a sample.
int Pieces::detail(const Vector3d& at, double radius) const {
    const double wanted = 2.2 * std::sqrt(radius / std::max(depth(at), radius) / pixel_);
    for (int rings : {6, 12, 24, 48}) {
        if (wanted <= rings) return rings;
    }
    return 96;
}

void Pieces::place(Run run, Run shadow_run, const Matrix3d& shape, const Vector3d& at, const Piece& look) {
    Piece piece = look;
    piece.run = run;
    piece.shadow_run = shadow_run;
    piece.model.topLeftCorner<3, 3>() = shape.cast<float>();
    piece.model.topRightCorner<3, 1>() = at.cast<float>();
    Matrix3d cofactors;
    cofactors << shape.col(1).cross(shape.col(2)), shape.col(2).cross(shape.col(0)),
        shape.col(0).cross(shape.col(1));
    piece.normal_matrix = (cofactors / cofactors.cwiseAbs().maxCoeff()).cast<float>();
    pieces_.push_back(piece);
}

void Pieces::cast(const Piece& look, const std::vector<Vector3d>& points, double radius) {
    if (!look.shadow) return;
    for (const Vector3d& point : points) casters_.push_back({point, radius});
}

void Pieces::add_bar(Shape shape, const Vector3d& from, const Vector3d& to, double radius,
                     const Piece& given) {
    const Vector3d along = to - from;
    if (along.norm() < 1e-12) return;
    Piece look = given;
    look.extent = {(from + to) / 2, along.norm() / 2 + radius};
    const Vector3d side = along.unitOrthogonal();
    Matrix3d columns;
    columns << radius * side, along, radius * side.cross(along.normalized());
    const Run run = shared(shape, std::max(12, detail(look.extent.centre, radius)));
    place(run, run, columns, from, look);
    cast(look, {from, to}, radius);
}

void Pieces::add_arrow(const Arrow& arrow) {
    const Vector3d from = frame_(arrow.from), vector = arrow.vector / frame_.unit;
    const double length = vector.norm(), away = depth(from + vector / 2);
    if (length < 1e-9 || away <= 0) return;
    const double width = arrow.width * away * 2 * view_.tangent * view_.aspect / 960;
    const double head = std::min(3.4 * width, 0.6 * length), share = head / (3.4 * width);
    const Vector3d neck = from + vector * (1 - head / length);
    Piece look;
    look.colour = linear(arrow.colour);
    look.shadow = false;  // it is no thing of the scene
    add_bar(Shape::rod, from, neck + 0.1 * head * vector / length, width / 2 * share, look);
    add_bar(Shape::cone, neck, from + vector, 1.45 * width * share, look);
}

Pieces::Pieces(const Drawing& drawing, const Frame& frame, const View& view, double pixel)
    : frame_(frame), view_(view), pixel_(pixel) {
    auto looks = [](const auto& thing) {
        Piece piece;
        piece.colour = linear(thing.colour);
        piece.ghost = thing.look == Look::ghost;
        piece.shadow = !piece.ghost;
        return piece;
    };
    auto around = [](const std::vector<Vector3d>& points, double radius) {
        double reach = 0;
        for (const Vector3d& point : points) reach = std::max(reach, (point - points.front()).norm());
        return Extent{points.front(), reach + radius};
    };
    const Matrix3d as_it_is = Matrix3d::Identity();
    const Vector3d in_place = Vector3d::Zero();
    for (const Ball& ball : drawing.balls()) {
        Piece look = looks(ball);
        look.shines = ball.shines;
        look.shadow = look.shadow && !ball.shines;
        look.extent = {frame_(ball.centre), ball.radius / frame_.unit};
        const int rings = detail(look.extent.centre, look.extent.radius);
        const Run run = shared(Shape::ball, rings),
                  shadow_run = shared(Shape::ball, std::clamp(rings / 2, 8, 24));
        place(run, shadow_run, look.extent.radius * as_it_is, look.extent.centre, look);
        cast(look, {look.extent.centre}, look.extent.radius);
    }
    for (const Box& box : drawing.boxes()) {
        Piece look = looks(box);
        const Vector3d half = box.half_extents / frame_.unit;
        look.extent = {frame_(box.pose.translation()), half.norm()};
        const double bevel = (look.ghost ? 0.004 : 0.07) * half.minCoeff();  // a ghost's edges are thin lines
        const Run run = append(rounded_box(half, bevel));
        place(run, run, box.pose.linear(), look.extent.centre, look);
        std::vector<Vector3d> corners;
        for (const Vector3d& corner : corners_of(box)) corners.push_back(frame_(corner));
        cast(look, corners, 0);
    }
    for (const Rod& rod : drawing.rods()) {
        add_bar(Shape::rod, frame_(rod.from), frame_(rod.to), rod.radius / frame_.unit, looks(rod));
    }
    for (const Tube& given : drawing.tubes()) {
        Piece look = looks(given);
        std::vector<Vector3d> points;
        for (const Vector3d& point : given.points) points.push_back(frame_(point));
        const double radius = given.radius / frame_.unit;
        look.extent = around(points, radius);
        const Run run = append(tube(points, radius, 14));
        place(run, run, as_it_is, in_place, look);
        cast(look, points, radius);
    }
    for (const Mesh& mesh : drawing.meshes()) {
        Piece look = looks(mesh);
        Mesh placed = mesh;
        for (Vector3d& point : placed.points) point = frame_(mesh.pose * point);
        look.extent = around(placed.points, 0);
        look.closed = false;
        const Run run = append(triangles_of(placed));
        place(run, run, as_it_is, in_place, look);
        cast(look, placed.points, 0);
    }
    for (const Arrow& arrow : drawing.arrows()) add_arrow(arrow);
}

}  // namespace nutshell::picture
