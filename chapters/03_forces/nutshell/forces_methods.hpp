// Chapter 3's methods as values, under the names the charts know.
#pragma once
#include <nutshell/compositions.hpp>
#include <nutshell/exponential.hpp>
#include <nutshell/flow.hpp>
#include <nutshell/implicit.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/runge_kutta.hpp>

namespace nutshell {

// For point masses: they drift and kick.
inline constexpr auto exponential_kick_method = [](auto state, const auto& forces, double t,
                                                   double dt) {
    return exponential_kick(std::move(state), forces, t, dt);
};
inline constexpr auto exponential_verlet_method = [](auto state, const auto& forces, double t,
                                                     double dt) {
    return exponential_verlet(std::move(state), forces, t, dt);
};
inline constexpr auto semi_implicit_exponential_method = [](auto state, const auto& forces,
                                                            double t, double dt) {
    return semi_implicit_exponential(std::move(state), forces, t, dt);
};
inline constexpr auto semi_implicit_division_method = [](auto state, const auto& forces, double t,
                                                         double dt) {
    return semi_implicit_division(std::move(state), forces, t, dt);
};
/// Fourth order with drag: Yoshida's three steps, each an exponential Verlet. One step back makes
/// the drag grow for a while.
/// @tparam Push  what forces(state, t) gives
template <class Push = Vector3>
Composed<ExponentialVerlet<Push>, 3> exponential_yoshida4() {
    return {{}, yoshida_weights()};
}

// For flows: they know y' = f(t, y).
inline constexpr auto explicit_midpoint_method = [](const auto& y, const auto& flow, double t,
                                                    double dt) {
    return explicit_midpoint(y, flow, t, dt);
};
inline constexpr auto rk4_method = [](const auto& y, const auto& flow, double t, double dt) {
    return rk4(y, flow, t, dt);
};
inline const DormandPrince<FlatPoint> dormand_prince_method = {};
inline constexpr auto implicit_euler_method = [](const auto& y, const auto& flow, double t,
                                                 double dt) {
    return implicit_euler(y, flow, t, dt);
};
inline constexpr auto implicit_midpoint_method = [](const auto& y, const auto& flow, double t,
                                                    double dt) {
    return implicit_midpoint(y, flow, t, dt);
};

}  // namespace nutshell
