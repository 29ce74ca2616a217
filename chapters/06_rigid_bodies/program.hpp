// The parts of chapter 6's program: each runs a scene, prints what it found, and writes its data,
// charts and pictures.
#pragma once
#include <nutshell/lab/output.hpp>

namespace nutshell {

// 6: torque, inertia, assembling
void diagrams(lab::Report& report);
void levers(lab::Report& report);
void pendulum(lab::Report& report);
void assembly(lab::Report& report);
void ladder(lab::Report& report);

// 6A: free bodies and tops
void free_bodies(lab::Report& report);
void free_study(lab::Report& report);
void heavy_tops(lab::Report& report);
void thrown(lab::Report& report);
void many_bodies(lab::Report& report);
void top_pictures(lab::Report& report);

// both
void pictures(lab::Report& report);

}  // namespace nutshell
