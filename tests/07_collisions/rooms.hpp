// What must hold in every room, whoever is in it.
#pragma once
#include <nutshell/rest_scenes.hpp>
#include "near.hpp"

namespace nutshell {

/// Two seconds in a room [dt 1/60 s]: no NaN, nobody escapes, no energy is gained.
inline void check_room(World world, Engine engine, std::uint64_t seed) {
    const double before = energy(world);
    double highest = -immovable;
    bool finite = true;
    for (int i = 0; i < 120; ++i) {
        engine.step(world, 1 / 60.0);
        const double now = energy(world);
        highest = std::max(highest, now), finite = finite && std::isfinite(now);
    }
    if (finite && highest <= before && escaped(world) == 0) return;
    FAIL_CHECK("room " << seed << ": energy " << highest << " of " << before << ", " << escaped(world)
                       << " escaped, finite: " << finite);
}

}  // namespace nutshell
