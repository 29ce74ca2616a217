// Exercise 7.6: an impulse at a point changes four momenta.
#pragma once
#include <nutshell/impulse.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct ApplyImpulse {
    static constexpr const char *id = "7.6", *function = "apply_impulse";
    static constexpr auto subject = NUTSHELL_CALL(apply_impulse);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        Body a, b;
        a.mass = 2.3, b.mass = 0.7;
        a.inertia = {0.4, 1.1, 0.9}, b.inertia = {2.2, 0.8, 1.5};
        a.position = {0.4, -1.2, 0.7}, b.position = {1.9, 0.3, -0.6};
        a.momentum = {1.1, 0.6, -2.4}, b.momentum = {-0.8, 1.7, 0.5};
        a.orientation = quaternion_about(Vector3(1, 2, 2) / 3, 0.8);
        b.orientation = quaternion_about(Vector3(2, -1, 2) / 3, 1.9);
        a.angular_momentum = {0.3, -0.7, 1.2}, b.angular_momentum = {1.6, 0.9, -0.4};
        const Contact at{{1.3, -0.2, 0.1}, Vector3(2, 3, -6) / 7, 0, 0};
        const Vector3 J(1.4, -0.9, 2.1);
        ask_one(paper, answer, a, b, at, J);
        ask_one(paper, answer, a, b, at, {-0.5, 1.8, 0.3});
        ask_one(paper, answer, a, b, {{0.2, 0.9, 1.4}, at.normal, 0, 0}, J);
        Body aside = a, beside = b;
        aside.position = {-0.6, 0.5, 1.5}, beside.position = {0.2, 2.1, 1.1};
        ask_one(paper, answer, aside, b, at, J);
        ask_one(paper, answer, a, beside, at, J);
    }

  private:
    template <class Answer>
    static void ask_one(Paper& paper, const Answer& answer, Body a, Body b, const Contact& at,
                        const Vector3& J) {
        paper.input("place of a", a.position, "place of b", b.position, "point", at.point,
                    "normal", at.normal, "J", J);
        const Body a0 = a, b0 = b;
        answer(a, b, at, J);
        const Vector3 ra = at.point - a0.position, rb = at.point - b0.position;
        paper.changed("the momentum of a [kg m/s]", a.momentum, a0.momentum, J);
        paper.changed("the momentum of b [kg m/s]", b.momentum, b0.momentum, J);
        paper.changed("the angular momentum of a [kg m^2/s]", a.angular_momentum,
                      a0.angular_momentum, ra.norm() * J.norm());
        paper.changed("the angular momentum of b [kg m^2/s]", b.angular_momentum,
                      b0.angular_momentum, rb.norm() * J.norm());
    }

  public:
#ifndef NUTSHELL_SHEET
    static About<ApplyImpulse> about() {
        using B = Body&;
        using C = const Contact&;
        using V = const Vector3&;
        return {
            .title = "One impulse, four momenta",
            .hints = {"The momenta change as those of particles do: b gets J, a its opposite.",
                      "An angular momentum about the centre of mass changes by lever x J. The "
                      "lever leads from the body's centre to the contact: each body has its own.",
                      "Lever of a: the contact's point minus the position of a. Cross it with J "
                      "and take it from a; the same with the lever of b, added to b."},
            .mistakes =
                {{"nothing turns", "E35, E36",
                  "A rod that is hit at its end slides off without turning.",
                  "You change the momenta only. An impulse beside the centre also changes the "
                  "angular momentum, by its lever.",
                  [](B a, B b, C, V J) { a.momentum -= J, b.momentum += J; }},
                 {"the torque of the wrong sign", "classic: J x r, or the lever turned round",
                  "What is hit on its right turns left.",
                  "Both angular momenta change with the wrong sign. It is lever x J in this "
                  "order, and the lever goes from the centre to the contact.",
                  [](B a, B b, C at, V J) {
                      a.momentum -= J, b.momentum += J;
                      a.angular_momentum += (at.point - a.position).cross(J);
                      b.angular_momentum -= (at.point - b.position).cross(J);
                  }},
                 {"lever from the world's origin", "classic",
                  "The farther from the origin, the wilder the spin after a touch.",
                  "Your lever is the contact's place in the world. It begins at the centre of "
                  "each body.",
                  [](B a, B b, C at, V J) {
                      a.momentum -= J, b.momentum += J;
                      a.angular_momentum -= at.point.cross(J);
                      b.angular_momentum += at.point.cross(J);
                  }},
                 {"one lever for both", "classic",
                  "Two bodies that meet make spin out of nothing.",
                  "You use one body's lever for both. Each has its own.",
                  [](B a, B b, C at, V J) {
                      a.momentum -= J, b.momentum += J;
                      a.angular_momentum -= (at.point - b.position).cross(J);
                      b.angular_momentum += (at.point - b.position).cross(J);
                  }},
                 {"both spun the same way", "classic: action without reaction",
                  "Two bodies that meet make spin out of nothing.",
                  "a gets the opposite impulse: what it turns has the other sign too.",
                  [](B a, B b, C at, V J) {
                      a.momentum -= J, b.momentum += J;
                      a.angular_momentum += (at.point - a.position).cross(J);
                      b.angular_momentum += (at.point - b.position).cross(J);
                  }},
                 {"the normal for the impulse", "classic: r x n",
                  "However hard the hit, the spin is the same.",
                  "You cross the lever with the normal. It is the impulse that turns.",
                  [](B a, B b, C at, V J) {
                      a.momentum -= J, b.momentum += J;
                      a.angular_momentum -= (at.point - a.position).cross(at.normal);
                      b.angular_momentum += (at.point - b.position).cross(at.normal);
                  }},
                 {"signs exchanged", "classic: the impulse on a", "Bodies suck each other in.",
                  "J is what b gets; you give it to a.",
                  [](B a, B b, C at, V J) {
                      a.momentum += J, b.momentum -= J;
                      a.angular_momentum += (at.point - a.position).cross(J);
                      b.angular_momentum -= (at.point - b.position).cross(J);
                  }},
                 {"the torque in the body's axes", "classic: the wrong frame",
                  "Only bodies that are turned spin off wrongly.",
                  "You turn the change of the angular momentum into the body's axes. It is kept "
                  "in the world's, as the lever and the impulse are.",
                  [](B a, B b, C at, V J) {
                      a.momentum -= J, b.momentum += J;
                      a.angular_momentum -=
                          a.orientation.conjugate() * (at.point - a.position).cross(J);
                      b.angular_momentum +=
                          b.orientation.conjugate() * (at.point - b.position).cross(J);
                  }}},
            .alternatives = {{"body by body",
                              [](B a, B b, C at, V J) {
                                  const auto push = [&](B body, const Vector3& I) {
                                      body.momentum += I;
                                      body.angular_momentum -= I.cross(at.point - body.position);
                                  };
                                  push(a, -J), push(b, J);
                              }}},
            .survivors = {{"statements 1 and 3 swapped", "four momenta, each changed once"},
                          {"statements 1 and 4 swapped", "four momenta, each changed once"},
                          {"statements 2 and 4 swapped", "four momenta, each changed once"}},
        };
    }
#endif
};

inline const bool apply_impulse_entered = enter<ApplyImpulse>();

}  // namespace nutshell::exercises
