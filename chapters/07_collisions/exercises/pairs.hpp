// Two particles that meet, or do not: the questions of exercises 7.1 and 7.2.
#pragma once
#include <nutshell/impacts.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct Pair {
    Particle a, b;
    Vector3 normal;
    double e;
};

/// Each argument varied alone, glancing and head-on, closing in and leaving.
inline std::vector<Pair> pairs() {
    const Vector3 n = Vector3(2, 1, -2) / 3, m = Vector3(2, -3, 6) / 7, p(1.2, -0.4, 0.9);
    const Vector3 u(3.1, -0.8, -1.7), v(-2.2, 1.9, 2.6), w(1.1, 2.4, -0.6);
    return {
        {{2.5, p, u}, {0.8, p + n, v}, n, 0.7},
        {{1.3, p, u}, {0.8, p + n, v}, n, 0.7},
        {{2.5, p, u}, {1.7, p + n, v}, n, 0.7},
        {{2.5, p, w}, {0.8, p + n, v}, n, 0.7},
        {{2.5, p, u}, {0.8, p + n, 1.5 * v}, n, 0.7},
        {{2.5, p, u}, {0.8, p + m, v}, m, 0.7},
        {{2.5, p, u}, {0.8, p + n, v}, n, 0.2},
        {{2.5, p, u}, {0.8, p + n, v}, n, 1},
        {{2.5, p, u}, {0.8, p + n, v}, n, 0},
        {{2.5, p, v}, {0.8, p + n, u}, n, 0.7},
        {{2.5, p, v}, {0.8, p + n, v / 2.5 + 0.3 * n}, n, 0.7},  // leaving slowly
        {{2.5, p, 2.5 * n}, {0.8, p + n, -0.8 * n}, n, 0.7},
    };
}

inline void input(Paper& paper, const Pair& pair) {
    paper.input("mass of a", pair.a.mass, "momentum of a", pair.a.momentum, "mass of b",
                pair.b.mass, "momentum of b", pair.b.momentum, "n", pair.normal, "e", pair.e);
}

/// The size [N s] of what enters the impulse.
inline double size_of(const Pair& pair) {
    const double reduced = 1 / (1 / pair.a.mass + 1 / pair.b.mass);
    return 2 * reduced * (velocity(pair.a).norm() + velocity(pair.b).norm());
}

}  // namespace nutshell::exercises
