// Exercise 6.2: the inertia of one particle, where the source's (45) and its listing slip.
#pragma once
#include <nutshell/inertia.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct PointInertia {
    static constexpr const char *id = "6.2", *function = "point_inertia";
    static constexpr auto subject = NUTSHELL_CALL(point_inertia);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Vector3 a(0.7, 1.2, -0.9), b(-1.4, 0.3, 0.8);
        for (const auto& [mass, r] : {std::pair{2.5, a}, {0.8, a}, {2.5, b}}) {
            paper.input("mass", mass, "r", r);
            const Matrix3 inertia = answer(mass, r);
            paper.output("the inertia [kg m^2]", inertia, mass * r.squaredNorm());
        }
    }

#ifndef NUTSHELL_SHEET
    static Matrix3 right(double mass, const Vector3& r) {
        Matrix3 inertia;
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                inertia(j, k) = mass * ((j == k ? r.dot(r) : 0) - r[j] * r[k]);
        return inertia;
    }
    static About<PointInertia> about() {
        return {
            .title = "The inertia of a particle",
            .hints =
                {"Put v = omega x r into L = m r x v and multiply it out. What is the matrix "
                 "that stands before omega?",
                 "Its diagonal entry (0,0) is the mass times y squared plus z squared: the "
                 "squared distance from the x axis.",
                 "The identity times the squared length of r, less the column r times the "
                 "row r; all of it times the mass."},
            .picture = "particle.svg",
            .mistakes =
                {{"mass times distance squared, for every axis", "E24",
                  "A bead on the axis of a wheel makes it hard to spin.",
                  "You have the source's (45): m r^2 about every axis. That holds for an axis at "
                  "right angles to r; what points along omega has no lever.",
                  [](double mass, const Vector3& r) -> Matrix3 {
                      return mass * r.squaredNorm() * Matrix3::Identity();
                  }},
                 {"the question mark binds last", "E65",
                  "Long things spin about their own length as slowly as end over end.",
                  "Your diagonal is r^2 instead of r^2 less the square of the component: in "
                  "(j==k)?r2:0-r(j)*r(k) the subtraction belongs to the second branch only.",
                  [](double mass, const Vector3& r) -> Matrix3 {
                      const double r2 = r.squaredNorm();
                      Matrix3 inertia;
                      for (int j = 0; j < 3; ++j)
                          for (int k = 0; k < 3; ++k)
                              inertia(j, k) = mass * ((j == k) ? r2 : 0 - r[j] * r[k]);
                      return inertia;
                  }},
                 {"products of inertia with a plus", "classic: CAD programs list them so",
                  "A wheel with a heavy place on its outer rim wobbles as if it were on "
                  "the inner one.",
                  "The entries off the diagonal have the wrong sign: they are minus m times the "
                  "product of two components.",
                  [](double mass, const Vector3& r) -> Matrix3 {
                      Matrix3 inertia = -right(mass, r);
                      inertia.diagonal() *= -1;
                      return inertia;
                  }},
                 {"only the diagonal", "classic: three numbers are enough",
                  "A wheel heavy at two opposite places, one on each rim, spins as if it "
                  "were balanced.",
                  "You leave the entries off the diagonal at zero. They are what makes L point "
                  "away from omega.",
                  [](double mass, const Vector3& r) -> Matrix3 {
                      return right(mass, r).diagonal().asDiagonal();
                  }},
                 {"the spread instead of the inertia", "classic: the covariance of the mass",
                  "A long stick is easy to turn end over end and hard about its length.",
                  "You have the mass times r r^T alone. That grows along r; inertia grows across "
                  "it: take it from m r^2 on the diagonal.",
                  [](double mass, const Vector3& r) -> Matrix3 {
                      return mass * r * r.transpose();
                  }},
                 {"the mass forgotten", "classic", "Stone and cork spin alike.",
                  "The mass does not enter.",
                  [](double, const Vector3& r) -> Matrix3 { return right(1, r); }},
                 {"the distance not squared", "classic",
                  "A figure skater who pulls in her arms gets too little from it.",
                  "Your diagonal grows with the distance; inertia grows with its square: once "
                  "for the lever, once for the speed.",
                  [](double mass, const Vector3& r) -> Matrix3 {
                      return right(mass, r) / r.norm();
                  }},
                 {"the mass in the first term only", "classic: a bracket",
                  "Heavy dumbbells wobble.",
                  "The mass multiplies the first term only. It belongs before both: a bracket is "
                  "missing.",
                  [](double mass, const Vector3& r) -> Matrix3 {
                      return mass * r.dot(r) * Matrix3::Identity() - r * r.transpose();
                  }}},
            .alternatives = {{"entry by entry",
                              [](double mass, const Vector3& r) -> Matrix3 {
                                  return right(mass, r);
                              }},
                             {"minus the square of the cross product's matrix",
                              [](double mass, const Vector3& r) -> Matrix3 {
                                  Matrix3 cross;
                                  cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
                                  return -mass * cross * cross;
                              }}},
        };
    }
#endif
};

inline const bool point_inertia_entered = enter<PointInertia>();

}  // namespace nutshell::exercises
