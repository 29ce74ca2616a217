// The scenes of chapter 4: where orientations go, and what is asked of them. Nothing moves by
// force here, so a scene has no steps: it has poses and what it needs.
#pragma once
#include <nutshell/euler_angles.hpp>
#include <nutshell/need.hpp>

namespace nutshell {

// [order]
/// Two quarter turns about the world's axes, one after the other, and in the other order.
struct TwoQuarterTurns {
    Quaternion one = quaternion_about(Vector3::UnitX(), pi / 2),
               other = quaternion_about(Vector3::UnitZ(), pi / 2);

    Quaternion one_first() const { return product(other, one); }
    Quaternion other_first() const { return product(one, other); }
    /// How far apart the two ends are [rad].
    double apart() const { return angle_between(one_first(), other_first()); }
};
// [/order]

// [full_turn]
/// One full turn, made of many small ones.
struct FullTurn {
    Vector3 axis{1, 2, 3};
    Need need{1.0 / 300, "rad", "one pixel at the end of an arm of 300 pixels"};

    /// How far from home `steps` small turns to first order end [rad], each made as long as one.
    double error(long steps) const {
        const Vector3 beta = 2 * pi / static_cast<double>(steps) * direction_of(axis);
        Quaternion q = four_vector({0, 0, 0}, 1);
        for (long n = 0; n < steps; ++n) q = small_turn(q, beta);
        return angle_between(q, four_vector({0, 0, 0}, 1));
    }
    /// How long the 4-vector is afterwards if nobody divides.
    double length(long steps) const {
        const Vector3 beta = 2 * pi / static_cast<double>(steps) * direction_of(axis);
        Quaternion q = four_vector({0, 0, 0}, 1);
        for (long n = 0; n < steps; ++n)
            q = Quaternion(q.coeffs() + vector_product(beta, q).coeffs() / 2);
        return q.norm();
    }
};
// [/full_turn]

// [poses]
/// Two poses, and the ways between them.
struct TwoPoses {
    Quaternion from = orientation_of(EulerAngles{-1.2, -1, 0}),
               to = orientation_of(EulerAngles{0.9, -0.9, 2.2});
    Need need{1.0 / 300, "rad", "one pixel at the end of an arm of 300 pixels"};

    /// Two poses `angle` [rad] apart.
    static TwoPoses apart(double angle) {
        TwoPoses poses;
        poses.to = product(quaternion_about({0.3, -1, 0.2}, angle), poses.from);
        return poses;
    }
    /// The three angles taken from one to the other each by itself: what one does without
    /// 4-vectors.
    Quaternion by_angles(double part) const {
        const EulerAngles a = euler_angles(from), b = euler_angles(to);
        return orientation_of({(1 - part) * a.yaw + part * b.yaw,
                               (1 - part) * a.pitch + part * b.pitch,
                               (1 - part) * a.roll + part * b.roll});
    }
    /// The farthest that nlerp is from slerp on the way [rad].
    double largest_lead(int pieces = 200) const {
        double most = 0;
        for (int i = 0; i <= pieces; ++i) {
            const double part = static_cast<double>(i) / pieces;
            most = std::max(most, angle_between(slerp(from, to, part), nlerp(from, to, part)));
        }
        return most;
    }
};

/// How much faster nlerp is in the middle than at the ends, between poses `angle` [rad] apart.
inline double nlerp_speed_ratio(double angle) {
    const double c = std::cos(angle / 4);
    return 1 / (c * c);
}
// [/poses]

// [overhead]
/// A camera on a tripod follows a bird that flies over it along x: yaw and pitch, no roll.
struct Overhead {
    double speed = 10;   // [m/s], of the bird
    double height = 20;  // [m], above the camera
    double aside = 2;    // [m]: how far beside the zenith it passes
    Need need{pi, "rad/s", "what the motor of the tripod can do: half a turn a second"};

    Vector3 bird(double t) const { return {speed * t, height, aside}; }
    /// The camera looks along its body's z.
    EulerAngles angles(double t) const {
        const Vector3 p = bird(t);
        return {std::atan2(p.x(), p.z()), -std::atan2(p.y(), std::hypot(p.x(), p.z())), 0};
    }
    Quaternion pose(double t) const { return orientation_of(angles(t)); }
    /// How fast the line of sight turns when the bird is nearest [rad/s].
    double sight_rate() const { return speed / std::hypot(height, aside); }
    /// How fast the yaw must turn then [rad/s]: it does not know that the bird is high.
    double yaw_rate() const { return speed / aside; }
};
// [/overhead]

}  // namespace nutshell
