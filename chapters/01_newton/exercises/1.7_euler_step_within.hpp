// Exercise 1.7: the largest step that meets a tolerance.
#pragma once
#include <nutshell/newton.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

#ifndef NUTSHELL_SHEET
inline double whole_steps(double duration, double largest) {
    return duration / std::max(1.0, std::ceil(duration / largest));
}
#endif

struct EulerStepWithin {
    static constexpr const char *id = "1.7", *function = "euler_step_within";
    static constexpr auto subject = NUTSHELL_CALL(euler_step_within);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Vector3 slanted{1, -2, 3}, down{0, -9.81, 0};
        ask_one(paper, answer, 0.6, slanted, 2);          // 12.47 steps
        ask_one(paper, answer, 0.04, down, 3);            // 1103.6 steps
        ask_one(paper, answer, 0.25, slanted, 1.3);       // 12.65 steps
        ask_one(paper, answer, 0.25, slanted, 2.6);       // 50.6 steps
        ask_one(paper, answer, 0.25, {4, 1, -0.5}, 2.6);  // 55.9 steps
        ask_one(paper, answer, 50, slanted, 1.5);         // less than one step
        ask_one(paper, answer, 1, {0, -8, 0}, 2);         // 16 steps, and all is exact
        ask_one(paper, answer, 16, {0, 0, 8}, 2);         // one step, exactly
        ask_one(paper, answer, 0.1, Vector3::Zero(), 2.5);
    }

  private:
    template <class Answer>
    static void ask_one(Paper& paper, const Answer& answer, double tolerance,
                        const Vector3& acceleration, double duration) {
        paper.input("tolerance", tolerance, "acceleration", acceleration, "duration", duration);
        const double step = answer(tolerance, acceleration, duration);
        const double pull = acceleration.norm() * duration;
        paper.output("the step [s]", step,
                     pull > 0 ? std::min(duration, 2 * tolerance / pull) : duration);
    }

  public:
#ifndef NUTSHELL_SHEET
    static About<EulerStepWithin> about() {
        return {
            .title = "The step that meets a tolerance",
            .hints = {"Exercise 1.6 gives the error from the step. Here the error is given and "
                      "the step is asked for.",
                      "Set the length of Euler's error equal to the tolerance and solve for dt. "
                      "That is the largest step, but it need not divide the duration.",
                      "How many steps of the largest size fill the duration? Round that number "
                      "up, but never below one; the duration divided by it is the answer."},
            .mistakes =
                {{"half the step", "classic: the 2 lost",
                  "The game makes twice the steps it needs.",
                  "The error is a T dt/2: solved for dt there is a 2 above the line.",
                  [](double tolerance, const Vector3& acceleration, double duration) -> double {
                      return whole_steps(duration, tolerance / (acceleration.norm() * duration));
                  }},
                 {"a step that does not divide the duration", "classic",
                  "The last step jumps beyond the end, or stops short of it.",
                  "The largest step is right, but a whole number of steps must fill the "
                  "duration. Round the number of steps up.",
                  [](double tolerance, const Vector3& acceleration, double duration) -> double {
                      return 2 * tolerance / (acceleration.norm() * duration);
                  }},
                 {"rounded to the nearest number of steps", "classic",
                  "Now and then the error is a little above the tolerance.",
                  "You round the number of steps to the nearest. When that is down, the step is "
                  "too large: round up.",
                  [](double tolerance, const Vector3& acceleration, double duration) -> double {
                      return duration / std::max(1.0, std::round(duration * acceleration.norm() *
                                                                 duration / (2 * tolerance)));
                  }},
                 {"rounded the wrong way", "classic",
                  "The error is always a little above the tolerance.",
                  "You round the number of steps down, so the step becomes too large. Fewer "
                  "steps are larger steps: round up.",
                  [](double tolerance, const Vector3& acceleration, double duration) -> double {
                      return duration / std::max(1.0, std::floor(duration * acceleration.norm() *
                                                                 duration / (2 * tolerance)));
                  }},
                 {"the error of one step only", "E04: local for global error",
                  "The ball misses by far more than the tolerance.",
                  "You ask that a single step stays within the tolerance (a dt^2/2). The errors "
                  "of all T/dt steps add up to a T dt/2, and that must stay within it.",
                  [](double tolerance, const Vector3& acceleration, double duration) -> double {
                      return whole_steps(duration,
                                         std::sqrt(2 * tolerance / acceleration.norm()));
                  }},
                 {"a duration without steps", "classic: division by zero",
                  "With a weak force, or none, the step is infinite and every number after it is "
                  "lost.",
                  "When there is no force, the number of steps comes out as zero and you divide "
                  "by it. There is always at least one step.",
                  [](double tolerance, const Vector3& acceleration, double duration) -> double {
                      return duration / std::ceil(duration / (2 * tolerance /
                                                              (acceleration.norm() * duration)));
                  }},
                 {"one component for the length", "classic",
                  "A slanted pull misses by more than the tolerance.",
                  "You use the largest component of the acceleration. The error is a vector "
                  "along it, so its length is what must stay within the tolerance.",
                  [](double tolerance, const Vector3& acceleration, double duration) -> double {
                      return whole_steps(
                          duration,
                          2 * tolerance / (acceleration.cwiseAbs().maxCoeff() * duration));
                  }},
                 {"the duration left out", "classic",
                  "A short throw meets the tolerance, a long one does not.",
                  "The error grows with the duration (a T dt/2), so the largest step must shrink "
                  "with it.",
                  [](double tolerance, const Vector3& acceleration, double duration) -> double {
                      return whole_steps(duration, 2 * tolerance / acceleration.norm());
                  }},
                 {"one step too many where it comes out even", "classic: floor and one more",
                  "Now and then one step more than it needs.",
                  "You round down and add one. Where the number of steps comes out even that is "
                  "one too many: round up.",
                  [](double tolerance, const Vector3& acceleration, double duration) -> double {
                      return duration / (std::floor(acceleration.norm() * duration * duration /
                                                    (2 * tolerance)) +
                                         1);
                  }},
                 {"the y component for the length", "classic: gravity points down",
                  "A throw in the wind misses by more than the tolerance.",
                  "You use the y component of the acceleration. Its length is what the error "
                  "grows with: .norm().",
                  [](double tolerance, const Vector3& acceleration, double duration) -> double {
                      return duration / std::max(1.0, std::ceil(acceleration.y() * duration *
                                                                duration / (2 * tolerance)));
                  }},
                 {"cut at the duration only", "classic",
                  "The last step jumps beyond the end, or stops short of it.",
                  "You take the duration where the step is longer. Also below it the step must "
                  "divide the duration into whole steps: round their number up.",
                  [](double tolerance, const Vector3& acceleration, double duration) -> double {
                      return std::min(duration, 2 * tolerance / (acceleration.norm() * duration));
                  }},
                 {"the vertical part for the length", "classic: gravity points down",
                  "A throw in the wind misses by more than the tolerance.",
                  "You use the size of the acceleration's y component. The error is a vector "
                  "along all of it: its length is what must stay within the tolerance.",
                  [](double tolerance, const Vector3& acceleration, double duration) -> double {
                      return duration /
                             std::max(1.0, std::ceil(std::abs(acceleration.y()) * duration *
                                                     duration / (2 * tolerance)));
                  }},
                 {"whole steps a second", "classic: frames per second",
                  "The last step jumps beyond the end, or stops short of it.",
                  "You round to a whole number of steps in a second. It is the duration that "
                  "must be filled by whole steps: round the number that fits into it.",
                  [](double tolerance, const Vector3& acceleration, double duration) -> double {
                      return 1 / std::max(1.0, std::ceil(acceleration.norm() * duration /
                                                         (2 * tolerance)));
                  }}},
            .alternatives = {{"by trying",
                              [](double tolerance, const Vector3& acceleration,
                                 double duration) -> double {
                                  int steps = 1;
                                  while (throw_error(Kicked::after_drift, acceleration, duration,
                                                     duration / steps)
                                             .norm() > tolerance)
                                      ++steps;
                                  return duration / steps;
                              }}},
            .survivors = {{"acceleration.x and y swapped", "only its length is used"},
                          {"acceleration.y and z swapped", "only its length is used"},
                          {"acceleration.z and x swapped", "only its length is used"},
                          {"fraction cut off", "ceil leaves none"}},
        };
    }
#endif
};

inline const bool euler_step_within_entered = enter<EulerStepWithin>();

}  // namespace nutshell::exercises
