// What the wide loops cannot beat on this machine, compiled with the same flags for the same
// processors. Two floors each: streaming, which loads and stores the same arrays with one
// addition for every number stored; and arithmetic, which does the same sums on one number loaded
// and one stored. The floor of a loop is the larger of the two.
#pragma once
#include <nutshell/wide.hpp>

namespace nutshell::wide {

/// Streams what an anchored step must: position, velocity, mass and anchor in; position and
/// velocity out.
void stream_anchored(std::size_t n, Axes position, Axes velocity, const double* mass,
                     ConstAxes anchor);
/// Streams what a step of a chain or a cloth must: position, velocity and mass in; position and
/// velocity out.
void stream_net(std::size_t n, Axes position, Axes velocity, const double* mass);

/// The arithmetic of one anchored step for n particles, on any numbers between 1 and 2.
void arithmetic_anchored(std::size_t n, const double* in, double* out, const Medium& medium,
                         double stiffness, double dt);
/// The arithmetic of n springs with a rest length: the pull on both ends.
void arithmetic_spring(std::size_t n, const double* in, double* out, double rest_length,
                       double stiffness);
/// The arithmetic of weight, drag, kick and drift of n particles.
void arithmetic_move(std::size_t n, const double* in, double* out, const Medium& medium,
                     double dt);

}  // namespace nutshell::wide
