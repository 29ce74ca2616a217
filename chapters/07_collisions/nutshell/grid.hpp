// Chapter 7 · Broad phase: a grid, so that a body looks for contacts next door only.
#pragma once
#include <algorithm>
#include <nutshell/vector.hpp>
#include <stdexcept>
#include <vector>

namespace nutshell {

// [grid]
/// Points sorted into cubes of side `cell`. Two points nearer than `cell` are in the same cube or
/// in neighbours.
class Grid {
  public:
    /// Sorts the points [m] by cube, bottom layer first. The side grows where the points are so
    /// far apart that there would be more than eight cubes a point.
    /// @throws std::invalid_argument if a point is not finite: the world has blown up
    void sort(const std::vector<Vector3>& points, double cell) {
        const std::size_t n = points.size();
        Vector3 low = Vector3::Zero(), high = Vector3::Zero();
        if (n > 0) low = high = points[0];
        Vector3 sum = Vector3::Zero();
        for (const Vector3& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p), sum += p;
        if (!sum.allFinite())
            throw std::invalid_argument("Grid: a position is not finite; the world has blown up");
        const Vector3 extent = high - low;
        const double most = 8 * static_cast<double>(n) + 64;
        for (;; cell *= 1.25) {
            const Vector3 cubes = extent / cell + Vector3::Ones();
            if (cubes.prod() <= most) break;
        }
        size_ = (extent / cell).cast<int>() + Eigen::Vector3i::Ones();

        cube_.resize(n), item_.resize(n);
        start_.assign(static_cast<std::size_t>(size_[0] * size_[1] * size_[2]) + 1, 0);
        for (std::size_t i = 0; i < n; ++i) {
            const Vector3 at = (points[i] - low) / cell;
            const Eigen::Vector3i cube = at.cast<int>();
            cube_[i] = (cube[1] * size_[2] + cube[2]) * size_[0] + cube[0];
            ++start_[static_cast<std::size_t>(cube_[i]) + 1];
        }
        for (std::size_t k = 1; k < start_.size(); ++k) start_[k] += start_[k - 1];
        next_.assign(start_.begin(), start_.end() - 1);
        for (std::size_t i = 0; i < n; ++i)
            item_[static_cast<std::size_t>(next_[static_cast<std::size_t>(cube_[i])]++)] =
                static_cast<int>(i);
    }

    const Eigen::Vector3i& size() const { return size_; }  ///< cubes along each axis
    /// The first item of a cube: its items are first(x, y, z) to first(x + 1, y, z) less one.
    int first(int x, int y, int z) const {
        return start_[static_cast<std::size_t>((y * size_[2] + z) * size_[0] + x)];
    }
    /// visit(item, other) for an item and all those, from number `least` on, in the cubes x0 to
    /// x1 of a row: they lie side by side. Rows outside of the grid are empty.
    template <class Visit>
    void with_row(int item, int least, int x0, int x1, int y, int z, const Visit& visit) const {
        if (y < 0 || y >= size_[1] || z < 0 || z >= size_[2]) return;
        const int from = std::max(least, first(std::max(x0, 0), y, z)),
                  to = first(std::min(x1, size_[0] - 1) + 1, y, z);
        for (int j = from; j < to; ++j)
            visit(item_[static_cast<std::size_t>(item)], item_[static_cast<std::size_t>(j)]);
    }

  private:
    Eigen::Vector3i size_{1, 1, 1};
    std::vector<int> cube_, start_, next_;  // cube of a point; first item of a cube
    std::vector<int> item_;                 // the points, cube after cube
};
// [/grid]

// [visit_pairs]
/// visit(i, j) for all points i and j in the same cube or in neighbours, across faces, edges and
/// corners, each pair once: of the 26 cubes around, one looks at the 13 that come after it.
template <class Visit>
void visit_pairs(const Grid& grid, const Visit& visit) {
    const Eigen::Vector3i cubes = grid.size();
    for (int y = 0; y < cubes[1]; ++y)
        for (int z = 0; z < cubes[2]; ++z)
            for (int x = 0; x < cubes[0]; ++x)
                for (int i = grid.first(x, y, z); i < grid.first(x + 1, y, z); ++i) {
                    // exercise 7.12
                    grid.with_row(i, i + 1, x, x + 1, y, z, visit);  // here and to the right
                    grid.with_row(i, 0, x - 1, x + 1, y, z + 1, visit);
                    for (int dz = -1; dz <= 1; ++dz)
                        grid.with_row(i, 0, x - 1, x + 1, y + 1, z + dz, visit);
                    // end 7.12
                }
}
// [/visit_pairs]

}  // namespace nutshell
