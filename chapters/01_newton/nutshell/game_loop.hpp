// The game loop: how simulated time keeps up with the player's clock.
#pragma once
#include <nutshell/newton.hpp>

namespace nutshell {

// [game_clock]
/// A fixed step with an accumulator. Real time flows in, whole steps flow out, the rest is
/// kept for the next frame.
struct GameClock {
    double step;            ///< the one step of the physics [s], greater than zero
    double owed = 0;        ///< time the physics still owes the clock [s]
    int most_steps = 1000;  ///< a frame's limit; the time beyond it is dropped
};

/// Tells how many steps to make in this frame, and books them: all whole steps that are due
/// leave `owed`, the fraction of a step stays. If more than most_steps are due, the surplus is
/// dropped with its time, however long the frame was: the game slows down instead of freezing.
/// @param frame_time  real time since the last frame [s]
/// @throws std::invalid_argument if the step is not positive or the frame time is negative
inline int steps_due(GameClock& clock, double frame_time) {
    require_positive(clock.step, "steps_due: the clock's step [s]");
    require(std::isfinite(frame_time) && frame_time >= 0,
            "steps_due: the frame time must be finite and not negative");
    // exercise 1.8
    clock.owed += frame_time;
    const double due = std::floor(clock.owed / clock.step);
    clock.owed -= due * clock.step;
    return static_cast<int>(std::min(due, static_cast<double>(clock.most_steps)));
    // end 1.8
}

/// What to draw: the state between the last two steps that belongs to the time owed.
/// Always one step behind the clock, so never jerky. @return position [m]
inline Vector3 drawn_position(const GameClock& clock, const PointMass& previous,
                              const PointMass& newest) {
    const double part = clock.owed / clock.step;
    return (1 - part) * previous.position + part * newest.position;
}
// [/game_clock]

}  // namespace nutshell
