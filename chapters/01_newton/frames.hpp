// Machines of different speed playing the same throw: what the game loop is tried on.
#pragma once
#include <nutshell/game_loop.hpp>
#include <nutshell/newton_scenes.hpp>
#include <string>
#include <vector>

namespace nutshell {

/// How a machine draws: about `hertz` frames a second, each up to the share `ragged` longer or
/// shorter, with one hitch of `hitch` seconds in the middle.
struct Machine {
    std::string name, label;  // in a table, and beside a ball
    double hertz, ragged = 0, hitch = 0;
};

inline std::vector<Machine> machines() {
    return {{"144 Hz", "144 Hz", 144},
            {"60 Hz", "60 Hz", 60},
            {"60 Hz, uneven", "uneven", 60, 0.8},
            {"30 Hz", "30 Hz", 30},
            {"60 Hz, one hitch of half a second", "a hitch", 60, 0, 0.5}};
}

/// The machine's frame times [s], adding up to `duration`. The same list in every run: the
/// unevenness comes from a fixed sequence (the generator of Numerical Recipes).
inline std::vector<double> frame_times(const Machine& machine, double duration) {
    std::vector<double> frames;
    unsigned state = 1;
    for (double t = 0; t < duration;) {
        state = state * 1664525u + 1013904223u;
        const double uneven = static_cast<double>(state >> 8) / (1 << 24) * 2 - 1;
        double frame = (1 + machine.ragged * uneven) / machine.hertz;
        if (machine.hitch > 0 && t < duration / 2 && t + frame >= duration / 2)
            frame = machine.hitch;
        frames.push_back(std::min(frame, duration - t));
        t += frame;
    }
    return frames;
}

inline constexpr double fixed_step = 1.0 / 120;  ///< of the game loop [s]

/// One frame of the throw as both loops show it.
struct Shown {
    double time;        ///< real time [s]
    Vector3 following;  ///< one step a frame, as long as the frame
    Vector3 fixed;      ///< fixed steps, drawn between the last two: one step behind the clock
};

/// The throw in both loops, with semi-implicit Euler, frame by frame.
class Player {
  public:
    /// A frame of so many seconds.
    Shown frame(double seconds) {
        following_ = semi_implicit_euler(following_, scene_, time_, seconds);
        time_ += seconds;
        for (int due = steps_due(clock_, seconds); due > 0; --due) {
            previous_ = newest_;
            newest_ = semi_implicit_euler(newest_, scene_, simulated_, fixed_step);
            simulated_ += fixed_step;
        }
        return shown();
    }
    Shown shown() const {
        return {time_, following_.position, drawn_position(clock_, previous_, newest_)};
    }

  private:
    ThrownBall scene_;
    PointMass following_ = scene_.start, previous_ = scene_.start, newest_ = scene_.start;
    GameClock clock_{fixed_step};
    double time_ = 0, simulated_ = 0;
};

/// Plays the throw on a machine, and calls observe(shown) for every frame.
template <class Observer>
void play(const Machine& machine, const Observer& observe) {
    Player player;
    observe(player.shown());
    for (const double frame : frame_times(machine, ThrownBall{}.duration))
        observe(player.frame(frame));
}

}  // namespace nutshell
