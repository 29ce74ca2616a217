// Chapter 6 · The free top, exact: any rigid body that no torque turns, at any time.
//
// L stands still in the world and wanders in the body, along the curve where the sphere |M| = |L|
// cuts the energy's ellipsoid. Three axes of the body, by their role instead of their number:
//   3  the axis round which L wanders: that of the largest moment, or of the smallest
//   2  the axis of the middle moment      1  the third
// In body axes M1 = A1 cn(u), M2 = +-A2 sn(u), M3 = +-A3 dn(u) with u = u0 + rate t (Jacobi's
// functions); the body's pose is where its axes are seen from L, and an angle about L.
#pragma once
#include <nutshell/elliptic.hpp>
#include <nutshell/free_rotation.hpp>

namespace nutshell {

// [free_top]
/// The exact free rotation of a body. Accurate to about 1e-15 times the angle turned, more near
/// the middle axis (where every error grows as the motion itself does).
/// Source: C. G. J. Jacobi, J. reine angew. Math. 39 (1850) 293; third integral after Carlson.
class FreeTop {
  public:
    /// @param inertia  principal moments [kg m^2]  @param start  the pose at t = 0
    /// @param L  angular momentum [kg m^2/s], world axes
    FreeTop(const Vector3& inertia, const Quaternion& start, const Vector3& L)
        : inertia_(inertia), start_(start), L_(L), length_(L.norm()) {
        const Vector3 I = inertia;
        const Vector3 M = rotate(inverse(start), L);
        // two equal moments, or a spin about one principal axis: free_rotation is exact
        simple_ = I[0] == I[1] || I[1] == I[2] || I[2] == I[0] || (M.array() != 0).count() <= 1;
        if (simple_) return;
        find_axes(M);
        const double I1 = I[one_], I2 = I[two_], I3 = I[three_], d1 = I3 - I1, d2 = I3 - I2,
                     d3 = I2 - I1;
        const double m1 = M[one_] * M[one_] / I1, m2 = M[two_] * M[two_] / I2,
                     m3 = M[three_] * M[three_] / I3;
        // every sum but one is of terms of one sign; that one vanishes on the separatrix
        a1_ = std::sqrt(I1 * (m1 + m2 * d2 / d1));
        a2_ = std::sqrt(I2 * (m2 + m1 * d1 / d2));
        a3_ = std::sqrt(I3 * (m3 + m2 * d3 / d1));
        const double fast = m3 + m2 * d3 / d1, slow = m3 - m1 * d3 / d2;
        rate_ = std::sqrt(d1 * d2 / (I1 * I2 * I3) * fast);
        complementary_ = std::sqrt(std::clamp(slow / fast, 1e-32, 1.0));
        quarter_ = complete_elliptic_k(complementary_);
        if (M[three_] < 0) a3_ = -a3_;
        const bool even = (two_ - one_ + 3) % 3 == 1;
        if (even != ((a3_ > 0) == (d2 > 0))) a2_ = -a2_;
        u0_ = a1_ > 0 ? elliptic_f(M[one_] / a1_, M[two_] / a2_, complementary_) : 0;
        about_L_ = length_ * (1 / I2 - 1 / I3) * a2_ * a2_ / (a3_ * a3_ * rate_);
        n_ = a1_ * a1_ / (a3_ * a3_);
        third0_ = elliptic_third(u0_, n_, complementary_);
        frame_ = product(start, frame_of(M));
    }

    /// Orientation at time t [s].
    Quaternion pose(double t) const {
        if (simple_) {
            Quaternion q = start_;
            if (length_ > 0) free_rotation(inertia_, q, L_, t);
            return q;
        }
        const double angle =
            length_ * t / inertia_[three_] +
            about_L_ * (elliptic_third(u0_ + rate_ * t, n_, complementary_) - third0_);
        const Quaternion about_L = exponential(std::remainder(angle, 4 * pi) / length_ * L_);
        return product(about_L, product(frame_, inverse(frame_of(in_body(t))))).normalized();
    }

    /// Angular momentum in body axes at time t [kg m^2/s].
    Vector3 in_body(double t) const {
        if (simple_) return rotate(inverse(pose(t)), L_);
        const Jacobi f = jacobi(u0_ + rate_ * t, complementary_);
        Vector3 M;
        M[one_] = a1_ * f.cn, M[two_] = a2_ * f.sn, M[three_] = a3_ * f.dn;
        return M;
    }

    /// Time between two flips [s]: from one passing of M2 = 0 to the next. Infinite without any.
    double between_flips() const {
        return simple_ ? std::numeric_limits<double>::infinity() : 2 * quarter_ / rate_;
    }

    /// The first time after the start when the part of L along the middle axis is zero [s].
    double first_flip() const {
        if (simple_) return std::numeric_limits<double>::infinity();
        return (2 * quarter_ * (std::floor(u0_ / (2 * quarter_)) + 1) - u0_) / rate_;
    }

  private:
    Vector3 inertia_;
    Quaternion start_;
    Vector3 L_;
    double length_;  // of L
    bool simple_;
    int one_ = 0, two_ = 1, three_ = 2;          // which axis has which role
    double a1_ = 0, a2_ = 0, a3_ = 0;            // amplitudes, two of them with a sign
    double rate_ = 0, u0_ = 0;                   // of Jacobi's argument
    double complementary_ = 1, quarter_ = 0;     // modulus k', and K
    double about_L_ = 0, n_ = 0, third0_ = 0;    // of the angle about L
    Quaternion frame_ = Quaternion::Identity();  // frame_of(M) at the start, in the world

    /// L wanders round the axis on whose side of the separatrix it is.
    void find_axes(const Vector3& M) {
        const auto& I = inertia_;
        int low = 0, high = 0;
        for (int i = 1; i < 3; ++i) {
            if (I[i] < I[low]) low = i;
            if (I[i] > I[high]) high = i;
        }
        two_ = 3 - low - high;
        const double to_high = M[high] * M[high] / I[high] * (I[high] - I[two_]);
        const double to_low = M[low] * M[low] / I[low] * (I[two_] - I[low]);
        three_ = to_high > to_low ? high : low;
        one_ = three_ == high ? low : high;
    }

    /// Axes made of L and body axis 1, which never point the same way, as seen from the body.
    Quaternion frame_of(const Vector3& M) const {
        Matrix3 frame;
        frame.col(0) = M.normalized();
        frame.col(1) = (Vector3::Unit(one_) - frame(one_, 0) * frame.col(0)).normalized();
        frame.col(2) = frame.col(0).cross(frame.col(1));
        return Quaternion(frame);
    }
};
// [/free_top]

// [exact_rotation]
/// The free rotation of any body, exact at any step. Costs ten times the split one.
inline void exact_rotation(const Vector3& inertia, Quaternion& q, const Vector3& L, double dt) {
    q = FreeTop(inertia, q, L).pose(dt);
}
// [/exact_rotation]

}  // namespace nutshell
