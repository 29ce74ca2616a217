// From a drawing and a camera to pixels.
#pragma once
#include <string>

#include "nutshell/picture/camera.hpp"
#include "nutshell/picture/drawing.hpp"
#include "nutshell/picture/image.hpp"

namespace nutshell::picture {

/// How much work goes into a picture.
struct Quality {
    int samples = 2;        ///< per pixel along each side: 2 means 2 x 2
    int shadow_map = 2048;  ///< [texels along each side]
};

/// Draws. The same input gives the same bytes on one machine, whatever its number of threads.
/// @throws NoGraphics if this machine cannot draw
/// @throws std::invalid_argument if the size is not in 1..4096, the quality not in 1..4 samples, or the
/// camera is bad
Image render(const Drawing& drawing, const Camera& camera, Size size = {}, const Quality& quality = {});

/// The same without its words.
Image render_bare(const Drawing& drawing, const Camera& camera, Size size = {}, const Quality& quality = {});

/// Whether this machine can draw.
bool available();

/// One line: what draws ("OSMesa: llvmpipe ..., OpenGL 4.5 ..."), or why nothing can.
std::string backend();

}  // namespace nutshell::picture
