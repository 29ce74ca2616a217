// Chapter 3 · How a chain hangs: the exact rest shape of masses and springs, and what it becomes
// with ever more links.
//
// All shapes hang in a plane from (0, 0): x to the other end, y up, in metres. At rest every link
// carries the same horizontal tension H; its vertical tension is less by one weight than that of
// the link before.
#pragma once
#include <nutshell/forces.hpp>
#include <vector>

namespace nutshell {

using Vector2 = Eigen::Vector2d;
using Matrix2 = Eigen::Matrix2d;

/// A chain at rest between two held ends.
struct HangingChain {
    std::size_t masses;  ///< N, between N + 1 links
    double mass;         ///< of each [kg]
    Spring link;         ///< of each link; stiffness and rest length greater than zero
    Vector2 end;         ///< the far end, seen from the near one [m]; end.x > 0
    double g = earth_gravity;
};

/// The tension [N] at the near end: H across, V how much of it carries weight. H > 0; V counts
/// downwards along the chain.
struct EndTension {
    double horizontal, vertical;
};

/// Where the far end comes to lie for a tension at the near end.
struct Reach {
    Vector2 end;     ///< [m]
    Matrix2 change;  ///< of `end` with H and V [m/N]
    double energy;   ///< complementary energy [J]: grows with H by end.x, with V by -end.y
};

// [link]
/// A link under tension (H, V) is a vector of length l0 + T/kappa in the direction of the
/// tension, downwards where V > 0.
inline Vector2 hanging_link(const Spring& link, const EndTension& tension) {
    const double T = std::hypot(tension.horizontal, tension.vertical);
    return (link.rest_length / T + 1 / link.stiffness) *
           Vector2(tension.horizontal, -tension.vertical);
}
// [/link]

// [reach]
/// Goes along the chain, link by link: each carries one weight less than the one before.
inline Reach reach(const HangingChain& chain, const EndTension& near) {
    Reach sum{Vector2::Zero(), Matrix2::Zero(), 0};
    EndTension tension = near;
    for (std::size_t i = 0; i <= chain.masses; ++i) {
        tension.vertical = near.vertical - static_cast<double>(i) * chain.mass * chain.g;
        const double H = tension.horizontal, V = tension.vertical, T = std::hypot(H, V);
        const double stiff = chain.link.rest_length / (T * T * T),
                     soft = chain.link.rest_length / T + 1 / chain.link.stiffness;
        sum.energy += chain.link.rest_length * T + T * T / (2 * chain.link.stiffness);
        sum.end += hanging_link(chain.link, tension);
        sum.change += Matrix2{{soft - stiff * H * H, -stiff * H * V},
                              {stiff * H * V, -soft + stiff * V * V}};
    }
    return sum;
}
// [/reach]

// [end_tension]
/// The tension at the near end that makes the chain reach its far end: two equations in two
/// unknowns by Newton's method. The same tension makes the complementary energy less (H end.x - V
/// end.y) least; it has one minimum only, so a step is halved until it goes down, and the method
/// arrives from anywhere. (Between level ends V is half the weight, and one equation in H is
/// left.)      @param reach_of  gives a Reach for an EndTension
template <class ReachOf>
EndTension end_tension(const ReachOf& reach_of, const Vector2& end, EndTension tension) {
    const auto height = [&](const EndTension& at) {
        return reach_of(at).energy - at.horizontal * end.x() + at.vertical * end.y();
    };
    for (int iteration = 0; iteration < 200; ++iteration) {
        const Reach now = reach_of(tension);
        const Vector2 step = now.change.inverse() * (end - now.end);
        const auto after = [&](double part) {
            return EndTension{tension.horizontal + part * step.x(),
                              tension.vertical + part * step.y()};
        };
        // Near the bottom the energies are equal: then the end decides.
        const auto better = [&](const EndTension& next) {
            if (next.horizontal < tension.horizontal / 10) return false;  // H stays positive
            return height(next) < height(tension) ||
                   (reach_of(next).end - end).norm() < (now.end - end).norm() / 2;
        };
        double part = 1;
        while (part > 1e-12 && !better(after(part))) part /= 2;
        if (part <= 1e-12) break;  // nothing is better: this is the minimum, to round-off
        tension = after(part);
    }
    return tension;
}
// [/end_tension]

/// @throws std::invalid_argument unless the far end lies to the right and masses, links and
/// gravity are greater than zero
inline void check_hanging(const HangingChain& chain) {
    require(chain.masses >= 1, "a hanging chain needs at least one mass");
    require_positive(chain.mass, "a mass of the chain [kg]");
    require_positive(chain.link.stiffness, "the stiffness of a link [N/m]");
    require_positive(chain.link.rest_length, "the rest length of a link [m]");
    require_positive(chain.end.x(), "the far end's x, seen from the near end [m],");
    require_positive(chain.g, "g [m/s^2]");
    require_finite(chain.end, "the far end [m]");
}

/// The exact tension at the near end of a chain of masses and springs. @throws
/// std::invalid_argument, see check_hanging, or if the ends are so close that some link would
/// have to push (a chain then folds in more than one way)
inline EndTension end_tension(const HangingChain& chain) {
    check_hanging(chain);
    const double weight = static_cast<double>(chain.masses) * chain.mass * chain.g;
    const auto reach_of = [&](const EndTension& tension) { return reach(chain, tension); };
    const EndTension tension = end_tension(reach_of, chain.end, {weight, weight / 2});
    require((reach_of(tension).end - chain.end).norm() <
                1e-9 * (chain.end.norm() + chain.link.rest_length),
            "the ends of the chain are too close together for every link to pull: move them "
            "apart, or use "
            "shorter links");
    return tension;
}

/// The exact rest shape: all N + 2 points, the two ends included. Accurate to round-off (the test
/// puts a chain there and measures the forces that remain). @throws std::invalid_argument, see
/// check_hanging
inline std::vector<Vector2> rest_shape(const HangingChain& chain) {
    EndTension tension = end_tension(chain);
    std::vector<Vector2> points{Vector2::Zero()};
    const double near = tension.vertical;
    for (std::size_t i = 0; i <= chain.masses; ++i) {
        tension.vertical = near - static_cast<double>(i) * chain.mass * chain.g;
        points.push_back(points.back() + hanging_link(chain.link, tension));
    }
    return points;
}

/// The rest shape of a chain that hangs straight down from one held end: the N + 1 heights [m],
/// the held end's 0 first.
inline std::vector<double> rest_heights_one_end_free(std::size_t masses, double mass,
                                                     const Spring& link,
                                                     double g = earth_gravity) {
    std::vector<double> heights{0};
    for (std::size_t below = masses; below >= 1; --below)
        heights.push_back(heights.back() - link.rest_length -
                          static_cast<double>(below) * mass * g / link.stiffness);
    return heights;
}

// [elastic_catenary]
/// The limit of ever more, ever shorter links: an elastic cord between the same ends.
struct Cord {
    double length;     ///< at rest [m]
    double weight;     ///< per metre at rest [N/m]
    double stiffness;  ///< tension over relative stretch (E A) [N]
    Vector2 end;       ///< the far end, seen from the near one [m]; end.x > 0
};

/// The cord that the chain approximates: each link with half a mass at either end.
inline Cord cord_of(const HangingChain& chain) {
    const auto links = static_cast<double>(chain.masses + 1);
    return {links * chain.link.rest_length, chain.mass * chain.g / chain.link.rest_length,
            chain.link.stiffness * chain.link.rest_length, chain.end};
}

/// The point [m] of the cord that lies `s` metres from its near end at rest: the elastic
/// catenary.
inline Vector2 cord_point(const Cord& cord, const EndTension& near, double s) {
    const double H = near.horizontal, V = near.vertical, w = cord.weight, here = V - w * s;
    return {H * s / cord.stiffness + H / w * (std::asinh(V / H) - std::asinh(here / H)),
            -(V - w * s / 2) * s / cord.stiffness - (std::hypot(H, V) - std::hypot(H, here)) / w};
}
// [/elastic_catenary]

/// Where the cord's far end comes to lie for a tension at its near end.
inline Reach reach(const Cord& cord, const EndTension& near) {
    const double H = near.horizontal, V = near.vertical, w = cord.weight,
                 E = cord.length / cord.stiffness;
    const double U = V - w * cord.length, T = std::hypot(H, V), S = std::hypot(H, U);
    const double angles = std::asinh(V / H) - std::asinh(U / H);
    const double stretch =
        (H * H * (V - U) + (V * V * V - U * U * U) / 3) / (2 * w * cord.stiffness);
    return {cord_point(cord, near, cord.length),
            Matrix2{{E + (angles - V / T + U / S) / w, (H / T - H / S) / w},
                    {-(H / T - H / S) / w, -E - (V / T - U / S) / w}},
            (V * T - U * S + H * H * angles) / (2 * w) + stretch};
}

/// The cord's tension at its near end. @throws std::invalid_argument if the far end is not to the
/// right
inline EndTension end_tension(const Cord& cord) {
    require_positive(cord.end.x(), "the far end's x, seen from the near end [m],");
    const double weight = cord.weight * cord.length;
    return end_tension([&](const EndTension& tension) { return reach(cord, tension); }, cord.end,
                       {weight, weight / 2});
}

}  // namespace nutshell
