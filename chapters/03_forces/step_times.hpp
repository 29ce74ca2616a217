// The time of one step of one particle, and the floors it is compared with: for the chapter's
// program and its test.
#pragma once
#include <algorithm>
#include <nutshell/chain_scenes.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/wide_floor.hpp>

namespace nutshell {

inline constexpr int timing_rounds = 5;   // the least time of so many is taken
inline constexpr double timed_dt = 1e-3;  // [s]; the time of a step does not depend on it
inline constexpr double slow_drag =
    1e-3;  // [kg/s]: the particles keep moving while they are timed

/// Nanoseconds per particle-step: the three verbs one after the other, all in one pass, and the
/// two floors.
struct Times {
    std::size_t particles;
    double verbs, one_pass, streaming, arithmetic;
    double slowest_floor = 0;  ///< of the rounds: how far the floor itself scatters
    double floor() const { return std::max(streaming, arithmetic); }
};

/// Times one kind of scene; `stream` and `arithmetic` are its floors, called for all particles.
/// All work in place. They take turns, so that a while in which the machine is busy hits them
/// alike.
template <class Scene, class Stream, class Arithmetic>
Times time_steps(const Scene& scene, const Stream& stream, const Arithmetic& arithmetic) {
    const std::size_t n = scene.start.size();
    Particles all = scene.start, streamed = scene.start;
    Vector3Array forces;
    const auto least = [n](double& best, const auto& work) {
        const double now = 1e9 / static_cast<double>(n) * lab::time_of(work, 1);
        best = std::min(best, now);
        return now;
    };
    constexpr double never = std::numeric_limits<double>::infinity();
    Times times{n, never, never, never, never};
    for (int round = 0; round < timing_rounds; ++round) {
        least(times.verbs, [&] {
            scene(all, 0, forces);
            kick(all, forces, timed_dt);
            drift(all, timed_dt);
        });
        least(times.one_pass, [&] { advance(all, scene, forces, timed_dt); });
        const double moved = least(times.streaming, [&] { stream(streamed); }),
                     summed = least(times.arithmetic, [&] { arithmetic(n); });
        times.slowest_floor = std::max({times.slowest_floor, moved, summed});
    }
    lab::keep(all.position.x[0]), lab::keep(streamed.position.x[0]);
    return times;
}

/// Calls loop(count, in, out) for n numbers in all, a block at a time that stays in the nearest
/// cache.
template <class Loop>
void in_blocks(std::size_t n, const Loop& loop) {
    constexpr std::size_t block = 256;
    static const std::vector<double> in(block, 1.5);
    double out[block];
    for (std::size_t done = 0; done < n; done += block) {
        loop(std::min(block, n - done), in.data(), out);
        lab::keep(out[0]);
    }
}

inline const wide::Medium timed_medium{0, -earth_gravity, 0, slow_drag};

inline Times time_anchored(std::size_t n) {
    AnchoredParticles scene = anchored_particles(n);
    scene.drag = slow_drag;
    return time_steps(
        scene,
        [&](Particles& all) {
            wide::stream_anchored(n, all.position.axes(), all.velocity.axes(), all.mass.data(),
                                  std::as_const(scene.anchors).axes());
        },
        [&](std::size_t count) {
            in_blocks(count, [&](std::size_t part, const double* in, double* out) {
                wide::arithmetic_anchored(part, in, out, timed_medium, scene.stiffness, timed_dt);
            });
        });
}

inline Times time_net(SpringNet net) {
    net.drag = slow_drag;
    return time_steps(
        net,
        [](Particles& all) {
            wide::stream_net(all.size(), all.position.axes(), all.velocity.axes(),
                             all.mass.data());
        },
        [&](std::size_t count) {
            in_blocks(count, [&](std::size_t part, const double* in, double* out) {
                for (const GridSpring& kind : net.springs.kinds) {
                    wide::arithmetic_spring(part, in, out, kind.spring.rest_length,
                                            kind.spring.stiffness);
                    lab::keep(out[0]);
                }
                wide::arithmetic_move(part, in, out, timed_medium, timed_dt);
            });
        });
}

/// A chain of n particles between two ends, stretched a little: it stays in order while it
/// swings.
inline SpringNet timed_chain(std::size_t n) {
    const double gap = 0.1;
    return chain(n - 2, 0.01, {100, 0.9 * gap}, {0, 0, 0},
                 {gap * static_cast<double>(n - 1), 0, 0});
}

inline SpringNet timed_cloth(std::size_t n) {
    const auto side = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(n))));
    SpringNet net =
        cloth(side, 0.1 * static_cast<double>(side - 1), 0.01 * static_cast<double>(side * side),
              100, Weave::with_shear_and_bend);
    for (std::size_t c = 0; c < side; ++c) net.held.push_back(c);
    return net;
}

}  // namespace nutshell
