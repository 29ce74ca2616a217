// What pictures share: the context and its programs, made once and kept.
#pragma once
#include <functional>
#include <string>

#include "gl.hpp"
#include "nutshell/picture/render.hpp"
#include "shaders.hpp"

namespace nutshell::picture {

struct Studio {
    Context context;
    gl::Program solid{shaders::solid_vertex, std::string(shaders::sunlight) + shaders::solid_fragment};
    gl::Program ground{shaders::solid_vertex, std::string(shaders::sunlight) + shaders::ground_fragment};
    gl::Program depth{shaders::solid_vertex, shaders::nothing_fragment};
    gl::Program sky{shaders::sky_vertex, shaders::sky_fragment};
    gl::Program trail{shaders::trail_vertex, shaders::trail_fragment};
    gl::Program glow{shaders::trail_vertex, shaders::glow_fragment};
};

/// Draws everything but words on the frame that `use_target` makes current. The studio's context must be the
/// current one, and the arguments good.
void draw(Studio& studio, const Drawing& drawing, const Camera& camera, Size size, const Quality& quality,
          const std::function<void()>& use_target);

/// The same, read back.
Image paint(Studio& studio, const Drawing& drawing, const Camera& camera, Size size, const Quality& quality);

}  // namespace nutshell::picture
