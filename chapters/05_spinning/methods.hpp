// Chapter 5's methods as values: name, look, order, evaluations of the angular velocity a step.
#pragma once
#include <nutshell/look.hpp>
#include <nutshell/spinning.hpp>
#include <string>
#include <tuple>

namespace nutshell {

template <class Step>
struct SpinMethod {
    std::string name, key;
    Look look;
    int order, evaluations;
    Step step;  ///< called as step(q, spin, t, dt), gives the pose one step later
};
template <class Step>
SpinMethod(std::string, std::string, Look, int, int, Step) -> SpinMethod<Step>;

/// From the source's rule to the fourth order.
inline auto spin_methods() {
    return std::tuple{
        SpinMethod{"first order, divided", "first_order",
                   Look{Family::explicit_one_step, Mark::circle, ""}, 1, 1,
                   [](const Quaternion& q, const auto& spin, double t, double dt) {
                       return first_order_unit(q, spin, t, dt);
                   }},
        SpinMethod{"exponential", "exponential", Look{Family::exponential, Mark::triangle, "5 3"},
                   1, 1,
                   [](const Quaternion& q, const auto& spin, double t, double dt) {
                       return exponential_map(q, spin, t, dt);
                   }},
        SpinMethod{"exponential midpoint", "midpoint",
                   Look{Family::exponential, Mark::triangle_down, "12 3 3 3"}, 2, 2,
                   [](const Quaternion& q, const auto& spin, double t, double dt) {
                       return exponential_midpoint(q, spin, t, dt);
                   }},
        SpinMethod{"Magnus 4", "magnus", Look{Family::exponential, Mark::star, "3 3"}, 4, 2,
                   [](const Quaternion& q, const auto& spin, double t, double dt) {
                       return magnus4(q, spin, t, dt);
                   }},
        SpinMethod{"RK4", "rk4", Look{Family::runge_kutta, Mark::circle, ""}, 4, 4,
                   [](const Quaternion& q, const auto& spin, double t, double dt) {
                       return rk4_pose(q, spin, t, dt);
                   }}};
}

/// Calls look(method) for each of them, in order.
template <class Looking>
void for_each_spin_method(const Looking& looking) {
    std::apply([&](const auto&... method) { (looking(method), ...); }, spin_methods());
}

}  // namespace nutshell
