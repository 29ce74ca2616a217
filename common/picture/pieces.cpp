#include "pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace nutshell::picture {

using Eigen::Matrix3d, Eigen::Vector3d, Eigen::Vector3f;

namespace {

constexpr Colour white{1, 1, 1}, black{0, 0, 0};  // on either page

}  // namespace

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

Vector3f linear(const Colour& colour, Theme theme) {
    const Colour shown = colour.on(theme);
    return Vector3f(shown.red, shown.green, shown.blue).array().max(0.0F).min(1.0F).pow(2.2F);
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
    const Run run = append(shape == Shape::ball           ? unit_ball(detail)
                           : shape == Shape::rod          ? unit_rod(2 * detail)
                           : shape == Shape::even_octants ? unit_octants(detail, true)
                           : shape == Shape::odd_octants  ? unit_octants(detail, false)
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
    look.colour = linear(arrow.colour, theme_);
    look.shadow = false;  // it is no thing of the scene
    add_bar(Shape::rod, from, neck + 0.1 * head * vector / length, width / 2 * share, look);
    add_bar(Shape::cone, neck, from + vector, 1.45 * width * share, look);
}

void Pieces::add_ball(const Ball& ball, const Piece& given) {
    Piece look = given;
    look.extent = {frame_(ball.centre), ball.radius / frame_.unit};
    const auto& [centre, radius, unused] = look.extent;
    const int rings = detail(centre, radius);
    const Run shadow_run = shared(Shape::ball, std::clamp(rings / 2, 8, 24));
    cast(look, {centre}, radius);
    if (!ball.orientation) {
        place(shared(Shape::ball, rings), shadow_run, radius * Matrix3d::Identity(), centre, look);
        return;
    }
    const Matrix3d turned = radius * ball.orientation->toRotationMatrix();
    place(shared(Shape::even_octants, rings), shadow_run, turned, centre, look);
    look.shadow = false;
    look.colour = linear(mix(ball.colour, white, 0.75F), theme_);
    place(shared(Shape::odd_octants, rings), shadow_run, turned, centre, look);
}

void Pieces::add_box(const Box& box, const Piece& given) {
    Piece look = given;
    const Vector3d half = box.half_extents / frame_.unit;
    look.extent = {frame_(box.pose.translation()), half.norm()};
    const double bevel = (look.ghost ? 0.004 : 0.07) * half.minCoeff();  // a ghost's edges are thin lines
    const Run run = append(rounded_box(half, bevel));
    place(run, run, box.pose.linear(), look.extent.centre, look);
    std::vector<Vector3d> corners;
    for (const Vector3d& corner : corners_of(box)) corners.push_back(frame_(corner));
    cast(look, corners, 0);
    if (box.marked) mark_faces(box, half);
}

/// A thin plate on each face and a disc on three of them. @param half extents, in the frame
void Pieces::mark_faces(const Box& box, const Vector3d& half) {
    const double thick = 0.012 * half.minCoeff();
    const std::array<Colour, 3> plates{mix(box.colour, black, 0.55F), mix(box.colour, white, 0.72F),
                                       mix(box.colour, white, 0.12F)},
        dots{white, mix(box.colour, black, 0.7F), mix(box.colour, black, 0.7F)};
    const Matrix3d turned = box.pose.linear();
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const double least = std::min(half[u], half[v]);
        Vector3d plate = half - Vector3d::Constant(0.17 * least);
        plate[axis] = thick;
        const Run run = append(rounded_box(plate, 0.4 * thick));
        for (const double side : {-1.0, 1.0}) {
            Piece look;
            look.shadow = false;
            look.ghost = box.look == Look::ghost;
            look.colour = linear(plates[std::size_t(axis)], theme_);
            const Vector3d out = side * turned.col(axis),
                           face = frame_(box.pose.translation()) + half[axis] * out;
            look.extent = {face, plate.norm()};
            place(run, run, turned, face, look);
            if (side < 0) continue;
            look.colour = linear(dots[std::size_t(axis)], theme_);
            add_bar(Shape::rod, face, face + 2 * thick * out, 0.34 * least, look);
        }
    }
}

Pieces::Pieces(const Drawing& drawing, const Frame& frame, const View& view, double pixel)
    : frame_(frame), view_(view), pixel_(pixel), theme_(drawing.theme()) {
    auto looks = [this](const auto& thing) {
        Piece piece;
        piece.colour = linear(thing.colour, theme_);
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
    const Ground& ground = drawing.ground();
    for (const Ball& ball : drawing.balls()) {
        Piece look = looks(ball);
        const double above = ground.normal.dot(ball.centre) - ground.height;
        const bool far = ball.contact_shadow && !(std::abs(above) < 2 * ball.radius);
        look.shines = ball.shines;
        look.shadow = look.shadow && !ball.shines && !far;
        add_ball(ball, look);
    }
    for (const Box& box : drawing.boxes()) add_box(box, looks(box));
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
