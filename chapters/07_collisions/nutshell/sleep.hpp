// Chapter 7 · Sleep: what lies still together, and has done so for a while, costs nothing.
#pragma once
#include <cstddef>
#include <numeric>
#include <nutshell/contact_solver.hpp>

namespace nutshell {

/// When bodies fall asleep.
struct SleepRule {
    double speed = 0.05;  ///< slower than this is still: of the centre, and of the turning [m/s]
    double after = 0.5;   ///< how long all that touch must have been still [s]
};

// [sleep]
/// Which bodies sleep. Bodies that touch are an island: they fall asleep together, and when one
/// of them is moved, all wake.
class Sleep {
  public:
    bool asleep(std::size_t i) const { return i < asleep_.size() && asleep_[i]; }

    void start_step(std::size_t bodies) {
        still_for_.resize(bodies, 0), asleep_.resize(bodies, false), island_.resize(bodies);
        std::iota(island_.begin(), island_.end(), std::size_t{0});
    }
    /// Bodies i and j touch.
    void join(std::size_t i, std::size_t j) { island_[root(i)] = root(j); }

    /// Before a step: an island with a body in it that moves wakes, for a body that sleeps is as
    /// good as a wall.
    /// @param reach  of each body [m]    @return whether anybody woke
    bool wake(const std::vector<Body>& bodies, const std::vector<double>& reach,
              const SleepRule& rule) {
        std::vector<bool> disturbed(bodies.size(), false);
        for (std::size_t i = 0; i < bodies.size(); ++i)
            if (!still(bodies[i], reach[i], rule)) disturbed[root(i)] = true;
        bool any = false;
        for (std::size_t i = 0; i < bodies.size(); ++i)
            if (asleep_[i] && disturbed[root(i)])
                asleep_[i] = false, still_for_[i] = 0, any = true;
        return any;
    }

    /// After a step of dt [s]: islands in which all were still for long enough sleep.
    void end_step(std::vector<Body>& bodies, const std::vector<double>& reach,
                  const SleepRule& rule, double dt) {
        std::vector<double> least(bodies.size(), immovable);
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (asleep_[i]) bodies[i].momentum.setZero(), bodies[i].angular_momentum.setZero();
            still_for_[i] = still(bodies[i], reach[i], rule) ? still_for_[i] + dt : 0;
            least[root(i)] = std::min(least[root(i)], still_for_[i]);
        }
        for (std::size_t i = 0; i < bodies.size(); ++i)
            asleep_[i] = bodies[i].mass < immovable && least[root(i)] >= rule.after;
    }

  private:
    static bool still(const Body& body, double reach, const SleepRule& rule) {
        return velocity(body).norm() + reach * angular_velocity(body).norm() < rule.speed;
    }
    std::vector<double> still_for_;    // [s]
    std::vector<bool> asleep_;         // immovable bodies never do: they join no islands
    std::vector<std::size_t> island_;  // another body of the same island; itself at the root

    std::size_t root(std::size_t i) {
        while (island_[i] != i) i = island_[i] = island_[island_[i]];
        return i;
    }
};
// [/sleep]

}  // namespace nutshell
