// The parts of chapter 7's program: each runs a scene, prints what it found, and writes its data,
// charts and pictures. The first half is the page 07_collisions, the second 07a_piles.
#pragma once
#include <nutshell/lab/output.hpp>

namespace nutshell {

// 07_collisions: impacts and friction
void head_on(lab::Report& report);

// 07a_piles: rest, stacks, piles, the universe

}  // namespace nutshell
