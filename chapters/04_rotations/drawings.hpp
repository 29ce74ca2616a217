// What the pictures and the moving figures of chapter 4 show: each drawing made in one place. All
// of it in this header, because the page's module is compiled from live/ alone.
#pragma once
#include <array>
#include <nutshell/picture/camera.hpp>
#include <nutshell/picture/drawing.hpp>
#include <nutshell/rotation_scenes.hpp>

namespace nutshell {

namespace pic = picture;

/// From the frame of a body that stands at `at` in the pose q to the world.
inline Eigen::Isometry3d placed(const Quaternion& q, const Vector3& at) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = rotation_matrix(q);
    pose.translation() = at;
    return pose;
}

/// A book with marked faces: its cover looks along +z, its back stands along y.
inline pic::Box book(const Quaternion& q, const Vector3& at, pic::Colour colour,
                     double size = 1) {
    return pic::Box{.pose = placed(q, at),
                    .half_extents = size * Vector3(0.5, 0.7, 0.16),
                    .colour = colour,
                    .marked = true};
}

/// A cube with marked faces, every corner multiplied by `map`, be it a rotation or not.
inline void add_cube(pic::Drawing& drawing, const Matrix3& map, const Vector3& at,
                     pic::Colour colour, pic::Look look = pic::Look::solid) {
    const std::array shades{pic::mix(colour, pic::palette::ink, 0.45F),
                            pic::mix(colour, pic::palette::paper, 0.55F), colour};
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-0.5, 0.5}) {
            Vector3 middle = Vector3::Zero(), u = middle, v = middle;
            middle[axis] = side, u[(axis + 1) % 3] = 0.5, v[(axis + 2) % 3] = 0.5;
            pic::Mesh face{.points = {},
                           .triangles = {{0, 1, 2}, {0, 2, 3}},
                           .colour = shades[static_cast<std::size_t>(axis)],
                           .look = look};
            for (const Vector3& corner : {Vector3(middle - u - v), Vector3(middle + u - v),
                                          Vector3(middle + u + v), Vector3(middle - u + v)})
                face.points.push_back(map * corner + at);
            drawing.add(face);
            if (side > 0 && look == pic::Look::solid)
                drawing.add(pic::Ball{
                    .centre = map * middle + at, .radius = 0.08, .colour = pic::palette::paper});
        }
}

/// The twelve edges of the cube turned by `q`: what is exact, round what should be.
inline void add_frame(pic::Drawing& drawing, const Quaternion& q) {
    for (int axis = 0; axis < 3; ++axis)
        for (const double u : {-0.5, 0.5})
            for (const double v : {-0.5, 0.5}) {
                Vector3 from = Vector3::Zero();
                from[axis] = -0.5, from[(axis + 1) % 3] = u, from[(axis + 2) % 3] = v;
                const Vector3 to = from + Vector3::Unit(axis);
                drawing.add(pic::Rod{.from = rotate(q, from),
                                     .to = rotate(q, to),
                                     .radius = 0.012,
                                     .colour = pic::palette::ink});
            }
}

/// A circle of radius r about `axis` through `centre`, from one angle to another [rad]; angle 0
/// is in the direction of `zero`, which is made perpendicular to the axis.
inline std::vector<Vector3> arc(const Vector3& centre, const Vector3& axis, const Vector3& zero,
                                double r, double from, double to) {
    const Vector3 n = axis.normalized(), u = (zero - n * n.dot(zero)).normalized() * r;
    std::vector<Vector3> points;
    for (int i = 0; i <= 48; ++i)
        points.push_back(centre + turned(u, n, from + (to - from) * i / 48));
    return points;
}

/// A body on gimbals: the outer ring turns with the yaw, the middle one with the pitch too, the
/// body with all three.
inline pic::Drawing gimbals(const EulerAngles& angles) {
    const Quaternion yaw = orientation_of({angles.yaw, 0, 0}),
                     pitch = orientation_of({angles.yaw, angles.pitch, 0}),
                     all = orientation_of(angles);
    const Vector3 up = Vector3::UnitY(), across = rotate(yaw, Vector3::UnitX()),
                  ahead = rotate(pitch, Vector3::UnitZ());
    pic::Drawing drawing;
    const auto ring = [&](const Vector3& axis, const Vector3& zero, double r,
                          pic::Colour colour) {
        drawing.add(pic::Tube{.points = arc({0, 0, 0}, axis, zero, r, 0, 2 * pi),
                              .radius = 0.035,
                              .colour = colour});
    };
    // each ring holds the axle of the next one
    ring(across, up, 1.5, pic::palette::explicit_euler);
    drawing.add(pic::Rod{.from = 1.5 * up, .to = 1.75 * up, .radius = 0.05});
    drawing.add(pic::Rod{.from = -1.5 * up, .to = -1.75 * up, .radius = 0.05});
    ring(rotate(pitch, up), across, 1.25, pic::palette::symplectic);
    for (const double side : {-1.0, 1.0}) {
        drawing.add(
            pic::Rod{.from = side * 1.25 * across, .to = side * 1.5 * across, .radius = 0.05});
        drawing.add(
            pic::Rod{.from = side * 0.6 * ahead, .to = side * 1.25 * ahead, .radius = 0.05});
    }
    drawing.add(book(all, {0, 0, 0}, pic::palette::body, 0.85));
    drawing.add(pic::Arrow{.from = 1.8 * up,
                           .vector = 0.55 * up,
                           .colour = pic::palette::explicit_euler,
                           .label = "yaw"});
    drawing.add(pic::Arrow{.from = 1.55 * across,
                           .vector = 0.55 * across,
                           .colour = pic::palette::symplectic,
                           .label = "pitch"});
    drawing.add(pic::Arrow{.from = 0.9 * ahead,
                           .vector = 0.9 * ahead,
                           .colour = pic::palette::body,
                           .label = "roll"});
    return drawing;
}

/// The path of the body's z on a sphere, on `way` from 0 to `until`, with a dot every tenth (of
/// radius `dot`; 0: none).
template <class Way>
void add_way(pic::Drawing& drawing, const Way& way, pic::Colour colour, double radius,
             double until = 1, double dot = 0.045) {
    const Vector3 nose(0, 0, radius);
    pic::Trail trail{.points = {}, .colour = colour, .width = 5};
    for (int i = 0; i <= 100 && i <= 100 * until + 1e-9; ++i)
        trail.points.push_back(rotate(way(i / 100.0), nose));
    if (trail.points.size() > 1) drawing.add(trail);
    for (int i = 0; dot > 0 && i <= 10 && i <= 10 * until + 1e-9; ++i)
        drawing.add(
            pic::Ball{.centre = rotate(way(i / 10.0), nose), .radius = dot, .colour = colour});
}

}  // namespace nutshell
