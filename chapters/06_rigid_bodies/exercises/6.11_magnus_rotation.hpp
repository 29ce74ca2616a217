// Exercise 6.11: the free rotation to fourth order; body L taken from the pose too often.
#pragma once
#include <nutshell/rotation_methods.hpp>
#include "free_bodies.hpp"

namespace nutshell::exercises {

struct MagnusRotation {
    static constexpr const char *id = "6.11", *function = "magnus_rotation";
    static constexpr auto subject = NUTSHELL_CALL(magnus_rotation);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        ask_rotation(paper, answer);
    }

#ifndef NUTSHELL_SHEET
    /// The step with its parts open: the factor of the cross product, that of the slopes in the
    /// middle, whether M is made as long as L, and whether the pose is turned after it.
    static void with(const Vector3& inertia, Quaternion& q, const Vector3& L, double dt,
                     double cross, double slopes, bool length = true, bool align = true) {
        q = trimmed(q);
        const auto rate = [&](const Vector3& M) -> Vector3 {
            return M.cross(M.cwiseQuotient(inertia));
        };
        const Vector3 M0 = in_body_axes(q, L), k1 = rate(M0), k2 = rate(M0 + dt / 2 * k1),
                      k3 = rate(M0 + dt / 2 * k2), k4 = rate(M0 + dt * k3);
        Vector3 M1 = M0 + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        if (length) M1 *= 1.5 - 0.5 * M1.squaredNorm() / L.squaredNorm();
        const Vector3 middle = (M0 + M1) / 2 + slopes * dt * (k1 - rate(M1));
        const Vector3 w0 = M0.cwiseQuotient(inertia), wm = middle.cwiseQuotient(inertia),
                      w1 = M1.cwiseQuotient(inertia);
        const Quaternion turn =
            turn_by(dt / 6 * (w0 + 4 * wm + w1) + cross * dt * dt * w0.cross(w1));
        const Vector3 missing = (turn * M1).cross(M0) / L.squaredNorm();
        q = q * (align ? four_vector(missing / 2, 1) : four_vector({0, 0, 0}, 1)) * turn;
    }
    static About<MagnusRotation> about() {
        using V = const Vector3&;
        const char* by_now =
            "the marked lines read M0 and square, which are made of L above them";
        return {
            .title = "Fourth order, without asking the pose",
            .hints =
                {"First M alone, to the end of the step: chapter 3's RK4 with four rates. Only "
                 "then the pose, from omega at the start, the middle and the end.",
                 "Omega is J times M, component by component. The mean is Simpson's, 1 4 1; in "
                 "the body's axes Magnus' cross product is the earlier crossed with the later, "
                 "with dt^2/12. The middle of M is the mean of its ends plus dt/8 times the "
                 "difference of their rates.",
                 "The new pose is start times turn. Between them stands the small turn by which "
                 "the turned M1 misses M0: their cross product over the square of L, half of it "
                 "as the vector part and 1 as the last."},
            .order = 4,
            .picture = "s7_failures.svg",
            .mistakes =
                {{"body L from the pose at each stage", "classic: RK4 on the group of poses",
                  "Near the middle axis the error is ten thousand times larger.",
                  "You take L in the body from a new pose at every stage. Errors of the pose "
                  "then "
                  "change the motion. Let M go its own way through the step.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      const auto at = [&](const Vector3& u) -> Vector3 {
                          const Vector3 w = omega_of(inertia, turn_by(u) * q, L);
                          return w - u.cross(w) / 2 + u.cross(u.cross(w)) / 12;
                      };
                      const Vector3 k1 = omega_of(inertia, q, L), k2 = at(dt / 2 * k1),
                                    k3 = at(dt / 2 * k2), k4 = at(dt * k3);
                      q = turn_by(dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)) * q;
                  }},
                 {"the cross product the other way", "classic: the formula for world axes",
                  "Refining the step helps less than it should.",
                  "In the body's axes the earlier omega comes first in the cross product. Your "
                  "sign doubles the error: second order.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      with(inertia, q, L, dt, -1. / 12, 1. / 8);
                  }},
                 {"no cross product", "classic: a mean of angular velocities",
                  "Refining the step helps less than it should; MuJoCo's RK4 does this.",
                  "Turns do not commute: without the cross product it is second order.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      with(inertia, q, L, dt, 0, 1. / 8);
                  }},
                 {"the middle as the mean of the ends", "classic",
                  "Refining the step helps less than it should.",
                  "M goes a curve. The mean of its ends misses the middle by dt^2/8 of its "
                  "bend: add dt/8 times the difference of the rates.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      with(inertia, q, L, dt, 1. / 12, 0);
                  }},
                 {"the missing turn left out", "classic: errors of the pose that add up",
                  "After a while M and L are no longer the same arrow.",
                  "The pose and M are found apart and end a little apart. Turn the pose by what "
                  "is missing, so that M is L again.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      with(inertia, q, L, dt, 1. / 12, 1. / 8, true, false);
                  }},
                 {"Euler for M", "classic: one rate for the whole step",
                  "The handle flips at the wrong time.",
                  "M takes one rate, that of the start: first order. RK4 takes four.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      const Vector3 M0 = in_body_axes(q, L), w0 = M0.cwiseQuotient(inertia);
                      Vector3 M1 = M0 + dt * M0.cross(w0);
                      M1 *= L.norm() / M1.norm();
                      const Vector3 w1 = M1.cwiseQuotient(inertia);
                      const Quaternion turn =
                          turn_by(dt / 2 * (w0 + w1) + dt * dt / 12 * w0.cross(w1));
                      const Vector3 missing = (turn * M1).cross(M0) / L.squaredNorm();
                      q = (q * four_vector(missing / 2, 1) * turn).normalized();
                  }}},
            .alternatives = {{"the same with quotients and AngleAxis",
                              [](V inertia, Quaternion& q, V L, double dt) {
                                  with(inertia, q, L, dt, 1. / 12, 1. / 8);
                              }}},
            .survivors = {{"L frozen", by_now},
                          {"L.x and y swapped", by_now},
                          {"L.x zeroed", by_now},
                          {"L.y and z swapped", by_now},
                          {"L.y zeroed", by_now},
                          {"L.z and x swapped", by_now},
                          {"L.z zeroed", by_now}},
        };
    }
#endif
};

inline const bool magnus_rotation_entered = enter<MagnusRotation>();

}  // namespace nutshell::exercises
