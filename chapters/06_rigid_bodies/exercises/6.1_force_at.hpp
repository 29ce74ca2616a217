// Exercise 6.1: what a force at the end of a lever arm does to a body.
#pragma once
#include <nutshell/body.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct ForceAt {
    static constexpr const char *id = "6.1", *function = "force_at";
    static constexpr auto subject = NUTSHELL_CALL(force_at);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Vector3 u(3, -10, 4), v(-2, 5, 7), a(0.6, 1.1, -0.8), b(1.3, -0.4, 0.5);
        ask_one(paper, answer, u, a);
        ask_one(paper, answer, v, a);
        ask_one(paper, answer, u, b);
        ask_one(paper, answer, Vector3(2 * a), a);  // along the arm
    }

  private:
    template <class Answer>
    static void ask_one(Paper& paper, const Answer& answer, const Vector3& force,
                        const Vector3& arm) {
        paper.input("force", force, "arm", arm);
        const Wrench push = answer(force, arm);
        paper.output("the force [N]", push.force, force);
        paper.output("the torque [N m]", push.torque, force.norm() * arm.norm());
    }

  public:
#ifndef NUTSHELL_SHEET
    static About<ForceAt> about() {
        return {
            .title = "What a lever does",
            .hints = {"A wrench holds two vectors. The force goes into it as it is; which vector "
                      "is perpendicular to both arm and force?",
                      "Equation (42). The order of the two factors says which way it turns: an "
                      "arm to the right and a force upwards turn counter-clockwise.",
                      "A vector's .cross takes the second factor. Hand back the two vectors "
                      "between braces, the force first."},
            .picture = "torque.svg",
            .mistakes =
                {{"the factors exchanged", "classic", "A door that is pushed open slams shut.",
                  "Your torque is that of the opposite turn: the arm comes first in (42).",
                  [](const Vector3& force, const Vector3& arm) -> Wrench {
                      return {force, force.cross(arm)};
                  }},
                 {"the printed cross product", "E49",
                  "A wheel that is pushed at its rim leaves its plane.",
                  "The third component is wrong: its last factor is the x of the force, not the "
                  "z.",
                  [](const Vector3& force, const Vector3& arm) -> Wrench {
                      Vector3 torque = arm.cross(force);
                      torque[2] = arm[0] * force[1] - arm[1] * force[2];
                      return {force, torque};
                  }},
                 {"force times length of the arm", "classic: the direction forgotten",
                  "Every push turns a body as if it came from the side, even one at its centre "
                  "line.",
                  "You multiply the force by the arm's length. That points along the force; a "
                  "torque points along the axis, and only the part of the force across the arm "
                  "counts.",
                  [](const Vector3& force, const Vector3& arm) -> Wrench {
                      return {force, arm.norm() * force};
                  }},
                 {"the arm made as long as one", "classic",
                  "A long spanner is no better than a short one.",
                  "You use the direction of the arm only. Its length is what makes it a lever.",
                  [](const Vector3& force, const Vector3& arm) -> Wrench {
                      return {force, arm.normalized().cross(force)};
                  }},
                 {"no force left", "classic: a force off the centre only turns",
                  "A ball that is hit off its centre spins and stays where it is.",
                  "The torque is right, but the force is gone. A force off the centre does both: "
                  "it pushes the whole body, and it turns it.",
                  [](const Vector3& force, const Vector3& arm) -> Wrench {
                      return {Vector3::Zero(), arm.cross(force)};
                  }},
                 {"only the force across the arm", "classic",
                  "A rope that pulls along the arm does not pull at all.",
                  "You take away the part of the force that points along the arm. It turns "
                  "nothing, but it still pushes.",
                  [](const Vector3& force, const Vector3& arm) -> Wrench {
                      const Vector3 n = arm.normalized(), across = force - n * n.dot(force);
                      return {across, arm.cross(force)};
                  }}},
            .alternatives = {{"written out",
                              [](const Vector3& F, const Vector3& r) -> Wrench {
                                  return {F,
                                          {r.y() * F.z() - r.z() * F.y(),
                                           r.z() * F.x() - r.x() * F.z(),
                                           r.x() * F.y() - r.y() * F.x()}};
                              }},
                             {"by the other order and a minus",
                              [](const Vector3& force, const Vector3& arm) -> Wrench {
                                  Wrench push;
                                  push.force = force;
                                  push.torque = -force.cross(arm);
                                  return push;
                              }}},
        };
    }
#endif
};

inline const bool force_at_entered = enter<ForceAt>();

}  // namespace nutshell::exercises
