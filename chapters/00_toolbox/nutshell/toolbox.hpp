// The toolbox: the mathematics this course uses, each tool a function of a few lines.
#pragma once
#include <cmath>
#include <complex>
#include <nutshell/require.hpp>
#include <nutshell/vector.hpp>

namespace nutshell {

using Vector2 = Eigen::Vector2d;       ///< a point or a direction in a plane
using Matrix2 = Eigen::Matrix2d;       ///< a linear map of a plane
using Complex = std::complex<double>;  ///< a point of the plane that can be multiplied

// [direction]
/// The vector of length 1 that points from one place to another.
/// @throws std::invalid_argument if the two are the same place
inline Vector3 direction(const Vector3& from, const Vector3& to) {
    require_positive((to - from).norm(), "direction: the distance");
    // exercise 0.1
    const Vector3 way = to - from;
    return way / way.norm();
    // end 0.1
}
// [/direction]

// [part_along]
/// How much of v points along n, a direction of length 1: |v| times the cosine of the angle
/// between them. Negative if v points the other way.
inline double part_along(const Vector3& v, const Vector3& n) {
    // exercise 0.2
    return v.dot(n);
    // end 0.2
}
// [/part_along]

// [triangle_area]
/// The area of the triangle with the sides a and b from one corner: half of |a x b|.
inline double triangle_area(const Vector3& a, const Vector3& b) {
    // exercise 0.3
    return a.cross(b).norm() / 2;
    // end 0.3
}
// [/triangle_area]

// [slope]
/// The slope of f at x from two places, h to either side of it. Its error falls with h^2.
/// @param f  called as f(x), gives a number
template <class Function>
double slope(const Function& f, double x, double h) {
    require_positive(h, "slope: h");
    // exercise 0.4
    return (f(x + h) - f(x - h)) / (2 * h);
    // end 0.4
}
// [/slope]

// [area_under]
/// The area under f from a to b, cut into strips of equal width, each as high as f in its
/// middle. The error falls with the square of the width.
/// @param f  called as f(x), gives a number      @param strips  how many, at least 1
template <class Function>
double area_under(const Function& f, double a, double b, int strips) {
    require(strips >= 1, "area_under: at least one strip");
    // exercise 0.5
    const double width = (b - a) / strips;
    double area = 0;
    for (int i = 0; i < strips; ++i) area += f(a + (i + 0.5) * width) * width;
    return area;
    // end 0.5
}
// [/area_under]

// [grown]
/// What becomes of y in a time t if it changes, at every moment, by rate * y per second:
/// y e^(rate t). It grows if the rate is positive and decays if it is negative.
/// @param rate  [1/s]    @param t  [s]
inline double grown(double y, double rate, double t) {
    // exercise 0.6
    return y * std::exp(rate * t);
    // end 0.6
}
// [/grown]

// [turned]
/// The point z of the plane, turned about the origin by an angle [rad], counter-clockwise.
inline Complex turned(Complex z, double angle) {
    // exercise 0.7
    return z * Complex{std::cos(angle), std::sin(angle)};
    // end 0.7
}
// [/turned]

// [spiralled]
/// What becomes of z in a time t [s] if it changes by lambda z per second: the real part of
/// lambda [1/s] makes it grow or decay, the imaginary part [rad/s] makes it turn.
inline Complex spiralled(Complex z, Complex lambda, double t) {
    // exercise 0.8
    return turned(z * grown(1, lambda.real(), t), lambda.imag() * t);
    // end 0.8
}
// [/spiralled]

// [mapped]
/// A matrix times a vector: v.x of the first column and v.y of the second.
inline Vector2 mapped(const Matrix2& A, const Vector2& v) {
    // exercise 0.9
    return v.x() * A.col(0) + v.y() * A.col(1);
    // end 0.9
}
// [/mapped]

// [largest_factor]
/// By how much a matrix that is applied again and again multiplies in the end: the size of its
/// larger eigenvalue. The eigenvalues solve  z^2 - trace z + determinant = 0; two real ones, or
/// a complex pair, whose size is the square root of the determinant.
inline double largest_factor(const Matrix2& A) {
    const double half_trace = A.trace() / 2, determinant = A.determinant();
    // exercise 0.10
    const double inside = half_trace * half_trace - determinant;
    if (inside < 0) return std::sqrt(determinant);
    return std::abs(half_trace) + std::sqrt(inside);
    // end 0.10
}
// [/largest_factor]

// [newton_root]
/// A place where f is zero, by Newton's method from a first guess x: draw the tangent, go where
/// it crosses zero, and again. Each turn about doubles the digits once it is near.
/// @param f, df  called with a number: the function and its slope (not zero on the way)
template <class Function, class Slope>
double newton_root(const Function& f, const Slope& df, double x, int turns) {
    // exercise 0.11
    for (int turn = 0; turn < turns; ++turn) x -= f(x) / df(x);
    return x;
    // end 0.11
}
// [/newton_root]

}  // namespace nutshell
