// Chapter 7 · The universe: the source's own program, as printed and repaired. Its sphere, its
// force (0, -0.01, 0), its start at (0, 2, 0) with L = (0.01, 0, 0), its floor and its step.
#pragma once
#include <nutshell/rest_scenes.hpp>

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
    Switches switches = {1};

    World start() const {
        World world;
        world.walls = {Plane{}};
        world.gravity = force / mass;
        world.surface = {restitution, 0};
        Body ball;
        ball.mass = mass, ball.inertia = Vector3::Constant(mass);  // the source's I
        ball.position = place, ball.angular_momentum = spin;
        world.add(ball, Sphere{radius});
        return world;
    }
    /// When the ball first touches the floor, and when it has bounced for the last time [s].
    double first_contact() const {
        return std::sqrt(2 * (place.y() - radius) * mass / -force.y());
    }
    double rest_time() const { return first_contact() * (1 + restitution) / (1 - restitution); }
};
// [/universe]

// [printed_universe]
/// The program as printed, in its own float: position, momentum and angular momentum of its one
/// body, and the matrix R. Only what moves is kept; the errors are the source's.
struct PrintedUniverse {
    using Vector3f = Eigen::Vector3f;
    Vector3f p{0, 2, 0}, K{0, 0, 0}, L{0.01f, 0, 0}, F{0, -0.01f, 0};
    Eigen::Matrix3f R = Eigen::Matrix3f::Identity();
    long contacts = 0;

    /// Universe::evolve: Euler's step, then the floor that tests the centre, tests no approach
    /// and takes a tenth of L at every contact (E62-E64).
    void evolve(float dt) {
        const Vector3f v = K, omega = L;
        p = p + v * dt;
        K = K + F * dt;
        R = rotation(omega * dt) * R;
        if (p.y() < 0) {
            p.y() = 0;
            K.y() = static_cast<float>(-0.9 * static_cast<double>(K.y()));
            L = 0.9f * L;
            ++contacts;
        }
    }
    /// The source's Rotation(v): the axis is v/|v|, 0/0 where |v| is zero or too small to square
    /// (E52); it turns the wrong way (E51) and stretches (E53).
    __attribute__((no_sanitize("float-divide-by-zero"))) static Eigen::Matrix3f rotation(
        const Vector3f& v) {
        const float angle = std::sqrt(v.x() * v.x() + v.y() * v.y() + v.z() * v.z());
        const float x = v.x() / angle, y = v.y() / angle, z = v.z() / angle;
        const float c = std::cos(angle), s = std::sin(angle), t = 1 - c;
        Eigen::Matrix3f m;
        m << t * x * x + c, t * x * y + s * z, t * x * z - s * y,  //
            t * x * y - s * z, t * y * y + c, t * y * z + s * x,   //
            t * x * z + s * y, t * y * z - s * x, t * z * z + c;
        return m;
    }
};
// [/printed_universe]

}  // namespace nutshell
