// Chapter 6 · Pendulums: a body on a pivot, and what gravity does to it.
#pragma once
#include <nutshell/body.hpp>
#include <nutshell/elliptic.hpp>
#include <nutshell/inertia.hpp>
#include <nutshell/need.hpp>
#include <nutshell/newton_scenes.hpp>

namespace nutshell {

// [pendulum_period]
/// The period [s] of a pendulum that is let go at `angle` [rad] from hanging: 4 sqrt(l/g) K(k), k
/// = sin(angle/2). Exact at any angle below pi; accurate to a few units in the last place.
/// @param length  l = I/(m r) [m]: of the rod if all mass is at its end, 2/3 of a uniform rod
/// @throws std::invalid_argument unless 0 <= angle < pi and the length is greater than zero
inline double pendulum_period(double length, double angle) {
    require_positive(length, "pendulum_period: the length [m]");
    require(angle >= 0 && angle < pi,
            "pendulum_period: the angle must be at least 0 and below pi");
    return 4 * std::sqrt(length / -gravity.y()) * complete_elliptic_k(std::cos(angle / 2));
}
// [/pendulum_period]

/// Where a pendulum is, and how fast it turns.
struct Swing {
    double angle, rate;  ///< from hanging [rad], and its change [rad/s]
};

// [swing]
/// A pendulum at time t [s] after it was let go at `angle` [rad] from hanging, below pi in size:
/// sin(now/2) = k sn(omega t + K) with k = sin(angle/2), and its rate of change. Solves now'' =
/// -omega^2 sin(now). Accurate to a few epsilon times 1 + omega t.
/// @param omega  of small swings [rad/s]
inline Swing swing(double omega, double angle, double t) {
    const double k = std::sin(angle / 2), complementary = std::cos(angle / 2);
    const Jacobi f = jacobi(omega * t + complete_elliptic_k(complementary), complementary);
    return {2 * std::atan2(k * f.sn, f.dn), 2 * k * omega * f.cn};
}
// [/swing]

// [pendulum]
/// A body that hangs from a pivot at the origin, let go at rest; it swings about the world's z.
/// exact: `swing`.
struct Pendulum {
    std::string name;
    double mass, distance;  ///< [kg]; from the pivot to the centre of mass [m]
    double angle;           ///< at the start [rad], counter-clockwise from hanging
    Pinned start;           ///< the centre lies on the body's -y
    double duration;        ///< [s]: three periods
    Need need{1.0 / 960, "rad", "one pixel of its snapshot, at a radius of 960 pixels"};

    /// @param inertia  principal moments about the pivot [kg m^2], the body's y along the
    /// pendulum
    Pendulum(std::string called, double its_mass, double its_distance, const Vector3& inertia,
             double start_angle)
        : name(std::move(called)),
          mass(its_mass),
          distance(its_distance),
          angle(start_angle),
          start(checked(Pinned{inertia, exponential({0, 0, start_angle})})),
          duration(3 * pendulum_period(length(), start_angle)) {}

    /// Length [m] of the pendulum with all mass in one point that swings alike: I/(m r).
    double length() const { return start.inertia.z() / (mass * distance); }
    /// Angular frequency of small swings [rad/s].
    double omega() const { return std::sqrt(-gravity.y() / length()); }

    /// The weight, at the end of the lever from pivot to centre.
    Wrench operator()(const Pinned& body, double) const {
        return force_at(mass * gravity, rotate(body.orientation, {0, -distance, 0}));
    }
    /// Angle from hanging [rad], counter-clockwise, between -pi and pi.
    double angle_of(const Pinned& body) const {
        const Vector3 arm = rotate(body.orientation, {0, -1, 0});
        return std::atan2(arm.x(), -arm.y());
    }
    Pinned exact(double t) const {
        const Swing now = swing(omega(), angle, t);
        Pinned body = start;
        body.orientation = exponential({0, 0, now.angle});
        body.angular_momentum = {0, 0, start.inertia.z() * now.rate};
        return body;
    }
    double error(const Pinned& body, double t) const {
        return angle_between(body.orientation, exact(t).orientation);
    }
    /// Energy of rotation and height [J]; zero hanging at rest.
    double energy(const Pinned& body) const {
        const double height = distance + rotate(body.orientation, {0, -distance, 0}).y();
        return rotational_energy(body) - mass * gravity.y() * height;
    }
};

/// A bob of 1 kg on a rod without mass, 1 m long. A point has no moment about the rod; the motion
/// has no spin about it either, so the small one given here is never used.
inline Pendulum rod_pendulum(double angle) {
    return {"rod_pendulum", 1, 1, {1, 1e-3, 1}, angle};
}

/// A uniform rod of 1 kg, 1 m long and 2 cm thick, on a pivot at its end.
inline Pendulum compound_pendulum(double angle) {
    const Vector3 z_along = cylinder_inertia(1, 0.01, 1);
    const Vector3 own(z_along.x(), z_along.z(), z_along.y());
    return {"compound_pendulum", 1, 0.5, own + parallel_axis(1, {0, 0.5, 0}).diagonal(), angle};
}
// [/pendulum]

// [pendulum_limit]
/// The largest stable step [s] of Verlet for small swings of a pinned body: its drift turns about
/// a fixed axis exactly, so it is the limit of a mass on a spring, 2/omega.
inline double pendulum_verlet_limit(double omega) {
    require_positive(omega, "pendulum_verlet_limit: omega [rad/s]");
    return 2 / omega;
}
// [/pendulum_limit]

}  // namespace nutshell
