// Exercise 6.9: how L changes as seen from the body, where engines leave it out.
#pragma once
#include <nutshell/free_rotation.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct GyroscopicTerm {
    static constexpr const char *id = "6.9", *function = "gyroscopic_term";
    static constexpr auto subject = NUTSHELL_CALL(gyroscopic_term);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Vector3 flat(0.9, 0.45, 0.35), other(0.4, 1.6, 0.7), M(2.3, -4.1, 1.7),
            N(-1.9, 3.2, 4.4);
        const auto one = [&](const Vector3& J, const Vector3& m) {
            paper.input("J", J, "M", m);
            const Vector3 change = answer(J, m);
            paper.output("the gyroscopic term [N m]", change, m.squaredNorm() * J.norm());
        };
        one(flat, M), one(other, M), one(flat, N);
        one(flat, {0, 3.1, 0});  // about a principal axis
    }

#ifndef NUTSHELL_SHEET
    static About<GyroscopicTerm> about() {
        using V = const Vector3&;
        return {
            .title = "The gyroscopic term",
            .hints =
                {"L stands still in the world. Who turns with omega sees everything that "
                 "stands still turn with minus omega.",
                 "A vector that turns with an angular velocity changes by that, crossed with "
                 "the vector. Which sign is left, and which order gets rid of it?",
                 "omega in the body's axes is J times M, component by component. The answer "
                 "is M crossed with it."},
            .picture = "kept.svg",
            .mistakes =
                {{"of the wrong sign", "classic: omega x L",
                  "Energy and |L| are perfect, and L swings round in the world.",
                  "Seen from the body, L turns the other way round: M x omega, not omega x M.",
                  [](V J, V M) -> Vector3 { return J.cwiseProduct(M).cross(M); }},
                 {"missing", "classic: the default of several engines",
                  "Nothing ever tumbles; energy and |L| are perfect, and L turns with the body.",
                  "You let M stand still in the body. Then it is L that turns along, and nothing "
                  "twisted it.",
                  [](V, V) -> Vector3 { return Vector3::Zero(); }},
                 {"taken twice", "classic: added by the engine and by the game",
                  "Everything tumbles too fast, with perfect energy.",
                  "The term is counted twice.",
                  [](V J, V M) -> Vector3 { return 2 * M.cross(J.cwiseProduct(M)); }},
                 {"divided by J", "classic: inverse moments taken for moments",
                  "Slim things tumble as fat ones should.",
                  "J holds the inverse moments: omega is J times M, not M over J.",
                  [](V J, V M) -> Vector3 { return M.cross(M.cwiseQuotient(J)); }},
                 {"omega for M", "classic: L and omega mixed up", "Heavy things hardly tumble.",
                  "You cross omega with J omega. The first factor is M itself, the second omega.",
                  [](V J, V M) -> Vector3 {
                      const Vector3 w = J.cwiseProduct(M);
                      return w.cross(J.cwiseProduct(w));
                  }},
                 {"J for omega", "classic: a factor forgotten",
                  "The tumbling does not care how fast it spins.",
                  "You cross M with J itself. omega is J times M, component by component: "
                  "J.cwiseProduct(M).",
                  [](V J, V M) -> Vector3 { return M.cross(J); }}},
            .alternatives = {{"Euler's three equations",
                              [](V J, V M) -> Vector3 {
                                  return {(J[2] - J[1]) * M[1] * M[2],
                                          (J[0] - J[2]) * M[2] * M[0],
                                          (J[1] - J[0]) * M[0] * M[1]};
                              }},
                             {"minus omega x M",
                              [](V J, V M) -> Vector3 {
                                  return -(J.asDiagonal() * M).cross(M);
                              }}},
        };
    }
#endif
};

inline const bool gyroscopic_term_entered = enter<GyroscopicTerm>();

}  // namespace nutshell::exercises
