// Where a method breaks, predicted: the matrix of one step and the size of its largest eigenvalue.
// The other half, measured: stability_limit and stays_within in <nutshell/lab/run.hpp>.
#pragma once
#include <Eigen/Core>
#include <nutshell/lab/run.hpp>

namespace nutshell::lab {

/// The matrix A of one step on a scene that is linear near `rest`: step(rest + u) = step(rest) + A u. Central
/// differences of `width` along each axis: exact but for round-off if the step is linear, within width^2 if
/// it is only smooth.
/// @param step  called with a flat state (Eigen::VectorXd), gives the flat state one step later
template <class Step>
Eigen::MatrixXd step_matrix(const Eigen::VectorXd& rest, const Step& step, double width = 1) {
    require_positive(width, "step_matrix: the width of the differences");
    Eigen::MatrixXd matrix(rest.size(), rest.size());
    for (Eigen::Index j = 0; j < rest.size(); ++j) {
        Eigen::VectorXd above = rest, below = rest;
        above[j] += width, below[j] -= width;
        const Eigen::VectorXd stepped_above = step(above), stepped_below = step(below);
        matrix.col(j) = (stepped_above - stepped_below) / (2 * width);
    }
    return matrix;
}

/// The largest |eigenvalue| of a square matrix: what one step multiplies its fastest growing error by.
/// @throws std::invalid_argument if the matrix is not square or holds a number that is not finite
double spectral_radius(const Eigen::MatrixXd& matrix);

}  // namespace nutshell::lab
