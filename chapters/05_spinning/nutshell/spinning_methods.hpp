// Chapter 5's methods as values; <nutshell/method.hpp> says what a method is. What is evaluated is
// the angular velocity.
#pragma once
#include <nutshell/method.hpp>
#include <nutshell/spinning.hpp>

namespace nutshell {

namespace methods {

inline constexpr Method first_order_unit{
    "first order, divided",
    {Family::explicit_one_step, Mark::circle},
    1,
    1,
    plainly([](const Quaternion& q, const auto& spin, double t, double dt) {
        return nutshell::first_order_unit(q, spin, t, dt);
    })};

inline constexpr Method exponential_map{
    "exponential",
    {Family::exponential, Mark::triangle, "5 3"},
    1,
    1,
    plainly([](const Quaternion& q, const auto& spin, double t, double dt) {
        return nutshell::exponential_map(q, spin, t, dt);
    })};

inline constexpr Method exponential_midpoint{
    "exponential midpoint",
    {Family::exponential, Mark::triangle_down, "12 3 3 3"},
    2,
    2,
    plainly([](const Quaternion& q, const auto& spin, double t, double dt) {
        return nutshell::exponential_midpoint(q, spin, t, dt);
    })};

inline constexpr Method magnus4{
    "Magnus 4",
    {Family::exponential, Mark::star, "3 3"},
    4,
    2,
    plainly([](const Quaternion& q, const auto& spin, double t, double dt) {
        return nutshell::magnus4(q, spin, t, dt);
    })};

/// Chapter 3's RK4, on the four numbers of a pose.
inline constexpr Method rk4_pose{
    "RK4",
    {Family::runge_kutta, Mark::circle},
    4,
    4,
    plainly([](const Quaternion& q, const auto& spin, double t, double dt) {
        return nutshell::rk4_pose(q, spin, t, dt);
    })};

}  // namespace methods

inline constexpr std::tuple spinning_methods{methods::first_order_unit, methods::exponential_map,
                                             methods::exponential_midpoint, methods::magnus4,
                                             methods::rk4_pose};

}  // namespace nutshell
