// The programs that OpenGL runs: one text for OpenGL 3.3 and, but for its first line, for WebGL2. Lengths are
// in units of the drawing's radius, so nothing depends on its scale.
#pragma once

namespace nutshell::picture::shaders {

/// Things and ground: position and normal to the world; also used, without a fragment shader, for the shadow
/// map.
inline constexpr const char* solid_vertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 model, view_projection;
uniform mat3 normal_matrix;
out vec3 world, facing;
void main() {
    vec4 place = model * vec4(position, 1.0);
    world = place.xyz;
    facing = normal_matrix * normal;
    gl_Position = view_projection * place;
})";

inline constexpr const char* nothing_fragment = "#version 330 core\nvoid main() {}";

/// How much of the sun reaches a point: nine comparisons with the shadow map, spread over its softness.
inline constexpr const char* sunlight = R"(#version 330 core
uniform mat4 shadow_view;          // world to the shadow map, 0 to 1
uniform vec2 shadow_step;          // between two comparisons, in the map
uniform float shadow_lift;         // how far a surface is lifted off its own shadow
uniform vec3 sun, up;
uniform sampler2DShadow shadow_map;
float sunlight(vec3 place, vec3 normal) {
    vec3 at = (shadow_view * vec4(place + shadow_lift * normal, 1.0)).xyz;
    at.z = min(at.z, 1.0);   // a depth map of floats does not do it by itself
    float sum = 0.0;
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j) sum += texture(shadow_map, vec3(at.xy + vec2(i, j) * shadow_step, at.z));
    return sum / 9.0;
}
)";

/// A thing: sun with soft shadow, light of sky and ground from above and below, a small highlight.
/// kind 0: solid; 1: ghost, clearer in its middle than at its rim; 2: shines by itself.
inline constexpr const char* solid_fragment = R"(
in vec3 world, facing;
uniform vec3 colour, eye;
uniform int kind, closed;
out vec4 pixel;
void main() {
    vec3 to_eye = normalize(eye - world), normal = normalize(facing);
    if (closed == 0 && dot(normal, to_eye) < 0.0) normal = -normal;
    float rim = 1.0 - max(dot(normal, to_eye), 0.0), opacity = 1.0;
    vec3 light;
    if (kind == 1) {
        light = colour;
        opacity = mix(0.20, 0.62, rim * rim);
    } else if (kind == 2) {
        light = mix(colour, vec3(1.0, 0.97, 0.88), 0.8 * (1.0 - rim) * (1.0 - rim));
    } else {
        float height = 0.5 + 0.5 * dot(normal, up), slope = max(dot(normal, sun), 0.0);
        float lit = slope > 0.0 ? sunlight(world, normal) : 0.0;
        vec3 ambient = mix(vec3(0.30, 0.29, 0.29), vec3(0.47, 0.50, 0.55), height);
        light = colour * (ambient + lit * slope * vec3(0.80, 0.77, 0.72));
        float shine = pow(max(dot(normal, normalize(to_eye + sun)), 0.0), 48.0);
        light += lit * 0.16 * shine + 0.05 * rim * rim * rim * vec3(0.9, 0.95, 1.0);
    }
    pixel = vec4(pow(light, vec3(1.0 / 2.2)), opacity);
})";

/// The ground: a grid that fades with the distance from the drawing into the sky's horizon.
inline constexpr const char* ground_fragment = R"(
in vec3 world, facing;
uniform vec3 colour, horizon, focus, grid_u, grid_v, ink;   // ink: what a line of the grid makes of the ground
uniform vec2 grid_offset;          // of the world's origin, in squares, modulo ten
uniform float squares;             // in one unit of length
uniform float samples;             // of a pixel along each side
out vec4 pixel;
float lines(vec2 at, float width) {
    vec2 size = max(fwidth(at), 1e-6);
    vec2 away = abs(fract(at - 0.5) - 0.5) / size;
    vec2 ink = clamp(0.5 * width + 0.5 - away, 0.0, 1.0) * (1.0 - smoothstep(0.24, 0.70, samples * size));
    return max(ink.x, ink.y);
}
void main() {
    vec2 at = vec2(dot(world, grid_u), dot(world, grid_v)) * squares + grid_offset;
    float distance = length(world - focus), near = exp(-0.045 * distance * distance);
    float line = max(0.50 * lines(at, 1.1 * samples), 0.85 * lines(at / 5.0, 1.5 * samples));
    float lit = sunlight(world, up);
    vec3 light = mix(horizon, colour, near);
    light *= mix(vec3(1.0), ink, line * near);
    light *= mix(vec3(0.42, 0.46, 0.54), vec3(1.0), lit);
    pixel = vec4(pow(light, vec3(1.0 / 2.2)), 1.0);
})";

/// The sky: from the horizon up, on one triangle that covers the picture.
inline constexpr const char* sky_vertex = R"(#version 330 core
out float height;
void main() {
    vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    height = 0.5 + 0.5 * at.y;
    gl_Position = vec4(at, 0.0, 1.0);
})";
inline constexpr const char* sky_fragment = R"(#version 330 core
in float height;
uniform vec3 top, horizon;
uniform float horizon_height;
out vec4 pixel;
void main() {
    float share = smoothstep(0.0, 1.0, (height - horizon_height) / max(1.0 - horizon_height, 0.6));
    pixel = vec4(pow(mix(horizon, top, share), vec3(1.0 / 2.2)), 1.0);
})";

/// Trails: ribbons of constant width, already projected; across and along are in pixels.
inline constexpr const char* trail_vertex = R"(#version 330 core
layout(location = 0) in vec4 place;
layout(location = 1) in vec2 ribbon;
layout(location = 2) in vec4 colour;
out vec2 at;   // times w: straight on the picture, not in space
out vec4 tint;
void main() {
    at = ribbon * place.w;
    tint = colour;
    gl_Position = place;
})";
inline constexpr const char* trail_fragment = R"(#version 330 core
in vec2 at;
in vec4 tint;
uniform float half_width, dash, gap;   // dash 0: solid
out vec4 pixel;
void main() {
    float ink = clamp(half_width + 0.5 - abs(at.x * gl_FragCoord.w), 0.0, 1.0);
    float along = mod(at.y * gl_FragCoord.w, dash + gap);
    if (dash > 0.0) ink *= clamp(0.5 * dash + 0.5 - abs(along - 0.5 * dash), 0.0, 1.0);
    pixel = vec4(pow(tint.rgb, vec3(1.0 / 2.2)), tint.a * ink);
})";

/// The glow round what shines, on a square.
inline constexpr const char* glow_fragment = R"(#version 330 core
in vec2 at;
in vec4 tint;
out vec4 pixel;
void main() {
    float fade = max(1.0 - length(at * gl_FragCoord.w), 0.0);
    pixel = vec4(pow(tint.rgb, vec3(1.0 / 2.2)), tint.a * fade * fade);
})";

}  // namespace nutshell::picture::shaders
