// Chapter 6 · Bodies: the state of this chapter for any number of bodies, and the same two verbs.
#pragma once
#include <nutshell/body.hpp>
#include <nutshell/particles.hpp>
#include <nutshell/wide_bodies.hpp>

namespace nutshell {

// [bodies]
/// Many orientations, one array for each number of their 4-vectors.
struct QuaternionArray {
    std::vector<double> x, y, z, w;

    explicit QuaternionArray(std::size_t n = 0) : x(n), y(n), z(n), w(n, 1) {}
    std::size_t size() const { return x.size(); }
    Quaternion operator[](std::size_t i) const { return Quaternion(w[i], x[i], y[i], z[i]); }
    void set(std::size_t i, const Quaternion& q) {
        x[i] = q.x(), y[i] = q.y(), z[i] = q.z(), w[i] = q.w();
    }
    wide::FourVectors arrays() { return {x.data(), y.data(), z.data(), w.data()}; }
};

/// Any number of rigid bodies: the fields of Body, one array each.
struct Bodies {
    std::vector<double> mass;       ///< [kg]
    Vector3Array inertia;           ///< principal moments [kg m^2]
    Vector3Array position;          ///< [m], world frame
    Vector3Array momentum;          ///< [kg m/s], world frame
    QuaternionArray orientation;    ///< from body axes to world axes
    Vector3Array angular_momentum;  ///< about each centre [kg m^2/s], world axes

    explicit Bodies(std::size_t n = 0)
        : mass(n, 1), inertia(n), position(n), momentum(n), orientation(n), angular_momentum(n) {
        for (std::size_t i = 0; i < n; ++i) inertia.set(i, Vector3::Ones());
    }
    std::size_t size() const { return mass.size(); }
    Body operator[](std::size_t i) const {
        return {mass[i],     inertia[i],     position[i],
                momentum[i], orientation[i], angular_momentum[i]};
    }
    void set(std::size_t i, const Body& body) {
        mass[i] = body.mass, inertia.set(i, body.inertia), position.set(i, body.position);
        momentum.set(i, body.momentum), orientation.set(i, body.orientation);
        angular_momentum.set(i, body.angular_momentum);
    }
    wide::BodyArrays arrays() {
        return {mass.data(),     inertia.axes(),       position.axes(),
                momentum.axes(), orientation.arrays(), angular_momentum.axes()};
    }
};
// [/bodies]

// [bodies_verbs]
/// The push on all bodies: forces [N] and torques [N m], world axes, each about its own centre.
/// The arrays belong to whoever summed them.
struct WrenchArrays {
    wide::ConstAxes force, torque;
};

/// Drift: every body moves and turns freely for dt seconds, by the Magnus step.
inline void drift(Bodies& all, double dt) {
    wide::drift(all.size(), all.arrays(), dt);
}

/// Kick: every body's own force and torque.
inline void kick(Bodies& all, const WrenchArrays& push, double dt) {
    wide::push(all.size(), all.momentum.axes(), push.force, dt);
    wide::push(all.size(), all.angular_momentum.axes(), push.torque, dt);
}
// [/bodies_verbs]

/// Gives the bodies back if they can be simulated. @throws std::invalid_argument that names the
/// first one that cannot, or if the arrays differ in length
inline Bodies checked(Bodies all) {
    const std::size_t n = all.size();
    for (const auto* array : {&all.inertia, &all.position, &all.momentum, &all.angular_momentum})
        require(array->x.size() == n && array->y.size() == n && array->z.size() == n,
                "bodies: " + std::to_string(n) + " masses, but another number of something else");
    const QuaternionArray& q = all.orientation;
    require(q.x.size() == n && q.y.size() == n && q.z.size() == n && q.w.size() == n,
            "bodies: " + std::to_string(n) + " masses, but another number of orientations");
    for (std::size_t i = 0; i < n; ++i) {
        try {
            checked(all[i]);
        } catch (const std::invalid_argument& problem) {
            throw std::invalid_argument("body " + std::to_string(i) + ": " + problem.what());
        }
    }
    return all;
}

// [free_boxes]
/// Scene S16: boxes of 3 kg far apart, spinning and wobbling, no two of them alike.
inline Bodies free_boxes(std::size_t n) {
    Bodies all(n);
    const Vector3 size = 0.6 * Vector3(std::sqrt(1.75), std::sqrt(1.75), 0.5);
    for (std::size_t i = 0; i < n; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(n);
        Body box{3, box_inertia(3, size), {10 * static_cast<double>(i), 0, 0}, {1, part, 0}};
        box.orientation = exponential(Vector3(part, 2 * part, -part));
        all.set(i, spinning(box, Vector3(0.1, 4 + part, 0.1)));
    }
    return all;
}
// [/free_boxes]

}  // namespace nutshell
