// What chapter 5's moving figures show. All of it in this header, because the page's module is
// compiled from live/ alone.
#pragma once
#include <nutshell/picture/camera.hpp>
#include <nutshell/picture/drawing.hpp>
#include <nutshell/spinning_scenes.hpp>

namespace nutshell {

namespace pic = picture;

/// A wheel whose axle is its body's z: rim, hub and spokes, the first one in another colour if it
/// is `painted`.
inline void add_wheel(pic::Drawing& drawing, const Quaternion& pose, const Vector3& centre,
                      double radius, int spokes, pic::Colour colour, bool painted,
                      pic::Look look = pic::Look::solid) {
    const auto place = [&](double r, double angle) {
        return Vector3(centre + rotate(pose, r * Vector3(std::cos(angle), std::sin(angle), 0)));
    };
    pic::Tube rim{.points = {}, .radius = 0.05 * radius, .colour = colour, .look = look};
    for (int i = 0; i <= 64; ++i) rim.points.push_back(place(radius, 2 * pi * i / 64));
    drawing.add(rim);
    for (int i = 0; i < spokes; ++i) {
        const bool special = painted && i == 0;
        drawing.add(
            pic::Rod{.from = centre,
                     .to = place(radius, pi / 2 + 2 * pi * i / spokes),
                     .radius = (special ? 0.045 : 0.03) * radius,
                     .colour = special && look == pic::Look::solid ? pic::palette::gold : colour,
                     .look = look});
    }
    if (look == pic::Look::solid)
        drawing.add(pic::Ball{.centre = centre, .radius = 0.1 * radius, .colour = colour});
}

}  // namespace nutshell
