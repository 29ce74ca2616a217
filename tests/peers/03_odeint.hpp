// Boost.odeint's runs of the scenes.
#pragma once
#include <boost/numeric/odeint.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_m4_mclachlan.hpp>
#include <nutshell/lab/output.hpp>
#include "03_problems.hpp"

namespace nutshell::peers {

namespace ode = boost::numeric::odeint;

inline constexpr Look grey{Family::peer};

template <class Y, class System, class Stepper, class Observer>
Y odeint_steps(Y y, const System& system, Stepper stepper, long steps, double dt, const Observer& observe) {
    for (long i = 0; i < steps; ++i) {
        stepper.do_step(system, y, static_cast<double>(i) * dt, dt);
        observe(y, static_cast<double>(i + 1) * dt);
    }
    return y;
}

template <class Scene, class Stepper>
void odeint_fixed(std::vector<Point>& points, const Scene& scene, const std::string& name, Stepper,
                  const std::vector<long>& steps) {
    for (const long n : steps)
        points.push_back(
            point(scene, "odeint " + name, grey, std::to_string(n) + " steps", [&](const auto& observe) {
                const auto system = [&scene](const auto& at, auto& dy, double) { scene.rate(at, dy); };
                return odeint_steps(scene.start, system, Stepper(), n,
                                    scene.duration / static_cast<double>(n), observe);
            }));
}

template <class Stepper, class Scene>
void odeint_controlled(std::vector<Point>& points, const Scene& scene, const std::string& name,
                       const std::vector<double>& tolerances) {
    for (const double tolerance : tolerances)
        points.push_back(
            point(scene, "odeint " + name + ", controlled", grey, "tolerance " + lab::rounded(tolerance),
                  [&](const auto& observe) {
                      auto y = scene.start;
                      const auto system = [&](const auto& at, auto& dy, double) { scene.rate(at, dy); };
                      ode::integrate_adaptive(ode::make_controlled<Stepper>(tolerance, tolerance), system, y,
                                              0.0, scene.duration, scene.duration / 1000,
                                              [&](const auto& at, double t) { observe(at, t); });
                      return y;
                  }));
}

template <std::size_t D, class Scene, class Stepper>
void odeint_nystroem(std::vector<Point>& points, const Scene& scene, const std::string& name, Stepper,
                     const std::vector<long>& steps) {
    using Half = std::array<double, D>;
    for (const long n : steps)
        points.push_back(
            point(scene, "odeint " + name, grey, std::to_string(n) + " steps", [&](const auto& observe) {
                Stepper stepper;
                std::pair<Half, Half> s;
                std::copy_n(scene.start.begin(), D, s.first.begin()),
                    std::copy_n(scene.start.begin() + D, D, s.second.begin());
                const double dt = scene.duration / static_cast<double>(n);
                const auto system = [&](const Half& q, Half& f) { scene.force(q, f); };
                for (long i = 0; i < n; ++i) {
                    stepper.do_step(system, s, static_cast<double>(i) * dt, dt);
                    observe(s.first, static_cast<double>(i + 1) * dt);
                }
                return s;
            }));
}

template <std::size_t N, class Scene>
void odeint_all(std::vector<Point>& points, const Scene& scene, const std::vector<long>& steps) {
    using Y = std::array<double, N>;
    odeint_fixed(points, scene, "rk4", ode::runge_kutta4<Y>(), steps);
    odeint_fixed(points, scene, "dopri5", ode::runge_kutta_dopri5<Y>(), steps);
    odeint_fixed(points, scene, "rkf78", ode::runge_kutta_fehlberg78<Y>(), steps);
    const std::vector<double> tolerances{1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14};
    odeint_controlled<ode::runge_kutta_dopri5<Y>>(points, scene, "dopri5", tolerances);
    odeint_controlled<ode::runge_kutta_fehlberg78<Y>>(points, scene, "rkf78", tolerances);
}

}  // namespace nutshell::peers
