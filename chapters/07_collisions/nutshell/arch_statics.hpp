// Chapter 7 · What statics says of an arch, without simulating it: stones do not break, joints do
// not pull, and do not slide. Then it stands if its forces find a way through all joints.
#pragma once
#include <nutshell/arch_scenes.hpp>
#include <optional>

namespace nutshell {

// [joints]
/// A joint of the right half of an arch, and the weight between it and the middle of the arch.
struct Joint {
    double angle;   ///< from the vertical [rad]
    double weight;  ///< [N]
    double moment;  ///< of it about the middle: weight times its mean x [N m]
};

/// All of them, from the crown down to the foot.
inline std::vector<Joint> joints_of(const Arch& arch) {
    // A wedge is an outer triangle without an inner one, both with the tip in the origin: of sides
    // R and half angle a, R^2 sin a cos a large, the centre 2/3 R cos a from the tip.
    const double r = arch.inside(), R = arch.outside(), a = arch.wedge() / 2;
    const double half = arch.density * arch.depth * earth_gravity * std::sin(a) * std::cos(a) / 2;
    const double weight = 2 * half * (R * R - r * r);
    const double moment = 2 * half * (R * R * R - r * r * r) * 2 / 3 * std::cos(a);
    std::vector<Joint> joints;
    if (arch.stones % 2 == 1)  // the first joint is the keystone's: half of it is to the left
        joints.push_back({a, weight / 2, half * (R * R * R - r * r * r) * std::sin(a) / 3});
    else
        joints.push_back({0, 0, 0});
    for (int i = 0; i < arch.stones / 2; ++i) {
        const Joint& last = joints.back();
        joints.push_back({last.angle + 2 * a, last.weight + weight,
                          last.moment + moment * std::sin(last.angle + a)});
    }
    return joints;
}
// [/joints]

// [window]
struct Range {
    double low = 0, high = immovable;
};

/// The moments H y [N m] of a thrust H [N] at the crown, at the height y, with which it
/// passes all joints between their inner and their outer end; low > high if there are none.
/// Eq. (7B.a).
inline Range window(const Arch& arch, const std::vector<Joint>& joints, double thrust) {
    Range moments;
    for (const Joint& joint : joints) {
        const double across =
            joint.weight * std::sin(joint.angle) + thrust * std::cos(joint.angle);
        moments.low = std::max(moments.low, across * arch.inside() - joint.moment);
        moments.high = std::min(moments.high, across * arch.outside() - joint.moment);
    }
    return moments;
}

/// Where the line of thrust crosses a joint: the distance from the centre of the arch [m].
inline double crossing(const Joint& joint, double thrust, double moment) {
    return (moment + joint.moment) /
           (joint.weight * std::sin(joint.angle) + thrust * std::cos(joint.angle));
}
// [/window]

// [thrusts]
/// The least and the largest thrust [N] whose line fits into the arch; nothing if none does, and
/// the arch cannot stand. The width of the window is a concave function of the thrust.
inline std::optional<Range> thrusts(const Arch& arch) {
    const std::vector<Joint> joints = joints_of(arch);
    const auto width = [&](double thrust) {
        const Range moments = window(arch, joints, thrust);
        return moments.high - moments.low;
    };
    const double much = 4 * joints.back().weight;
    double low = 0, high = much;
    for (int i = 0; i < 100; ++i) {  // the widest is within the middle two thirds of the better
        const double one = (2 * low + high) / 3, two = (low + 2 * high) / 3;
        (width(one) < width(two) ? low : high) = width(one) < width(two) ? one : two;
    }
    const double best = (low + high) / 2;
    if (width(best) < 0) return {};
    const auto last = [&](double fits, double does_not) {
        for (int i = 0; i < 60; ++i) {
            const double middle = (fits + does_not) / 2;
            (width(middle) >= 0 ? fits : does_not) = middle;
        }
        return fits;
    };
    return Range{last(best, 0), last(best, much)};
}

/// The least thickness [m] with which the arch can stand.
inline double least_thickness(Arch arch) {
    double falls = 0, stands = arch.radius;
    for (int i = 0; i < 50; ++i) {
        arch.thickness = (falls + stands) / 2;
        (thrusts(arch) ? stands : falls) = arch.thickness;
    }
    return stands;
}
// [/thrusts]

// [least_friction]
/// The least coefficient of friction with which no joint need slide: then some thrust whose line
/// fits has |H sin - W cos| <= mu (H cos + W sin) at all joints.
/// @return infinity if no line fits
inline double least_friction(const Arch& arch) {
    const std::optional<Range> fits = thrusts(arch);
    if (!fits) return immovable;
    double slides = 0, holds = 10;
    for (int i = 0; i < 60; ++i) {
        const double mu = (slides + holds) / 2;
        Range range = *fits;
        for (const Joint& joint : joints_of(arch)) {
            const double s = std::sin(joint.angle), c = std::cos(joint.angle), W = joint.weight;
            range.low = std::max(range.low, W * (c - mu * s) / (s + mu * c));
            if (s > mu * c) range.high = std::min(range.high, W * (c + mu * s) / (s - mu * c));
        }
        (range.low <= range.high ? holds : slides) = mu;
    }
    return holds;
}
// [/least_friction]

}  // namespace nutshell
