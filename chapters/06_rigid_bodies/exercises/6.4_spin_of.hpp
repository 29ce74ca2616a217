// Exercise 6.4: from angular momentum to angular velocity, where the source forgets the pose and
// its inverse has a wrong entry.
#pragma once
#include <nutshell/inertia.hpp>
#include <nutshell/rotations.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct SpinOf {
    static constexpr const char *id = "6.4", *function = "spin_of";
    static constexpr auto subject = NUTSHELL_CALL(spin_of);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        Matrix3 full;
        full << 2.1, -0.4, 0.3, -0.4, 1.7, 0.5, 0.3, 0.5, 1.2;
        const Matrix3 principal = Vector3(0.6, 1.9, 2.2).asDiagonal();
        const Matrix3 a = rotation_matrix(Quaternion(0.4, 0.3, -0.5, 0.7).normalized()),
                      b = rotation_matrix(Quaternion(0.9, -0.6, 0.2, 0.1).normalized());
        const Vector3 u(0.9, -1.4, 2.3), v(-1.7, 0.6, 0.8);
        ask_one(paper, answer, full, a, u);
        ask_one(paper, answer, principal, a, u);
        ask_one(paper, answer, full, b, u);
        ask_one(paper, answer, full, a, v);
    }

  private:
    template <class Answer>
    static void ask_one(Paper& paper, const Answer& answer, const Matrix3& inertia,
                        const Matrix3& rotation, const Vector3& L) {
        paper.input("inertia", inertia, "rotation", rotation, "L", L);
        paper.frame(rotation);
        const Vector3 omega = answer(inertia, rotation, L);
        paper.output("the angular velocity [rad/s]", omega, L.norm());
    }

  public:
#ifndef NUTSHELL_SHEET
    /// The source's inverse, all nine entries by cofactors. @param slip  with the printed (Z,Y)
    static Matrix3 inverse_of(const Matrix3& R, bool slip) {
        const double d = 1 / R.determinant();
        Matrix3 T;
        T(0, 0) = (R(1, 1) * R(2, 2) - R(1, 2) * R(2, 1)) * d;
        T(0, 1) = (R(2, 1) * R(0, 2) - R(0, 1) * R(2, 2)) * d;
        T(0, 2) = (R(0, 1) * R(1, 2) - R(1, 1) * R(0, 2)) * d;
        T(1, 0) = (R(1, 2) * R(2, 0) - R(1, 0) * R(2, 2)) * d;
        T(1, 1) = (R(0, 0) * R(2, 2) - R(0, 2) * R(2, 0)) * d;
        T(1, 2) = (R(1, 0) * R(0, 2) - R(0, 0) * R(1, 2)) * d;
        T(2, 0) = (R(1, 0) * R(2, 1) - R(2, 0) * R(1, 1)) * d;
        T(2, 1) = (R(2, slip ? 1 : 0) * R(0, 1) - R(2, 1) * R(0, 0)) * d;
        T(2, 2) = (R(0, 0) * R(1, 1) - R(0, 1) * R(1, 0)) * d;
        return T;
    }
    static About<SpinOf> about() {
        return {
            .title = "From angular momentum to angular velocity",
            .hints = {"L is given in the world's axes, the inertia in the body's. Which of the "
                      "two must change its axes first?",
                      "Bring L into the body with the way back, find the omega whose product "
                      "with the inertia it is, and bring that out.",
                      "A symmetric matrix has .inverse() and .ldlt().solve(right side). The "
                      "result is in the body's axes still."},
            .picture = "there_and_back.svg",
            .mistakes =
                {{"the inertia left unturned", "E27, E58",
                  "A thrown handle spins on steadily and never flips.",
                  "You apply the inverse inertia of the body's axes to an L in the world's. "
                  "Bring L into the body first, and omega out again.",
                  [](const Matrix3& inertia, const Matrix3&, const Vector3& L) -> Vector3 {
                      return inertia.inverse() * L;
                  }},
                 {"the printed inverse", "E54",
                  "A body whose parts stand askew creeps and gains energy; a box does not.",
                  "One entry of the inverse, (2,1), has a wrong factor: R(Z,Y)R(X,Y) for "
                  "R(Z,X)R(X,Y). It hides while the tensor is diagonal.",
                  [](const Matrix3& inertia, const Matrix3& rotation,
                     const Vector3& L) -> Vector3 {
                      return rotation *
                             Vector3(inverse_of(inertia, true) * (rotation.transpose() * L));
                  }},
                 {"turned the wrong way", "classic: rows for columns",
                  "Everything is right until the first body leans.",
                  "You bring L into the body with R and omega out with its transpose. R leads "
                  "from the body to the world.",
                  [](const Matrix3& inertia, const Matrix3& rotation,
                     const Vector3& L) -> Vector3 {
                      return rotation.transpose() * Vector3(inertia.inverse() * (rotation * L));
                  }},
                 {"left in the body", "classic",
                  "Spins are right in size and point along with the body.",
                  "The result is in the body's axes. Turn it out with the rotation.",
                  [](const Matrix3& inertia, const Matrix3& rotation, const Vector3& L)
                      -> Vector3 { return inertia.inverse() * (rotation.transpose() * L); }},
                 {"multiplied by the inertia", "classic",
                  "Heavy things spin faster than light ones.",
                  "You multiply where you should divide: L = I omega, so omega is the inverse of "
                  "I times L.",
                  [](const Matrix3& inertia, const Matrix3& rotation,
                     const Vector3& L) -> Vector3 {
                      return rotation * Vector3(inertia * (rotation.transpose() * L));
                  }},
                 {"divided by the diagonal", "classic: three moments are enough",
                  "A hammer whose head sits askew spins as if it sat straight.",
                  "You divide by the three entries of the diagonal. That is right in principal "
                  "axes only; this tensor has others too.",
                  [](const Matrix3& inertia, const Matrix3& rotation,
                     const Vector3& L) -> Vector3 {
                      return rotation *
                             Vector3(
                                 (rotation.transpose() * L).cwiseQuotient(inertia.diagonal()));
                  }},
                 {"L not brought into the body", "classic: half of the way",
                  "Everything is right until the first body leans.",
                  "You apply the inverse inertia of the body's axes to an L in the world's, and "
                  "turn the result out. L has to come into the body first.",
                  [](const Matrix3& inertia, const Matrix3& rotation, const Vector3& L)
                      -> Vector3 { return rotation * Vector3(inertia.inverse() * L); }}},
            .alternatives = {{"by the inverse in world axes",
                              [](const Matrix3& inertia, const Matrix3& rotation,
                                 const Vector3& L) -> Vector3 {
                                  const Matrix3 world = rotation * inertia * rotation.transpose();
                                  return world.inverse() * L;
                              }},
                             {"by the source's inverse, put right",
                              [](const Matrix3& inertia, const Matrix3& rotation,
                                 const Vector3& L) -> Vector3 {
                                  return rotation * Vector3(inverse_of(inertia, false) *
                                                            (rotation.transpose() * L));
                              }}},
        };
    }
#endif
};

inline const bool spin_of_entered = enter<SpinOf>();

}  // namespace nutshell::exercises
