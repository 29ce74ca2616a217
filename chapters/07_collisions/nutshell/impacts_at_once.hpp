// Chapter 7 · All impacts at the same instant: a set of linear equations, and not what a cradle does.
#pragma once
#include <Eigen/LU>
#include <nutshell/impacts.hpp>

namespace nutshell {

// [at_once]
/// The impacts of all touching pairs at once: every separating speed s turns into -e s, whether
/// the pair closes in or not. Wrong for Newton's cradle: waves need one impact after another.
inline void collide_at_once(std::vector<Particle>& all, const std::vector<Touch>& touches,
                            double e) {
    const auto n = static_cast<Eigen::Index>(touches.size());
    Eigen::MatrixXd gain = Eigen::MatrixXd::Zero(n, n);  // of speed i from an impulse at j
    Vector wanted(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Touch& at = touches[static_cast<std::size_t>(i)];
        wanted(i) = -(1 + e) * separating_speed(all[at.a], all[at.b], at.normal);
        for (Eigen::Index j = 0; j < n; ++j) {
            const Touch& by = touches[static_cast<std::size_t>(j)];
            const double along = at.normal.dot(by.normal);
            if (at.b == by.b) gain(i, j) += along / all[at.b].mass;
            if (at.a == by.a) gain(i, j) += along / all[at.a].mass;
            if (at.a == by.b) gain(i, j) -= along / all[at.a].mass;
            if (at.b == by.a) gain(i, j) -= along / all[at.b].mass;
        }
    }
    const Vector impulses = gain.fullPivLu().solve(wanted);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Touch& at = touches[static_cast<std::size_t>(i)];
        all[at.a].momentum -= impulses(i) * at.normal;
        all[at.b].momentum += impulses(i) * at.normal;
    }
}
// [/at_once]

}  // namespace nutshell
