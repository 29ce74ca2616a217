// The parts of chapter 3's program about many particles; its main calls them.
#pragma once
#include <nutshell/lab/output.hpp>

namespace nutshell {

/// Time per particle-step from 10 to a million particles, against the machine's own floor.
void scale(lab::Report& report);

/// Hanging chain and cloth: rest shapes, stability limits, pictures.
void chains_and_cloths(lab::Report& report);

/// A stiff cloth by small steps, implicit Euler and position-based dynamics.
void stiff_cloth(lab::Report& report);

}  // namespace nutshell
