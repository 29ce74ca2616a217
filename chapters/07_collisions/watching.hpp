// Runs a scene of rest and keeps the worst of what was seen on the way.
#pragma once
#include <nutshell/lab/run.hpp>
#include <nutshell/rest_scenes.hpp>

namespace nutshell {

/// The worst of a run.
struct Watched {
    double drift = 0;                     ///< of any centre from the vertical axis [m]
    double overlap = 0;                   ///< [m]
    double energy = 0;                    ///< highest, of that at the start
    double last_speed = 0, last_top = 0;  ///< in the last second; at the end [m/s]
    double body_step = 0;                 ///< processor time of one step of one body [s]
    int escaped = 0;
    World end;
};

/// @param look_every  steps between two looks for overlaps (a look at all pairs is dear)
template <class Scene>
Watched watched(const Scene& scene, const Switches& switches, double dt = 1 / 60.0,
                int look_every = 1) {
    Watched seen;
    World& world = seen.end = checked(scene.start());
    Engine engine(switches);
    const double before = energy(world);
    const long steps = lab::steps_of(scene.duration, dt);
    double took = 0;
    for (long i = 0; i < steps; ++i) {
        const double begin = lab::processor_seconds();
        engine.step(world, dt);
        took += lab::processor_seconds() - begin;
        for (const Body& body : world.bodies)
            seen.drift = std::max(seen.drift, std::hypot(body.position.x(), body.position.z()));
        if (i % look_every == 0) seen.overlap = std::max(seen.overlap, deepest_overlap(world));
        seen.energy = std::max(seen.energy, energy(world) / before);
        seen.escaped = std::max(seen.escaped, escaped(world));
        seen.last_top = top_speed(world);
        if (static_cast<double>(i) * dt >= scene.duration - 1 - dt / 2)
            seen.last_speed = std::max(seen.last_speed, seen.last_top);
    }
    seen.body_step = took / static_cast<double>(steps) / static_cast<double>(world.bodies.size());
    return seen;
}

}  // namespace nutshell
