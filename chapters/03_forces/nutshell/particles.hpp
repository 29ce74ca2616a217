// Chapter 3 · Particles: the state of chapter 1 for any number of points at once, and the same
// two verbs for all.
#pragma once
#include <algorithm>
#include <nutshell/exponential.hpp>
#include <nutshell/wide.hpp>
#include <utility>
#include <vector>

namespace nutshell {

// [vector3_array]
/// Many vectors, one array per axis ("structure of arrays"): a loop over one axis reads memory in
/// order, and the processor works on two, four or eight neighbours at once.
struct Vector3Array {
    std::vector<double> x, y, z;

    explicit Vector3Array(std::size_t n = 0) : x(n), y(n), z(n) {}
    std::size_t size() const { return x.size(); }
    void resize(std::size_t n) { x.resize(n), y.resize(n), z.resize(n); }
    Vector3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
    void set(std::size_t i, const Vector3& v) { x[i] = v.x(), y[i] = v.y(), z[i] = v.z(); }
    wide::Axes axes() { return {x.data(), y.data(), z.data()}; }
    wide::ConstAxes axes() const { return {x.data(), y.data(), z.data()}; }
};
// [/vector3_array]

// [particles]
/// Any number of point masses. Like the PointMass of chapter 1 they keep their velocity: their
/// masses never change.
struct Particles {
    std::vector<double> mass;  ///< [kg], each greater than zero
    Vector3Array position;     ///< [m], world frame
    Vector3Array velocity;     ///< [m/s], world frame

    explicit Particles(std::size_t n = 0, double each = 1)
        : mass(n, each), position(n), velocity(n) {}
    std::size_t size() const { return mass.size(); }
    PointMass operator[](std::size_t i) const { return {mass[i], position[i], velocity[i]}; }
    void set(std::size_t i, const PointMass& body) {
        mass[i] = body.mass, position.set(i, body.position), velocity.set(i, body.velocity);
    }
};
// [/particles]

// [particle_verbs]
/// The push on all particles as a step sees it: forces [N], world frame, one array per axis. The
/// arrays belong to whoever had them summed.
using ForceArrays = wide::ConstAxes;

/// Drift: every particle moves with the velocity it has, for dt seconds. Eq. (8) for all.
inline void drift(Particles& all, double dt) {
    wide::drift(all.size(), all.position.axes(), all.velocity.axes(), dt);
}

/// Kick: every particle's own force changes its velocity for dt seconds. Eq. (9) for all.
inline void kick(Particles& all, const ForceArrays& forces, double dt) {
    wide::kick(all.size(), all.velocity.axes(), forces, all.mass.data(), dt);
}
inline void kick(Particles& all, const Vector3Array& forces, double dt) {
    kick(all, forces.axes(), dt);
}
// [/particle_verbs]

// [particle_drag_verbs]
/// Multiplies the velocity of every particle by factor(mass [kg]); neighbours of equal mass share
/// it.
template <class Factor>
void scale_velocities(Particles& all, const Factor& factor) {
    double mass = 0, by = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all.mass[i] != mass) mass = all.mass[i], by = factor(mass);
        all.velocity.x[i] *= by, all.velocity.y[i] *= by, all.velocity.z[i] *= by;
    }
}

/// Stop: every particle is where it was, at rest.
inline void stop(Particles& all) {
    for (auto* axis : {&all.velocity.x, &all.velocity.y, &all.velocity.z})
        std::fill(axis->begin(), axis->end(), 0.0);
}

/// Decay: linear drag alone, gamma = `drag` [kg/s], acts on every particle for dt seconds.
inline void decay(Particles& all, double drag, double dt) {
    scale_velocities(all, [=](double mass) { return std::exp(-drag * dt / mass); });
}

/// The same by implicit Euler.
inline void implicit_decay(Particles& all, double drag, double dt) {
    scale_velocities(all, [=](double mass) { return 1 / (1 + drag * dt / mass); });
}
// [/particle_drag_verbs]

// [array_room]
/// The room a run of many particles needs: for their forces, and for the particles at rest. It
/// belongs to the run's stepper, so a step of a million particles allocates nothing, and runs that
/// take turns do not meet.
struct ArrayRoom {
    Vector3Array forces;
    Particles still;
};

/// A scene of many particles as a plain function asks it: forces(state, t), summed in that room.
/// @tparam Forces  forces(all, t, into) writes the forces into arrays
template <class Forces>
struct InRoom {
    const Forces& of;
    ArrayRoom& room;
    double drag = of.drag;  ///< gamma [kg/s]

    ForceArrays operator()(const Particles& all, double t) const {
        of(all, t, room.forces);
        return std::as_const(room.forces).axes();
    }
};

template <class Scene>
requires requires(const Scene& scene, Vector3Array& into) {
    scene(scene.start, 0.0, into);
}
ArrayRoom room_for(const Scene&) {
    return ArrayRoom();
}
template <class Forces>
InRoom<Forces> asking(const Forces& forces, ArrayRoom& room) {
    return {forces, room};
}
template <class Forces>
ForceArrays force_at_rest(const Particles& all, const InRoom<Forces>& forces, double t) {
    forces.room.still = all;
    stop(forces.room.still);
    return forces(forces.room.still, t);
}
// [/array_room]

/// The exponential kick of every particle under the force it feels at the start of the step.
template <class Forces>
Particles exponential_kick(Particles all, const Forces& forces, double t, double dt) {
    const auto push = force_at_rest(all, forces, t);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const UnderForce on_i{{push.x[i], push.y[i], push.z[i]}, forces.drag};
        all.set(i, exponential_kick(all[i], on_i, t, dt));
    }
    return all;
}

/// Gives the particles back if they can be simulated. @throws std::invalid_argument that names
/// the first particle whose mass is not greater than zero or whose numbers are not finite, or if
/// the arrays differ in length
inline Particles checked(Particles all) {
    const std::size_t n = all.size();
    for (const auto* array : {&all.position, &all.velocity})
        require(
            array->x.size() == n && array->y.size() == n && array->z.size() == n,
            "particles: " + std::to_string(n) +
                " masses, but positions or velocities of another number: give each particle all");
    for (std::size_t i = 0; i < n; ++i) {
        try {
            checked(all[i]);
        } catch (const std::invalid_argument& problem) {
            throw std::invalid_argument("particle " + std::to_string(i) + ": " + problem.what());
        }
    }
    return all;
}

/// Kinetic energy [J] of all.
inline double kinetic_energy(const Particles& all) {
    double sum = 0;
    for (std::size_t i = 0; i < all.size(); ++i) sum += kinetic_energy(all[i]);
    return sum;
}

// [particles_flat]
/// The state as one list of numbers for the general-purpose methods: all positions, then all
/// velocities, three numbers each. Unlike the verbs it allocates.
inline Vector flat(const Particles& all) {
    const auto n = static_cast<Eigen::Index>(all.size());
    Vector y(6 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
        y.segment<3>(3 * i) = all.position[static_cast<std::size_t>(i)];
        y.segment<3>(3 * (n + i)) = all.velocity[static_cast<std::size_t>(i)];
    }
    return y;
}

/// The particles `like`, but where y says.
inline Particles unflat(const Vector& y, Particles like) {
    const auto n = static_cast<Eigen::Index>(like.size());
    for (Eigen::Index i = 0; i < n; ++i) {
        like.position.set(static_cast<std::size_t>(i), y.segment<3>(3 * i));
        like.velocity.set(static_cast<std::size_t>(i), y.segment<3>(3 * (n + i)));
    }
    return like;
}

/// How the flat state changes per second: positions by the velocities, velocities by force over
/// mass.
inline Vector rate(const Particles& all, const Vector3Array& forces) {
    const auto n = static_cast<Eigen::Index>(all.size());
    Vector y(6 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        y.segment<3>(3 * i) = all.velocity[k];
        y.segment<3>(3 * (n + i)) = forces[k] / all.mass[k];
    }
    return y;
}
// [/particles_flat]

}  // namespace nutshell
