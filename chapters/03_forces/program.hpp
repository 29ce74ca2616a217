// The parts of chapter 3's program: each runs its scenes, prints what it found, and writes its
// data, charts and pictures.
#pragma once
#include <nutshell/lab/output.hpp>

namespace nutshell {

void falling(lab::Report& report);       // drag: exact at any step, and where the others break
void springs(lab::Report& report);       // the scene that sorts the methods; then with damping
void limits(lab::Report& report);        // stability, predicted and found
void planet_again(lab::Report& report);  // step control, high order, the logarithmic leapfrog
void model_ladder(lab::Report& report);  // a throw with three models of drag
void diagrams(lab::Report& report);
void pictures(lab::Report& report);

}  // namespace nutshell
