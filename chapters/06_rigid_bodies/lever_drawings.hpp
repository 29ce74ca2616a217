// What the moving figures of chapter 6's first half show.
#pragma once
#include <nutshell/body.hpp>
#include <nutshell/mesh_shapes.hpp>
#include <nutshell/picture/camera.hpp>
#include <nutshell/picture/drawing.hpp>

namespace nutshell {

namespace pic = picture;

/// A nail in a wall, on which pendulums hang.
inline void add_nail(pic::Drawing& drawing, const Vector3& at) {
    drawing.add(pic::Rod{.from = at + Vector3(0, 0, -0.12),
                         .to = at + Vector3(0, 0, 0.12),
                         .radius = 0.022,
                         .colour = pic::palette::steel});
}

/// A bob of a pendulum on its thin rod, hanging along the body's -y.
inline void add_bob(pic::Drawing& drawing, const Vector3& nail, const Quaternion& pose,
                    double length, pic::Colour colour, pic::Look look = pic::Look::solid) {
    const Vector3 bob = nail + rotate(pose, Vector3(0, -length, 0));
    drawing.add(
        pic::Rod{.from = nail, .to = bob, .radius = 0.008, .colour = colour, .look = look});
    drawing.add(pic::Ball{.centre = bob, .radius = 0.07, .colour = colour, .look = look});
}

/// A heavy rod on a nail, hanging along the body's -y.
inline void add_heavy_rod(pic::Drawing& drawing, const Vector3& nail, const Quaternion& pose,
                          double length, pic::Colour colour, pic::Look look = pic::Look::solid) {
    drawing.add(pic::Rod{.from = nail,
                         .to = nail + rotate(pose, Vector3(0, -length, 0)),
                         .radius = 0.035,
                         .colour = colour,
                         .look = look});
}

/// Blocks where the body is; `from_body` takes the blocks' axes into the body's.
inline void add_blocks(pic::Drawing& drawing, const std::vector<Block>& blocks,
                       const Quaternion& turn, const Vector3& centre, const Vector3& at,
                       pic::Look look = pic::Look::solid) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const Block& block = blocks[i];
        pic::Box box;
        box.pose.translation() = at + rotate(turn, block.place - centre);
        box.pose.linear() = rotation_matrix(turn) * block.rotation;
        box.half_extents = block.size / 2;
        box.colour = block.density > 2000 ? pic::palette::steel : pic::palette::gold;
        box.look = look;
        drawing.add(box);
    }
}

}  // namespace nutshell
