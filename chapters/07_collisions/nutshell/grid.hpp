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
            cube_[i] = number(static_cast<int>(at.x()), static_cast<int>(at.y()),
                              static_cast<int>(at.z()));
            ++start_[static_cast<std::size_t>(cube_[i]) + 1];
        }
        for (std::size_t k = 1; k < start_.size(); ++k) start_[k] += start_[k - 1];
        next_.assign(start_.begin(), start_.end() - 1);
        for (std::size_t i = 0; i < n; ++i)
            item_[static_cast<std::size_t>(next_[static_cast<std::size_t>(cube_[i])]++)] =
                static_cast<int>(i);
    }

    /// Calls visit(i, j) for all points i and j in the same cube or in neighbours, each pair
    /// once.
    template <class Visit>
    void pairs(const Visit& visit) const {
        for (int y = 0; y < size_[1]; ++y)
            for (int z = 0; z < size_[2]; ++z)
                for (int x = 0; x < size_[0]; ++x) {
                    const int begin = first(x, y, z), end = first(x + 1, y, z);
                    for (int i = begin; i < end; ++i) {
                        row(i, i + 1, x, x + 1, y, z, visit);  // here and to the right
                        row(i, 0, x - 1, x + 1, y, z + 1, visit);
                        for (int dz = -1; dz <= 1; ++dz)
                            row(i, 0, x - 1, x + 1, y + 1, z + dz, visit);
                    }
                }
    }

  private:
    Eigen::Vector3i size_{1, 1, 1};         // cubes along each axis
    std::vector<int> cube_, start_, next_;  // cube of a point; first item of a cube
    std::vector<int> item_;                 // the points, cube after cube

    int number(int x, int y, int z) const { return (y * size_[2] + z) * size_[0] + x; }
    int first(int x, int y, int z) const {
        return start_[static_cast<std::size_t>(number(x, y, z))];
    }
    /// item_[i] with all items of a run of cubes, from item `least` on: they lie side by side.
    template <class Visit>
    void row(int i, int least, int x0, int x1, int y, int z, const Visit& visit) const {
        if (y >= size_[1] || z < 0 || z >= size_[2]) return;
        const int from = std::max(least, first(std::max(x0, 0), y, z)),
                  to = first(std::min(x1, size_[0] - 1) + 1, y, z);
        for (int j = from; j < to; ++j)
            visit(item_[static_cast<std::size_t>(i)], item_[static_cast<std::size_t>(j)]);
    }
};
// [/grid]

}  // namespace nutshell
