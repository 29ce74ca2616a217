// Exercise 6.5: the inertia about another point, by parallel axes.
#pragma once
#include <nutshell/inertia.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct InertiaAbout {
    static constexpr const char *id = "6.5", *function = "inertia_about";
    static constexpr auto subject = NUTSHELL_CALL(inertia_about);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        Matrix3 inertia, other;
        inertia << 2.1, -0.4, 0.3, -0.4, 1.7, 0.5, 0.3, 0.5, 1.2;
        other << 0.9, 0.2, -0.1, 0.2, 1.3, 0.3, -0.1, 0.3, 1.6;
        const Vector3 centre(0.4, -0.7, 0.9), moved(-0.5, 0.8, 0.3), point(1.3, 0.6, -0.8),
            elsewhere(-0.9, 1.1, 0.7);
        ask_one(paper, answer, {1.7, centre, inertia}, point);
        ask_one(paper, answer, {0.6, centre, inertia}, point);
        ask_one(paper, answer, {1.7, moved, inertia}, point);
        ask_one(paper, answer, {1.7, centre, other}, point);
        ask_one(paper, answer, {1.7, centre, inertia}, elsewhere);
    }

  private:
    template <class Answer>
    static void ask_one(Paper& paper, const Answer& answer, const MassProperties& body,
                        const Vector3& point) {
        paper.input("body.mass", body.mass, "body.centre", body.centre, "body.inertia",
                    body.inertia, "point", point);
        const Matrix3 about = answer(body, point);
        paper.output("the inertia about the point [kg m^2]", about, body.inertia,
                     body.mass * (point - body.centre).squaredNorm());
    }

  public:
#ifndef NUTSHELL_SHEET
    static Matrix3 steiner(double mass, const Vector3& a) {
        return mass * (a.dot(a) * Matrix3::Identity() - a * a.transpose());
    }
    static About<InertiaAbout> about() {
        return {
            .title = "Parallel axes",
            .hints = {"Split every lever arm: from the point to the centre of mass, and from "
                      "there on. What is left when the mixed terms cancel?",
                      "Two inertias are left: the body's own about its centre, and that of all "
                      "its mass in one place. Where is that place, seen from the point?",
                      "parallel_axis wants the mass and the way between centre and point; its "
                      "sign does not matter, a plus in front of it does."},
            .picture = "parallel.svg",
            .mistakes =
                {{"the wrong sign", "classic: the formula for the way back",
                  "The body has a negative moment and spins against every push.",
                  "You subtract. About the centre of mass inertia is least; about any other "
                  "point it is more. No body has the inertia you give.",
                  [](const MassProperties& body, const Vector3& point) -> Matrix3 {
                      return body.inertia - steiner(body.mass, point - body.centre);
                  }},
                 {"from the origin", "classic: the centre taken for the origin",
                  "A thing is harder to turn the further it lies from the middle of the level.",
                  "You move by the point's distance from the origin of the axes. What counts is "
                  "its distance from the body's centre of mass.",
                  [](const MassProperties& body, const Vector3& point) -> Matrix3 {
                      return body.inertia + steiner(body.mass, point);
                  }},
                 {"distance squared, for every axis", "E24 once more",
                  "A door is hard to tilt about the line from its hinge to its middle.",
                  "You add m d^2 to every moment. The shift along an axis costs nothing about "
                  "that axis; and there are entries off the diagonal.",
                  [](const MassProperties& body, const Vector3& point) -> Matrix3 {
                      return body.inertia + body.mass * (point - body.centre).squaredNorm() *
                                                Matrix3::Identity();
                  }},
                 {"the question mark binds last", "E65",
                  "A rod on a pivot at its end refuses to spin about its own length.",
                  "The added diagonal is d^2 without the square of its own component: in the "
                  "listing's dI the ?: binds last.",
                  [](const MassProperties& body, const Vector3& point) -> Matrix3 {
                      const Vector3 r = point - body.centre;
                      Matrix3 added = -body.mass * r * r.transpose();
                      added.diagonal().setConstant(body.mass * r.squaredNorm());
                      return body.inertia + added;
                  }},
                 {"not moved at all", "classic",
                  "A door swings as easily on its hinges as about its middle.",
                  "You hand back the inertia about the centre of mass.",
                  [](const MassProperties& body, const Vector3&) -> Matrix3 {
                      return body.inertia;
                  }},
                 {"a point mass", "classic: the own inertia forgotten",
                  "A uniform rod on a pivot swings as a bob at its middle.",
                  "You have the inertia of all the mass in the centre. Add the body's own.",
                  [](const MassProperties& body, const Vector3& point) -> Matrix3 {
                      return steiner(body.mass, point - body.centre);
                  }},
                 {"a difference of squares", "classic: (a - b)^2 is not a^2 - b^2",
                  "The same door swings otherwise in another place of the level.",
                  "You add what all the mass would have at the point, seen from the origin, and "
                  "take off what it would have at the centre. What counts is the way from the "
                  "one to the other, squared.",
                  [](const MassProperties& body, const Vector3& point) -> Matrix3 {
                      return body.inertia + steiner(body.mass, point) -
                             steiner(body.mass, body.centre);
                  }},
                 {"the two places added", "E48: operator- adds",
                  "A thing is harder to turn the further it lies from the middle of the level.",
                  "You add the point and the centre. The way from the one to the other is their "
                  "difference.",
                  [](const MassProperties& body, const Vector3& point) -> Matrix3 {
                      return body.inertia + steiner(body.mass, point + body.centre);
                  }}},
            .alternatives = {{"by the inertia about the origin, there and back",
                              [](const MassProperties& body, const Vector3& point) -> Matrix3 {
                                  // about the origin first; then to the point
                                  const Matrix3 origin =
                                      body.inertia + steiner(body.mass, body.centre);
                                  const Vector3 c = body.centre, p = point;
                                  const Matrix3 mixed = 2 * c.dot(p) * Matrix3::Identity() -
                                                        c * p.transpose() - p * c.transpose();
                                  return origin - body.mass * mixed + steiner(body.mass, p);
                              }},
                             {"by the matrix of the cross product",
                              [](const MassProperties& body, const Vector3& point) -> Matrix3 {
                                  const Vector3 r = body.centre - point;
                                  Matrix3 cross;
                                  cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
                                  return body.inertia + body.mass * cross * cross.transpose();
                              }}},
        };
    }
#endif
};

inline const bool inertia_about_entered = enter<InertiaAbout>();

}  // namespace nutshell::exercises
