// What the pictures and the moving figures of chapter 4 show: each drawing made in one place.
#pragma once
#include <nutshell/picture/camera.hpp>
#include <nutshell/picture/drawing.hpp>
#include <nutshell/rotation_scenes.hpp>

namespace nutshell {

namespace pic = picture;

/// From the frame of a body that stands at `at` in the pose q to the world.
Eigen::Isometry3d placed(const Quaternion& q, const Vector3& at);

/// A book with marked faces: its cover looks along +z, its back stands along y.
pic::Box book(const Quaternion& q, const Vector3& at, pic::Colour colour, double size = 1);

/// A cube with marked faces, every corner multiplied by `map`, be it a rotation or not.
void add_cube(pic::Drawing& drawing, const Matrix3& map, const Vector3& at, pic::Colour colour,
              pic::Look look = pic::Look::solid);

/// A circle of radius r about `axis` through `centre`, from one angle to another [rad]; the angle 0
/// is in the direction of `zero`, which is made perpendicular to the axis.
std::vector<Vector3> arc(const Vector3& centre, const Vector3& axis, const Vector3& zero,
                         double r, double from, double to);

/// A body on gimbals: the outer ring turns with the yaw, the middle one with the pitch too, the
/// body with all three.
pic::Drawing gimbals(const EulerAngles& angles);

/// The path of one point of a body on a sphere, on `way` from 0 to 1, with a dot every tenth.
template <class Way>
void add_way(pic::Drawing& drawing, const Way& way, pic::Colour colour, double radius,
             const std::string& name, double until = 1) {
    const Vector3 nose(0, 0, radius);
    pic::Trail trail{.points = {}, .colour = colour, .width = 5};
    for (int i = 0; i <= 100 && i <= 100 * until + 1e-9; ++i)
        trail.points.push_back(rotate(way(i / 100.0), nose));
    if (trail.points.size() > 1) drawing.add(trail);
    for (int i = 0; i <= 10 && i <= 10 * until + 1e-9; ++i)
        drawing.add(
            pic::Ball{.centre = rotate(way(i / 10.0), nose), .radius = 0.045, .colour = colour});
    if (!name.empty())
        drawing.add(
            pic::Label{rotate(way(0.5 * until), Vector3(0, 0, 1.12 * radius)), name, colour});
}

}  // namespace nutshell
