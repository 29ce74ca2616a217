// Elliptic integrals and Jacobi's elliptic functions: the exact motion of pendulums and tops.
//
// Every function takes the complementary modulus k' = sqrt(1 - k^2) instead of k: where the motion nearly
// stands still (a pendulum near the top, a body near its middle axis) k is 1 to many digits, and k' holds the
// rest.
#pragma once
#include <array>
#include <limits>
#include <nutshell/require.hpp>
#include <nutshell/vector.hpp>

namespace nutshell {

/// The arithmetic-geometric mean of two positive numbers: replace both by their two means until they meet.
/// Each turn doubles the digits. Accurate to a few units in the last place. Source: C. F. Gauss, 1799.
/// @throws std::invalid_argument if one is not finite and greater than zero
inline double arithmetic_geometric_mean(double a, double b) {
    require_positive(a, "arithmetic_geometric_mean: the first number");
    require_positive(b, "arithmetic_geometric_mean: the second number");
    for (int turn = 0; turn < 60 && std::abs(a - b) > 1e-8 * a; ++turn) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b), a = mean;
    }
    return (a + b) / 2;  // the next mean; the one after differs by less than a unit in the last place
}

/// The complete elliptic integral K = integral from 0 to pi/2 of dphi/sqrt(1 - k^2 sin^2 phi), by Gauss'
/// mean.
/// @param complementary  k', 0 < k' <= 1: K grows as ln(4/k') when k' shrinks
inline double complete_elliptic_k(double complementary) {
    return pi / (2 * arithmetic_geometric_mean(1, complementary));
}

namespace elliptic {  // Source of the three: B. C. Carlson, Numer. Algorithms 10 (1995) 13.

/// Carlson's R_F(x, y, z) = 1/2 integral of dt/sqrt((t+x)(t+y)(t+z)), t from 0. None negative, at most one
/// zero.
inline double rf(double x, double y, double z) {
    for (int turn = 0; turn < 60; ++turn) {
        const double root =
            std::sqrt(x) * std::sqrt(y) + std::sqrt(y) * std::sqrt(z) + std::sqrt(z) * std::sqrt(x);
        x = (x + root) / 4, y = (y + root) / 4, z = (z + root) / 4;
        const double mean = (x + y + z) / 3, X = 1 - x / mean, Y = 1 - y / mean, Z = -X - Y;
        if (std::max({std::abs(X), std::abs(Y), std::abs(Z)}) > 1e-3) continue;
        const double e2 = X * Y - Z * Z, e3 = X * Y * Z;  // the rest is of sixth order: below 1e-18
        return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / std::sqrt(mean);
    }
    return std::numeric_limits<double>::quiet_NaN();
}

/// Carlson's R_C(x, y) = R_F(x, y, y), y > 0.
inline double rc(double x, double y) {
    return rf(x, y, y);
}

/// Carlson's R_J(x, y, z, p) = 3/2 integral of dt/((t+p) sqrt((t+x)(t+y)(t+z))), p > 0.
inline double rj(double x, double y, double z, double p) {
    const double delta = (p - x) * (p - y) * (p - z);
    double sum = 0, power = 1;  // power = 4^-turn
    for (int turn = 0; turn < 60; ++turn) {
        const double a = std::sqrt(x), b = std::sqrt(y), c = std::sqrt(z), q = std::sqrt(p);
        const double root = a * b + b * c + c * a, d = (q + a) * (q + b) * (q + c);
        sum += power / d * rc(1, 1 + power * power * power * delta / (d * d));
        power /= 4;
        x = (x + root) / 4, y = (y + root) / 4, z = (z + root) / 4, p = (p + root) / 4;
        const double mean = (x + y + z + 2 * p) / 5;
        const double X = 1 - x / mean, Y = 1 - y / mean, Z = 1 - z / mean, P = -(X + Y + Z) / 2;
        if (std::max({std::abs(X), std::abs(Y), std::abs(Z), std::abs(P)}) > 1e-3) continue;
        const double xyz = X * Y * Z, e2 = X * Y + X * Z + Y * Z - 3 * P * P;
        const double e3 = xyz + 2 * e2 * P + 4 * P * P * P;
        const double e4 = (2 * xyz + e2 * P + 3 * P * P * P) * P, e5 = xyz * P * P;
        const double series =
            1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26;
        return power * series / (mean * std::sqrt(mean)) + 6 * sum;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace elliptic

/// Jacobi's functions of one argument: sn^2 + cn^2 = 1 and dn^2 + k^2 sn^2 = 1.
struct Jacobi {
    double sn, cn, dn;
};

/// Jacobi's sn, cn, dn at u. For k' = 1 they are sin u, cos u, 1. Each Landen step (here upwards again, from
/// a modulus so small that the functions are sine and cosine) adds positive terms only, so nothing cancels.
/// Accurate to a few epsilon times 1 + |u|. Source: M. Abramowitz and I. Stegun, 1964, 16.12.
/// @throws std::invalid_argument unless u is finite and 0 < k' <= 1
inline Jacobi jacobi(double u, double complementary) {
    require(std::isfinite(u), "jacobi: the argument is not finite");
    require(complementary > 0 && complementary <= 1, "jacobi: the complementary modulus must be in (0, 1]");
    std::array<double, 16> k1,
        kc;  // of each step down: the next modulus, and the complementary one it came from
    std::size_t steps = 0;
    for (double c = complementary; 1 - c > 4e-16 && steps < k1.size(); ++steps) {
        kc[steps] = c, k1[steps] = (1 - c) / (1 + c);
        c = 2 * std::sqrt(c) / (1 + c);
    }
    const double quarter = complete_elliptic_k(complementary);
    const double phase = std::remainder(u, 4 * quarter) * (pi / 2 / quarter);
    Jacobi f{std::sin(phase), std::cos(phase), 1};
    while (steps-- > 0) {
        const double k = k1[steps], denominator = 1 + k * f.sn * f.sn;
        const double one_minus_k = 2 * kc[steps] / (1 + kc[steps]);
        f = {(1 + k) * f.sn / denominator, f.cn * f.dn / denominator,
             (one_minus_k + k * f.cn * f.cn) / denominator};
    }
    return f;
}

/// The elliptic integral of the first kind F, as a function of the point (cos phi, sin phi) instead of phi,
/// for -pi < phi <= pi: the u at which cn and sn are these two. @param complementary  k', 0 < k' <= 1
inline double elliptic_f(double cos_phi, double sin_phi, double complementary) {
    const double c2 = cos_phi * cos_phi, s2 = sin_phi * sin_phi;
    const double f = std::abs(sin_phi) * elliptic::rf(c2, c2 + complementary * complementary * s2, 1);
    const double from_zero = cos_phi >= 0 ? f : 2 * complete_elliptic_k(complementary) - f;
    return std::copysign(from_zero, sin_phi);
}

/// The integral from 0 to u of sn^2/(1 + n sn^2), n > -1: what an angle about the conserved direction adds up
/// to in a top. Nothing cancels for n > 0. Source: Carlson's form of Legendre's third integral.
/// @throws std::invalid_argument as jacobi does, and unless n > -1
inline double elliptic_third(double u, double n, double complementary) {
    require(n > -1, "elliptic_third: n must be greater than -1, or the integral has a pole");
    const double k2 = complementary * complementary, quarter = complete_elliptic_k(complementary);
    const double halves = std::round(u / (2 * quarter));
    const Jacobi f = jacobi(u - 2 * halves * quarter, complementary);
    const double s2 = f.sn * f.sn, c2 = f.cn * f.cn;
    const double part = f.sn * s2 / 3 * elliptic::rj(c2, c2 + k2 * s2, 1, 1 + n * s2);
    const double whole = halves == 0 ? 0 : 2 * halves / 3 * elliptic::rj(0, k2, 1, 1 + n);
    return whole + part;
}

}  // namespace nutshell
