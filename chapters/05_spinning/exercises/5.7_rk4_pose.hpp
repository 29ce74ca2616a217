// Exercise 5.7: chapter 3's rk4 on the four numbers of a pose.
#pragma once
#include "spins.hpp"

namespace nutshell::exercises {

struct Rk4Pose {
    static constexpr const char *id = "5.7", *function = "rk4_pose";
    static constexpr auto subject = NUTSHELL_CALL(rk4_pose);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        ask_spin(paper, answer, 0.6);
        const Quaternion q = Quaternion(0.4, 0.3, -0.5, 0.7).normalized();
        const double large = paper.step(0.8);  // where the stages are not of length one
        paper.input("q", q, "t", 0.6, "dt", large, "how far spin swings", 1.0);
        paper.frame(q);
        const Quaternion far = answer(q, Wobble{0.6}, 0.6, large);
        paper.output("the pose", far, 1.0);
    }

#ifndef NUTSHELL_SHEET
    using Flat = Eigen::Vector4d;
    template <class Rate>
    static Quaternion runge_kutta(const Quaternion& q, double t, double dt, const Rate& rate) {
        const Flat y = q.coeffs(), k1 = rate(y, t), k2 = rate(Flat(y + dt / 2 * k1), t + dt / 2),
                   k3 = rate(Flat(y + dt / 2 * k2), t + dt / 2),
                   k4 = rate(Flat(y + dt * k3), t + dt);
        return Quaternion(Flat(y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)));
    }
    static Flat rate_of(const Vector3& omega, const Quaternion& pose) {
        return (four_vector(omega, 0) * pose).coeffs() / 2;
    }
    static About<Rk4Pose> about() {
        return {
            .title = "Runge and Kutta turn",
            .hints =
                {"rk4 knows only a list of numbers and its rate. What is the rate of the four "
                 "numbers of q while the body turns with omega?",
                 "Take (32), less q, over dt: half of the product of (omega, 0) with q. omega "
                 "must be asked for the pose and the time that rk4 is at.",
                 "Write the rate as a function of a flat y and a time: make a Quaternion of "
                 "y, ask spin there, and hand back half of vector_product's coefficients."},
            .order = 4,
            .picture = "coning.svg",
            .mistakes =
                {{"the half forgotten", "classic", "Everything turns twice as fast.",
                  "q knows half of the angle: its rate is half of the product.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return runge_kutta(q, t, dt, [&](const Flat& y, double now) {
                          const Quaternion pose(y);
                          return Flat(2 * rate_of(spin(pose, now), pose));
                      });
                  }},
                 {"about the body's axes", "E20: the wrong side",
                  "A tilted body turns about a tilted axis.",
                  "(omega, 0) stands on the right of q. omega is in the world's axes: left.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return runge_kutta(q, t, dt, [&](const Flat& y, double now) {
                          const Quaternion pose(y);
                          return Flat((pose * four_vector(spin(pose, now), 0)).coeffs() / 2);
                      });
                  }},
                 {"the start's angular velocity four times", "classic: omega asked once",
                  "Four times the work for first order.",
                  "You ask for the angular velocity once, at the start. Each of the four rates "
                  "wants its own.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const Vector3 omega = spin(q, t);
                      return runge_kutta(q, t, dt, [&](const Flat& y, double) {
                          return Flat(rate_of(omega, Quaternion(y)));
                      });
                  }},
                 {"the start's time four times", "classic",
                  "Spins that follow the clock are late.",
                  "You ask for the right pose but always for the time t.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return runge_kutta(q, t, dt, [&](const Flat& y, double) {
                          const Quaternion pose(y);
                          return Flat(rate_of(spin(pose, t), pose));
                      });
                  }},
                 {"the rows of (31) as printed", "E19",
                  "The body turns about a wrong axis and sticks.",
                  "The scalar's row stands first in the printed (31); q keeps its scalar last.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return runge_kutta(q, t, dt, [&](const Flat& y, double now) {
                          const Quaternion pose(y);
                          const Flat r = rate_of(spin(pose, now), pose);
                          return Flat(r[3], r[0], r[1], r[2]);
                      });
                  }},
                 {"four numbers in another order", "classic", "Poses jump.",
                  "Eigen's constructor takes w first, but coeffs() keeps it last: make the pose "
                  "from the four numbers as a vector.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const auto rate = [&](const Eigen::Vector4d& y,
                                            [[maybe_unused]] double now) {
                          const Quaternion p(y[0], y[1], y[2], y[3]);
                          return Eigen::Vector4d((Quaternion(0, spin(p, now).x(),
                                                             spin(p, now).y(), spin(p, now).z()) *
                                                  p)
                                                     .coeffs() /
                                                 2);
                      };
                      return Quaternion(rk4(Eigen::Vector4d(q.coeffs()), rate, t, dt));
                  }},
                 {"the start's pose four times", "classic",
                  "Right for a spin that follows the clock, not for one that follows the body.",
                  "You ask spin for the pose of the start each time. Each of the four rates "
                  "wants its own.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const auto rate = [&](const Eigen::Vector4d& y,
                                            [[maybe_unused]] double now) {
                          const Quaternion p(y);
                          const Vector3 o = spin(q, now);
                          return Eigen::Vector4d(
                              (Quaternion(0, o.x(), o.y(), o.z()) * p).coeffs() / 2);
                      };
                      return Quaternion(rk4(Eigen::Vector4d(q.coeffs()), rate, t, dt));
                  }},
                 {"the rate of the start's pose", "classic", "It turns along a straight line.",
                  "The rate multiplies omega with the pose of the start. It is the pose of the "
                  "look.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      const auto rate = [&](const Eigen::Vector4d& y,
                                            [[maybe_unused]] double now) {
                          const Quaternion p(y);
                          const Vector3 o = spin(p, now);
                          return Eigen::Vector4d(
                              (Quaternion(0, o.x(), o.y(), o.z()) * q).coeffs() / 2);
                      };
                      return Quaternion(rk4(Eigen::Vector4d(q.coeffs()), rate, t, dt));
                  }},
                 {"made of length one inside the rate", "classic: a pose must be of length one",
                  "None to see: it is of fourth order too.",
                  "You make the 4-vector as long as one inside the rate. Between start and end "
                  "rk4 asks at places that are longer, and the rate of the four numbers is half "
                  "of the product with them as they are.",
                  [](const Quaternion& q, const auto& spin, double t, double dt) -> Quaternion {
                      return runge_kutta(q, t, dt, [&](const Flat& y, double now) {
                          const Quaternion pose = Quaternion(y).normalized();
                          return rate_of(spin(pose, now), pose);
                      });
                  }}},
            .alternatives = {{"four rates by hand",
                              [](const Quaternion& q, const auto& spin, double t,
                                 double dt) -> Quaternion {
                                  return runge_kutta(q, t, dt, [&](const Flat& y, double now) {
                                      const Quaternion pose(y);
                                      return rate_of(spin(pose, now), pose);
                                  });
                              }}},
        };
    }
#endif
};

inline const bool rk4_pose_entered = enter<Rk4Pose>();

}  // namespace nutshell::exercises
