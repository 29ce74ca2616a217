// The parts of chapter 1's program: each runs a scene, prints what it found, and writes its data,
// charts and pictures.
#pragma once
#include <nutshell/lab/output.hpp>

namespace nutshell {

void straight_line(lab::Report& report);
void thrown_ball(lab::Report& report);
void planet(lab::Report& report);
void frame_rate(lab::Report& report);
void game_loop(lab::Report& report);
void diagrams(lab::Report& report);
void pictures(lab::Report& report);

}  // namespace nutshell
