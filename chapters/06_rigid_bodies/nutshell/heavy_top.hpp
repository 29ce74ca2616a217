// Chapter 6 · The heavy top, exact: a symmetric body on a pivot, under its own weight.
#pragma once
#include <algorithm>
#include <nutshell/body.hpp>
#include <nutshell/elliptic.hpp>

namespace nutshell {

// [top]
/// What a symmetric top is: its axis is the body's z, its centre lies on it.
struct Top {
    double across = 1, along = 1;  ///< I1, I3 [kg m^2], both about the pivot
    double weight = 1;             ///< m g l [N m], l from the pivot to the centre
};

/// The torque [N m], world axes, of a pinned top's weight; up is the world's y. Source: eq. (42).
/// @param axis  of the top, from the pivot to the centre, length one, world axes
inline Vector3 weight_torque(const Top& top, const Vector3& axis) {
    return top.weight * Vector3(axis.z(), 0, -axis.x());  // l axis x (0, -m g, 0)
}
// [/top]

// [steady_precession]
/// The two rates [rad/s] at which a top can go round steadily at `angle` [rad] from upright, slow
/// first: Omega = (L3 -+ sqrt(L3^2 - 4 I1 m g l cos(angle))) / (2 I1 cos(angle)).
/// @param L3  angular momentum along its axis [kg m^2/s]
/// @throws std::invalid_argument if it spins too slowly to go round steadily, or is horizontal
inline std::array<double, 2> steady_precession(const Top& top, double L3, double angle) {
    const double c = std::cos(angle);
    const double root = L3 * L3 - 4 * top.across * top.weight * c;
    require(root >= 0,
            "steady_precession: L3^2 < 4 I1 m g l cos(angle): it falls, spin it faster");
    require(std::abs(c) > 1e-12,
            "steady_precession: horizontal, there is one rate only: m g l/L3");
    // exercise 6.12
    const double far = L3 + std::copysign(std::sqrt(root), L3);  // nothing cancels
    return {2 * top.weight / far, far / (2 * top.across * c)};
    // end 6.12
}

/// The spin [kg m^2/s] above which a top stands upright: L3^2 = 4 I1 m g l.
inline double sleeping_limit(const Top& top) {
    return 2 * std::sqrt(top.across * top.weight);
}
// [/steady_precession]

// [heavy_top]
/// The exact motion of a heavy top: c = cos(angle from upright) swings between two roots of a
/// cubic, c = c1 + (c2 - c1) sn^2(u0 + rate t); the axis goes round the vertical, and the body
/// round its axis, by integrals of 1/(1 - c) and 1/(1 + c).
/// Accurate to about 1e-14 times 1 + the angle turned. Source: J.-L. Lagrange, 1788.
class HeavyTop {
  public:
    /// @param start  with inertia (I1, I1, I3)
    /// @throws std::invalid_argument if it is not symmetric, has no weight, or stands upright or
    /// hangs to a millionth (then it sleeps or does not, which no formula with an angle says)
    HeavyTop(const Top& top, const Pinned& start) : top_(top), start_(checked(start)) {
        const double I1 = top.across;
        require(start.inertia == Vector3(I1, I1, top.along), "HeavyTop: the body is another one");
        require_positive(top.weight, "HeavyTop: m g l [N m]");
        const Vector3 axis = rotate(start.orientation, {0, 0, 1});
        const Vector3& L = start.angular_momentum;
        require(std::hypot(axis.x(), axis.z()) > 1e-6,
                "HeavyTop: the top stands upright or hangs");
        up_ = L.y(), own_ = L.dot(axis);
        const double c = axis.y(), s2 = axis.x() * axis.x() + axis.z() * axis.z();
        // c' = (omega x axis).y, and omega differs from L/I1 only along the axis
        const double c_rate = (L.z() * axis.x() - L.x() * axis.z()) / I1;
        const double round = (up_ - own_ * c) / I1, w = (c_rate * c_rate + round * round) / s2;
        const double pull = 2 * top.weight / I1;
        // c'^2 as a cubic in x = c - its value at the start
        const std::array<double, 3> x =
            roots({c_rate * c_rate, -2 * c * w - s2 * pull + 2 * own_ / I1 * round,
                   -w + 2 * pull * c - own_ * own_ / (I1 * I1), pull});
        low_ = c + x[0], swing_ = x[1] - x[0];
        rate_ = std::sqrt(pull / 4 * (x[2] - x[0]));
        complementary_ = std::sqrt(std::clamp((x[2] - x[1]) / (x[2] - x[0]), 1e-32, 1.0));
        if (swing_ > 0) {
            const double sn = std::sqrt(std::max(0.0, -x[0] / swing_)),
                         cn = std::sqrt(std::max(0.0, x[1] / swing_));
            u0_ = elliptic_f(cn, c_rate < 0 ? -sn : sn, complementary_);
        }
        azimuth_ = std::atan2(-axis.z(), axis.x());
        const Quaternion own = product(inverse(pose_at(c, azimuth_, 0)), start.orientation);
        spin_ = 2 * std::atan2(own.z(), own.w());
    }

    /// Orientation at time t [s].
    Quaternion pose(double t) const {
        const double u = u0_ + rate_ * t, s = jacobi(u, complementary_).sn;
        const double c = low_ + swing_ * s * s;
        // integrals of (up -+ own)/(2 I1 (1 -+ c)) over the time
        const double above = (up_ - own_) * share(u, 1 - low_, -swing_),
                     below = (up_ + own_) * share(u, 1 + low_, swing_);
        const double azimuth = azimuth_ + above + below;
        const double spin = spin_ + own_ * t * (1 / top_.along - 1 / top_.across) - above + below;
        return pose_at(c, azimuth, spin);
    }

    /// Largest and smallest angle from upright [rad].
    std::array<double, 2> swing() const { return {std::acos(low_), std::acos(low_ + swing_)}; }

  private:
    Top top_;
    Pinned start_;
    double up_ = 0, own_ = 0;                       // L about the vertical and about the axis
    double low_ = 0, swing_ = 0;                    // c1 and c2 - c1
    double rate_ = 0, complementary_ = 1, u0_ = 0;  // of Jacobi's argument
    double azimuth_ = 0, spin_ = 0;                 // at the start

    /// The integral of dt/(2 I1 (a + b sn^2 u)) from the start to u.
    double share(double u, double a, double b) const {
        const double n = b / a;
        const auto part = [&](double v) { return v - n * elliptic_third(v, n, complementary_); };
        return (part(u) - part(u0_)) / (2 * top_.across * a * rate_);
    }

    /// Tilted by the angle of cosine c towards x, turned by `azimuth` about the vertical, after a
    /// turn by `spin` about its own axis.
    static Quaternion pose_at(double c, double azimuth, double spin) {
        const double angle = std::acos(std::clamp(c, -1.0, 1.0));
        const Quaternion upright = exponential({-pi / 2, 0, 0}),
                         tilt = exponential({0, 0, -angle});
        return product(exponential({0, azimuth, 0}),
                       product(tilt, product(upright, exponential({0, 0, spin}))));
    }

    /// The roots of p[0] + p[1] x + p[2] x^2 + p[3] x^3, smallest first: all real, p[3] > 0, and
    /// p[0] >= 0 is the square of a speed at x = 0, between the first two roots.
    static std::array<double, 3> roots(const std::array<double, 4>& p) {
        if (p[0] == 0) {  // starts at a turning point: x = 0 and a quadratic
            const double half = p[2] / 2,
                         root = std::sqrt(std::max(0.0, half * half - p[1] * p[3]));
            const double far = -half - std::copysign(root, half);  // p[3] times one root
            std::array<double, 3> x{0, far / p[3], p[1] / far};
            std::sort(x.begin(), x.end());
            return x;
        }
        const double b = p[2] / (3 * p[3]), q = b * b - p[1] / (3 * p[3]);
        const double r = b * b * b - b * p[1] / (2 * p[3]) + p[0] / (2 * p[3]);
        const double angle = std::acos(std::clamp(r / (q * std::sqrt(q)), -1.0, 1.0)) / 3;
        std::array<double, 3> x;
        for (std::size_t i = 0; i < 3; ++i) {
            x[i] = -2 * std::sqrt(q) * std::cos(angle + 2 * pi / 3 * static_cast<double>(i)) - b;
            for (int turn = 0; turn < 3; ++turn) {  // Newton, for the last digits
                const double value = p[0] + x[i] * (p[1] + x[i] * (p[2] + x[i] * p[3]));
                const double slope = p[1] + x[i] * (2 * p[2] + x[i] * 3 * p[3]);
                if (slope != 0) x[i] -= value / slope;
            }
        }
        std::sort(x.begin(), x.end());
        return x;
    }
};
// [/heavy_top]

}  // namespace nutshell
