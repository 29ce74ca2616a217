// Turns from the whole group, and how closely two results must agree: shared by the tests of this room.
#pragma once
#include <nutshell/rotations.hpp>
#include "check.hpp"

constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// What identities of rotations hold to, times their condition.
constexpr double identity = 16 * epsilon;

/// Unit axes: along the edges, face diagonals and space diagonals of a cube, and three that favour nothing.
inline std::vector<nutshell::Vector3> axes() {
    std::vector<nutshell::Vector3> all;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x || y || z) all.push_back(nutshell::Vector3(x, y, z).normalized());
    for (const auto& v : {nutshell::Vector3(1, 2, 3), {-0.3, 0.7, 0.2}, {0.9, -0.01, 1e-9}})
        all.push_back(v.normalized());
    return all;
}

/// Angles of both signs: tiny ones, those near 0, pi, 2 pi and 4 pi, and some between.
inline std::vector<double> angles() {
    std::vector<double> all{0, 1e-300, 1e-170, 1e-12, 1e-8, 9.99e-5, 1.01e-4, 2.1e-4, 1e-3, 0.01, 0.03, 0.1};
    for (int half_turns = 1; half_turns <= 4; ++half_turns)
        for (const double near : {-0.3, -1e-3, -1e-8, 0.0, 1e-8, 1e-3, 0.3})
            all.push_back(half_turns * nutshell::pi + near);
    for (const double angle : {0.5, 1.0, 2.0, 2.5, 4.0, 5.5}) all.push_back(angle);
    const auto positive = all;
    for (const double angle : positive) all.push_back(-angle);
    return all;
}

/// Calls check(axis, angle) for all of them.
template <class Check>
void for_all_turns(const Check& check) {
    for (const auto& axis : axes())
        for (const double angle : angles()) check(axis, angle);
}

/// A few dozen turns that favour nothing, for checks of pairs and triples.
inline std::vector<nutshell::Quaternion> some_turns() {
    std::vector<nutshell::Quaternion> all;
    for (const auto& axis : axes())
        all.push_back(nutshell::quaternion_about(axis, 0.37 + 0.61 * double(all.size())));
    return all;
}

inline double largest(const nutshell::Matrix3& m) {
    return m.cwiseAbs().maxCoeff();
}
inline double apart(const nutshell::Quaternion& a, const nutshell::Quaternion& b) {
    return (a.coeffs() - b.coeffs()).norm();
}
