// Exercise 5.1: how fast a point of a spinning body is, where the source's (37) forgets the pose.
#pragma once
#include <nutshell/spinning.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct PointVelocity {
    static constexpr const char *id = "5.1", *function = "point_velocity";
    static constexpr auto subject = NUTSHELL_CALL(point_velocity);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Quaternion a = Quaternion(0.4, 0.3, -0.5, 0.7).normalized(),
                         b = Quaternion(0.9, -0.6, 0.2, 0.1).normalized();
        const Vector3 u(0.9, -1.4, 2.3), v(-1.7, 0.6, 0.8), p(0.7, 1.2, -0.4), r(-0.3, 0.5, 1.6);
        ask_one(paper, answer, u, a, p);
        ask_one(paper, answer, v, a, p);
        ask_one(paper, answer, u, b, p);
        ask_one(paper, answer, u, a, r);
    }

  private:
    template <class Answer>
    static void ask_one(Paper& paper, const Answer& answer, const Vector3& omega,
                        const Quaternion& pose, const Vector3& p) {
        paper.input("omega", omega, "pose", pose, "p", p);
        paper.frame(pose);
        const Vector3 velocity = answer(omega, pose, p);
        paper.output("the velocity [m/s]", velocity, omega.norm() * p.norm());
    }

  public:
#ifndef NUTSHELL_SHEET
    static About<PointVelocity> about() {
        return {
            .title = "How fast a point is",
            .hints = {"The formula wants the point where it is now, in the world. Which of your "
                      "three arguments is not given in the world's axes?",
                      "Turn p with the pose first. Then the angular velocity, crossed with that, "
                      "in this order.",
                      "rotate(pose, p) is the point in the world; a vector's .cross takes the "
                      "second factor."},
            .picture = "rolling.png",
            .mistakes =
                {{"the point where it began", "E22",
                  "Sparks fly from a grinding wheel in a fixed direction, whatever point it is.",
                  "You cross omega with p as it is in the body. The velocity belongs to the "
                  "point "
                  "where it is now: turn p with the pose first.",
                  [](const Vector3& omega, const Quaternion&, const Vector3& p) -> Vector3 {
                      return omega.cross(p);
                  }},
                 {"the factors exchanged", "classic", "Everything flies off backwards.",
                  "The cross product changes sign with the order: it is omega times the point.",
                  [](const Vector3& omega, const Quaternion& pose, const Vector3& p) -> Vector3 {
                      return (pose * p).cross(omega);
                  }},
                 {"omega taken for the body's", "E20: the frame is not said",
                  "Only bodies that are turned throw their sparks the wrong way.",
                  "You cross in the body's axes and turn the result. omega is given in the "
                  "world's.",
                  [](const Vector3& omega, const Quaternion& pose, const Vector3& p) -> Vector3 {
                      return pose * Vector3(omega.cross(p));
                  }},
                 {"turned the wrong way", "E51: the transposed rotation",
                  "The faster side of a rolling ball is the wrong one.",
                  "You turn p by the inverse of the pose. The pose leads from the body to the "
                  "world.",
                  [](const Vector3& omega, const Quaternion& pose, const Vector3& p) -> Vector3 {
                      return omega.cross(pose.conjugate() * p);
                  }},
                 {"the printed cross product", "E49", "A point on the y axis moves by itself.",
                  "The third component is wrong: the last factor is the x of the point, not its "
                  "z.",
                  [](const Vector3& omega, const Quaternion& pose, const Vector3& p) -> Vector3 {
                      const Vector3 x = pose * p;
                      Vector3 v = omega.cross(x);
                      v[2] = omega[0] * x[1] - omega[1] * x[2];
                      return v;
                  }},
                 {"the point added", "classic", "Points at rest move.",
                  "You add the point's own place: that is where it is, not how fast.",
                  [](const Vector3& omega, const Quaternion& pose, const Vector3& p) -> Vector3 {
                      return omega.cross(rotate(pose, p)) + rotate(pose, p);
                  }},
                 {"omega turned, the point not", "classic",
                  "Only bodies that are turned throw their sparks the wrong way.",
                  "omega is in the world's axes already. It is the point that must be turned "
                  "into the world.",
                  [](const Vector3& omega, const Quaternion& pose, const Vector3& p) -> Vector3 {
                      return rotate(pose, omega).cross(p);
                  }},
                 {"number by number", "classic", "Sparks fly along the wrong axes.",
                  "You multiply component by component. A velocity stands at right angles to "
                  "both: the cross product.",
                  [](const Vector3& omega, const Quaternion& pose, const Vector3& p) -> Vector3 {
                      return omega.cwiseProduct(rotate(pose, p));
                  }},
                 {"along the arm", "classic: v = omega r",
                  "Sparks fly straight out from the axis.",
                  "omega r is the greatest speed, and no direction. A point goes at right angles "
                  "to its arm and to omega.",
                  [](const Vector3& omega, const Quaternion& pose, const Vector3& p) -> Vector3 {
                      return omega.norm() * (pose * p);
                  }}},
            .alternatives =
                {{"both in the body, the result turned",
                  [](const Vector3& omega, const Quaternion& pose, const Vector3& p) -> Vector3 {
                      return pose * Vector3((pose.conjugate() * omega).cross(p));
                  }},
                 {"written out",
                  [](const Vector3& omega, const Quaternion& pose, const Vector3& p) -> Vector3 {
                      const Vector3 x = pose.toRotationMatrix() * p;
                      return {omega[1] * x[2] - omega[2] * x[1],
                              omega[2] * x[0] - omega[0] * x[2],
                              omega[0] * x[1] - omega[1] * x[0]};
                  }}},
        };
    }
#endif
};

inline const bool point_velocity_entered = enter<PointVelocity>();

}  // namespace nutshell::exercises
