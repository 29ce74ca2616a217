// Chapter 3 · Scenes of many particles: each on its own spring, a chain, a cloth.
#pragma once
#include <algorithm>
#include <nutshell/exponential.hpp>
#include <nutshell/need.hpp>
#include <nutshell/springs.hpp>
#include <utility>

namespace nutshell {

// [anchored_particles]
/// Many particles, each on its own spring of rest length zero to its own fixed point, with drag
/// and gravity.
struct AnchoredParticles {
    std::string name = "anchored_particles";
    Particles start;
    Vector3Array anchors;      ///< [m]
    double stiffness = 100;    ///< kappa [N/m]
    double drag = 0.5;         ///< gamma [kg/s]
    double g = earth_gravity;  ///< [m/s^2], downwards
    double duration = 2;       ///< [s]

    /// The forces, summed into arrays of the caller's.
    void operator()(const Particles& all, double, Vector3Array& forces) const {
        forces.resize(all.size());
        wide::weight_and_drag(all.size(), forces.axes(), all.velocity.axes(), all.mass.data(),
                              {0, -g, 0, drag});
        wide::anchored_springs(all.size(), forces.axes(), all.position.axes(), anchors.axes(),
                               stiffness);
    }
    Vector3Array operator()(const Particles& all, double t) const {
        Vector3Array forces;
        (*this)(all, t, forces);
        return forces;
    }
};

/// n particles of 1 kg in a square field, one metre apart, all at their anchors and moving in all
/// directions.
inline AnchoredParticles anchored_particles(std::size_t n) {
    AnchoredParticles scene;
    const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
    scene.start = Particles(n), scene.anchors = Vector3Array(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Vector3 anchor(static_cast<double>(i % side), 2, static_cast<double>(i / side));
        const double angle = static_cast<double>(i);
        scene.anchors.set(i, anchor);
        scene.start.set(i, {1, anchor, {std::cos(angle), 0, std::sin(angle)}});
    }
    return scene;
}
// [/anchored_particles]

// [spring_net]
/// Particles in a grid joined by springs, with drag and gravity; some are held and do not move. A
/// chain has one row.
struct SpringNet {
    std::string name;
    Particles start;
    GridSprings springs;
    std::vector<std::size_t> held;  ///< numbers of the held particles, in rising order
    double drag = 0;                ///< gamma [kg/s]
    double g = earth_gravity;       ///< [m/s^2], downwards
    double duration = 10;           ///< [s]

    /// The forces, summed into arrays of the caller's.
    void operator()(const Particles& all, double, Vector3Array& forces) const {
        forces.resize(all.size());
        wide::weight_and_drag(all.size(), forces.axes(), all.velocity.axes(), all.mass.data(),
                              {0, -g, 0, drag});
        add_forces(springs, all, forces);
        for (const std::size_t i : held)
            forces.set(i, Vector3::Zero());  // the hand that holds it balances every force
    }
    Vector3Array operator()(const Particles& all, double t) const {
        Vector3Array forces;
        (*this)(all, t, forces);
        return forces;
    }
    /// Of motion, height and springs [J].
    double energy(const Particles& all) const {
        double sum = kinetic_energy(all) + spring_energy(list_of(springs), all);
        for (std::size_t i = 0; i < all.size(); ++i)
            sum += gravity_energy(all.mass[i], all.position[i], g);
        return sum;
    }
};
// [/spring_net]

/// Gives the scene back if it can be simulated. @throws std::invalid_argument if its particles or
/// springs cannot, if drag is negative, or a held particle moves, does not exist or is out of
/// order
inline SpringNet checked(SpringNet net) {
    checked(net.start);
    checked(net.springs, net.start.size());
    checked_drag(net.drag);
    require(std::isfinite(net.g), "gravity g [m/s^2] must be finite");
    for (std::size_t i = 0; i < net.held.size(); ++i) {
        const std::string which = "held particle " + std::to_string(net.held[i]);
        require(
            net.held[i] < net.start.size(),
            which + ": there are only " + std::to_string(net.start.size()) + ", counted from 0");
        require(i == 0 || net.held[i] > net.held[i - 1],
                which + ": number the held particles in rising order, each once");
        require(net.start.velocity[net.held[i]].isZero(0),
                which + " has a velocity: give it none");
    }
    return net;
}

/// The same check for anchored particles.
inline AnchoredParticles checked(AnchoredParticles scene) {
    checked(scene.start);
    checked_drag(scene.drag);
    checked(Spring{scene.stiffness});
    require(std::isfinite(scene.g), "gravity g [m/s^2] must be finite");
    require(scene.anchors.size() == scene.start.size(),
            "every anchored particle needs one anchor");
    for (std::size_t i = 0; i < scene.anchors.size(); ++i)
        require_finite(scene.anchors[i], "an anchor [m]");
    return scene;
}

// [chain]
/// A chain of `masses` equal masses [kg] from `left` [m], held, to `right` [m], held too unless
/// `right_free`. The links start straight, all equally long; one more link than masses if both
/// ends are held, as many if one is free.
/// @throws std::invalid_argument if it cannot be simulated
inline SpringNet chain(std::size_t masses, double mass, const Spring& link, const Vector3& left,
                       const Vector3& right, bool right_free = false) {
    require(masses >= 1, "a chain needs at least one mass");
    const std::size_t links = right_free ? masses : masses + 1;
    SpringNet net{right_free ? "chain_one_end_free" : "chain",
                  Particles(links + 1, mass),
                  {1, links + 1, {{0, 1, link}}},
                  {0}};
    if (!right_free) net.held.push_back(links);
    for (std::size_t i = 0; i <= links; ++i)
        net.start.position.set(
            i, left + (right - left) * (static_cast<double>(i) / static_cast<double>(links)));
    return checked(net);
}
// [/chain]

// [cloth]
/// Which springs a cloth has. Every kind adds stiffness, and takes from the largest step.
enum class Weave { structural, with_shear, with_shear_and_bend };

/// A flat square cloth of n x n particles, `side` [m] long and of `mass` [kg] in all, standing
/// upright in the plane z = 0 with its upper left corner at `corner` [m]. All springs have the
/// same stiffness [N/m] and start at rest length. Nothing is held. @throws std::invalid_argument
/// if it cannot be simulated
inline SpringNet cloth(std::size_t n, double side, double mass, double stiffness, Weave weave,
                       const Vector3& corner = Vector3::Zero()) {
    require(n >= 2, "a cloth needs at least 2 x 2 particles");
    require_positive(side, "the side of a cloth [m]");
    const double gap = side / static_cast<double>(n - 1), diagonal = std::sqrt(2.0) * gap;
    SpringNet net{"cloth", Particles(n * n, mass / static_cast<double>(n * n)), {n, n, {}}, {}};
    net.springs.kinds = {{0, 1, {stiffness, gap}}, {1, 0, {stiffness, gap}}};
    if (weave != Weave::structural) {
        net.springs.kinds.push_back({1, 1, {stiffness, diagonal}});
        net.springs.kinds.push_back({1, -1, {stiffness, diagonal}});
    }
    if (weave == Weave::with_shear_and_bend) {
        net.springs.kinds.push_back({0, 2, {stiffness, 2 * gap}});
        net.springs.kinds.push_back({2, 0, {stiffness, 2 * gap}});
    }
    for (std::size_t r = 0; r < n; ++r)
        for (std::size_t c = 0; c < n; ++c)
            net.start.position.set(r * n + c, corner + gap * Vector3(static_cast<double>(c),
                                                                     -static_cast<double>(r), 0));
    return checked(net);
}
// [/cloth]

// [one_pass]
/// One step of semi-implicit Euler for anchored particles, in place and in one pass over memory:
/// the same verbs, the same numbers bit for bit. It sums no forces in arrays.
inline void advance(Particles& all, const AnchoredParticles& scene, Vector3Array&, double dt) {
    wide::anchored_step(all.size(), all.position.axes(), all.velocity.axes(), all.mass.data(),
                        scene.anchors.axes(), scene.stiffness, {0, -scene.g, 0, scene.drag}, dt);
}

/// The same for a grid of springs: once all springs that start in a row have been added, no later
/// spring touches this row, so it may be kicked and may drift while it is still in the nearest
/// cache. A chain goes block by block in the same way.
inline void advance(Particles& all, const SpringNet& net, Vector3Array& sums, double dt) {
    const auto& [rows, columns, kinds] = net.springs;
    const wide::Medium medium{0, -net.g, 0, net.drag};
    const wide::Axes position = all.position.axes(), velocity = all.velocity.axes();
    const bool first_held = !net.held.empty() && net.held.front() == 0;
    const bool last_held = net.held.size() > first_held && net.held.back() == all.size() - 1;
    if (rows == 1 && kinds.size() == 1 && kinds[0].right == 1 &&
        net.held.size() == std::size_t(first_held) + last_held) {
        const Spring& link = kinds[0].spring;
        wide::chain_step(columns, position, velocity, all.mass.data(), link.rest_length,
                         link.stiffness, medium, first_held, last_held, dt);
        return;
    }
    sums.resize(all.size());
    const wide::Axes forces = sums.axes();
    std::size_t reach = 0;  // how many rows down the springs reach
    for (const GridSpring& kind : kinds) reach = std::max(reach, kind.down);
    std::size_t begun = 0;  // rows whose sum of forces has begun
    auto hold = net.held.begin();
    for (std::size_t r = 0; r < rows; ++r) {
        for (; begun < rows && begun <= r + reach; ++begun) {
            const std::size_t i = begun * columns;
            wide::weight_and_drag(columns, forces.from(i), velocity.from(i), all.mass.data() + i,
                                  medium);
        }
        add_row_forces(net.springs, r, position, forces);
        const std::size_t i = r * columns;
        for (; hold != net.held.end() && *hold < i + columns; ++hold)
            sums.set(*hold, Vector3::Zero());
        wide::kick(columns, velocity.from(i), forces.from(i), all.mass.data() + i, dt);
        wide::drift(columns, position.from(i), velocity.from(i), dt);
    }
}
// [/one_pass]

}  // namespace nutshell
