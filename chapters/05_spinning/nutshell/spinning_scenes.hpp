// The scenes of chapter 5. What a scene is made of: see chapter 1's newton_scenes.hpp. The state
// is a pose; what a method asks for is the angular velocity [rad/s], world axes.
#pragma once
#include <nutshell/need.hpp>
#include <nutshell/spinning.hpp>
#include <string>

namespace nutshell {

// [wheel]
/// A wheel on a fixed axle, at one speed. exact: one turn by the whole angle; accurate to 1e-16 of
/// that angle.
struct SpinningWheel {
    std::string name = "spinning_wheel";
    Vector3 axis{0, 0, 1};  // of any length but zero
    double rate = 2 * pi;   // [rad/s]
    double turns = 10;
    Quaternion start = four_vector({0, 0, 0}, 1);
    double duration = 2 * pi * turns / rate;  // [s]
    Need need{1.0 / 300, "rad", "one pixel at the rim of a wheel of 300 pixels' radius"};

    static SpinningWheel at(const Vector3& axis, double turns_per_second, double turns) {
        SpinningWheel wheel;
        wheel.axis = axis, wheel.rate = 2 * pi * turns_per_second, wheel.turns = turns;
        wheel.duration = turns / turns_per_second;
        return wheel;
    }
    /// Scenes S6 and S6 fast of the comparison with other engines: a thousand turns.
    static SpinningWheel s6() { return at({1, 2, 3}, 1, 1000); }
    static SpinningWheel s6_fast() { return at({1, 2, 3}, 20, 1000); }

    Vector3 omega() const { return rate * direction_of(axis); }
    Vector3 operator()(const Quaternion&, double) const { return omega(); }
    Quaternion exact(double t) const {
        return quaternion_about(axis, std::remainder(rate * t, 4 * pi));
    }
    double error(const Quaternion& q, double t) const { return angle_between(q, exact(t)); }
};
// [/wheel]

// [coning]
/// A body that spins about its own x axis while that axis goes round a circle: like a top that
/// circles, or a drone's camera that shakes. exact: R = R_z(turning t) R_x(spinning t), accurate
/// to 1e-16 of the angles.
struct Coning {
    std::string name = "coning";
    double turning = 2 * pi * 0.5;  // [rad/s], of the x axis about the world's z
    double spinning = 2 * pi;       // [rad/s], about the body's x
    Quaternion start = four_vector({0, 0, 0}, 1);
    double duration = 2;  // [s]: one round
    Need need{1.0 / 300, "rad", "one pixel at the end of an arm of 300 pixels"};

    /// Both turns at once: about z, and about where the x axis is now.
    Vector3 operator()(const Quaternion&, double t) const {
        const double c = std::cos(turning * t), s = std::sin(turning * t);
        return {spinning * c, spinning * s, turning};
    }
    Quaternion exact(double t) const {
        return product(quaternion_about(Vector3::UnitZ(), turning * t),
                       quaternion_about(Vector3::UnitX(), spinning * t));
    }
    double error(const Quaternion& q, double t) const { return angle_between(q, exact(t)); }
};
// [/coning]

// [rolling]
/// A wheel rolls along x on the ground y = 0 without slipping. The state is its pose; its centre
/// follows from the distance rolled. exact: the cycloid; accurate to round-off.
struct RollingWheel {
    std::string name = "rolling_wheel";
    double radius = 0.5;  // [m]
    double speed = 1.5;   // [m/s], of the centre
    Quaternion start = four_vector({0, 0, 0}, 1);
    double duration = 2 * 2 * pi * radius / speed;  // [s]: two turns
    Need need{7.0 / 960, "m", "one pixel of its picture, 7 m across 960 pixels"};

    /// Forwards along x is clockwise: about -z.
    Vector3 omega() const { return {0, 0, -speed / radius}; }
    Vector3 operator()(const Quaternion&, double) const { return omega(); }
    Vector3 centre(double t) const { return {speed * t, radius, 0}; }
    /// Where a point of the wheel is that began at `p` from the centre [m].
    Vector3 point(const Quaternion& q, double t, const Vector3& p) const {
        return centre(t) + rotate(q, p);
    }
    /// How fast it is [m/s]: with the centre, and round it.
    Vector3 velocity(const Quaternion& q, const Vector3& p) const {
        return Vector3(speed, 0, 0) + point_velocity(omega(), q, p);
    }
    Quaternion exact(double t) const {
        return quaternion_about(Vector3::UnitZ(), -speed / radius * t);
    }
    /// Of the lowest point at the start [m].
    double error(const Quaternion& q, double t) const {
        const Vector3 lowest(0, -radius, 0);
        return (point(q, t, lowest) - point(exact(t), t, lowest)).norm();
    }
};
// [/rolling]

}  // namespace nutshell
