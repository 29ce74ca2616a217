// The wide loops of chapter 3: the verbs over arrays of any length, and the springs of chains and
// cloths. Compiled in kernels/wide.cpp with -O3, on x86 once for every machine and once for
// machines with AVX2; the processor chooses when the program starts. Both give the same bits: no
// sum changes its order, nothing is contracted. They take bare pointers, trust their caller and
// allocate nothing. Learners read particles.hpp and springs.hpp.
#pragma once
#include <cstddef>

namespace nutshell::wide {

/// N vectors that are read: one array per axis.
struct ConstAxes {
    const double *x = nullptr, *y = nullptr, *z = nullptr;
    ConstAxes from(std::size_t i) const { return {x + i, y + i, z + i}; }
};

/// N vectors that are written.
struct Axes {
    double *x = nullptr, *y = nullptr, *z = nullptr;
    Axes from(std::size_t i) const { return {x + i, y + i, z + i}; }
    operator ConstAxes() const { return {x, y, z}; }
};

/// What is the same for every particle of a scene.
struct Medium {
    double gx = 0, gy = 0, gz = 0;  ///< gravity [m/s^2]
    double drag = 0;                ///< [kg/s]: the force of drag is -drag * velocity
};

/// x += v dt
void drift(std::size_t n, Axes position, ConstAxes velocity, double dt);
/// v += dt/m F
void kick(std::size_t n, Axes velocity, ConstAxes force, const double* mass, double dt);
/// F = m g - drag v: begins a sum of forces.
void weight_and_drag(std::size_t n, Axes force, ConstAxes velocity, const double* mass,
                     const Medium& medium);
/// F += stiffness (anchor - x): springs of rest length zero, one for each particle.
void anchored_springs(std::size_t n, Axes force, ConstAxes position, ConstAxes anchor,
                      double stiffness);

/// n springs; spring i joins a[i] and b[i], all different particles: force_a += pull, force_b -=
/// pull.
void springs_between(std::size_t n, ConstAxes a, ConstAxes b, Axes force_a, Axes force_b,
                     double rest_length, double stiffness);
/// Springs inside one row of n particles; spring i joins i and i + step. Each particle gets both
/// its pulls at once. step is at most `most_step`.
void springs_in_row(std::size_t n, std::size_t step, ConstAxes position, Axes force,
                    double rest_length, double stiffness);
inline constexpr std::size_t most_step = 16;

/// weight_and_drag, anchored_springs, kick and drift in one pass over memory: the same numbers,
/// bit for bit.
void anchored_step(std::size_t n, Axes position, Axes velocity, const double* mass,
                   ConstAxes anchor, double stiffness, const Medium& medium, double dt);
/// weight_and_drag, springs_in_row with step 1, kick and drift in one pass; the first and the
/// last particles may be held.
void chain_step(std::size_t n, Axes position, Axes velocity, const double* mass,
                double rest_length, double stiffness, const Medium& medium, bool first_held,
                bool last_held, double dt);

}  // namespace nutshell::wide
