// Chapter 6 · Inertia: how hard it is to turn a thing, about every axis at once.
#pragma once
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <nutshell/moments.hpp>
#include <nutshell/revised_newton.hpp>
#include <span>
#include <vector>

namespace nutshell {

// [point_inertia]
/// Inertia [kg m^2] of one point mass about the origin, r [m] its place: m (r^2 1 - r r^T). Only
/// the part of r at right angles to the axis counts. Source: eq. (49), one term; eq. (63).
inline Matrix3 point_inertia(double mass, const Vector3& r) {
    // exercise 6.2
    return mass * (r.squaredNorm() * Matrix3::Identity() - r * r.transpose());
    // end 6.2
}
// [/point_inertia]

// [mass_properties]
/// What a rigid thing's shape and density come down to.
struct MassProperties {
    double mass = 0;                    ///< [kg]
    Vector3 centre = Vector3::Zero();   ///< of mass [m], in the axes of the shape
    Matrix3 inertia = Matrix3::Zero();  ///< [kg m^2] about the centre, in the axes of the shape
};

/// Of a cloud of particles: sums. Their inertia is taken about their own centre. Source: eqs.
/// (49), (60), (61). @throws std::invalid_argument if there is none, or a mass is not positive
inline MassProperties mass_properties(std::span<const Particle> cloud) {
    require(!cloud.empty(), "mass_properties: a cloud without particles has no centre");
    MassProperties sum;
    for (const Particle& particle : cloud) {
        sum.mass += checked(particle).mass;
        sum.centre += particle.mass * particle.position;
    }
    sum.centre /= sum.mass;
    for (const Particle& particle : cloud)
        sum.inertia += point_inertia(particle.mass, particle.position - sum.centre);
    return sum;
}
// [/mass_properties]

// [parallel_axis]
/// What is added to the inertia about the centre of mass to get the inertia about a point that is
/// `offset` [m] away from it: that of all mass in the centre. Source: eq. (63), Steiner
inline Matrix3 parallel_axis(double mass, const Vector3& offset) {
    return point_inertia(mass, offset);
}

/// Inertia [kg m^2] about `point` [m], both in the axes of the shape.
inline Matrix3 inertia_about(const MassProperties& body, const Vector3& point) {
    // exercise 6.5
    return body.inertia + parallel_axis(body.mass, point - body.centre);
    // end 6.5
}
// [/parallel_axis]

// [in_world]
/// Inertia in world axes of a body whose inertia in its own axes is `inertia` and that R has
/// turned: I = R I0 R^T. A column of R says where an axis of the body points. Source: eq. (53*).
inline Matrix3 in_world(const Matrix3& inertia, const Matrix3& rotation) {
    // exercise 6.3
    return rotation * inertia * rotation.transpose();
    // end 6.3
}
// [/in_world]

// [spin_of]
/// Angular velocity [rad/s], world axes, of a body whose inertia in its own axes is `inertia`,
/// principal or not: into the body, solve I0 omega = L, back: R I0^-1 R^T L. Source: eq. (53*).
/// @param L  angular momentum [kg m^2/s], world axes
/// @throws std::invalid_argument if the inertia has no inverse, as a rod without thickness
inline Vector3 spin_of(const Matrix3& inertia, const Matrix3& rotation, const Vector3& L) {
    const double largest = inertia.cwiseAbs().maxCoeff();
    require(inertia.determinant() > 1e-14 * largest * largest * largest,
            "spin_of: the inertia tensor has no inverse: a moment is zero, as of a rod without "
            "thickness");
    // exercise 6.4
    const Matrix3 answer = inertia.inverse();
    const Vector3 own = rotation.transpose() * L, spin = answer * own;
    return rotation * spin;
    // end 6.4
}
// [/spin_of]

// [principal]
/// The axes about which a body can spin without a torque, and its moments of inertia about them.
struct PrincipalAxes {
    Vector3 moments;  ///< [kg m^2]
    Matrix3 axes;     ///< right-handed: a column is a principal axis, in the axes of the shape
};

/// Eigenvalues of a symmetric matrix, the smallest first, and its eigenvectors: turn about one
/// axis after the other, each time so that the entry of the two others vanishes, until all have.
/// Every turn makes the entries' squares smaller; five rounds are enough for round-off. No checks.
/// Source: C. G. J. Jacobi (1846); G. H. Golub, C. F. Van Loan, Matrix Computations, 8.5.
inline PrincipalAxes symmetric_axes(Matrix3 matrix) {
    Matrix3 axes = Matrix3::Identity();
    const double small = 1e-18 * matrix.cwiseAbs().maxCoeff();
    for (int round = 0; round < 20; ++round) {
        bool done = true;
        for (const auto& [i, j] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
            if (!(std::abs(matrix(i, j)) > small)) continue;
            done = false;
            const double cot2 = (matrix(j, j) - matrix(i, i)) / (2 * matrix(i, j));
            const double t =
                std::copysign(1 / (std::abs(cot2) + std::sqrt(1 + cot2 * cot2)), cot2);
            Matrix3 turn = Matrix3::Identity();  // tan is t, at most 45 degrees
            turn(i, i) = turn(j, j) = 1 / std::sqrt(1 + t * t);
            turn(i, j) = t * turn(i, i), turn(j, i) = -turn(i, j);
            matrix = Matrix3(turn.transpose() * matrix * turn), axes = Matrix3(axes * turn);
            matrix(i, j) = matrix(j, i) = 0;
        }
        if (done) break;
    }
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return matrix(a, a) < matrix(b, b); });
    PrincipalAxes found;
    for (int k = 0; k < 3; ++k) {
        const int from = order[static_cast<std::size_t>(k)];
        found.moments[k] = matrix(from, from), found.axes.col(k) = axes.col(from);
    }
    if (found.axes.determinant() < 0) found.axes.col(0) *= -1;
    return found;
}

/// Principal axes of an inertia tensor [kg m^2]: the eigenvectors of a symmetric matrix. One that
/// is diagonal already, but for round-off, keeps its axes in their order.
/// @throws std::invalid_argument with the reason if the tensor is not finite, not symmetric, or
/// no body can have it
inline PrincipalAxes principal_axes(const Matrix3& inertia) {
    require_finite(inertia, "an inertia tensor [kg m^2]");
    const double size = inertia.cwiseAbs().maxCoeff();
    require((inertia - inertia.transpose()).cwiseAbs().maxCoeff() <= 1e-12 * size,
            "an inertia tensor is symmetric, this one is not: was it turned by R I R^T?");
    PrincipalAxes found{inertia.diagonal(), Matrix3::Identity()};
    const Matrix3 mixed = inertia - Matrix3(found.moments.asDiagonal());
    if (mixed.cwiseAbs().maxCoeff() > 1e-15 * size) found = symmetric_axes(inertia);
    const std::string reason = why_impossible(found.moments);
    require(reason.empty(), "no body has this inertia tensor: " + reason);
    return found;
}
// [/principal]

}  // namespace nutshell
