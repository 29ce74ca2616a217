// The wide loops of chapter 4: many points turned, many orientations composed. Compiled in
// kernels/turns.cpp as chapter 3's are (wide.hpp says how). Learners read rotations.hpp.
#pragma once
#include <array>
#include <nutshell/wide.hpp>

namespace nutshell::wide {

/// N 4-vectors: one array per number.
struct FourVectors {
    double *x = nullptr, *y = nullptr, *z = nullptr, *w = nullptr;
};
/// N matrices: one array per entry, row by row.
using Matrices = std::array<double*, 9>;

/// out = R in, one matrix (row by row) for all points.
void turn_by_matrix(std::size_t n, Axes out, ConstAxes in, const double* matrix);
/// The same by one 4-vector (x, y, z, w): t = 2 u x p, out = p + w t + u x t.
void turn_by_four_vector(std::size_t n, Axes out, ConstAxes in, const double* four_vector);
/// What neither can beat: three numbers in, three out, with one addition each.
void stream_points(std::size_t n, Axes out, ConstAxes in);

/// pose = turn pose, each by its own; the 4-vectors are not normalised.
void compose_four_vectors(std::size_t n, FourVectors pose, FourVectors turn);
/// The same, each made as long as one afterwards.
void compose_unit_four_vectors(std::size_t n, FourVectors pose, FourVectors turn);
/// What neither can beat: eight numbers in, four out, with one addition each.
void stream_four_vectors(std::size_t n, FourVectors pose, FourVectors turn);
void compose_matrices(std::size_t n, const Matrices& pose, const Matrices& turn);

}  // namespace nutshell::wide
