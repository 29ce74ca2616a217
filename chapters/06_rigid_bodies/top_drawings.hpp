// What the second half of chapter 6 shows: a handle, a spanner, a top, and arrows. All of it in
// this header, because the page's module is compiled from live/ alone.
#pragma once
#include <nutshell/picture/camera.hpp>
#include <nutshell/picture/drawing.hpp>
#include <nutshell/top_scenes.hpp>

namespace nutshell {

namespace pic = picture;

/// From the axes of a body whose centre of mass is at `at` to the world.
inline Eigen::Isometry3d posed(const Quaternion& q, const Vector3& at) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = rotation_matrix(q);
    pose.translation() = at;
    return pose;
}

/// A box of a body: where its middle is in the body [m], and half its edges.
inline pic::Box block(const Quaternion& q, const Vector3& at, const Vector3& middle,
                      const Vector3& half, pic::Colour colour, pic::Look look) {
    return {.pose = posed(q, at + rotate(q, middle)),
            .half_extents = half,
            .colour = colour,
            .look = look,
            .marked = look == pic::Look::solid};
}

/// The handle of the flip, its rods drawn thick so that their faces can be told apart; a ball on
/// one end of the bar, so that left is not right.
inline void add_handle(pic::Drawing& drawing, const Quaternion& q, const Vector3& at,
                       pic::Colour colour, pic::Look look = pic::Look::solid) {
    const Handle handle;
    const double half = 0.085, foot = handle.foot();
    drawing.add(block(q, at, {0, foot, 0}, {handle.bar / 2, half, half}, colour, look));
    drawing.add(block(q, at, {0, foot + (handle.stem + half) / 2, 0},
                      {half, (handle.stem - half) / 2, half}, colour, look));
    drawing.add(pic::Ball{.centre = at + rotate(q, Vector3(handle.bar / 2, foot, 0)),
                          .radius = 0.15,
                          .colour = look == pic::Look::solid ? pic::palette::gold : colour,
                          .look = look});
}

/// A spanner along its body's x: shaft, jaw at +x, a ring at the other end; `times` as large as
/// it is.
inline void add_spanner(pic::Drawing& drawing, const Quaternion& q, const Vector3& at,
                        double times, pic::Colour colour, pic::Look look = pic::Look::solid) {
    const auto put = [&](const Vector3& middle, const Vector3& half) {
        drawing.add(block(q, at, times * middle, times * half, colour, look));
    };
    put({0, 0, 0}, {0.085, 0.011, 0.005});
    put({0.088, 0, 0}, {0.012, 0.024, 0.008});
    put({0.109, 0.018, 0}, {0.014, 0.007, 0.008});
    put({0.109, -0.018, 0}, {0.014, 0.007, 0.008});
    put({-0.095, 0, 0}, {0.016, 0.016, 0.008});
    if (look == pic::Look::solid)
        drawing.add(pic::Ball{.centre = at + rotate(q, Vector3(0.12 * times, 0, 0)),
                              .radius = 0.012 * times,
                              .colour = pic::palette::gold});
}

/// The heavy top of 1 kg: a cylinder that has its moments, 0.06, 0.06 and 0.1 kg m^2, on an axle
/// from the pivot at the origin; its sectors alternate, so that it can be seen to spin.
inline void add_top(pic::Drawing& drawing, const Quaternion& q, double distance,
                    pic::Colour colour, pic::Look look = pic::Look::solid) {
    const double radius = std::sqrt(0.2),
                 half = std::sqrt(0.12) / 2;  // m r^2/2, m (3 r^2 + h^2)/12
    const auto at = [&](double r, double angle, double z) {
        return Vector3(r * std::cos(angle), r * std::sin(angle), distance + z);
    };
    constexpr int sectors = 8, parts = 6;
    for (const bool light : {false, true}) {
        pic::Mesh mesh{.points = {},
                       .triangles = {},
                       .pose = posed(q, Vector3::Zero()),
                       .colour = light && look == pic::Look::solid
                                     ? pic::mix(colour, pic::palette::paper, 0.6F)
                                     : colour,
                       .look = look};
        for (int sector = light ? 1 : 0; sector < sectors; sector += 2)
            for (int part = 0; part < parts; ++part) {
                const double a = 2 * pi / sectors * (sector + part / double(parts)),
                             b = a + 2 * pi / (sectors * parts);
                const int first = static_cast<int>(mesh.points.size());
                for (const Vector3& p :
                     {at(0, 0, half), at(radius, a, half), at(radius, b, half),
                      at(radius, a, -half), at(radius, b, -half), at(0, 0, -half)})
                    mesh.points.push_back(p);
                for (const auto& [i, j, k] : {std::array{0, 1, 2}, std::array{1, 3, 4},
                                              std::array{1, 4, 2}, std::array{5, 4, 3}})
                    mesh.triangles.push_back({first + i, first + j, first + k});
            }
        drawing.add(mesh);
    }
    drawing.add(pic::Rod{.from = Vector3::Zero(),
                         .to = rotate(q, Vector3(0, 0, distance + half + 0.12)),
                         .radius = 0.02,
                         .colour = look == pic::Look::solid ? pic::palette::steel : colour,
                         .look = look});
}

/// The colour of a method's family, for what it computed.
inline pic::Colour colour_of(Family family) {
    return pic::hex(shades_of(family));
}

}  // namespace nutshell
