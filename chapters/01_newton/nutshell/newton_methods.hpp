// Chapter 1's methods as values, under the names the charts know.
#pragma once
#include <nutshell/newton.hpp>

namespace nutshell {

inline constexpr auto euler_method = [](auto state, const auto& forces, double t, double dt) {
    return euler(std::move(state), forces, t, dt);
};
inline constexpr auto semi_implicit_euler_method = [](auto state, const auto& forces, double t,
                                                      double dt) {
    return semi_implicit_euler(std::move(state), forces, t, dt);
};
inline constexpr auto verlet_method = [](auto state, const auto& forces, double t, double dt) {
    return verlet(std::move(state), forces, t, dt);
};

}  // namespace nutshell
