// Exercise 7.5: how a point of a body answers an impulse there.
#pragma once
#include <nutshell/impulse.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct MobilityOfPoint {
    static constexpr const char *id = "7.5", *function = "mobility";
    static constexpr auto subject = NUTSHELL_CALL(mobility);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        Matrix3 W, V;
        W << 2.1, 0.3, -0.4, 0.3, 1.2, 0.5, -0.4, 0.5, 3.3;
        V << 0.8, -0.2, 0.1, -0.2, 2.7, 0.6, 0.1, 0.6, 1.4;
        const Vector3 r(0.7, -1.1, 0.4), s(-0.3, 0.8, -1.6);
        ask_one(paper, answer, 0.4, W, r);
        ask_one(paper, answer, 1.9, W, r);
        ask_one(paper, answer, 0.4, V, r);
        ask_one(paper, answer, 0.4, W, s);
        ask_one(paper, answer, 0, W, r);
        ask_one(paper, answer, 0.4, W, Vector3::Zero());
    }

  private:
    template <class Answer>
    static void ask_one(Paper& paper, const Answer& answer, double inverse_mass,
                        const Matrix3& inverse_inertia, const Vector3& lever) {
        paper.input("inverse_mass", inverse_mass, "inverse_inertia", inverse_inertia, "lever",
                    lever);
        const Matrix3 K = answer(inverse_mass, inverse_inertia, lever);
        paper.output("the mobility [1/kg]", K, inverse_mass,
                     lever.squaredNorm() * inverse_inertia.norm());
    }

  public:
#ifndef NUTSHELL_SHEET
    static About<MobilityOfPoint> about() {
        using M = const Matrix3&;
        using V = const Vector3&;
        static constexpr auto cross = [](V r) {
            Matrix3 c;
            c << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
            return c;
        };
        return {
            .title = "How a point answers",
            .hints =
                {"An impulse J changes the velocity of the centre by J/m, and the angular "
                 "velocity by the inverse inertia times r x J. What does that make of the "
                 "velocity of the point at r?",
                 "The point gains J/m + (I^-1 (r x J)) x r. Write r x as a matrix; something "
                 "crossed with r is minus r crossed with it.",
                 "With C the matrix of r x: the identity over m, minus C times the inverse "
                 "inertia times C."},
            .mistakes =
                {{"levers forgotten", "E35",
                  "A rod that is hit at its end only moves, and never "
                  "turns as it should; it bounces as if hit at its centre.",
                  "You count the motion of the centre only. The impulse also turns the body, and "
                  "the point moves with that.",
                  [](double m, M, V) -> Matrix3 { return m * Matrix3::Identity(); }},
                 {"the sign of the second cross product", "classic: r x omega for omega x r",
                  "Long bodies explode at their first touch.",
                  "You add what must be taken away: omega x r is minus r x omega, and the matrix "
                  "of r x, squared, is negative.",
                  [](double m, M W, V r) -> Matrix3 {
                      return m * Matrix3::Identity() + cross(r) * W * cross(r);
                  }},
                 {"one cross product only", "classic: r x n not squared",
                  "Spin comes out of impacts that go through the centre.",
                  "You stop at the angular velocity. The velocity of the point is that crossed "
                  "with r once more.",
                  [](double m, M W, V r) -> Matrix3 {
                      return m * Matrix3::Identity() + W * cross(r);
                  }},
                 {"the inertia of a ball", "classic: one moment for all axes",
                  "Long bodies bounce as if they were round.",
                  "You put one mean moment in the place of the tensor. Each axis answers in its "
                  "own way.",
                  [](double m, M W, V r) -> Matrix3 {
                      return m * Matrix3::Identity() - W.trace() / 3 * cross(r) * cross(r);
                  }},
                 {"inertia for its inverse", "classic",
                  "Heavy things spin away from a touch that light ones ignore.",
                  "You use the inertia. What is given, and needed, is its inverse.",
                  [](double m, M W, V r) -> Matrix3 {
                      return m * Matrix3::Identity() - cross(r) * W.inverse() * cross(r);
                  }},
                 {"the mass twice inverted", "classic: impulse not divided by the mass",
                  "A wall that cannot move is knocked aside.",
                  "You divide by inverse_mass, which is one over the mass already: multiply by "
                  "it.",
                  [](double m, M W, V r) -> Matrix3 {
                      return (m > 0 ? 1 / m : 0) * Matrix3::Identity() - cross(r) * W * cross(r);
                  }},
                 {"struck at right angles to its lever", "classic: r^2/I",
                  "What is hit along its lever gives way too easily.",
                  "r^2/I is for an impulse at right angles to the lever, about one axis. One "
                  "along the lever "
                  "turns nothing: the matrix of r x stands on both sides of the inverse inertia.",
                  [](double m, M W, V r) -> Matrix3 {
                      return m * Matrix3::Identity() + r.squaredNorm() * W;
                  }},
                 {"the inverse inertia on the left", "classic: two factors exchanged",
                  "Long bodies turn about an axis that nobody struck.",
                  "An impulse becomes a torque first, then a spin, then a velocity, so the "
                  "inverse inertia stands between the two matrices of r x.",
                  [](double m, M W, V r) -> Matrix3 {
                      return m * Matrix3::Identity() - W * cross(r) * cross(r);
                  }},
                 {"the inverse inertia on the right", "classic: two factors exchanged",
                  "Long bodies turn about an axis that nobody struck.",
                  "An impulse becomes a torque first, then a spin, then a velocity, so the "
                  "inverse inertia stands between the two matrices of r x.",
                  [](double m, M W, V r) -> Matrix3 {
                      return m * Matrix3::Identity() - cross(r) * cross(r) * W;
                  }}},
            .alternatives = {{"column by column",
                              [](double m, M W, V r) -> Matrix3 {
                                  Matrix3 K;
                                  for (int i = 0; i < 3; ++i) {
                                      const Vector3 J = Vector3::Unit(i), turned = W * r.cross(J);
                                      K.col(i) = m * J + turned.cross(r);
                                  }
                                  return K;
                              }}},
        };
    }
#endif
};

inline const bool mobility_of_point_entered = enter<MobilityOfPoint>();

}  // namespace nutshell::exercises
