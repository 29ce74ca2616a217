// Exercise 6.10: five turns about the body's own axes.
#pragma once
#include "free_bodies.hpp"

namespace nutshell::exercises {

struct SplitRotation {
    static constexpr const char *id = "6.10", *function = "split_rotation";
    static constexpr auto subject = NUTSHELL_CALL(split_rotation);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        ask_rotation(paper, answer);
    }

#ifndef NUTSHELL_SHEET
    /// A turn about the body's own axis number i at the speed that M's part along it gives; with
    /// `along`, M turns back by the same angle.
    static void turn(int i, const Vector3& inertia, Quaternion& q, Vector3& M, double dt,
                     bool along = true) {
        const Vector3 angle = dt * M[i] / inertia[i] * Vector3::Unit(i);
        q = q * turn_by(angle);
        if (along) M = turn_by(-angle) * M;
    }
    static About<SplitRotation> about() {
        using V = const Vector3&;
        return {
            .title = "Five turns about the body's own axes",
            .hints = {"turn_about wants L in the body's axes, and keeps it up to date. It is "
                      "Verlet's pattern: what comes first comes last, in halves.",
                      "Half a turn about x, half about y, the whole one about z, then back: half "
                      "about y, half about x. All five with the same q and M.",
                      "M starts as rotate(inverse(q), L). The axis is the template's number: "
                      "turn_about<0> is x. A whole turn takes dt, a half one dt/2."},
            .order = 2,
            .picture = "s7.svg",
            .mistakes =
                {{"once through, not there and back", "classic: Lie's splitting for Strang's",
                  "The handle flips too early or too late.",
                  "x, y, z and the end: first order. There and back in halves is symmetric in "
                  "time, and second.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      Vector3 M = in_body_axes(q, L);
                      for (int i = 0; i < 3; ++i) turn(i, inertia, q, M, dt);
                  }},
                 {"M from the start five times", "classic: a copy where the thing was meant",
                  "Each turn spins as if the ones before had not happened: the handle never "
                  "flips.",
                  "Every turn changes M, which the next one needs. Hand over the same M five "
                  "times.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      Vector3 M = in_body_axes(q, L);
                      for (const int i : {0, 1, 2, 1, 0})
                          turn(i, inertia, q, M, i == 2 ? dt : dt / 2, false);
                  }},
                 {"L in the world's axes", "E58: axes mixed up",
                  "Only bodies that start upright turn rightly, and not for long.",
                  "You hand over L as it stands in the world. The turns are about the body's "
                  "axes: turn L into the body first.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      Vector3 M = L;
                      for (const int i : {0, 1, 2, 1, 0})
                          turn(i, inertia, q, M, i == 2 ? dt : dt / 2);
                  }},
                 {"five whole turns", "classic: no halves", "Things spin almost twice as fast.",
                  "The outer four turns are halves: each axis gets dt once in all.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      Vector3 M = in_body_axes(q, L);
                      for (const int i : {0, 1, 2, 1, 0}) turn(i, inertia, q, M, dt);
                  }},
                 {"half a turn about z", "classic", "The spin about z is lost by half.",
                  "z comes once only, in the middle: it takes the whole dt.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      Vector3 M = in_body_axes(q, L);
                      for (const int i : {0, 1, 2, 1, 0}) turn(i, inertia, q, M, dt / 2);
                  }},
                 {"the halves not mirrored", "classic", "The handle flips too early or too late.",
                  "You begin the way back with x again. It must be the way there, backwards: y, "
                  "then x.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      Vector3 M = in_body_axes(q, L);
                      for (const int i : {0, 1, 2, 0, 1})
                          turn(i, inertia, q, M, i == 2 ? dt : dt / 2);
                  }},
                 {"the way back is missing", "classic: half of the five",
                  "Everything turns half about x and y.",
                  "Half about x, half about y, the whole about z: the way back is missing, y and "
                  "then x.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      Vector3 M = in_body_axes(q, L);
                      for (int i = 0; i < 3; ++i) turn(i, inertia, q, M, i < 2 ? dt / 2 : dt);
                  }},
                 {"four turns of five", "classic", "Spins about x are half as fast.",
                  "The last half turn about x is missing: what came first comes last.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      Vector3 M = in_body_axes(q, L);
                      for (const int i : {0, 1, 2, 1})
                          turn(i, inertia, q, M, i < 2 ? dt / 2 : dt);
                  }}},
            .alternatives = {{"a loop over five axes, turns by the exponential",
                              [](V inertia, Quaternion& q, V L, double dt) {
                                  q.normalize();
                                  Vector3 M = in_body_axes(q, L);
                                  for (const int i : {0, 1, 2, 1, 0})
                                      turn(i, inertia, q, M, i == 2 ? dt : dt / 2);
                              }}},
        };
    }
#endif
};

inline const bool split_rotation_entered = enter<SplitRotation>();

}  // namespace nutshell::exercises
