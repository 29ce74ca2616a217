// Chapter 1's methods as values; <nutshell/method.hpp> says what a method is.
#pragma once
#include <nutshell/method.hpp>
#include <nutshell/newton.hpp>

namespace nutshell {

namespace methods {

inline constexpr Method euler{"Euler",
                              {Family::explicit_one_step, Mark::circle},
                              1,
                              1,
                              plainly([](auto state, const auto& forces, double t, double dt) {
                                  return nutshell::euler(std::move(state), forces, t, dt);
                              })};

inline constexpr Method semi_implicit_euler{
    "semi-implicit Euler",
    {Family::symplectic, Mark::triangle, "9 4"},
    1,
    1,
    plainly([](auto state, const auto& forces, double t, double dt) {
        return nutshell::semi_implicit_euler(std::move(state), forces, t, dt);
    })};

/// Keeps the force of a step's end for the next step.
inline constexpr Method verlet{
    "Verlet", {Family::symplectic, Mark::square}, 2, 1, [](const auto& scene) {
        return KeptVerlet<PushOf<std::decay_t<decltype(scene)>>>{};
    }};

}  // namespace methods

inline constexpr std::tuple newton_methods{methods::euler, methods::semi_implicit_euler,
                                           methods::verlet};

}  // namespace nutshell
