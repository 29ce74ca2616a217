// What chapter 7's moving figures share. All of it in this header, because the page's module is
// compiled from live/ alone.
#pragma once
#include <nutshell/picture/camera.hpp>
#include <nutshell/picture/drawing.hpp>

namespace nutshell {

namespace pic = picture;

/// A camera that holds a rectangle of the picture's plane, seen from `from`.
inline pic::Camera camera_on(const Vector3& low, const Vector3& high, const Vector3& from,
                             pic::Size size) {
    pic::Drawing room;
    room.add(pic::Trail{.points = {low, {high.x(), low.y(), low.z()}, high}});
    return pic::fit(room, from, size, {.margin = 0.02});
}

}  // namespace nutshell
