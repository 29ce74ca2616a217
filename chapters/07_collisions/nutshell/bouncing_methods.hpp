// Chapter 7's ways to bounce as values; <nutshell/method.hpp> says what a method is.
#pragma once
#include <nutshell/bouncing_ball.hpp>
#include <nutshell/method.hpp>

namespace nutshell {

namespace methods {

/// From impact to impact; the step says only when to look.
inline constexpr Method bounce_events{
    "event-driven",
    {Family::exponential, Mark::triangle},
    no_order,
    0,
    plainly([](const Particle& body, const BouncingBall& scene, double, double dt) {
        return bounce_by_events(scene, body, dt);
    })};

/// Verlet, and the floor rule at the end of each step.
inline constexpr Method bounce_steps{
    "time-stepping",
    {Family::symplectic, Mark::square, "6 3"},
    1,
    1,
    plainly([](Particle body, const BouncingBall& scene, double t, double dt) {
        body = nutshell::verlet(body, scene, t, dt);
        bounce_off_floor(scene, body);
        return body;
    })};

/// Verlet, and the floor that pushes a fifth of the depth out in each step, through the speed.
inline constexpr Method bounce_pushed{
    "pushed out",
    {Family::runge_kutta, Mark::diamond, "10 3"},
    1,
    1,
    plainly([](Particle body, const BouncingBall& scene, double t, double dt) {
        body = nutshell::verlet(body, scene, t, dt);
        bounce_with_push(scene, body, dt, 0.2);
        return body;
    })};

/// The source's program: Euler, and the printed floor.
inline constexpr Method bounce_printed{
    "as printed",
    {Family::explicit_one_step, Mark::circle, "3 3"},
    no_order,
    1,
    plainly([](Particle body, const BouncingBall& scene, double t, double dt) {
        body = nutshell::euler(body, scene, t, dt);
        bounce_as_printed(body);
        return body;
    })};

}  // namespace methods

inline constexpr std::tuple bouncing_methods{methods::bounce_events, methods::bounce_steps,
                                             methods::bounce_pushed, methods::bounce_printed};

}  // namespace nutshell
