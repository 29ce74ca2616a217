// Chapter 3 · Implicit methods: the step is an equation for where it ends. Dear, and stable at
// any step.
#pragma once
#include <Eigen/LU>
#include <limits>
#include <nutshell/require.hpp>
#include <nutshell/vector.hpp>

namespace nutshell {

template <class Flat>
using SquareOf = Eigen::Matrix<double, Flat::RowsAtCompileTime, Flat::RowsAtCompileTime>;

// [jacobian]
/// How each rate changes with each number of y, d f_i / d y_j, by forward differences: as
/// many evaluations as y has numbers, and one. @param rate  f(y, t), known already
template <class Flat, class Rate>
SquareOf<Flat> jacobian(const Rate& f, const Flat& y, const Flat& rate, double t) {
    const double scale = y.cwiseAbs().maxCoeff(), width = 1e-8 * (scale > 1e-290 ? scale : 1);
    SquareOf<Flat> J(y.size(), y.size());
    for (Eigen::Index j = 0; j < y.size(); ++j) {
        Flat shifted = y;
        shifted[j] += width;
        J.col(j) = (f(shifted, t) - rate) / (shifted[j] - y[j]);
    }
    return J;
}
// [/jacobian]

// [implicit_euler]
/// One step of implicit Euler: the z that solves z = y + dt f(z, t + dt), by Newton's method.
/// First order; leaves an undamped spring 1/(1 + (omega dt)^2) of its energy a step, at any step.
/// Putting z back into the right side until it stays would diverge beyond omega dt = 1; Newton's
/// method does not. @throws std::runtime_error if 50 iterations do not reach round-off
template <class Flat, class Rate>
Flat implicit_euler(const Flat& y, const Rate& f, double t, double dt) {
    Flat z = y;
    double last = std::numeric_limits<double>::infinity();
    Eigen::PartialPivLU<SquareOf<Flat>> solver(y.size());
    for (int iteration = 0; iteration < 50; ++iteration) {
        const Flat rate = f(z, t + dt);
        if (iteration == 0 ||
            iteration % 5 == 4)  // the slope of the first guess serves a few iterations
            solver.compute(SquareOf<Flat>::Identity(y.size(), y.size()) -
                           dt * jacobian(f, z, rate, t + dt));
        const Flat correction = solver.solve(Flat(z - y - dt * rate));
        z -= correction;
        const double size = correction.norm(), scale = z.norm() + y.norm() + 1e-290;
        if (size <= 1e-15 * scale || (size <= 1e-12 * scale && size > last / 4))
            return z;  // round-off reached
        last = size;
    }
    throw std::runtime_error(
        "implicit_euler: Newton's method found no end of the step at t = " + std::to_string(t) +
        " s: try a smaller dt than " + std::to_string(dt) + " s");
}
// [/implicit_euler]

// [implicit_midpoint]
/// One step of the implicit midpoint rule: an implicit Euler step to the middle, then as far
/// again. Second order; keeps the energy of a spring to round-off at any step, and shows it too
/// slow when the step is large.
template <class Flat, class Rate>
Flat implicit_midpoint(const Flat& y, const Rate& f, double t, double dt) {
    return 2 * implicit_euler(y, f, t, dt / 2) - y;
}
// [/implicit_midpoint]

}  // namespace nutshell
