// The scenes of chapter 3 that move one point mass. What a scene consists of: see
// <nutshell/newton_scenes.hpp>. `drag` is the linear drag gamma [kg/s] that is part of the
// force; the exponential methods treat it exactly.
#pragma once
#include <nutshell/exponential.hpp>
#include <nutshell/forces.hpp>
#include <nutshell/newton_scenes.hpp>
#include <nutshell/right_hand_side.hpp>
#include <nutshell/runge_kutta.hpp>

namespace nutshell {

// [falling]
/// A body falls from rest under weight and linear drag (scene S3 of the comparison with other
/// engines). Bold numbers: no real body of 1 kg has linear drag at this speed.
/// exact: closed form, eqs. (3.d)-(3.e); accurate to round-off.
struct FallingWithDrag {
    std::string name = "falling_with_drag";
    double drag = 0.5;  // gamma [kg/s]
    PointMass start{1, {0, 0, 0}, {0, 0, 0}};
    double duration = 5;  // [s]
    Need need{60.0 / 960, "m", "one pixel of its snapshot, 60 m across 960 pixels"};

    Vector3 operator()(const PointMass& body, double) const {
        return gravity_force(body.mass) + linear_drag_force(drag, body.velocity);
    }
    Vector3 terminal_velocity() const { return gravity_force(start.mass) / drag; }
    PointMass exact(double t) const {
        const double x = drag * t / start.mass;
        const Vector3 v = terminal_velocity(), excess = start.velocity - v;
        return {start.mass, start.position + v * t + excess * t * phi_1(-x),
                v + excess * std::exp(-x)};
    }
    double error(const PointMass& state, double t) const { return distance(state, exact(t)); }
};
// [/falling]

/// A ball falls from rest in air: weight and quadratic drag.
/// exact: v = v_t tanh(g t/v_t), eq. (3A.d); accurate to round-off.
struct FallingInAir {
    std::string name = "falling_in_air";
    double air = air_drag(1.2, 0.47, pi * 0.1 * 0.1);  // c [kg/m]: a ball of radius 10 cm
    PointMass start{1, {0, 0, 0}, {0, 0, 0}};
    double duration = 5;  // [s]
    Need need{120.0 / 960, "m", "one pixel of its snapshot, 120 m across 960 pixels"};

    Vector3 operator()(const PointMass& ball, double) const {
        return gravity_force(ball.mass) + quadratic_drag_force(air, ball.velocity);
    }
    double terminal_speed() const { return std::sqrt(start.mass * earth_gravity / air); }
    PointMass exact(double t) const {
        const double v = terminal_speed(), x = earth_gravity * t / v;
        const double log_cosh =
            x + std::log1p(std::exp(-2 * x)) - std::log(2.0);  // does not overflow
        return {start.mass, {0, -v * v / earth_gravity * log_cosh, 0}, {0, -v * std::tanh(x), 0}};
    }
    double error(const PointMass& state, double t) const { return distance(state, exact(t)); }
};

// [spring_scene]
/// A mass on a spring of rest length zero, with or without linear drag (scenes S2 and S2d).
/// Period 1 s without drag. exact: closed form in all regimes; accurate to about 1e-15 times
/// the angle turned, omega t.
struct MassOnSpring {
    std::string name = "mass_on_spring";
    double stiffness = 4 * pi * pi;  // kappa [N/m]
    double drag = 0;                 // gamma [kg/s]
    PointMass start{1, {1, 0, 0}, {0, 0, 0}};
    double duration = 10;  // [s]
    Need need{3.0 / 960, "m", "one pixel of its snapshot, 3 m across 960 pixels"};

    /// Damping ratio: 0 undamped, below 1 it swings, 1 critical, above 1 it creeps.
    static MassOnSpring with_damping(double ratio) {
        MassOnSpring scene;
        scene.name = ratio < 1   ? "damped_spring"
                     : ratio > 1 ? "overdamped_spring"
                                 : "critically_damped_spring";
        scene.drag = checked_drag(2 * ratio * scene.omega() * scene.start.mass);
        return scene;
    }
    double omega() const { return std::sqrt(stiffness / start.mass); }  ///< [rad/s]
    double damping_rate() const { return drag / start.mass; }           ///< nu = gamma/m [1/s]

    /// Eq. (18*) with rest length zero needs no root.
    Vector3 operator()(const PointMass& mass, double) const {
        return -stiffness * mass.position - drag * mass.velocity;
    }
    PointMass exact(double t) const {
        return SpringPropagator{omega(), damping_rate()}(start, *this, 0, t);
    }
    double error(const PointMass& state, double t) const { return distance(state, exact(t)); }
    double energy(const PointMass& mass) const {
        return kinetic_energy(mass) + stiffness * mass.position.squaredNorm() / 2;
    }
};
// [/spring_scene]

// [throw_scene]
/// The ball of chapter 1, thrown without drag, with linear drag or through air: the model
/// ladder. exact: closed form where there is no air. With air there is none: a tight run stands
/// for it, accurate to 1e-11 m (tests compare it with another method).
struct ThrowInAir {
    std::string name = "throw_in_air";
    double drag = 0;  // linear, gamma [kg/s]
    double air =
        air_drag(1.2, 0.47, pi * 0.1 * 0.1);  // quadratic, c [kg/m]: a ball of radius 10 cm
    PointMass start{1, {0, 0, 0}, {10, 15, 0}};
    double duration = 3;  // [s]
    Need need{40.0 / 960, "m", "one pixel of its snapshot, 40 m across 960 pixels"};

    Vector3 operator()(const PointMass& ball, double) const {
        return gravity_force(ball.mass) + linear_drag_force(drag, ball.velocity) +
               quadratic_drag_force(air, ball.velocity);
    }
    PointMass exact(double t) const {
        if (t == 0) return start;
        if (air == 0) return exponential_kick(start, *this, 0, t);
        const FlatPoint y = adaptive(flat(start), right_hand_side(start, *this), 0, t,
                                     {1e-13, 1e-13}, t / 100, [](const FlatPoint&, double) {});
        return unflat(y, start);
    }
    double error(const PointMass& state, double t) const { return distance(state, exact(t)); }
};
// [/throw_scene]

}  // namespace nutshell
