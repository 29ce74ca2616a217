// Chapter 6's methods as values; <nutshell/method.hpp> says what a method is. Those of chapters 1
// and 3 move bodies too: kick_and_drift_methods without drag, and general_methods.
#pragma once
#include <nutshell/forces_methods.hpp>
#include <nutshell/lie_methods.hpp>
#include <nutshell/rotation_methods.hpp>

namespace nutshell {

namespace methods {

/// As the source prints it. Wrong, so its order is that of an error which does not shrink.
inline constexpr Method printed_step{"printed step",
                                     {Family::explicit_one_step, Mark::cross, "2 3"},
                                     no_order,
                                     1,
                                     plainly(DriftKick<printed_rotation>{})};

/// The source's step with eqs. (53*) and (56*).
inline constexpr Method corrected_step{"corrected step",
                                       {Family::explicit_one_step, Mark::plus, "9 4"},
                                       1,
                                       1,
                                       plainly(DriftKick<explicit_rotation>{})};

inline constexpr Method engine_step{"body-frame Euler",
                                    {Family::explicit_one_step, Mark::triangle, "12 3 3 3"},
                                    1,
                                    1,
                                    plainly(EngineStep<1>{})};

/// Another motion than the body's, so it converges to no truth.
inline constexpr Method engine_step_without_gyroscopic{"body-frame Euler, no gyroscopic term",
                                                       variant(engine_step.look), no_order, 1,
                                                       plainly(EngineStep<0>{})};

/// Verlet whose drift keeps the angular velocity of the start.
inline constexpr Method kick_constant_kick{"kick, constant omega, kick",
                                           {Family::symplectic, Mark::cross, "2 3"},
                                           1,
                                           2,
                                           plainly(KickFreeKick<explicit_rotation>{})};

inline constexpr Method kick_split_kick{"kick, split turns, kick",
                                        {Family::symplectic, Mark::triangle_down, "7 2 2 2"},
                                        2,
                                        2,
                                        plainly(KickFreeKick<split_rotation>{})};

/// Second order with a torque, exact without.
inline constexpr Method kick_exact_kick{"kick, exact free motion, kick",
                                        {Family::exact, Mark::square},
                                        2,
                                        2,
                                        plainly(KickFreeKick<exact_rotation>{})};

/// Fourth order without a torque, second with one.
inline constexpr Method kick_magnus_kick{"kick, Magnus, kick",
                                         {Family::exponential, Mark::star},
                                         4,
                                         2,
                                         plainly(KickFreeKick<magnus_rotation>{})};

inline constexpr Method lie_rk4{
    "RK4 on the group",
    {Family::exponential, Mark::diamond, "9 4"},
    4,
    4,
    plainly([](const auto& state, const auto& forces, double t, double dt) {
        return nutshell::lie_rk4(state, forces, t, dt);
    })};

}  // namespace methods

inline constexpr std::tuple rigid_methods{methods::printed_step,
                                          methods::corrected_step,
                                          methods::engine_step,
                                          methods::engine_step_without_gyroscopic,
                                          methods::kick_constant_kick,
                                          methods::kick_split_kick,
                                          methods::kick_exact_kick,
                                          methods::kick_magnus_kick,
                                          methods::lie_rk4};

}  // namespace nutshell
