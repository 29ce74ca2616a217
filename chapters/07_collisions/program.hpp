// The parts of chapter 7's program: each runs a scene, prints what it found, and writes its data,
// charts and pictures. The first half is the page 07_collisions, the second 07a_piles,
// a side road 07b_arch.
#pragma once
#include <nutshell/lab/output.hpp>

namespace nutshell {

// 07_collisions: impacts and friction
void head_on(lab::Report& report);
void glancing(lab::Report& report);
void pool(lab::Report& report);
void bouncing(lab::Report& report);
void bad_floors(lab::Report& report);
void too_fast(lab::Report& report);
void levers(lab::Report& report);
void gaining(lab::Report& report);
void friction(lab::Report& report);
void cradle(lab::Report& report);
void pictures(lab::Report& report);

// 07a_piles: rest, stacks, piles, the universe
void stack(lab::Report& report);
void switches(lab::Report& report);
void pile(lab::Report& report);
void pile_cost(lab::Report& report);
void dominoes(lab::Report& report);
void universe(lab::Report& report);
void rest_diagrams(lab::Report& report);
void rest_pictures(lab::Report& report);

// 07b_arch: a side road, convex pieces
void arch(lab::Report& report);

}  // namespace nutshell
