// Chapter 7 · The universe: the source's own program, as printed and repaired. Its sphere, its
// force (0, -0.01, 0), its start at (0, 2, 0) with L = (0.01, 0, 0), its floor and its step.
#pragma once
#include <nutshell/body.hpp>
#include <nutshell/many_turns.hpp>

namespace nutshell {

// [universe]
/// The source's main(), repaired: a ball of radius 1 m bounces on the floor with its surface, not
/// its centre, and its spin changes by friction only, not by 0.9 at every contact.
struct Universe {
    std::string name = "universe";
    double mass = 1, radius = 1;  // [kg], [m]
    Vector3 force{0, -0.01, 0};   // [N]
    Vector3 place{0, 2, 0};       // [m]
    Vector3 spin{0.01, 0, 0};     // L [kg m^2/s]
    double restitution = 0.9;
    double dt = 0.008;  // [s]

    Body ball() const {
        Body ball;
        ball.mass = mass, ball.inertia = Vector3::Constant(mass);  // the source's I
        ball.position = place, ball.angular_momentum = spin;
        return ball;
    }
    /// When the ball first touches the floor, and when it has bounced for the last time [s].
    double first_contact() const {
        return std::sqrt(2 * (place.y() - radius) * mass / -force.y());
    }
    double rest_time() const { return first_contact() * (1 + restitution) / (1 - restitution); }
};
// [/universe]

// [mended]
/// Universe::evolve, mended, and nothing more: kick, drift, collide. A ball that is in the floor
/// is put on it, and if it was on its way down, it leaves with e of its speed. No friction: its
/// spin stays. Errata E59, E62, E63, E64.
inline void evolve_mended(const Universe& universe, Body& ball, double dt) {
    // exercise 7.13
    kick(ball, {universe.force, Vector3::Zero()}, dt);
    drift(ball, dt);
    if (ball.position.y() >= universe.radius) return;
    ball.position.y() = universe.radius;
    if (ball.momentum.y() < 0) ball.momentum.y() *= -universe.restitution;
    // end 7.13
}
// [/mended]

// [printed_universe]
/// The program as printed, in its own float: position, momentum and angular momentum of its one
/// body, and the matrix R. Only what moves is kept; the errors are the source's.
struct PrintedUniverse {
    using Vector3f = Eigen::Vector3f;
    Vector3f p{0, 2, 0}, K{0, 0, 0}, L{0.01f, 0, 0}, F{0, -0.01f, 0};
    Eigen::Matrix3f R = Eigen::Matrix3f::Identity();
    long contacts = 0;

    /// Universe::evolve: Euler's step, then the floor that tests the centre, tests no approach
    /// and takes a tenth of L at every contact (E62-E64). Its Rotation is chapter 4's.
    void evolve(float dt) {
        const Vector3f v = K, omega = L;
        p = p + v * dt;
        K = K + F * dt;
        R = printed::product(printed::rotation(omega * dt), R);
        if (p.y() < 0) {
            p.y() = 0;
            K.y() = static_cast<float>(-0.9 * static_cast<double>(K.y()));
            L = 0.9f * L;
            ++contacts;
        }
    }
};
// [/printed_universe]

}  // namespace nutshell
