// The parts of chapter 3's program about many particles; its main calls them.
#pragma once
#include <nutshell/lab/output.hpp>

namespace nutshell {

/// Time per particle-step from 10 to a million particles, against the machine's own floor.
void scale(lab::Report& report);

void hanging_chain(lab::Report& report);  ///< its shape against the exact one
void net_limits(lab::Report& report);     ///< the largest steps on chain and cloth
void hanging_cloth(lab::Report& report);  ///< a picture, and one per cent of the step

/// A stiff cloth by small steps, implicit Euler and position-based dynamics.
void stiff_cloth(lab::Report& report);

}  // namespace nutshell
