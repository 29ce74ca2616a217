#include "pieces.hpp"

#include <algorithm>
#include <cmath>

namespace nutshell::picture {

using Eigen::Matrix3d, Eigen::Vector3d, Eigen::Vector3f;

Frame frame_of(const Drawing& drawing, const Camera& camera) {
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

Pieces::Run Pieces::append(const Vertices& vertices) {
    const Run run{int(vertices_.size()), int(vertices.size())};
    vertices_.insert(vertices_.end(), vertices.begin(), vertices.end());
    return run;
}

Pieces::Run Pieces::shared(Shape shape, int detail) {
    const auto key = std::make_pair(shape, detail);
    if (const auto found = shared_.find(key); found != shared_.end()) return found->second;
    const Run run = append(shape == Shape::ball  ? unit_ball(detail)
                           : shape == Shape::rod ? unit_rod(2 * detail)
                                                 : unit_cone(2 * detail));
    return shared_[key] = run;
}

/// As many rings as make the outline's corners smaller than a quarter of a sample.
int Pieces::detail(const Vector3d& at, double radius) const {
    const double depth = std::max(-view_.to_camera(at).z(), radius);
    const double wanted = 2.2 * std::sqrt(radius / depth / pixel_);
    for (int rings : {6, 12, 24, 48}) {
        if (wanted <= rings) return rings;
    }
    return 96;
}

void Pieces::place(Run run, const Matrix3d& shape, const Vector3d& at, const Piece& look) {
    Piece piece = look;
    piece.first = run.first;
    piece.count = run.count;
    piece.model.topLeftCorner<3, 3>() = shape.cast<float>();
    piece.model.topRightCorner<3, 1>() = at.cast<float>();
    const Matrix3d cofactors = (Matrix3d() << shape.col(1).cross(shape.col(2)),
                                shape.col(2).cross(shape.col(0)), shape.col(0).cross(shape.col(1)))
                                   .finished();
    piece.normal_matrix = (cofactors / cofactors.cwiseAbs().maxCoeff()).cast<float>();
    piece.shadow = piece.shadow && !piece.ghost && !piece.shines;
    if (piece.shadow) casters_.push_back(piece.extent);
    pieces_.push_back(piece);
}

void Pieces::add_bar(Shape shape, const Vector3d& from, const Vector3d& to, double radius,
                     const Piece& given) {
    const Vector3d along = to - from;
    if (along.norm() < 1e-12) return;
    Piece look = given;
    look.extent = {(from + to) / 2, along.norm() / 2 + radius};
    const Vector3d side = along.unitOrthogonal();
    const Vector3d other = side.cross(along.normalized());
    Matrix3d columns;
    columns << radius * side, along, radius * other;
    if (columns.determinant() < 0) columns.col(2) = -columns.col(2);
    place(shared(shape, std::max(12, detail(view_.eye, radius))), columns, from, look);
}

void Pieces::add_arrow(const Arrow& arrow) {
    const Vector3d from = frame_(arrow.from), vector = arrow.vector / frame_.unit;
    const double length = vector.norm();
    if (length < 1e-9) return;
    const double depth = -view_.to_camera(arrow.from + arrow.vector / 2).z() / frame_.unit;
    if (depth <= 0) return;
    const double width = arrow.width * depth * 2 * view_.tangent * view_.aspect / 960;
    const double head = std::min(3.4 * width, 0.6 * length), share = head / (3.4 * width);
    const Vector3d neck = from + vector * (1 - head / length);
    Piece look;
    look.colour = linear(arrow.colour);
    add_bar(Shape::rod, from, neck + 0.1 * head * vector / length, width / 2 * share, look);
    add_bar(Shape::cone, neck, from + vector, 1.45 * width * share, look);
}

Pieces::Pieces(const Drawing& drawing, const Frame& frame, const View& view, double pixel)
    : frame_(frame), view_(view), pixel_(pixel) {
    auto looks = [](const auto& thing) {
        Piece piece;
        piece.colour = linear(thing.colour);
        piece.ghost = thing.look == Look::ghost;
        return piece;
    };
    for (const Ball& ball : drawing.balls()) {
        Piece look = looks(ball);
        look.shines = ball.shines;
        const double radius = ball.radius / frame_.unit;
        look.extent = {frame_(ball.centre), radius};
        place(shared(Shape::ball, detail(ball.centre, ball.radius)), radius * Matrix3d::Identity(),
              look.extent.centre, look);
    }
    for (const Box& box : drawing.boxes()) {
        Piece look = looks(box);
        const Vector3d half = box.half_extents / frame_.unit;
        look.extent = {frame_(box.pose.translation()), half.norm()};
        place(append(rounded_box(half)), box.pose.linear(), look.extent.centre, look);
    }
    for (const Rod& rod : drawing.rods()) {
        add_bar(Shape::rod, frame_(rod.from), frame_(rod.to), rod.radius / frame_.unit, looks(rod));
    }
    auto around = [](const std::vector<Vector3d>& points, double radius) {
        const Vector3d middle = points.front();
        double reach = 0;
        for (const Vector3d& point : points) reach = std::max(reach, (point - middle).norm());
        return Extent{middle, reach + radius};
    };
    for (const Tube& given : drawing.tubes()) {
        Piece look = looks(given);
        std::vector<Vector3d> points;
        for (const Vector3d& point : given.points) points.push_back(frame_(point));
        const double radius = given.radius / frame_.unit;
        look.extent = around(points, radius);
        look.shadow = false;  // its bounding ball would waste the shadow map; its points are casters below
        const Run run = append(tube(points, radius, 14));
        place(run, Matrix3d::Identity(), Vector3d::Zero(), look);
        if (look.ghost) continue;
        pieces_.back().shadow = true;
        for (const Vector3d& point : points) casters_.push_back({point, radius});
    }
    for (const Mesh& mesh : drawing.meshes()) {
        Piece look = looks(mesh);
        Mesh scaled = mesh;
        for (Vector3d& point : scaled.points) point = frame_(mesh.pose * point);
        look.extent = around(scaled.points, 0);
        look.shadow = false;
        place(append(triangles(scaled)), Matrix3d::Identity(), Vector3d::Zero(), look);
        if (look.ghost) continue;
        pieces_.back().shadow = true;
        for (const Vector3d& point : scaled.points) casters_.push_back({point, 0.0});
    }
    for (const Arrow& arrow : drawing.arrows()) add_arrow(arrow);
}

}  // namespace nutshell::picture
