// Exercise 5.4: one step of a spin by the exponential.
#pragma once
#include <nutshell/euler_angles.hpp>
#include "spins.hpp"

namespace nutshell::exercises {

struct ExponentialMap {
    static constexpr const char *id = "5.4", *function = "exponential_map";
    static constexpr auto subject = NUTSHELL_CALL(exponential_map);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        ask_spin(paper, answer, 0.6);
        const Quaternion q = Quaternion(0.4, 0.3, -0.5, 0.7).normalized();
        paper.input("q", q, "a body that does not spin, dt", paper.step(0.2));
        const Quaternion same = answer(q, Wobble{0, 0}, 0.6, paper.step(0.2));
        paper.output("the pose", same, 1.0);
    }

#ifndef NUTSHELL_SHEET
    static About<ExponentialMap> about() {
        return {
            .title = "A step by the exponential",
            .hints = {"For the time of one step the angular velocity is taken as it is at the "
                      "start. Which rotation vector does the body turn by?",
                      "The exponential makes a turn of a rotation vector; the product puts it "
                      "after the pose. On which side, for the world's axes?",
                      "Ask spin for omega at q and t, multiply by dt, and put the exponential of "
                      "that to the left of q."},
            .order = 1,
            .picture = "wheel.png",
            .mistakes =
                {{"about the body's axes", "E20: the wrong side",
                  "A tilted drone turns about a tilted axis when told to yaw.",
                  "You put the turn on the right of q, where its axis is read in the body. omega "
                  "is in the world's axes: left.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return q * exp_of(spin(q, t) * dt);
                  }},
                 {"to first order", "E18, E20",
                  "A wheel at 20 turns a second loses every fourth.",
                  "You make the first-order step (32*). It is late by omega dt less 2 atan(omega "
                  "dt/2) every time; the exponential is not.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return Quaternion(q.coeffs() +
                                        (four_vector(spin(q, t) * dt, 0) * q).coeffs() / 2)
                          .normalized();
                  }},
                 {"three angles plus omega dt", "classic: Euler angles as if they were positions",
                  "Fine while the plane flies level along z; when it flies along x, what should "
                  "roll it pitches it.",
                  "You add the parts of omega dt to yaw, pitch and roll. Their axes are not the "
                  "world's, nor at right angles.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      EulerAngles angles = euler_angles(q);
                      const Vector3 turn = spin(q, t) * dt;
                      angles.pitch += turn.x(), angles.yaw += turn.y(), angles.roll += turn.z();
                      return orientation_of(angles);
                  }},
                 {"half of the turn", "classic", "Everything spins at half its speed.",
                  "The exponential halves the angle by itself. Give it omega dt, all of it.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return exp_of(spin(q, t) * (dt / 2)) * q;
                  }},
                 {"the turn back", "E51: the source's class Rotation",
                  "Everything spins the other way.", "You turn by -omega dt.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return exp_of(spin(q, t) * -dt) * q;
                  }},
                 {"the time of the step's end", "classic", "Pushes act one step too early.",
                  "You ask for the angular velocity at t + dt. The step starts at t.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return exp_of(spin(q, t + dt) * dt) * q;
                  }},
                 {"the time of the step's middle", "classic",
                  "A better method for a spin that follows the clock, and not the one asked for.",
                  "You ask for the angular velocity at t + dt/2. This step takes that of its "
                  "start.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return product(exponential(spin(q, t + dt / 2) * dt), q);
                  }},
                 {"the step's time forgotten", "classic", "Everything spins wildly.",
                  "You turn by omega itself. The angle is omega times dt.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return product(exponential(spin(q, t) + 0 * dt * spin(q, t)), q);
                  }},
                 {"the turn alone", "classic", "Everything jumps back to where it began.",
                  "You return the turn of this step alone. It comes on top of q.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return exponential(spin(q, t) * dt);
                  }}},
            .alternatives =
                {{"about the body's axes, with omega turned into them",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return q * exp_of(q.conjugate() * Vector3(spin(q, t) * dt));
                  }},
                 {"axis and angle",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const Vector3 omega = spin(q, t);
                      return Quaternion(
                                 Eigen::AngleAxisd(omega.norm() * dt, omega.normalized())) *
                             q;
                  }}},
        };
    }
#endif
};

inline const bool exponential_map_entered = enter<ExponentialMap>();

}  // namespace nutshell::exercises
