// Chapter 3 · Types of forces: gravity, springs and drag, each with its energy. Forces add: sum
// them with +.
#pragma once
#include <nutshell/newton.hpp>

namespace nutshell {

// [gravity]
/// Weight [N] of a mass [kg]: (0, -m g, 0), g in m/s^2. Source: eq. (17) with the unit of g
/// corrected (E07).
inline Vector3 gravity_force(double mass, double g = earth_gravity) {
    return {0, -mass * g, 0};
}

/// Its potential energy [J], zero at height zero.
inline double gravity_energy(double mass, const Vector3& position, double g = earth_gravity) {
    return mass * g * position.y();
}
// [/gravity]

// [spring]
/// A massless spring, by Hooke's law.
struct Spring {
    double stiffness;        ///< kappa [N/m], not negative
    double rest_length = 0;  ///< l0 [m], not negative: where it neither pulls nor pushes
};

/// The force [N] of a spring on its end at `end`; the other end gets the opposite. Pulls when
/// longer than its rest length, pushes when shorter. Where both ends meet, the direction does
/// not exist and the force is zero (E08). Positions in m, world frame. Source: eq. (18*).
inline Vector3 spring_force(const Spring& spring, const Vector3& end, const Vector3& other_end) {
    // exercise 3.1
    const Vector3 d = end - other_end;
    const double length = d.norm();
    if (length == 0) return Vector3::Zero();
    return spring.stiffness * (spring.rest_length - length) / length * d;
    // end 3.1
}

/// Its potential energy [J], zero at rest length. The force is minus its gradient.
inline double spring_energy(const Spring& spring, const Vector3& end, const Vector3& other_end) {
    const double stretch = (end - other_end).norm() - spring.rest_length;
    return spring.stiffness * stretch * stretch / 2;
}
// [/spring]

// [drag]
/// Linear (viscous) drag [N], for honey and dust: against the velocity [m/s] relative to the
/// medium, gamma in kg/s. Source: eq. (19), there called friction (E09).
inline Vector3 linear_drag_force(double gamma, const Vector3& velocity) {
    return -gamma * velocity;
}

/// Quadratic drag [N], for balls and cars in air: against the velocity [m/s] relative to the
/// medium, growing with the square of the speed. @param c  [kg/m], see air_drag      Eq. (3.a).
inline Vector3 quadratic_drag_force(double c, const Vector3& velocity) {
    // exercise 3.2
    return -c * velocity.norm() * velocity;
    // end 3.2
}

/// c = rho C A / 2 [kg/m] of a body of front area A [m^2] in a medium of density rho [kg/m^3];
/// C has no unit (0.47 for a ball).
inline double air_drag(double density, double drag_coefficient, double area) {
    return density * drag_coefficient * area / 2;
}
// [/drag]

/// Gives the spring back if it can be simulated. @throws std::invalid_argument if its stiffness
/// or rest length is negative or not finite
inline Spring checked(const Spring& spring) {
    require(std::isfinite(spring.stiffness) && spring.stiffness >= 0,
            "the stiffness of a spring [N/m] must be finite and not negative, not " +
                std::to_string(spring.stiffness));
    require(std::isfinite(spring.rest_length) && spring.rest_length >= 0,
            "the rest length of a spring [m] must be finite and not negative, not " +
                std::to_string(spring.rest_length));
    return spring;
}

/// Gives a drag coefficient (gamma [kg/s] or c [kg/m]) back if it is finite and not negative.
/// @throws std::invalid_argument otherwise: negative drag would feed energy in
inline double checked_drag(double coefficient) {
    require(
        std::isfinite(coefficient) && coefficient >= 0,
        "a drag coefficient must be finite and not negative, not " + std::to_string(coefficient));
    return coefficient;
}

}  // namespace nutshell
