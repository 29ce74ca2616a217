// The wide loops of chapter 6: any number of bodies. Compiled in kernels/bodies.cpp as those of
// chapter 3 are (wide.hpp says how). Learners read rotation_methods.hpp and bodies.hpp.
#pragma once
#include <nutshell/wide_turns.hpp>

namespace nutshell::wide {

/// K += F dt, or L += torque dt.
void push(std::size_t n, Axes momentum, ConstAxes force, double dt);

/// What a loop over bodies reads and writes.
struct BodyArrays {
    const double* mass = nullptr;
    ConstAxes inertia;  ///< principal moments
    Axes position;
    ConstAxes momentum;
    FourVectors orientation;
    ConstAxes angular_momentum;
};

/// The drift of n bodies: centres by their momentum, poses by the Magnus step of fourth order; no
/// sine, no cosine, no branch. Good to round-off of the exponential while a body turns by less
/// than pi in dt.
void drift(std::size_t n, const BodyArrays& bodies, double dt);

/// Streams what that drift must: the same arrays in and out, one addition for each number stored.
void stream_bodies(std::size_t n, const BodyArrays& bodies);

/// The arithmetic of that drift for n bodies, on any numbers between 1 and 2.
void arithmetic_bodies(std::size_t n, const double* in, double* out, double dt);

}  // namespace nutshell::wide
