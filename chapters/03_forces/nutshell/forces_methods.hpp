// Chapter 3's methods as values; <nutshell/method.hpp> says what a method is.
#pragma once
#include <nutshell/compositions.hpp>
#include <nutshell/exponential.hpp>
#include <nutshell/implicit.hpp>
#include <nutshell/log_hamiltonian.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/particles.hpp>
#include <nutshell/right_hand_side.hpp>
#include <nutshell/runge_kutta.hpp>

namespace nutshell {

namespace methods {

// They kick and drift, for forces of position and time.

/// Evaluates the force at the start of every step again. Without drag it has the numbers of
/// `verlet`; with drag in its kicks it has other ones, and bears a longer step.
inline constexpr Method verlet_re_evaluated{
    "Verlet, re-evaluated", variant(verlet.look), 2, 2,
    plainly([](auto state, const auto& forces, double t, double dt) {
        return nutshell::verlet(std::move(state), forces, t, dt);
    })};

inline constexpr Method yoshida4{"Yoshida 4",
                                 {Family::symplectic, Mark::diamond, "14 4"},
                                 4,
                                 3,
                                 composed(verlet, yoshida_weights)};

inline constexpr Method yoshida4_re_evaluated{"Yoshida 4, re-evaluated", variant(yoshida4.look),
                                              4, 6,
                                              composed(verlet_re_evaluated, yoshida_weights)};

inline constexpr Method kahan_li8{"Kahan-Li 8",
                                  {Family::symplectic, Mark::star, "12 3 3 3"},
                                  8,
                                  15,
                                  composed(verlet, kahan_li_weights)};

inline constexpr Method kahan_li8_re_evaluated{"Kahan-Li 8, re-evaluated",
                                               variant(kahan_li8.look), 8, 30,
                                               composed(verlet_re_evaluated, kahan_li_weights)};

// The same with linear drag apart from the other forces.

inline constexpr Method semi_implicit_division{
    "semi-implicit, implicit drag",
    {Family::exponential, Mark::cross, "7 2 2 2"},
    1,
    1,
    plainly([](auto state, const auto& forces, double t, double dt) {
        return nutshell::semi_implicit_division(std::move(state), forces, t, dt);
    })};

inline constexpr Method semi_implicit_exponential{
    "semi-implicit, exponential drag",
    {Family::exponential, Mark::plus, "2 3"},
    1,
    1,
    plainly([](auto state, const auto& forces, double t, double dt) {
        return nutshell::semi_implicit_exponential(std::move(state), forces, t, dt);
    })};

inline constexpr Method exponential_kick{
    "exponential kick",
    {Family::exponential, Mark::circle, "9 4"},
    1,
    1,
    plainly([](auto state, const auto& forces, double t, double dt) {
        return nutshell::exponential_kick(std::move(state), forces, t, dt);
    })};

inline constexpr Method exponential_verlet{
    "exponential Verlet",
    {Family::exponential, Mark::square},
    2,
    2,
    plainly([](auto state, const auto& forces, double t, double dt) {
        return nutshell::exponential_verlet(std::move(state), forces, t, dt);
    })};

inline constexpr Method exponential_verlet_inside{
    "exponential Verlet, half-drags inside", variant(exponential_verlet.look), 2, 1,
    [](const auto& scene) {
        using Scene = std::decay_t<decltype(scene)>;
        return ExponentialVerletInside<decltype(Scene::start), PushOf<Scene>>{};
    }};

/// Yoshida's three steps, each an exponential Verlet. The step back makes the drag grow for a
/// while.
inline constexpr Method exponential_yoshida4{
    "exponential Yoshida 4",
    {Family::exponential, Mark::diamond, "14 4"},
    4,
    3,
    composed(exponential_verlet_inside, yoshida_weights)};

// They know only y' = f(t, y).

inline constexpr Method explicit_midpoint{
    "explicit midpoint",
    {Family::runge_kutta, Mark::triangle, "9 4"},
    2,
    2,
    on_flat([](const auto& y, const auto& f, double t, double dt) {
        return nutshell::explicit_midpoint(y, f, t, dt);
    })};

inline constexpr Method rk4{"RK4",
                            {Family::runge_kutta, Mark::circle},
                            4,
                            4,
                            on_flat([](const auto& y, const auto& f, double t, double dt) {
                                return nutshell::rk4(y, f, t, dt);
                            })};

inline constexpr Method dormand_prince{
    "Dormand-Prince 5(4)",
    {Family::runge_kutta, Mark::diamond, "14 4"},
    5,
    6,
    [](const auto& scene) { return FlatStepper<DormandPrince<decltype(flat(scene.start))>>{}; }};

inline constexpr Method implicit_euler{
    "implicit Euler",
    {Family::implicit, Mark::triangle_down, "9 4"},
    1,
    as_needed,
    on_flat([](const auto& y, const auto& f, double t, double dt) {
        return nutshell::implicit_euler(y, f, t, dt);
    })};

inline constexpr Method implicit_midpoint{
    "implicit midpoint",
    {Family::implicit, Mark::square},
    2,
    as_needed,
    on_flat([](const auto& y, const auto& f, double t, double dt) {
        return nutshell::implicit_midpoint(y, f, t, dt);
    })};

// Each knows one scene.

/// For a body on a spring: exact, so it has no order.
inline constexpr Method exact_propagator{
    "exact propagator",
    {Family::exact, Mark::diamond, "9 4"},
    no_order,
    0,
    [](const auto& spring) {
        return SpringPropagator{spring.omega(), spring.damping_rate()};
    }};

/// For a planet with its own clock.
inline constexpr Method logarithmic_leapfrog{
    "logarithmic leapfrog",
    {Family::symplectic, Mark::plus, "5 3"},
    2,
    1,
    [](const auto& planet) { return LogHamiltonian(planet.gm, planet.start); }};

inline constexpr Method logarithmic_leapfrog8{"logarithmic leapfrog, order 8",
                                              variant(logarithmic_leapfrog.look), 8, 15,
                                              composed(logarithmic_leapfrog, kahan_li_weights)};

}  // namespace methods

/// They move every state that has the verbs drift, kick, decay and stop.
inline constexpr std::tuple kick_and_drift_methods = std::tuple_cat(
    newton_methods,
    std::tuple{methods::verlet_re_evaluated, methods::yoshida4, methods::yoshida4_re_evaluated,
               methods::kahan_li8, methods::kahan_li8_re_evaluated,
               methods::semi_implicit_division, methods::semi_implicit_exponential,
               methods::exponential_kick, methods::exponential_verlet,
               methods::exponential_verlet_inside, methods::exponential_yoshida4});

/// They move every state that has a flat form.
inline constexpr std::tuple general_methods{methods::explicit_midpoint, methods::rk4,
                                            methods::dormand_prince, methods::implicit_euler,
                                            methods::implicit_midpoint};

inline constexpr std::tuple forces_methods =
    std::tuple_cat(kick_and_drift_methods, general_methods,
                   std::tuple{methods::exact_propagator, methods::logarithmic_leapfrog,
                              methods::logarithmic_leapfrog8});

}  // namespace nutshell
