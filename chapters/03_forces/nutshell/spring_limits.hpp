// Chapter 3 · How large a step a chain or a cloth bears: by formula, by the waves of an endless
// cloth, by linearising.
//
// Near rest a net of springs swings in many modes at once, each like one mass on one spring. The
// fastest mode breaks first: a method whose limit on one spring is omega dt = theta bears steps
// up to theta / (fastest omega).
#pragma once
#include <nutshell/chain_scenes.hpp>
#include <nutshell/compositions.hpp>

namespace nutshell {

// [chain_frequency]
/// The fastest angular frequency [rad/s] of a straight unstressed chain of `masses` equal masses
/// [kg]. With both ends held 2 sqrt(kappa/m) sin(N pi / (2(N+1))), with one end free 2
/// sqrt(kappa/m) sin((2N-1) pi / (2(2N+1))).
inline double chain_frequency(std::size_t masses, double mass, double stiffness,
                              bool one_end_free = false) {
    const auto N = static_cast<double>(masses);
    const double angle =
        one_end_free ? (2 * N - 1) * pi / (2 * (2 * N + 1)) : N * pi / (2 * (N + 1));
    return 2 * std::sqrt(stiffness / mass) * std::sin(angle);
}
// [/chain_frequency]

// [composed_limit]
/// The largest theta = omega dt a composition of Verlets bears on one spring: 2 for Verlet
/// itself. Its step is a matrix of determinant 1, so both eigenvalues lie on the unit circle
/// while the trace is between -2 and 2.
/// @param weights  as of yoshida_weights(), kahan_li_weights()
template <std::size_t Count>
double composed_limit(const std::array<double, Count>& weights) {
    const auto trace = [&](double theta) {
        Eigen::Matrix2d step = Eigen::Matrix2d::Identity();
        for (const double w : weights) {
            const Eigen::Matrix2d kick{{1, 0}, {-w * theta / 2, 1}},
                drift{{1, w * theta}, {0, 1}};
            step = kick * drift * kick * step;
        }
        return step.trace();
    };
    double theta = 0;
    while (std::abs(trace(theta + 1e-5)) <= 2 + 1e-12) theta += 1e-5;
    return theta;
}
// [/composed_limit]

// [cloth_frequency]
/// The fastest angular frequency [rad/s] of an endless, flat, unstressed grid of springs between
/// equal masses [kg]: the fastest of all plane waves. A wave whose phase grows by a from column
/// to column and by b from row to row stretches a spring along u by the phase between its two
/// ends. Omega squared is the greater eigenvalue of D, the sum of 2 (1 - cos(phase)) kappa/m u
/// u^T.
/// @param steps  phases tried on each axis
inline double cloth_frequency(const std::vector<GridSpring>& kinds, double mass,
                              int steps = 720) {
    double fastest = 0;
    for (int a = 0; a <= steps; ++a)
        for (int b = -steps; b <= steps; ++b) {
            Eigen::Matrix2d D = Eigen::Matrix2d::Zero();
            for (const auto& [down, right, spring] : kinds) {
                const Eigen::Vector2d u(static_cast<double>(right), -static_cast<double>(down));
                const double phase = pi / steps * (a * u.x() + b * u.y());
                D += 2 * (1 - std::cos(phase)) * spring.stiffness / mass / u.squaredNorm() * u *
                     u.transpose();
            }
            const double mean = D.trace() / 2,
                         spread = std::hypot((D(0, 0) - D(1, 1)) / 2, D(0, 1));
            fastest = std::max(fastest, mean + spread);
        }
    return std::sqrt(fastest);
}
// [/cloth_frequency]

// [fastest_mode]
/// The fastest mode of a net of springs near a state, found by multiplying a random shift by the
/// stiffness over and over (power iteration): what grows fastest is left. Works for any shape and
/// any tension.
struct Mode {
    double frequency;    ///< [rad/s]
    Vector3Array shape;  ///< one shift for each particle, of total length 1
};

/// @param at  the state whose positions the springs are linearised at
inline Mode fastest_mode(const SpringNet& net, const Particles& at, int iterations = 2000) {
    const std::vector<Link> links = list_of(net.springs).links;
    std::vector<Matrix3> slopes;
    for (const auto& [a, b, spring] : links)
        slopes.push_back(spring_slope(spring, at.position[a], at.position[b]));
    Mode mode{0, Vector3Array(at.size())};
    Vector3Array change(at.size());
    std::vector<bool> moves(at.size(), true);
    for (const std::size_t i : net.held) moves[i] = false;
    // Any start will do that has a little of every mode.
    for (std::size_t i = 0; i < at.size(); ++i) {
        const auto k = static_cast<double>(i);
        if (moves[i])
            mode.shape.set(
                i, {std::sin(1 + 7 * k * k), std::sin(2 + 5 * k * k), std::sin(3 + 3 * k * k)});
    }
    for (int iteration = 0; iteration < iterations; ++iteration) {
        for (std::size_t i = 0; i < at.size(); ++i) change.set(i, Vector3::Zero());
        for (std::size_t k = 0; k < links.size(); ++k) {
            const auto [a, b, spring] = links[k];
            const Vector3 on_a = slopes[k] * (mode.shape[a] - mode.shape[b]);
            add(change, a, on_a);
            add(change, b, -on_a);
        }
        double length2 = 0, square = 0, norm2 = 0;  // of shape, frequency, next shape
        for (std::size_t i = 0; i < at.size(); ++i) {
            const Vector3 next = moves[i] ? Vector3(-change[i] / at.mass[i]) : Vector3::Zero();
            length2 += at.mass[i] * mode.shape[i].squaredNorm();
            square += at.mass[i] * mode.shape[i].dot(next);
            norm2 += next.squaredNorm();
            mode.shape.set(i, next);
        }
        mode.frequency = std::sqrt(std::max(0.0, square / length2));
        for (std::size_t i = 0; i < at.size() && norm2 > 0; ++i)
            mode.shape.set(i, mode.shape[i] / std::sqrt(norm2));
    }
    return mode;
}
// [/fastest_mode]

}  // namespace nutshell
