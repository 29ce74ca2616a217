// Exercise 6.3: the inertia of a turned body in the world's axes, which the source leaves
// unturned.
#pragma once
#include <nutshell/inertia.hpp>
#include <nutshell/rotations.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct InWorld {
    static constexpr const char *id = "6.3", *function = "in_world";
    static constexpr auto subject = NUTSHELL_CALL(in_world);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        Matrix3 full;
        full << 2.1, -0.4, 0.3, -0.4, 1.7, 0.5, 0.3, 0.5, 1.2;
        const Matrix3 principal = Vector3(0.6, 1.9, 2.2).asDiagonal();
        const Matrix3 a = rotation_matrix(Quaternion(0.4, 0.3, -0.5, 0.7).normalized()),
                      b = rotation_matrix(Quaternion(0.9, -0.6, 0.2, 0.1).normalized());
        for (const auto& [inertia, rotation] :
             {std::pair{full, a}, {principal, a}, {full, b}, {principal, b}}) {
            paper.input("inertia", inertia, "rotation", rotation);
            const Matrix3 turned = answer(inertia, rotation);
            paper.output("the inertia in world axes [kg m^2]", turned, 1.0);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<InWorld> about() {
        return {
            .title = "Inertia in the world's axes",
            .hints = {"Take an angular velocity in the world and ask for its angular momentum. "
                      "The body knows the answer in its own axes only.",
                      "Three steps, read from right to left: bring the vector into the body, "
                      "multiply by its inertia, bring the result out. Which matrix leads in, "
                      "which out?",
                      "The rotation stands on the left, the inertia in the middle, the "
                      "rotation's .transpose() on the right."},
            .picture = "there_and_back.svg",
            .mistakes =
                {{"left unturned", "E27, E58",
                  "A thrown stick spins about its length as slowly as end over end once it has "
                  "turned.",
                  "You hand back the inertia of the body's own axes. It turns with the body.",
                  [](const Matrix3& inertia, const Matrix3&) -> Matrix3 { return inertia; }},
                 {"turned the wrong way", "classic: rows for columns",
                  "A body that leans to the left behaves as one that leans to the right.",
                  "You have R^T I0 R, which turns the tensor back instead of on. The rotation "
                  "that leads from the body to the world stands on the left.",
                  [](const Matrix3& inertia, const Matrix3& rotation) -> Matrix3 {
                      return rotation.transpose() * inertia * rotation;
                  }},
                 {"turned on one side", "classic: as if it were a vector",
                  "The inertia is not symmetric any more, and energy appears from nowhere.",
                  "You multiply by the rotation once. A matrix that takes a vector and gives a "
                  "vector must have both ends turned: R I0 R^T.",
                  [](const Matrix3& inertia, const Matrix3& rotation) -> Matrix3 {
                      return rotation * inertia;
                  }},
                 {"turned out, never in", "classic",
                  "A body at rest in a tilted pose trembles when it is touched.",
                  "You have I0 R^T: the vector comes into the body and the answer stays there. "
                  "Turn it out again.",
                  [](const Matrix3& inertia, const Matrix3& rotation) -> Matrix3 {
                      return inertia * rotation.transpose();
                  }},
                 {"the transpose forgotten", "classic",
                  "The inertia changes with the pose even for a ball.",
                  "Both factors are R. The right one must be the way back, its transpose.",
                  [](const Matrix3& inertia, const Matrix3& rotation) -> Matrix3 {
                      return rotation * inertia * rotation;
                  }},
                 {"only the diagonal turned", "classic: three moments kept",
                  "Tilted bodies never wobble.",
                  "You keep only the diagonal of the result. In the world's axes a tilted body "
                  "has products of inertia too.",
                  [](const Matrix3& inertia, const Matrix3& rotation) -> Matrix3 {
                      const Matrix3 all = rotation * inertia * rotation.transpose();
                      return all.diagonal().asDiagonal();
                  }},
                 {"the moments turned as a vector", "classic",
                  "Bodies that have turned spin against every push.",
                  "You turn the three numbers of the diagonal as if they were a vector. They are "
                  "moments of a tensor, which is turned from both sides; and what stands beside "
                  "the diagonal is lost.",
                  [](const Matrix3& inertia, const Matrix3& rotation) -> Matrix3 {
                      return Vector3(rotation * inertia.diagonal()).asDiagonal();
                  }}},
            .alternatives = {{"column by column",
                              [](const Matrix3& inertia, const Matrix3& rotation) -> Matrix3 {
                                  Matrix3 turned;
                                  for (int k = 0; k < 3; ++k) {
                                      const Vector3 own = rotation.transpose().col(k);
                                      turned.col(k) = rotation * (inertia * own);
                                  }
                                  return turned;
                              }},
                             {"by the transpose of a product",
                              [](const Matrix3& inertia, const Matrix3& rotation) -> Matrix3 {
                                  const Matrix3 half = rotation * inertia;
                                  return (rotation * half.transpose()).transpose();
                              }}},
        };
    }
#endif
};

inline const bool in_world_entered = enter<InWorld>();

}  // namespace nutshell::exercises
