// Chapter 3's scenes S2, S2d, S3 and S5 with the least state each needs (two numbers, four for the planet),
// as both sides of the comparison see them; and how a run is timed and measured.
#pragma once
#include <nutshell/forces_methods.hpp>
#include <nutshell/forces_scenes.hpp>
#include <nutshell/lab/run.hpp>

namespace nutshell::peers {

/// One run of a method, theirs (a peer) or ours.
struct Point {
    std::string method;
    Look look;
    std::string how;
    double seconds, error;  // of the whole run
};
inline bool is_peer(const Point& p) {
    return p.look.family == Family::peer;
}

/// A scene as both sides see it: y' = rate(y), y of N numbers, error(y, t) in metres.
template <std::size_t N>
struct Problem {
    std::string id, name, unit;
    std::array<double, N> start;
    double duration, worst;  // runs that are off by more are not compared
    double round_off;        // errors below this are chance on both sides: they count as equal
    bool final_error_only;
};

struct Spring2 : Problem<2> {
    MassOnSpring scene;
    explicit Spring2(double ratio)
        : Problem<2>{ratio == 0 ? "S2" : "S2d",
                     ratio == 0 ? "mass on a spring, 10 s" : "damped spring, 10 s",
                     "m",
                     {1, 0},
                     10,
                     0.1,
                     1e-12,
                     false},
          scene(MassOnSpring::with_damping(ratio)) {}
    template <class Y>
    void rate(const Y& y, Y& dy) const {
        dy[0] = y[1], dy[1] = -scene.stiffness * y[0] - scene.drag * y[1];
    }
    template <class Q>
    void force(const Q& q, Q& f) const {
        f[0] = -scene.stiffness * q[0];
    }
    template <class Y>
    double error(const Y& y, double t) const {
        return std::abs(y[0] - scene.exact(t).position.x());
    }
};

struct Fall2 : Problem<2> {
    FallingWithDrag scene;
    Fall2() : Problem<2>{"S3", "falling with linear drag, 5 s", "m", {0, 0}, 5, 5, 1e-12, false} {}
    template <class Y>
    void rate(const Y& y, Y& dy) const {
        dy[0] = y[1], dy[1] = -earth_gravity - scene.drag * y[1];
    }
    template <class Y>
    double error(const Y& y, double t) const {
        return std::abs(y[0] - scene.exact(t).position.y());
    }
};

struct Planet4 : Problem<4> {
    Planet scene = Planet::for_orbits(100);
    Planet4()
        : Problem<4>{"S5", "planet, e = 0.6, 100 orbits", "a", {0.4, 0, 0, 2}, 200 * pi, 0.1, 5e-10, true} {}
    template <class Y>
    void rate(const Y& y, Y& dy) const {
        const double r2 = y[0] * y[0] + y[1] * y[1], k = -1 / (r2 * std::sqrt(r2));
        dy[0] = y[2], dy[1] = y[3], dy[2] = k * y[0], dy[3] = k * y[1];
    }
    template <class Q>
    void force(const Q& q, Q& f) const {
        const double r2 = q[0] * q[0] + q[1] * q[1], k = -1 / (r2 * std::sqrt(r2));
        f[0] = k * q[0], f[1] = k * q[1];
    }
    template <class Y>
    double error(const Y& y, double t) const {
        const Vector3 p = scene.exact(t).position;
        return std::hypot(y[0] - p.x(), y[1] - p.y());
    }
};

/// Errors are collected in a run of their own, so that observing costs no time in the timed one.
template <class Scene>
struct Errors {
    const Scene& scene;
    double largest = 0, last = 0;
    template <class Y>
    void observe(const Y& y, double t) {
        last = scene.error(y, t), largest = std::max(largest, last);
    }
    double result() const { return scene.final_error_only ? last : largest; }
};

/// A whole run with every call in it inlined, theirs and ours alike: what a program that runs this one method
/// would do. Left to itself, g++ decides by the size of this file which inner step becomes a call, and a call
/// costs a factor of two.
template <class Work>
[[gnu::noinline, gnu::flatten]] auto run_once(const Work& work) {
    return work([](const auto&, double) {});
}

/// `work(observe)` makes the whole run; timed without an observer, measured with it.
template <class Scene, class Work>
Point point(const Scene& scene, const std::string& method, const Look& look, const std::string& how,
            const Work& work) {
    Errors<Scene> errors{scene};
    work([&](const auto& y, double t) {
        if (t > 0 && (!scene.final_error_only || t > 0.999 * scene.duration)) errors.observe(y, t);
    });
    const double seconds = lab::time_of([&] { lab::keep(run_once(work)); }, 5, 1e-3);
    return {method, look, how, seconds, errors.result()};
}

}  // namespace nutshell::peers
