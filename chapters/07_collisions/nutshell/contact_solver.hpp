// Chapter 7 · The contact solver: many contacts at once, by going round them again and again.
// Each is given the impulse that it lacks, and never pulls.
#pragma once
#include <nutshell/contact.hpp>

namespace nutshell {

// [mobile]
/// How a body answers impulses at this moment.
struct Mobility {
    double inverse_mass = 0;                    ///< [1/kg]
    Matrix3 inverse_inertia = Matrix3::Zero();  ///< [1/(kg m^2)], world axes
    double inverse_moment = 0;  ///< if all moments are equal (ball, cube): 1/I, else 0
};

inline Mobility mobility_of(const Body& body) {
    const Vector3& I = body.inertia;
    if (I[0] == I[1] && I[1] == I[2])  // a ball's or a cube's does not turn with it
        return {1 / body.mass, Vector3::Constant(1 / I[0]).asDiagonal(), 1 / I[0]};
    return {1 / body.mass, world_inverse_inertia(body)};
}

/// The angular velocity [rad/s] that an angular momentum L [kg m^2/s] is, or that one given adds.
inline Vector3 turning(const Mobility& of, const Vector3& L) {
    if (of.inverse_moment > 0) return of.inverse_moment * L;  // three products instead of nine
    return of.inverse_inertia * L;
}
// [/mobile]

// [pressed]
/// A contact that the solver works on: between two points, one fixed to each body, each with a
/// round skin (radius 0: none).
struct PressedContact {
    int a, b;                            ///< numbers of the bodies; -1 is the earth
    int feature;                         ///< see Contact
    bool balls;                          ///< both bodies are spheres: the normal turns with them
    Vector3 normal;                      ///< from a to b, world axes
    Vector3 lever_a, lever_b;            ///< from the centres to the contact [m], world axes
    double separation;                   ///< [m]
    double normal_mass, friction_mass;   ///< impulse per speed changed [kg]
    double normal_impulse = 0;           ///< of this sub-step [N s], never negative
    Vector3 friction = Vector3::Zero();  ///< of this sub-step [N s], across the normal
    double closing = 0;                  ///< separating speed before this sub-step [m/s]
    Vector3 anchor_a, anchor_b;          ///< the fixed points [m], body axes
    double radius_a, radius_b;           ///< of the skins [m]
};
// [/pressed]

// [masses]
/// What one body's part of a contact adds to its mobility [1/kg]: along the normal, eq. (7.e),
/// and in all three directions together (the trace of K).
struct Gains {
    double normal = 0, all = 0;
};
inline void add_gains(Gains& gains, const Mobility& of, const Vector3& lever, const Vector3& n) {
    const Vector3 turn = lever.cross(n);
    gains.normal += of.inverse_mass + turn.dot(turning(of, turn));
    gains.all += 3 * of.inverse_mass + lever.squaredNorm() * of.inverse_inertia.trace() -
                 lever.dot(turning(of, lever));
}

/// Fixes a contact's points to its bodies, and asks both how they answer.
inline void prepare(PressedContact& c, const Contact& found, const Body& a, const Body& b,
                    const Mobility& of_a, const Mobility& of_b) {
    c.normal = found.normal, c.separation = found.separation, c.feature = found.feature;
    c.lever_a = found.point - a.position, c.lever_b = found.point - b.position;
    if (!c.balls) {  // two balls touch between their centres, however they turn
        const Vector3 half_gap = found.separation / 2 * found.normal;
        c.anchor_a = rotate(inverse(a.orientation), c.lever_a - half_gap - c.radius_a * c.normal);
        c.anchor_b = rotate(inverse(b.orientation), c.lever_b + half_gap + c.radius_b * c.normal);
    }
    Gains gains;
    add_gains(gains, of_a, c.lever_a, c.normal), add_gains(gains, of_b, c.lever_b, c.normal);
    c.normal_mass = 1 / gains.normal;
    c.friction_mass = 2 / (gains.all - gains.normal);  // over the mean of all directions across n
}

/// Where the contact is after the bodies have moved: in the middle between its two points.
inline void follow(PressedContact& c, const Body& a, const Body& b) {
    if (c.balls) {
        const Vector3 between = b.position - a.position;
        const double distance = between.norm();
        if (distance > 0) c.normal = between / distance;
        c.separation = distance - c.radius_a - c.radius_b;
        c.lever_a = (c.radius_a + c.separation / 2) * c.normal, c.lever_b = c.lever_a - between;
        c.friction -= c.normal.dot(c.friction) * c.normal;
        return;
    }
    const Vector3 at_a = a.position + rotate(a.orientation, c.anchor_a) + c.radius_a * c.normal;
    const Vector3 at_b = b.position + rotate(b.orientation, c.anchor_b) - c.radius_b * c.normal;
    const Vector3 middle = (at_a + at_b) / 2;
    c.separation = c.normal.dot(at_b - at_a);
    c.lever_a = middle - a.position, c.lever_b = middle - b.position;
}
// [/masses]

// [push]
/// Velocity of b's point seen from a's [m/s].
inline Vector3 contact_velocity(const PressedContact& c, const Body& a, const Body& b,
                                const Mobility& of_a, const Mobility& of_b) {
    const Vector3 omega_a = turning(of_a, a.angular_momentum),
                  omega_b = turning(of_b, b.angular_momentum);
    return of_b.inverse_mass * b.momentum - of_a.inverse_mass * a.momentum +
           omega_b.cross(c.lever_b) - omega_a.cross(c.lever_a);
}

/// The impulse J on b, its opposite on a.
inline void apply_impulse(const PressedContact& c, Body& a, Body& b, const Vector3& J) {
    a.momentum -= J, b.momentum += J;
    a.angular_momentum -= c.lever_a.cross(J), b.angular_momentum += c.lever_b.cross(J);
}
// [/push]

// [soft]
/// A contact that overlaps, as a stiff and strongly damped spring, its step taken by implicit
/// Euler: what is too deep comes out slowly, without a bounce.
struct Softness {
    double rate = 0;  ///< of the depth, undone per second [1/s]
    double mass = 1;  ///< part of the contact's mass that answers
    double fade = 0;  ///< part of the impulse so far that is given back
};

/// @param frequency  of the spring [1/s]    @param damping  ratio; 1 is critical
/// Source: E. Catto, Soft Constraints, GDC 2011; Solver2D, 2024.
inline Softness softness(double frequency, double damping, double h) {
    // exercise 7.11
    const double omega = 2 * pi * frequency, c = 2 * damping + h * omega, k = h * omega * c;
    return {omega / c, k / (1 + k), 1 / (1 + k)};
    // end 7.11
}
// [/soft]

// [wish]
/// What the solver wants of all contacts in one pass.
struct Press {
    double h;                ///< sub-step [s]
    double friction;         ///< mu
    double restitution;      ///< e; 0 in a pass that pushes out
    double slow;             ///< contacts that close in slower than this [m/s] do not bounce
    Softness soft = {};      ///< of contacts that overlap
    double fastest_out = 3;  ///< what overlaps comes out no faster [m/s]
    bool pyramid = false;    ///< friction bounded along two axes apart, not in a cone: wrong
};

/// Friction of at most `limit` in size, whatever its direction: Coulomb's cone.
inline Vector3 in_cone(const Vector3& friction, double limit) {
    const double square = friction.squaredNorm();
    return square > limit * limit ? Vector3(limit / std::sqrt(square) * friction) : friction;
}

/// Friction of at most `limit` along each of two axes across the normal, as fast solvers have it:
/// between the axes that is up to sqrt 2 times too much. Wrong, and kept to show it.
inline Vector3 in_pyramid(const Vector3& friction, double limit, const Vector3& n) {
    const Vector3 x = n.unitOrthogonal(), y = n.cross(x);
    return std::clamp(x.dot(friction), -limit, limit) * x +
           std::clamp(y.dot(friction), -limit, limit) * y;
}

/// What a contact asks for.
struct Wish {
    double speed = 0;  ///< to separate with [m/s]
    double mass = 1;   ///< part of the contact's mass that answers
    double fade = 0;   ///< part of the impulse so far that is given back
};

/// A gap may close in just so fast that it touches; what overlaps comes out softly; what came in
/// fast, and is pressed or about to be, bounces; all else neither closes in nor opens.
/// @param s  the contact's separating speed now [m/s]
inline Wish wish_of(const PressedContact& c, double s, const Press& want) {
    Wish wish;
    if (c.separation > 0)
        wish.speed = -c.separation / want.h;
    else if (want.soft.rate > 0)
        wish = {std::min(-want.soft.rate * c.separation, want.fastest_out), want.soft.mass,
                want.soft.fade};
    if (want.restitution > 0 && c.closing < -want.slow &&
        (c.normal_impulse > 0 || s < wish.speed))
        wish.speed = -want.restitution * c.closing;
    return wish;
}
// [/wish]

// [turn]
/// One contact's turn: the impulse that gives it its wish and does not let it slide, added to
/// what it had so far; the sum never pulls, and its friction never exceeds mu times its normal
/// impulse, whatever its direction.
inline void press(PressedContact& c, Body& a, Body& b, const Mobility& of_a, const Mobility& of_b,
                  const Press& want) {
    const Vector3 u = contact_velocity(c, a, b, of_a, of_b);
    const double s = c.normal.dot(u);
    const Wish wish = wish_of(c, s, want);
    // exercise 7.8
    const double normal = std::max(
        0.0, (1 - wish.fade) * c.normal_impulse + wish.mass * c.normal_mass * (wish.speed - s));
    if (normal == 0 && c.normal_impulse == 0) return;  // open, and stays so
    const Vector3 wanted = c.friction - c.friction_mass * (u - s * c.normal);
    const double limit = want.friction * normal;
    const Vector3 friction =
        want.pyramid ? in_pyramid(wanted, limit, c.normal) : in_cone(wanted, limit);

    apply_impulse(c, a, b, (normal - c.normal_impulse) * c.normal + (friction - c.friction));
    c.normal_impulse = normal, c.friction = friction;
    // end 7.8
}
// [/turn]

}  // namespace nutshell
