// Chapter 6 · Levers: a bar on a pivot, and things on it that weigh.
#pragma once
#include <nutshell/pendulum_scenes.hpp>
#include <vector>

namespace nutshell {

// [lever]
/// Something that lies on a lever, as a point.
struct Load {
    double mass;   ///< [kg]
    double place;  ///< along the bar from the pivot [m], negative on the left
};

/// A straight uniform bar on a pivot at the origin, with loads on it; let go at rest and level,
/// until one end touches the ground. It turns about the world's z; the body's x is the bar.
/// exact: a lever out of balance is a pendulum let go at 90 degrees, its heavy side hanging.
struct Lever {
    std::string name;
    double bar, left, right;  ///< mass of the bar [kg]; its two ends, left negative [m]
    std::vector<Load> loads;
    double height;                              ///< of the pivot over the ground [m]
    Pinned start = checked(Pinned{moments()});  ///< at rest
    Need need = {0.01 / reach(), "rad", "1 cm at the longer end"};
    double duration = time_of_touch();  ///< [s]; 1 s if it is in balance

    double reach() const { return std::max(right, -left); }
    /// Mass times place, summed [kg m]: the level lever's torque is -g times this. Source: (46).
    double imbalance() const {
        double sum = bar * (left + right) / 2;
        for (const Load& load : loads) sum += load.mass * load.place;
        return sum;
    }
    /// About the pivot: the bar, a thin cylinder moved by the parallel-axis theorem, and points.
    Vector3 moments() const {
        const double length = right - left, middle = (left + right) / 2;
        const Vector3 own = cylinder_inertia(bar, 0.05, length);
        Vector3 sum =
            Vector3(own.z(), own.x(), own.y()) + parallel_axis(bar, {middle, 0, 0}).diagonal();
        for (const Load& load : loads)
            sum += point_inertia(load.mass, {load.place, 0, 0}).diagonal();
        return sum;
    }

    /// Every weight at the end of its own lever arm; the bar's at its middle.
    Wrench operator()(const Pinned& body, double) const {
        const auto weight = [&](double mass, double place) {
            return force_at(mass * gravity, rotate(body.orientation, {place, 0, 0}));
        };
        Wrench sum = weight(bar, (left + right) / 2);
        for (const Load& load : loads) sum = sum + weight(load.mass, load.place);
        return sum;
    }
    /// Angle of the bar [rad] from level, counter-clockwise: positive with the right end up.
    double tilt(const Pinned& body) const {
        const Vector3 along = rotate(body.orientation, {1, 0, 0});
        return std::atan2(along.y(), along.x());
    }
    /// The tilt at which an end touches the ground [rad], on the side to which it falls.
    double tilt_of_touch() const {
        return imbalance() > 0 ? -std::asin(height / right) : std::asin(height / -left);
    }
    /// Of small swings of its heavy side [rad/s].
    double omega() const {
        return std::sqrt(-gravity.y() * std::abs(imbalance()) / start.inertia.z());
    }

    Swing motion(double t) const {  ///< tilt, and its rate
        if (imbalance() == 0) return {0, 0};
        const Swing heavy = swing(omega(), pi / 2, t);  // from hanging, coming down
        const double side = imbalance() > 0 ? 1 : -1;
        return {side * (heavy.angle - pi / 2), side * heavy.rate};
    }
    Pinned exact(double t) const {
        const Swing now = motion(t);
        Pinned body = start;
        body.orientation = exponential({0, 0, now.angle});
        body.angular_momentum = {0, 0, start.inertia.z() * now.rate};
        return body;
    }
    double error(const Pinned& body, double t) const {
        return angle_between(body.orientation, exact(t).orientation);
    }
    /// Energy of rotation and height [J]; zero level and at rest.
    double energy(const Pinned& body) const {
        return rotational_energy(body) - gravity.y() * imbalance() * std::sin(tilt(body));
    }

  private:
    double time_of_touch() const {
        if (imbalance() == 0) return 1;
        double low = 0, high = pendulum_period(-gravity.y() / (omega() * omega()), pi / 2) / 4;
        for (int halving = 0; halving < 60; ++halving) {
            const double middle = (low + high) / 2;
            (std::abs(motion(middle).angle) < std::abs(tilt_of_touch()) ? low : high) = middle;
        }
        return low;
    }
};
// [/lever]

// [levers]
/// A child of 25 kg near one end of a plank, a grown-up of 75 kg near the middle.
inline Lever seesaw() {
    return {"seesaw", 20, -2, 2, {{25, -1.8}, {75, 0.5}}, 0.5};
}
/// The same, with the grown-up where the torques cancel.
inline Lever balanced_seesaw() {
    return {"balanced_seesaw", 20, -2, 2, {{25, -1.8}, {75, 0.6}}, 0.5};
}
/// A stone of 200 kg on the short arm of an iron bar, a hand that weighs down 40 kg on the long.
inline Lever crowbar() {
    return {"crowbar", 10, -0.25, 1.75, {{200, -0.25}, {40, 1.75}}, 0.2};
}
/// Two seesaws that are out of balance by the same 10 kg m: light riders at the ends, ...
inline Lever light_and_far() {
    return {"light_and_far", 20, -2, 2, {{20, -2}, {25, 2}}, 0.5};
}
/// ... and heavy ones near the pivot.
inline Lever heavy_and_near() {
    return {"heavy_and_near", 20, -2, 2, {{80, -0.5}, {100, 0.5}}, 0.5};
}
// [/levers]

}  // namespace nutshell
