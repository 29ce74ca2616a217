// Exercise 1.8: how many steps this frame owes.
#pragma once
#include <nutshell/game_loop.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

#ifndef NUTSHELL_SHEET
inline int at_most(const GameClock& clock, double due) {
    return static_cast<int>(std::min(due, static_cast<double>(clock.most_steps)));
}
#endif

struct StepsDue {
    static constexpr const char *id = "1.8", *function = "steps_due";
    static constexpr auto subject = NUTSHELL_CALL(steps_due);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        // even frames, a short one, none, one far too long, and what comes after it
        ask_clock(paper, answer, {.step = 0.01, .owed = 0.0067, .most_steps = 5},
                  {0.0141, 0.0171, 0.0172, 0.0038, 0.0, 0.0464, 0.1235, 0.0063, 0.0318, 0.4172,
                   0.0021});
        // all exact: a step that is just due, one that is not, the limit, one beyond it
        ask_clock(paper, answer, {.step = 1. / 64, .owed = 0, .most_steps = 3},
                  {1. / 64, 1. / 128, 1. / 128, 3. / 64, 4. / 64, 1.0, 1. / 32});
        // a laptop that slept for two years: more steps than an int can count
        ask_clock(paper, answer, {.step = 1. / 64, .owed = 1. / 256, .most_steps = 8},
                  {std::ldexp(1.0, 26)});
    }

  private:
    template <class Answer>
    static void ask_clock(Paper& paper, const Answer& answer, GameClock clock,
                          const std::vector<double>& frame_times) {
        for (const double frame_time : frame_times) {
            const double owed = clock.owed;
            paper.input("frame_time", frame_time, "clock.step", clock.step, "clock.owed", owed,
                        "clock.most_steps", clock.most_steps);
            const int steps = answer(clock, frame_time);
            paper.output("the number of steps", steps, 1);
            paper.changed("clock.owed afterwards [s]", clock.owed, owed, clock.step);
        }
    }

  public:
#ifndef NUTSHELL_SHEET
    static About<StepsDue> about() {
        return {
            .title = "How many steps a frame owes",
            .hints = {"The clock remembers in owed what earlier frames left over. This frame's "
                      "time comes on top of it.",
                      "Only whole steps can be made. What is less than a step stays owed for the "
                      "next frame.",
                      "Add the frame's time to owed; the whole steps in it are due, and their "
                      "time is paid, even if most_steps lets you make fewer of them."},
            .picture = "game_loop.png",
            .mistakes =
                {{"no memory of earlier frames", "classic",
                  "At 60 frames a second the game runs slower than the clock; at 144 it "
                  "stands "
                  "still.",
                  "You count the whole steps of this frame alone and forget the rest. Add "
                  "the "
                  "frame's time to clock.owed, and leave there what is less than a step.",
                  [](GameClock& clock, double frame_time) -> int {
                      clock.owed = 0;
                      return at_most(clock, std::floor(frame_time / clock.step));
                  }},
                 {"the rest forgotten", "classic: the accumulator dropped each frame",
                  "The game runs a little slower than the clock, by another part at every "
                  "frame "
                  "rate.",
                  "You set clock.owed to zero after counting. What is less than a step must "
                  "stay "
                  "owed, or time is lost in every frame.",
                  [](GameClock& clock, double frame_time) -> int {
                      clock.owed += frame_time;
                      const double due = std::floor(clock.owed / clock.step);
                      clock.owed = 0;
                      return at_most(clock, due);
                  }},
                 {"rounded to the nearest", "classic",
                  "The picture jerks back: at times the physics is ahead of the clock.",
                  "You round to the nearest whole number of steps, so a step is made before "
                  "its "
                  "time has come. Round down: only time that has passed can be paid.",
                  [](GameClock& clock, double frame_time) -> int {
                      clock.owed += frame_time;
                      const double due = std::max(0.0, std::round(clock.owed / clock.step));
                      clock.owed -= due * clock.step;
                      return at_most(clock, due);
                  }},
                 {"rounded up", "classic",
                  "The physics is always ahead of the clock, and drawing between two states "
                  "looks into the future.",
                  "You round up, so the last step is made before its time has come. Round "
                  "down.",
                  [](GameClock& clock, double frame_time) -> int {
                      clock.owed += frame_time;
                      const double due = std::max(0.0, std::ceil(clock.owed / clock.step));
                      clock.owed -= due * clock.step;
                      return at_most(clock, due);
                  }},
                 {"no limit", "classic: the spiral of death",
                  "After one slow frame the next is slower still, until the game freezes.",
                  "You never make fewer steps than are due. Beyond clock.most_steps the "
                  "surplus "
                  "must be dropped.",
                  [](GameClock& clock, double frame_time) -> int {
                      clock.owed += frame_time;
                      const double due = std::floor(clock.owed / clock.step);
                      clock.owed -= due * clock.step;
                      return static_cast<int>(due);
                  }},
                 {"the surplus kept for later", "classic: the spiral of death, slowly",
                  "After a long frame the game runs at its limit for seconds, in fast "
                  "motion.",
                  "You keep owing the steps beyond clock.most_steps, so the debt is carried "
                  "on. "
                  "Beyond the limit time is dropped: only what is less than a step stays "
                  "owed.",
                  [](GameClock& clock, double frame_time) -> int {
                      clock.owed += frame_time;
                      const int due = at_most(clock, std::floor(clock.owed / clock.step));
                      clock.owed -= due * clock.step;
                      return due;
                  }},
                 {"steps never paid", "classic",
                  "The game runs faster and faster until every frame is at the limit.",
                  "You count the steps but leave their time in clock.owed, so it is counted "
                  "again in every frame. Take the time of the steps off.",
                  [](GameClock& clock, double frame_time) -> int {
                      clock.owed += frame_time;
                      return at_most(clock, std::floor(clock.owed / clock.step));
                  }},
                 {"the cast before the limit", "classic: more than an int holds",
                  "When the laptop wakes from a long sleep, the game asks for a negative number "
                  "of steps.",
                  "You turn the number of steps into an int and limit it then. After a very long "
                  "frame no "
                  "int can hold it: limit it first, as a double, and cast what is left.",
                  [](GameClock& clock, double frame_time) -> int {
                      clock.owed += frame_time;
                      const double due = std::floor(clock.owed / clock.step);
                      clock.owed -= due * clock.step;
                      return std::min(static_cast<int>(due), clock.most_steps);
                  }},
                 {"the fraction dropped with the surplus", "classic",
                  "After every long frame the picture jumps by a part of a step.",
                  "Where the limit is reached you set clock.owed to zero. Only whole steps are "
                  "dropped; the fraction of a step stays owed.",
                  [](GameClock& clock, double frame_time) -> int {
                      clock.owed += frame_time;
                      double due = std::floor(clock.owed / clock.step);
                      if (due > clock.most_steps)
                          due = clock.most_steps, clock.owed = 0;
                      else
                          clock.owed -= due * clock.step;
                      return static_cast<int>(due);
                  }},
                 {"the frame's time is not booked", "classic",
                  "The game runs backwards in its own books: owed falls below zero.",
                  "You count the steps of old and new time together, but the new time is never "
                  "added to clock.owed.",
                  [](GameClock& clock, double frame_time) -> int {
                      const double due = std::floor((clock.owed + frame_time) / clock.step);
                      clock.owed -= due * clock.step;
                      return at_most(clock, due);
                  }},
                 {"the rest is kept and never spent", "classic",
                  "At 144 frames a second the game stands still, although time is owed.",
                  "You count the steps in this frame's time alone. The rest goes into "
                  "clock.owed, but nobody looks for whole steps there.",
                  [](GameClock& clock, double frame_time) -> int {
                      const double due = std::floor(frame_time / clock.step);
                      clock.owed += frame_time - due * clock.step;
                      return at_most(clock, due);
                  }},
                 {"the earlier rest overwritten", "classic",
                  "The game runs a little slower than the clock.",
                  "You put this frame's time into clock.owed in place of what was there. Add it: "
                  "+=.",
                  [](GameClock& clock, double frame_time) -> int {
                      clock.owed = frame_time;
                      const double due = std::floor(clock.owed / clock.step);
                      clock.owed -= due * clock.step;
                      return at_most(clock, due);
                  }},
                 {"a step only when more than one is owed", "classic",
                  "At a frame rate that is a multiple of the step's, every other step comes "
                  "late.",
                  "You compare by > where >= belongs: a step that is just due is due.",
                  [](GameClock& clock, double frame_time) -> int {
                      clock.owed += frame_time;
                      const double due = std::max(0.0, std::ceil(clock.owed / clock.step) - 1);
                      clock.owed -= due * clock.step;
                      return at_most(clock, due);
                  }},
                 {"the limit on the time owed", "classic",
                  "After a long frame the drawing jerks.",
                  "You cut clock.owed at most_steps steps, and with it the fraction of a step. "
                  "The fraction stays.",
                  [](GameClock& clock, double frame_time) -> int {
                      clock.owed =
                          std::min(clock.owed + frame_time, clock.most_steps * clock.step);
                      const double due = std::floor(clock.owed / clock.step);
                      clock.owed -= due * clock.step;
                      return at_most(clock, due);
                  }},
                 {"the frame's time cut before it is booked", "classic: a clamp on dt",
                  "After every long frame the picture jumps by a part of a step.",
                  "You cut the frame's time at most_steps steps before you add it. What you cut "
                  "off need not be a whole number of steps: the fraction in it should stay owed.",
                  [](GameClock& clock, double frame_time) -> int {
                      clock.owed += std::min(frame_time, clock.most_steps * clock.step);
                      const double due = std::floor(clock.owed / clock.step);
                      clock.owed -= due * clock.step;
                      return at_most(clock, due);
                  }},
                 {"the frame's time cut at a quarter of a second",
                  "classic: the guard of many game loops",
                  "After a very long frame the picture jumps by a part of a step.",
                  "You cut long frames at a quarter of a second before you add them. What you "
                  "cut off need not be a whole number of steps: the fraction in it should stay "
                  "owed.",
                  [](GameClock& clock, double frame_time) -> int {
                      clock.owed += std::min(frame_time, 0.25);
                      const double due = std::floor(clock.owed / clock.step);
                      clock.owed -= due * clock.step;
                      return at_most(clock, due);
                  }}},
            .alternatives = {{"one by one up to the limit",
                              [](GameClock& clock, double frame_time) -> int {
                                  clock.owed += frame_time;
                                  int steps = 0;
                                  while (clock.owed >= clock.step && steps < clock.most_steps)
                                      clock.owed -= clock.step, ++steps;
                                  clock.owed = std::fmod(clock.owed, clock.step);
                                  return steps;
                              }}},
            .survivors = {{"fraction cut off, 2", "floor leaves none"}},
        };
    }
#endif
};

inline const bool steps_due_entered = enter<StepsDue>();

}  // namespace nutshell::exercises
