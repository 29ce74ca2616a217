// The parts of chapter 4's program: each runs a scene, prints what it found, and writes its data,
// charts and pictures.
#pragma once
#include <nutshell/lab/output.hpp>

namespace nutshell {

void order(lab::Report& report);
void printed_matrices(lab::Report& report);
void small_turns(lab::Report& report);
void between_poses(lab::Report& report);
void three_angles(lab::Report& report);
void million_turns(lab::Report& report);
void cost(lab::Report& report);
void pictures(lab::Report& report);

}  // namespace nutshell
