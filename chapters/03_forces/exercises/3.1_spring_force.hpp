// Exercise 3.1: the force of a spring.
#pragma once
#include <nutshell/forces.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct SpringForce {
    static constexpr const char *id = "3.1", *function = "spring_force";
    static constexpr auto subject = NUTSHELL_CALL(spring_force);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Vector3 end{1.3, -0.4, 2.2}, near{0.9, 0.1, 1.7}, far{-2.1, 3.4, 0.3};
        ask_one(paper, answer, {12.5, 1.6}, end, far);   // longer than at rest: pulls
        ask_one(paper, answer, {12.5, 1.6}, end, near);  // shorter: pushes
        ask_one(paper, answer, {3.5, 0}, end, far);
        ask_one(paper, answer, {3.5, 1.6}, end, far);
        ask_one(paper, answer, {12.5, 1.6}, near, far);
        ask_one(paper, answer, {12.5, 1.6}, end,
                end + Vector3(6e-7, 0, -8e-7));  // nearly meet: it pushes with all its might
        ask_one(paper, answer, {12.5, 1.6}, end, end);  // the ends meet
    }

  private:
    template <class Answer>
    static void ask_one(Paper& paper, const Answer& answer, const Spring& spring,
                        const Vector3& end, const Vector3& other_end) {
        paper.input("stiffness", spring.stiffness, "rest length", spring.rest_length, "end", end,
                    "other end", other_end);
        const Vector3 force = answer(spring, end, other_end);
        paper.output("the force on the end [N]", force, spring.stiffness * spring.rest_length,
                     Vector3(spring.stiffness * (end - other_end)));
    }

  public:
#ifndef NUTSHELL_SHEET
    static About<SpringForce> about() {
        return {
            .title = "The force of a spring",
            .hints = {"Draw the two ends and an arrow from the other end to this one. Along it "
                      "the spring pushes or pulls; what decides which?",
                      "The strength is the stiffness times how much the length differs from the "
                      "rest length; the direction is a vector of length one. What if there is no "
                      "direction?",
                      "Take the difference of the ends and its norm. For a norm of zero answer "
                      "with no force; else stiffness times (rest length minus length), along the "
                      "difference over its norm."},
            .mistakes =
                {{"no guard where the ends meet", "E08: the source's eq. (18)",
                  "Two particles meet, and from that step on everything is NaN and vanishes.",
                  "Where both ends are at one place you divide zero by zero. A spring without a "
                  "direction has no force there: test the length first.",
                  [](const Spring& spring, const Vector3& end,
                     const Vector3& other_end) -> Vector3 {
                      const Vector3 d = end - other_end;
                      return spring.stiffness * (spring.rest_length - d.norm()) / d.norm() * d;
                  }},
                 {"the wrong sign", "classic",
                  "The spring flies apart: the longer it is, the harder it pushes.",
                  "The force has the right size and the wrong direction: a long spring must pull "
                  "its end towards the other end.",
                  [](const Spring& spring, const Vector3& end, const Vector3& other_end)
                      -> Vector3 { return -spring_force(spring, end, other_end); }},
                 {"no rest length", "classic", "The rope contracts to a point.",
                  "You pull in proportion to the length. It is the length beyond the rest length "
                  "that counts.",
                  [](const Spring& spring, const Vector3& end, const Vector3& other_end)
                      -> Vector3 { return -spring.stiffness * (end - other_end); }},
                 {"a direction that is not of length one", "classic: forgot to normalise",
                  "Long springs are far too strong and short ones too weak.",
                  "You multiply by the difference of the ends, whose length is not one. Divide "
                  "by its norm.",
                  [](const Spring& spring, const Vector3& end,
                     const Vector3& other_end) -> Vector3 {
                      const Vector3 d = end - other_end;
                      return spring.stiffness * (spring.rest_length - d.norm()) * d;
                  }},
                 {"a rope, not a spring", "classic", "A compressed spring does nothing.",
                  "When it is shorter than its rest length, a spring pushes. You give no force "
                  "there; that is a rope.",
                  [](const Spring& spring, const Vector3& end,
                     const Vector3& other_end) -> Vector3 {
                      if ((end - other_end).norm() < spring.rest_length) return Vector3::Zero();
                      return spring_force(spring, end, other_end);
                  }},
                 {"half the force", "classic: the energy's 1/2",
                  "Everything swings too slowly, by a factor of the root of two.",
                  "The 1/2 belongs to the spring's energy. Its force is the slope of the energy, "
                  "and there the 1/2 is gone.",
                  [](const Spring& spring, const Vector3& end, const Vector3& other_end)
                      -> Vector3 { return spring_force(spring, end, other_end) / 2; }},
                 {"it always pulls", "classic: an abs too many", "A compressed spring collapses.",
                  "You take the size of the stretch. Its sign says whether the spring pulls or "
                  "pushes.",
                  [](const Spring& spring, const Vector3& end,
                     const Vector3& other_end) -> Vector3 {
                      const Vector3 d = end - other_end;
                      const double length = d.norm();
                      if (length == 0) return Vector3::Zero();
                      return -spring.stiffness * std::abs(length - spring.rest_length) / length *
                             d;
                  }},
                 {"the rest length taken from every component", "classic: a number from a vector",
                  "The spring pulls towards a corner of the world.",
                  "You take the rest length from x, y and z alike. It is a length: take it from "
                  "the length, and go along the direction.",
                  [](const Spring& spring, const Vector3& end,
                     const Vector3& other_end) -> Vector3 {
                      const Vector3 d = end - other_end;
                      if (d.norm() == 0) return Vector3::Zero();
                      return -spring.stiffness * (d - Vector3::Constant(spring.rest_length));
                  }},
                 {"divided by the rest length", "classic",
                  "Springs get stiffer the longer they are.",
                  "You divide the difference of the ends by the rest length. Its own length "
                  "makes it a direction.",
                  [](const Spring& spring, const Vector3& end,
                     const Vector3& other_end) -> Vector3 {
                      const Vector3 d = end - other_end;
                      const double l = d.norm();
                      if (l == 0) return Vector3::Zero();
                      return spring.stiffness * (spring.rest_length - l) / spring.rest_length * d;
                  }},
                 {"the stretch relative to the rest length", "classic",
                  "Short springs are too strong.",
                  "The stiffness is in N/m: it wants the stretch in metres, not as a part of the "
                  "rest length.",
                  [](const Spring& spring, const Vector3& end,
                     const Vector3& other_end) -> Vector3 {
                      const Vector3 d = end - other_end;
                      const double l = d.norm();
                      if (l == 0) return Vector3::Zero();
                      return spring.stiffness * (spring.rest_length - l) / spring.rest_length *
                             d / l;
                  }},
                 {"the square of the stretch", "classic", "Springs break loose.",
                  "You square the stretch: that belongs to the energy. The force grows with the "
                  "stretch itself.",
                  [](const Spring& spring, const Vector3& end,
                     const Vector3& other_end) -> Vector3 {
                      const Vector3 d = end - other_end;
                      const double l = d.norm();
                      if (l == 0) return Vector3::Zero();
                      return -spring.stiffness * (l - spring.rest_length) *
                             (l - spring.rest_length) * d / l;
                  }},
                 {"at rest where the ends meet only", "classic",
                  "Springs pull as if they had no rest length.",
                  "You add where you must subtract: the stretch is the length less the rest "
                  "length.",
                  [](const Spring& spring, const Vector3& end,
                     const Vector3& other_end) -> Vector3 {
                      const Vector3 d = end - other_end;
                      const double l = d.norm();
                      if (l == 0) return Vector3::Zero();
                      return -spring.stiffness * (l + spring.rest_length) * d / l;
                  }},
                 {"the rest length taken from every component", "classic: a number from a vector",
                  "A slanting spring has another strength, and pulls askew.",
                  "You take the rest length from x, y and z alike. It is a length: take it from "
                  "the length, and go along the direction.",
                  [](const Spring& spring, const Vector3& end,
                     const Vector3& other_end) -> Vector3 {
                      const Vector3 d = end - other_end;
                      return -spring.stiffness *
                             (d - spring.rest_length * d.array().sign().matrix());
                  }}},
            .alternatives =
                {{"by a unit vector",
                  [](const Spring& spring, const Vector3& end,
                     const Vector3& other_end) -> Vector3 {
                      const Vector3 towards =
                          (other_end - end).normalized();  // Eigen gives zero for zero
                      return spring.stiffness * ((end - other_end).norm() - spring.rest_length) *
                             towards;
                  }}},
            .survivors = {{"result to int", "zero has no fraction"}},
        };
    }
#endif
};

inline const bool spring_force_entered = enter<SpringForce>();

}  // namespace nutshell::exercises
