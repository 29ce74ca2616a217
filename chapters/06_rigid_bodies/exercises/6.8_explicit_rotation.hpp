// Exercise 6.8: the source's turn, where the inverse inertia is left in the body's axes.
#pragma once
#include <nutshell/rotation_methods.hpp>
#include "free_bodies.hpp"

namespace nutshell::exercises {

struct ExplicitRotation {
    static constexpr const char *id = "6.8", *function = "explicit_rotation";
    static constexpr auto subject = NUTSHELL_CALL(explicit_rotation);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        ask_rotation(paper, answer);
    }

#ifndef NUTSHELL_SHEET
    static About<ExplicitRotation> about() {
        using V = const Vector3&;
        return {
            .title = "The source's turn, with its inertia turned too",
            .hints = {"Two things in a row: which angular velocity belongs to this pose and this "
                      "L, and what a steady angular velocity does to a pose.",
                      "The first is a function of this chapter, the second was exercise 5.4. The "
                      "angular velocity is in the world's axes: on which side does its turn "
                      "stand?",
                      "angular_velocity(inertia, q, L) times dt is the rotation vector; its "
                      "exponential times q, in this order, is the new q."},
            .order = 1,
            .picture = "flip.png",
            .mistakes =
                {{"the inverse inertia left in the body's axes", "E27, E58",
                  "The handle never flips: it turns about one axis for ever.",
                  "You divide L as it stands in the world by the moments of the body's axes. "
                  "Turn L into the body, divide, turn back: R I0^-1 R^T L.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      q = turn_by(L.cwiseQuotient(inertia) * dt) * q;
                  }},
                 {"a world's turn on the body's side", "E20, E28: the side is not said",
                  "Only bodies that are turned tumble wrongly.",
                  "The turn stands on the right of q, but omega is in the world's axes: left.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      q = q * turn_by(omega_of(inertia, q, L) * dt);
                  }},
                 {"turned the wrong way into the body", "E51: the transposed rotation",
                  "Tilted bodies tumble wrongly.",
                  "The pose leads from the body to the world: into the body leads its inverse.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      const Vector3 w = q.conjugate() * Vector3((q * L).cwiseQuotient(inertia));
                      q = turn_by(w * dt) * q;
                  }},
                 {"omega left in the body's axes", "classic: half of the way",
                  "Tilted bodies turn about a tilted axis.",
                  "You turned L into the body and divided, but did not turn the result back into "
                  "the world.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      const Vector3 w = in_body_axes(q, L).cwiseQuotient(inertia);
                      q = turn_by(w * dt) * q;
                  }},
                 {"multiplied by the moments", "classic", "Heavy things spin fastest.",
                  "L is inertia times omega, so omega is L divided by it.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      const Vector3 w = q * Vector3(in_body_axes(q, L).cwiseProduct(inertia));
                      q = turn_by(w * dt) * q;
                  }},
                 {"the small turn for the whole one", "E18, E20",
                  "A fast spin is late, in every step.",
                  "That is (32): first order in the angle. The exponential turns by all of it.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      q = small_turn(q, omega_of(inertia, q, L) * dt);
                  }},
                 {"L not brought into the body", "classic: half of the way",
                  "Tilted bodies tumble wrongly.",
                  "You divide L as it stands in the world by the moments of the body's axes, and "
                  "turn the result out. L has to come into the body first.",
                  [](V inertia, Quaternion& q, V L, double dt) {
                      const Vector3 w = q * Vector3(L.cwiseQuotient(inertia));
                      q = turn_by(w * dt) * q;
                  }}},
            .alternatives = {{"in the body's axes, on the right",
                              [](V inertia, Quaternion& q, V L, double dt) {
                                  const Vector3 w = in_body_axes(q, L).cwiseQuotient(inertia);
                                  q = (q * turn_by(w * dt)).normalized();
                              }},
                             {"with the matrix of the inverse inertia",
                              [](V inertia, Quaternion& q, V L, double dt) {
                                  const Matrix3 R = q.toRotationMatrix();
                                  const Vector3 w =
                                      R * inertia.cwiseInverse().asDiagonal() * R.transpose() * L;
                                  q = turn_by(w * dt) * q;
                              }}},
        };
    }
#endif
};

inline const bool explicit_rotation_entered = enter<ExplicitRotation>();

}  // namespace nutshell::exercises
