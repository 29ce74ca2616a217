// Chapter 7 · The universe as a scene of the engine, in one sub-step a step as the source has it.
#pragma once
#include <nutshell/rest_scenes.hpp>
#include <nutshell/universe.hpp>

namespace nutshell {

// [universe_world]
inline constexpr Switches universe_switches{1};

inline World world_of(const Universe& universe) {
    World world;
    world.walls = {Plane{}};
    world.gravity = universe.force / universe.mass;
    world.surface = {universe.restitution, 0};
    world.add(universe.ball(), Sphere{universe.radius});
    return world;
}
// [/universe_world]

}  // namespace nutshell
