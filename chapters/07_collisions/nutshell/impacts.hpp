// Chapter 7 · Impacts: an impulse changes momentum, at once. What one body gains, the other
// loses.
#pragma once
#include <limits>
#include <nutshell/revised_newton.hpp>
#include <vector>

namespace nutshell {

/// The mass [kg] of what nothing moves: a wall, the floor, the earth. 1 over it is zero, so every
/// formula below holds for walls too. Source: the limit in eq. (69).
inline constexpr double immovable = std::numeric_limits<double>::infinity();

/// Gives the restitution back. @throws std::invalid_argument unless it is between 0 and 1 (E34)
inline double checked_restitution(double e) {
    require(e >= 0 && e <= 1, "a restitution must be between 0 and 1, not " + digits(e));
    return e;
}

/// Gives a contact's normal back. @throws std::invalid_argument unless its length is one
inline Vector3 checked_normal(const Vector3& n) {
    require_finite(n, "the normal of a contact");
    require(std::abs(n.norm() - 1) < 1e-9,
            "the normal of a contact has length " + digits(n.norm()) + " instead of 1");
    return n;
}

// [closing]
/// How fast b moves away from a along the normal n, which points from a to b [m/s]; negative
/// while they close in. Source: eqs. (64), (66), their component along n (E34).
inline double separating_speed(const Particle& a, const Particle& b, const Vector3& n) {
    return n.dot(velocity(b) - velocity(a));
}
// [/closing]

// [collide]
/// The impulse [N s] along n that turns the separating speed s < 0 into -e s. None if they do not
/// close in. Eq. (7.a), out of eq. (65*) and the momentum that both keep.
/// @param e  restitution: 1 elastic, 0 stuck along n
inline double impact_impulse(const Particle& a, const Particle& b, const Vector3& n, double e) {
    // exercise 7.1
    const double s = separating_speed(a, b, n);
    if (!(s < 0)) return 0;
    return -(1 + e) * s / (1 / a.mass + 1 / b.mass);
    // end 7.1
}

/// Collide: two particles meet, and one impulse along n (unit, from a to b) changes both momenta.
/// A wall is a particle of mass `immovable`. Source: eqs. (67*)-(71).
inline void collide(Particle& a, Particle& b, const Vector3& n, double e) {
    // exercise 7.2
    const Vector3 impulse = impact_impulse(a, b, n, e) * n;
    a.momentum -= impulse;
    b.momentum += impulse;
    // end 7.2
}
// [/collide]

/// Gives two particles that may collide back as they are. @throws std::invalid_argument if a mass
/// is not greater than zero (it may be `immovable`), a number is not finite, or neither can move
inline void check_pair(const Particle& a, const Particle& b) {
    for (const Particle* body : {&a, &b}) {
        require(body->mass > 0, "the mass of a colliding particle is " + digits(body->mass) +
                                    " kg, but must be greater than zero");
        require_finite(body->position, "the position of a colliding particle [m]");
        require_finite(body->momentum, "the momentum of a colliding particle [kg m/s]");
    }
    require(a.mass < immovable || b.mass < immovable,
            "two immovable things cannot collide: give one of them a finite mass");
}

// [one_after_another]
/// Two particles, by their numbers, that touch, and the normal from a to b.
struct Touch {
    std::size_t a, b;
    Vector3 normal;
};

/// Impacts of many touching particles at one moment, one pair after another, until no pair closes
/// in faster than `still` [m/s].
/// @return the number of impacts
/// @throws std::runtime_error after a million impacts: some e < 1 never end ("inelastic
/// collapse")
inline long collide_one_after_another(std::vector<Particle>& all,
                                      const std::vector<Touch>& touches, double e,
                                      double still = 0) {
    long impacts = 0;
    for (bool closing = true; closing;) {
        closing = false;
        for (const auto& [a, b, n] : touches) {
            if (separating_speed(all[a], all[b], n) >= -still) continue;
            collide(all[a], all[b], n, e);
            closing = true;
            if (++impacts > 1'000'000)
                throw std::runtime_error(
                    "collide_one_after_another: a million impacts and no end; let pairs that "
                    "close in slower than some speed `still` be at rest");
        }
    }
    return impacts;
}
// [/one_after_another]

// [printed]
/// The impact as printed in eqs. (67)-(68): the whole relative velocity is reversed, not its
/// component along the normal, whether the two close in or not (E34-E36). Right head-on only.
inline void collide_as_printed(Particle& a, Particle& b, double c) {
    const Vector3 va = velocity(a), vb = velocity(b);
    const double total = a.mass + b.mass;
    a.momentum = a.mass * (va + b.mass / total * (c + 1) * (vb - va));
    b.momentum = b.mass * (vb + a.mass / total * (c + 1) * (va - vb));
}
// [/printed]

}  // namespace nutshell
