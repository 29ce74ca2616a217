// Exercise 7.10: warm start, what a contact takes over from the step before.
#pragma once
#include <nutshell/contact_memory.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct TakeOver {
    static constexpr const char *id = "7.10", *function = "take_over";
    static constexpr auto subject = NUTSHELL_CALL(take_over);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Vector3 n = Vector3(0.1, 0.9, -0.3).normalized(),
                      turned = Vector3(0.3, 0.9, -0.1).normalized();
        const Vector3 f(0.5, -0.1, 0.4), g(-0.3, 0.2, 0.7);
        one(paper, answer, 3, 8, 3, 8, n, n, 2.5, f);
        one(paper, answer, 3, 8, 3, 8, turned, n, 2.5, f);
        one(paper, answer, 8, 3, 3, 8, Vector3(-turned), n, 1.5, f);
        one(paper, answer, 5, 0, 0, 5, Vector3(-n), turned, 0.5, g);
        one(paper, answer, -1, 4, -1, 4, turned, n, 3.5, g);
        one(paper, answer, 3, 8, 3, 8, n, n, 0, Vector3::Zero());
    }

  private:
    template <class Answer>
    static void one(Paper& paper, const Answer& answer, int a, int b, int old_a, int old_b,
                    const Vector3& normal, const Vector3& old_normal, double impulse,
                    const Vector3& friction) {
        PressedContact c{}, old{};
        c.a = a, c.b = b, c.normal = normal, c.normal_impulse = 0, c.friction.setZero();
        old.a = old_a, old.b = old_b, old.normal = old_normal, old.normal_impulse = impulse;
        old.friction = friction - old_normal.dot(friction) * old_normal;
        paper.input("a now", static_cast<double>(a), "a then", static_cast<double>(old_a),
                    "normal now", normal, "normal impulse then", impulse, "friction then",
                    old.friction);
        answer(c, old);
        paper.output("the normal impulse [N s]", c.normal_impulse, impulse, 1.0);
        paper.output("the friction [N s]", c.friction, old.friction, 1.0);
    }

  public:
#ifndef NUTSHELL_SHEET
    static About<TakeOver> about() {
        return {
            .title = "Warm start",
            .hints = {"The normal impulse is a number: what does it become when the two bodies "
                      "have changed places? And the friction, a vector that acts on b?",
                      "If a is now what b was, the friction that acted on the old b acts on the "
                      "new a: its opposite acts on the new b.",
                      "Lay the old friction across the new normal: less its part along it."},
            .mistakes =
                {{"the wrong body's sign", "classic: contacts are found in either order",
                  "Every few steps a block in a pile jerks, as if kicked.",
                  "When the bodies have changed places you keep the friction's sign. It acts on "
                  "b: on the old b, which is now a.",
                  [](PressedContact& c, const PressedContact& old) -> void {
                      c.normal_impulse = old.normal_impulse;
                      c.friction = old.friction - c.normal.dot(old.friction) * c.normal;
                  }},
                 {"not laid across the new normal", "classic",
                  "Rolling balls climb: their friction has a part that lifts.",
                  "The normal has turned since. Take away what the old friction has along the "
                  "new one.",
                  [](PressedContact& c, const PressedContact& old) -> void {
                      c.normal_impulse = old.normal_impulse;
                      c.friction = old.a == c.a ? old.friction : Vector3(-old.friction);
                  }},
                 {"the normal impulse changes sign too", "classic",
                  "Two boxes that were found the other way round stick together.",
                  "You turn the normal impulse round with the bodies. It is along the normal, "
                  "which has turned round by itself, and must never be negative.",
                  [](PressedContact& c, const PressedContact& old) -> void {
                      const double sign = old.a == c.a ? 1 : -1;
                      c.normal_impulse = sign * old.normal_impulse;
                      c.friction = sign * (old.friction - c.normal.dot(old.friction) * c.normal);
                  }},
                 {"no friction", "classic: only the normal impulse is kept",
                  "A stack on a slope creeps.",
                  "You take over the normal impulse and forget the friction.",
                  [](PressedContact& c, const PressedContact& old) -> void {
                      c.normal_impulse = old.normal_impulse, c.friction = Vector3::Zero();
                  }},
                 {"faded", "classic: v *= 0.98 for impulses",
                  "A tower sinks slowly into the floor.",
                  "You start with a little less than the contact had. What rests needs all of "
                  "it; the passes take back what is too much.",
                  [](PressedContact& c, const PressedContact& old) -> void {
                      const double sign = old.a == c.a ? 1 : -1;
                      c.normal_impulse = 0.98 * old.normal_impulse;
                      c.friction =
                          0.98 * sign * (old.friction - c.normal.dot(old.friction) * c.normal);
                  }},
                 {"the part along the normal added", "classic: a sign",
                  "Rolling balls gain a little speed in every step.",
                  "You add the old friction's part along the new normal once more, instead of "
                  "taking it away.",
                  [](PressedContact& c, const PressedContact& old) -> void {
                      const double sign = old.a == c.a ? 1 : -1;
                      c.normal_impulse = old.normal_impulse;
                      const Vector3 f = old.friction;
                      c.friction = sign * (f + c.normal.dot(f) * c.normal);
                  }},
                 {"stretched to its old length", "classic",
                  "Rolling balls gain a little in every step.",
                  "The friction has the right direction, but you stretch it to its old length. "
                  "What was along "
                  "the new normal is lost: do not give it back.",
                  [](PressedContact& c, const PressedContact& old) -> void {
                      const double sign = old.a == c.a ? 1 : -1;
                      c.normal_impulse = old.normal_impulse;
                      const Vector3 f = old.friction - c.normal.dot(old.friction) * c.normal;
                      c.friction =
                          f.norm() > 0 ? Vector3(sign * old.friction.norm() / f.norm() * f) : f;
                  }}},
            .alternatives = {{"by a cross product twice",
                              [](PressedContact& c, const PressedContact& old) -> void {
                                  const Vector3 f =
                                      old.a == c.a ? old.friction : Vector3(-old.friction);
                                  c.normal_impulse = old.normal_impulse;
                                  c.friction = c.normal.cross(f).cross(c.normal);
                              }}},
            .survivors = {{"an int for sign", "it is 1 or -1"},
                          {"statements 1 and 2 swapped", "neither uses what the other sets"},
                          {"statements 2 and 3 swapped", "neither uses what the other sets"}},
        };
    }
#endif
};

inline const bool take_over_entered = enter<TakeOver>();

}  // namespace nutshell::exercises
