// The parts of chapter 2's program: each runs a scene, prints what it found, and writes its data,
// charts and pictures.
#pragma once
#include <nutshell/lab/output.hpp>

namespace nutshell {

void momentum_throw(lab::Report& report);
void many_forces(lab::Report& report);
void leaky_cart(lab::Report& report);
void raindrop(lab::Report& report);
void rocket(lab::Report& report);
void launch(lab::Report& report);
void momentum_books(lab::Report& report);
void diagrams(lab::Report& report);
void pictures(lab::Report& report);

}  // namespace nutshell
