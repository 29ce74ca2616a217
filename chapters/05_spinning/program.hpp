// The parts of chapter 5's program: each runs a scene, prints what it found, and writes its data,
// charts and pictures.
#pragma once
#include <nutshell/lab/output.hpp>

namespace nutshell {

void velocity(lab::Report& report);
void steady_spin(lab::Report& report);
void ten_turns(lab::Report& report);
void engines(lab::Report& report);
void coning(lab::Report& report);
void wagon(lab::Report& report);
void pictures(lab::Report& report);

}  // namespace nutshell
