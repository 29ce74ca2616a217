// Chapter 7 · An impulse at the point where two bodies touch: it changes their momenta and, by
// its levers, their angular momenta. Restitution says how much, friction which way.
#pragma once
#include <Eigen/LU>
#include <nutshell/contact.hpp>
#include <nutshell/method.hpp>
#include <optional>

namespace nutshell {

// [apply_impulse]
/// The impulse J [N s], world axes, on b at the point of contact, and its opposite on a: what one
/// gains, in momentum and about any point in angular momentum, the other loses.
inline void apply_impulse(Body& a, Body& b, const Contact& at, const Vector3& J) {
    // exercise 7.6
    a.momentum -= J;
    b.momentum += J;
    a.angular_momentum -= (at.point - a.position).cross(J);
    b.angular_momentum += (at.point - b.position).cross(J);
    // end 7.6
}
// [/apply_impulse]

// [mobility]
/// How a body's point at `lever` [m] from its centre answers an impulse there: its velocity
/// changes by K J, K in 1/kg. Eq. (7.e): J/m from the motion, (I^-1 (r x J)) x r from the
/// turning.
inline Matrix3 mobility(double inverse_mass, const Matrix3& inverse_inertia,
                        const Vector3& lever) {
    // exercise 7.5
    Matrix3 cross;                      // cross * J = lever x J
    cross << 0, -lever.z(), lever.y(),  //
        lever.z(), 0, -lever.x(),       //
        -lever.y(), lever.x(), 0;
    return inverse_mass * Matrix3::Identity() - cross * inverse_inertia * cross;
    // end 7.5
}

/// The same for the relative velocity of two bodies: u' = u + K J.
inline Matrix3 mobility(const Body& a, const Body& b, const Contact& at) {
    return mobility(1 / a.mass, world_inverse_inertia(a), at.point - a.position) +
           mobility(1 / b.mass, world_inverse_inertia(b), at.point - b.position);
}
// [/mobility]

// [smooth]
/// The impulse [N s] of a contact without friction: along n, and it turns the separating speed
/// n.u into -e n.u. None if they do not close in. Source: E35, eq. (67*) with levers.
inline Vector3 smooth_impulse(const Matrix3& K, const Vector3& u, const Vector3& n, double e) {
    const double s = n.dot(u);
    if (!(s < 0)) return Vector3::Zero();
    return -(1 + e) * s / n.dot(K * n) * n;
}
// [/smooth]

// [sliding]
/// The impulse of an impact without bounce through which the contact slides, towards some unit
/// vector d: along n - mu d, so great that nothing closes in any more. d must be where the velocity
/// that it leaves points; it is looked for all round. Eq. (7.g).
/// @return nothing if no direction is found
inline std::optional<Vector3> sliding_impulse(const Matrix3& K, const Vector3& u,
                                              const Vector3& n, double mu) {
    // What brings the separating speed to zero is -n.u/gain times n - mu d, gain = n.K(n - mu d);
    // and the velocity that is left, times gain, is `left`.
    const Vector3 across = u - n.dot(u) * n;
    const Vector3 x = across.norm() > 0 ? across.normalized() : n.unitOrthogonal();
    const Vector3 y = n.cross(x);
    const auto towards = [&](double angle) -> Vector3 {
        return std::cos(angle) * x + std::sin(angle) * y;
    };
    const auto left = [&](const Vector3& d) -> Vector3 {
        const Vector3 answer = K * (n - mu * d);
        return n.dot(answer) * u - n.dot(u) * answer;
    };
    const auto off = [&](double angle) {  // how far `left` is off d, to the left
        const Vector3 d = towards(angle);
        return n.cross(d).dot(left(d));
    };
    const auto slides = [&](double angle) -> std::optional<Vector3> {
        const Vector3 d = towards(angle), along = n - mu * d;
        const double gain = n.dot(K * along);
        if (!(gain > 0) || d.dot(left(d)) < 0) return {};
        return Vector3(-n.dot(u) / gain * along);
    };
    if (std::abs(off(0)) <= 1e-15 * K.norm() * u.norm())
        if (const auto J = slides(0)) return J;  // a ball: friction turns no direction
    for (const int looks : {32, 2048}) {         // thin rods have roots close together
        const double step = 2 * pi / looks;
        for (int i = 0; i < looks + 2; ++i) {  // from x to both sides in turn, and past -x
            const double side = i % 2 ? -1 : 1;
            double from = side * (i / 2) * step, to = from + side * step;
            const bool sign = off(from) > 0;
            if (sign == (off(to) > 0)) continue;
            for (int k = 0; k < 50; ++k) {
                const double middle = (from + to) / 2;
                ((off(middle) > 0) == sign ? from : to) = middle;
            }
            if (const auto J = slides(to)) return J;
        }
    }
    return {};
}
// [/sliding]

// [plastic]
/// The impact without bounce, with Coulomb's friction: afterwards the contact neither closes in
/// nor slides, if mu times the normal impulse can hold it. Else it slides on, against just as
/// much. Should no direction of sliding be found, there is no friction. Eqs. (7.f), (7.g).
/// @param K, u  mobility [1/kg] and relative velocity [m/s] of the contact, n.u < 0
inline Vector3 plastic_impulse(const Matrix3& K, const Vector3& u, const Vector3& n, double mu) {
    // exercise 7.7
    const Vector3 stick = -K.inverse() * u;
    const double normal = n.dot(stick);
    const Vector3 friction = stick - normal * n;
    if (normal > 0 && friction.norm() <= mu * normal) return stick;
    return sliding_impulse(K, u, n, mu).value_or(smooth_impulse(K, u, n, 0));
    // end 7.7
}
// [/plastic]

// [laws]
/// Restitution as a wish: the contact shall leave with -e of its closing speed, whatever friction
/// does. A contact that sticks ends with no tangential velocity. Can gain energy on a rod.
inline Vector3 clamped_impulse(const Matrix3& K, const Vector3& u, const Vector3& n, double e,
                               double mu) {
    return plastic_impulse(K, u + e * n.dot(u) * n, n, mu);
}

/// Restitution as an echo: the plastic impulse, times 1 + e. It leaves with -e of its closing
/// speed too; a contact that sticks leaves with -e of its tangential velocity as well. Never
/// gains energy. Eq. (7.h).
inline Vector3 echo_impulse(const Matrix3& K, const Vector3& u, const Vector3& n, double e,
                            double mu) {
    return (1 + e) * plastic_impulse(K, u, n, mu);
}
// [/laws]

// [law]
/// An impact law as one value: its name, its look on charts, and the impulse [N s] that it gives a
/// contact of mobility K and velocity u, n.u < 0.
struct ImpactLaw {
    const char* name;
    Look look;
    Vector3 (*impulse)(const Matrix3& K, const Vector3& u, const Vector3& n, double e, double mu);

    std::string key() const { return key_of(name); }
};

namespace laws {
inline constexpr ImpactLaw clamped{
    "clamped", {Family::explicit_one_step, Mark::circle}, clamped_impulse};
inline constexpr ImpactLaw echo{"echo", {Family::symplectic, Mark::square}, echo_impulse};
}  // namespace laws

inline constexpr std::tuple impact_laws{laws::clamped, laws::echo};
// [/law]

// [collide_bodies]
/// Collide: two bodies touch, and one impulse changes all four momenta. Eqs. (67*)-(69*).
inline void collide(Body& a, Body& b, const Contact& at, const Surface& surface,
                    const ImpactLaw& law = laws::clamped) {
    const Vector3 u = contact_velocity(a, b, at), &n = at.normal;
    if (!(n.dot(u) < 0)) return;
    const Matrix3 K = mobility(a, b, at);
    apply_impulse(a, b, at, law.impulse(K, u, n, surface.restitution, surface.friction));
}
// [/collide_bodies]

/// Throws std::invalid_argument if these two bodies cannot collide here: a number is not finite,
/// a mass or a moment not greater than zero (both may be `immovable`), the normal no unit vector,
/// or neither body can move.
inline void check_contact(const Body& a, const Body& b, const Contact& at) {
    checked_normal(at.normal);
    require_finite(at.point, "the point of a contact [m]");
    for (const Body* body : {&a, &b}) {
        if (body->mass < immovable || body->inertia.minCoeff() < immovable) {
            checked(*body);
            continue;
        }
        require_finite(body->position, "the position of an immovable body [m]");
        require_finite(body->momentum, "the momentum of an immovable body [kg m/s]");
    }
    require(a.mass < immovable || b.mass < immovable,
            "two immovable bodies cannot collide: give one of them a finite mass and inertia");
}

}  // namespace nutshell
