// Chapter 3 · What games do about stiff nets: two steps that no stiffness breaks, and what each
// of them loses.
#pragma once
#include <nutshell/chain_scenes.hpp>

namespace nutshell {

// [linear_implicit_euler]
/// Implicit Euler with one Newton iteration a step: the forces of the end are taken as those of
/// the start plus their slope times the change. With v' = v + dv,
///     (m + gamma dt) dv - dt^2 (dF/dp) dv = dt F + dt^2 (dF/dp) v
/// a set of linear equations, solved by conjugate gradients without writing down a matrix. Stable
/// at any step on springs under tension; it damps what it cannot resolve. Compressed springs
/// would make the matrix indefinite: their push across themselves is left out of the slope.
/// Source: D. Baraff and A. Witkin, Large Steps in Cloth Simulation, SIGGRAPH 1998.
struct LinearImplicitEuler {
    double tolerance = 1e-10;  ///< of the equations, relative to their right side
    long iterations = 0;       ///< of conjugate gradients so far
    Springs list = {};         ///< the net's springs, listed by the first step
    Vector3Array forces{}, r{}, d{}, Ad{};

    Particles operator()(Particles all, const SpringNet& net, double t, double dt);
};
// [/linear_implicit_euler]

// [at_rest_length]
/// The two ends of a spring, [m], world frame.
struct Ends {
    Vector3 a, b;
};

/// Both ends moved along the spring until it has its rest length [m]. Each moves in proportion
/// to its inverse mass [1/kg], so that their common centre of mass stays; an end that is held
/// has an inverse mass of zero. Ends that meet, or are both held, stay where they are.
/// Eq. (3.i).
inline Ends at_rest_length(const Vector3& a, const Vector3& b, double rest_length,
                           double inverse_mass_a, double inverse_mass_b) {
    // exercise 3.9
    const Vector3 way = b - a;
    const double length = way.norm(), both = inverse_mass_a + inverse_mass_b;
    if (length == 0 || both == 0) return {a, b};
    const Vector3 too_much = (1 - rest_length / length) * way;
    return {a + inverse_mass_a / both * too_much, b - inverse_mass_b / both * too_much};
    // end 3.9
}
// [/at_rest_length]

// [position_based]
/// Position-based dynamics: drift as if there were no springs, then put right, spring by spring,
/// what the drift has made too long or too short, and take for the velocity how far everybody
/// got. Stable at any step. What it computes is not the spring: how stiff the net seems depends
/// on the number of iterations and on the step.
/// Source: M. Mueller et al., Position Based Dynamics, VRIPHYS 2006.
struct PositionBased {
    int iterations = 10;                    ///< over all springs, in each step
    Springs list = {};                      ///< the net's springs, listed by the first step
    std::vector<double> inverse_mass = {};  ///< [1/kg], 0 for what is held

    Particles operator()(Particles all, const SpringNet& net, double, double dt) {
        if (list.links.empty()) begin(all, net);
        const Vector3Array before = all.position;
        kick_by_weight_and_drag(all, net, dt);
        drift(all, dt);
        for (int turn = 0; turn < iterations; ++turn)
            for (const auto& [a, b, spring] : list.links) {
                const Ends ends =
                    at_rest_length(all.position[a], all.position[b], spring.rest_length,
                                   inverse_mass[a], inverse_mass[b]);
                all.position.set(a, ends.a), all.position.set(b, ends.b);
            }
        for (std::size_t i = 0; i < all.size(); ++i)
            all.velocity.set(i, (all.position[i] - before[i]) / dt);
        return all;
    }
    // [/position_based]

    void begin(const Particles& all, const SpringNet& net) {
        list = list_of(net.springs);
        inverse_mass.resize(all.size());
        for (std::size_t i = 0; i < all.size(); ++i) inverse_mass[i] = 1 / all.mass[i];
        for (const std::size_t i : net.held) inverse_mass[i] = 0;
    }
    /// What is held has no velocity and gets none.
    void kick_by_weight_and_drag(Particles& all, const SpringNet& net, double dt) const {
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (inverse_mass[i] == 0) continue;
            const Vector3 free = all.velocity[i] + dt * Vector3(0, -net.g, 0);
            all.velocity.set(i, free / (1 + net.drag * dt * inverse_mass[i]));
        }
    }
};

inline Particles LinearImplicitEuler::operator()(Particles all, const SpringNet& net, double t,
                                                 double dt) {
    if (list.links.empty()) list = list_of(net.springs);
    const std::size_t n = all.size();
    std::vector<char> held(n, 0);
    for (const std::size_t i : net.held) held[i] = 1;
    // without the push across compressed springs: one that is too short acts along itself only
    std::vector<Matrix3> slopes;
    for (auto [a, b, spring] : list.links) {
        const Vector3 from = all.position[a], to = all.position[b];
        spring.rest_length = std::min(spring.rest_length, (from - to).norm());
        slopes.push_back(spring_slope(spring, from, to));
    }
    const auto change = [&](const Vector3Array& shift, Vector3Array& into) {
        into.resize(n);
        for (std::size_t i = 0; i < n; ++i) into.set(i, Vector3::Zero());
        for (std::size_t k = 0; k < slopes.size(); ++k) {
            const Link& link = list.links[k];
            const Vector3 on_a = slopes[k] * (shift[link.a] - shift[link.b]);
            add(into, link.a, on_a), add(into, link.b, -on_a);
        }
        for (const std::size_t i : net.held) into.set(i, Vector3::Zero());
    };
    const auto dot = [&](const Vector3Array& a, const Vector3Array& b) {
        double sum = 0;
        for (std::size_t i = 0; i < n; ++i) sum += a[i].dot(b[i]);
        return sum;
    };
    net(all, t, forces);
    change(all.velocity, Ad);
    r.resize(n), d.resize(n);
    for (std::size_t i = 0; i < n; ++i)
        r.set(i, held[i] ? Vector3::Zero() : Vector3(dt * forces[i] + dt * dt * Ad[i]));
    d = r;
    Vector3Array dv(n);
    double size = dot(r, r);
    const double enough = tolerance * tolerance * size;
    for (std::size_t turn = 0; turn < 10 * n && size > enough; ++turn, ++iterations) {
        change(d, Ad);
        for (std::size_t i = 0; i < n; ++i)
            Ad.set(i, (all.mass[i] + net.drag * dt) * d[i] - dt * dt * Ad[i]);
        const double step = size / dot(d, Ad);
        for (std::size_t i = 0; i < n; ++i) {
            dv.set(i, dv[i] + step * d[i]);
            r.set(i, r[i] - step * Ad[i]);
        }
        const double before = size;
        size = dot(r, r);
        for (std::size_t i = 0; i < n; ++i) d.set(i, r[i] + size / before * d[i]);
    }
    for (std::size_t i = 0; i < n; ++i)
        if (!held[i]) all.velocity.set(i, all.velocity[i] + dv[i]);
    drift(all, dt);
    return all;
}

}  // namespace nutshell
