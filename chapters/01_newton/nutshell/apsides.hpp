// Where an orbit turns: the direction of its aphelia, orbit after orbit.
#pragma once
#include <nutshell/newton.hpp>
#include <vector>

namespace nutshell {

/// Watches positions in the x-y plane go by and notes the direction [rad] in which each aphelion
/// lies. Between samples the squared distance is taken for a parabola through three of them, so
/// the angle is good to O(h^3).
struct Aphelia {
    std::vector<double> angles;  ///< direction of each aphelion [rad]
    std::vector<double>
        samples;  ///< when it was: how many samples after the first, with the part of one

    void observe(const Vector3& position) {
        before_ = here_, here_ = after_, after_ = position;
        if (++seen_ < 3) return;
        const double r0 = before_.squaredNorm(), r1 = here_.squaredNorm(),
                     r2 = after_.squaredNorm();
        if (!(r1 > r0 && r1 >= r2)) return;
        const double s = (r2 - r0) / (2 * (2 * r1 - r0 - r2));  // vertex, in steps from `here_`
        const Vector3 vertex =
            here_ + s * (after_ - before_) / 2 + s * s * (after_ - 2 * here_ + before_) / 2;
        angles.push_back(std::atan2(vertex.y(), vertex.x()));
        samples.push_back(static_cast<double>(seen_ - 2) + s);
    }
    /// How many samples an orbit takes, from aphelion to aphelion. @throws std::invalid_argument
    /// before two aphelia
    double samples_per_orbit() const {
        require(
            samples.size() >= 2,
            "samples_per_orbit: fewer than two aphelia were seen: run for at least two orbits");
        return (samples.back() - samples.front()) / static_cast<double>(samples.size() - 1);
    }
    /// Mean turn of the axis per orbit [rad], positive counter-clockwise. @throws
    /// std::invalid_argument before two aphelia
    double turn_per_orbit() const {
        require(angles.size() >= 2,
                "turn_per_orbit: fewer than two aphelia were seen: run for at least two orbits");
        double turned = 0;
        for (std::size_t i = 1; i < angles.size(); ++i)
            turned += std::remainder(angles[i] - angles[i - 1], 2 * pi);
        return turned / static_cast<double>(angles.size() - 1);
    }

  private:
    Vector3 before_, here_, after_;
    int seen_ = 0;
};

}  // namespace nutshell
