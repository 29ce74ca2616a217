// Exercise 7.8: one contact's turn, the heart of the solver.
#pragma once
#include <nutshell/contact_solver.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct PressOne {
    static constexpr const char *id = "7.8", *function = "press";
    static constexpr auto subject = NUTSHELL_CALL(press);

    /// Two bodies that touch, both moving and turning, with some impulse from before.
    struct Pair {
        Body a, b;
        Mobility of_a, of_b;
        PressedContact c;
    };
    static Pair pair(double normal_impulse, const Vector3& friction, const Vector3& push) {
        Pair p;
        p.a.mass = 2, p.a.inertia = {0.5, 0.7, 0.9}, p.a.momentum = {0.3, 0.4, -0.2};
        p.a.orientation = Quaternion(0.9, 0.2, -0.3, 0.25).normalized();
        p.a.angular_momentum = {0.1, -0.2, 0.3};
        p.b.mass = 3, p.b.inertia = {0.8, 0.6, 1.1}, p.b.momentum = push;
        p.b.position = {0.1, 1.2, -0.2};
        p.b.angular_momentum = {-0.2, 0.1, 0.15};
        p.of_a = {1 / p.a.mass, world_inverse_inertia(p.a)};
        p.of_b = {1 / p.b.mass, world_inverse_inertia(p.b)};
        PressedContact& c = p.c;
        c.a = 0, c.b = 1, c.feature = 0, c.balls = false;
        c.normal = Vector3(0.1, 0.9, -0.2).normalized();
        c.lever_a = {0.15, 0.55, -0.2}, c.lever_b = {0.05, -0.65, 0.1};
        c.separation = 0, c.normal_mass = 1.1, c.friction_mass = 0.8;
        c.normal_impulse = normal_impulse;
        c.friction = friction - c.normal.dot(friction) * c.normal;
        c.anchor_a = c.anchor_b = Vector3::Zero(), c.radius_a = c.radius_b = 0;
        return p;
    }

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Press hard{0.01, 0.5, 0, 0}, rough{0.01, 2.5, 0, 0}, slippery{0.01, 0.1, 0, 0};
        const Vector3 in(0.8, -3, 0.5), slow(0.4, -0.9, 0.1), out(0.2, 2.5, 0.1),
            gently(0.3, 0.2, -0.2);
        const Vector3 none = Vector3::Zero(), some(0.2, 0.1, -0.15);
        one(paper, answer, "closing in", pair(0, none, in), hard);
        one(paper, answer, "closing in, slippery", pair(0, none, in), slippery);
        one(paper, answer, "closing in, rough", pair(0, none, in), rough);
        one(paper, answer, "pressed before", pair(0.9, some, slow), hard);
        one(paper, answer, "pressed before, opens gently", pair(1.5, some, gently), hard);
        one(paper, answer, "pressed before, opens fast", pair(0.7, some, out), hard);
        one(paper, answer, "apart and leaving", pair(0, none, out), hard);
        one(paper, answer, "pressed before, flies off", pair(0.7, some, {0.2, 9, 0.1}), hard);
        one(paper, answer, "hardly pressed before, flies off", pair(0.0005, none, out), hard);
        Pair other = pair(0.3, none, in);
        other.c.normal = Vector3(-0.3, 0.8, 0.4).normalized();
        other.c.friction = Vector3(0.08, 0.03, 0).cross(other.c.normal);
        one(paper, answer, "another normal", other, hard);
        other.c.normal_mass = 0.9;
        one(paper, answer, "one that answers less along it", other, rough);
        other.c.friction_mass = 0.5;
        one(paper, answer, "and across it", other, rough);
        Pair barely = pair(0, none, in);  // closes in at half a millimetre a second
        const Vector3 u =
            contact_velocity(barely.c, barely.a, barely.b, barely.of_a, barely.of_b);
        barely.b.momentum -= barely.b.mass * (barely.c.normal.dot(u) + 0.0005) * barely.c.normal;
        one(paper, answer, "closing in, barely", barely, hard, 0.003);
        Pair gap = pair(0.2, some, in);
        gap.c.separation = 0.004;
        one(paper, answer, "a gap of 4 mm", gap, rough);
        Press soft = hard;
        soft.soft = {20, 0.7, 0.3};
        Pair deep = pair(0.8, some, slow);
        deep.c.separation = -0.01;
        one(paper, answer, "1 cm deep, soft", deep, soft);
        Press pyramid = slippery;
        pyramid.pyramid = true;
        one(paper, answer, "closing in, a pyramid of friction", pair(0, none, in), pyramid);
    }

  private:
    template <class Answer>
    static void one(Paper& paper, const Answer& answer, const char* what, Pair p,
                    const Press& want, double size = 3) {
        const Pair start = p;
        paper.input("contact", what, "momentum of b", p.b.momentum, "friction coefficient",
                    want.friction, "impulse so far", p.c.normal_impulse, "separation",
                    p.c.separation);
        answer(p.c, p.a, p.b, p.of_a, p.of_b, want);
        paper.output("the normal impulse of the sub-step so far [N s]", p.c.normal_impulse, size);
        paper.output("the friction of the sub-step so far [N s]", p.c.friction, size);
        paper.changed("the momentum of a [kg m/s]", p.a.momentum, start.a.momentum, size);
        paper.changed("the momentum of b [kg m/s]", p.b.momentum, start.b.momentum, size);
        paper.changed("the angular momentum of a [kg m^2/s]", p.a.angular_momentum,
                      start.a.angular_momentum, size);
        paper.changed("the angular momentum of b [kg m^2/s]", p.b.angular_momentum,
                      start.b.angular_momentum, size);
    }

  public:
#ifndef NUTSHELL_SHEET
    /// How a wrong answer differs from the right one.
    struct Slip {
        bool clamp_each = false, may_pull = false, no_cone = false, cone_of_old = false,
             no_levers = false, forget = false, add = false, whole = false, no_fade = false,
             cone_only = false, anew = false;
    };
    static void with(const Slip& slip, PressedContact& c, Body& a, Body& b, const Mobility& of_a,
                     const Mobility& of_b, const Press& want) {
        Vector3 u = contact_velocity(c, a, b, of_a, of_b);
        if (slip.add)
            u = of_b.inverse_mass * b.momentum + of_a.inverse_mass * a.momentum +
                (of_b.inverse_inertia * b.angular_momentum).cross(c.lever_b) +
                (of_a.inverse_inertia * a.angular_momentum).cross(c.lever_a);
        const double s = c.normal.dot(u), before = c.normal_impulse;
        const Wish wish = wish_of(c, s, want);
        const double more = wish.mass * c.normal_mass * (wish.speed - s);
        double normal = std::max(0.0, (1 - wish.fade) * before + more);
        if (slip.clamp_each) normal = before + std::max(0.0, more - wish.fade * before);
        if (slip.no_fade) normal = std::max(0.0, before + more);
        if (slip.may_pull) normal = (1 - wish.fade) * before + more;
        Vector3 wanted = (slip.anew ? 0 : 1) * c.friction -
                         c.friction_mass * (slip.whole ? u : u - s * c.normal);
        const double limit = want.friction * (slip.cone_of_old ? before : normal);
        const Vector3 friction = slip.no_cone ? wanted
                                 : want.pyramid && !slip.cone_only
                                     ? in_pyramid(wanted, limit, c.normal)
                                     : in_cone(wanted, limit);
        const Vector3 J =
            (normal - before) * c.normal + friction - (slip.anew ? 0 : 1) * c.friction;
        if (slip.no_levers)
            a.momentum -= J, b.momentum += J;
        else
            apply_impulse(c, a, b, J);
        if (!slip.forget) c.normal_impulse = normal, c.friction = friction;
    }
    static auto wrong(const Slip& slip) {
        return [slip](PressedContact& c, Body& a, Body& b, const Mobility& of_a,
                      const Mobility& of_b,
                      const Press& want) -> void { with(slip, c, a, b, of_a, of_b, want); };
    }
    static About<PressOne> about() {
        return {
            .title = "One contact's turn",
            .hints = {"What is the separating speed now, and what is it wished to be? What "
                      "impulse along the normal makes up for the difference?",
                      "Add it to what the contact had so far, and only then forbid the sum to be "
                      "negative. The same for friction: add, then bring the sum into the cone of "
                      "the new normal impulse.",
                      "Apply the difference between the new sums and the old ones, and keep the "
                      "new ones in c."},
            .mistakes =
                {{"each impulse clamped, not the sum", "classic: clamping the increment",
                  "Stacks swell and hop: a contact that was given too much can never give it "
                  "back.",
                  "You forbid each new impulse to be negative. It is the sum that must not be: a "
                  "later turn has to take back what an earlier one gave too much.",
                  wrong({.clamp_each = true})},
                 {"it pulls", "classic", "Balls that leave the floor are held back as by glue.",
                  "Your normal impulse may become negative. A contact can push only.",
                  wrong({.may_pull = true})},
                 {"friction without a bound", "classic: friction not bounded by mu N",
                  "Nothing ever slides, not even on ice.",
                  "Your friction is as large as sticking needs. It may be at most mu times the "
                  "normal impulse.",
                  wrong({.no_cone = true})},
                 {"bounded by the last normal impulse", "classic: one turn late",
                  "The first touch has no friction.",
                  "You bound friction by the normal impulse from before this turn. Take the new "
                  "sum.",
                  wrong({.cone_of_old = true})},
                 {"friction takes the normal part too", "E34: the whole relative velocity",
                  "Balls that land lose their bounce to friction.",
                  "You give friction the whole relative velocity. Only what is across the "
                  "normal slides.",
                  wrong({.whole = true})},
                 {"no levers", "classic: the impulse at the centre",
                  "A brick hit at its end flies off without turning.",
                  "The momenta change, the angular momenta do not. The impulse acts at the "
                  "contact, not at the centres: apply_impulse knows its levers.",
                  wrong({.no_levers = true})},
                 {"nothing is kept", "classic: no accumulation",
                  "The first pass helps, all others shake.",
                  "The contact does not keep its new sums. The next turn then begins from wrong "
                  "ones.",
                  wrong({.forget = true})},
                 {"velocities added", "E48: the printed operator- adds",
                  "Two bodies that fly side by side collide.",
                  "You add the velocities of the two points. What counts is their difference, "
                  "b's seen from a's.",
                  wrong({.add = true})},
                 {"nothing is given back", "classic: wish.fade forgotten", "Soft things ring.",
                  "A soft contact gives back the part wish.fade of what it had: you keep all of "
                  "it.",
                  wrong({.no_fade = true})},
                 {"friction begun anew", "classic: not accumulated", "Stacks creep sideways.",
                  "You begin the friction anew in each turn. Like the normal impulse it is a "
                  "sum: from "
                  "c.friction on.",
                  wrong({.anew = true})},
                 {"always the cone", "classic: want.pyramid forgotten",
                  "None: the cone is the better one.",
                  "want.pyramid makes no difference: where it is set, in_pyramid bounds the "
                  "friction.",
                  wrong({.cone_only = true})}},
            .alternatives = {{"increments first, then clamped against the sum",
                              [](PressedContact& c, Body& a, Body& b, const Mobility& of_a,
                                 const Mobility& of_b, const Press& want) -> void {
                                  const Vector3 u = contact_velocity(c, a, b, of_a, of_b);
                                  const Wish wish = wish_of(c, c.normal.dot(u), want);
                                  double more =
                                      wish.mass * c.normal_mass * (wish.speed - c.normal.dot(u)) -
                                      wish.fade * c.normal_impulse;
                                  more = std::max(more, -c.normal_impulse);
                                  const Vector3 across = u - c.normal.dot(u) * c.normal;
                                  const Vector3 wanted = c.friction - c.friction_mass * across;
                                  const double limit = want.friction * (c.normal_impulse + more);
                                  Vector3 friction = wanted;
                                  if (want.pyramid)
                                      friction = in_pyramid(wanted, limit, c.normal);
                                  else if (wanted.norm() > limit)
                                      friction = wanted.normalized() * limit;
                                  apply_impulse(c, a, b, more * c.normal + friction - c.friction);
                                  c.normal_impulse += more, c.friction = friction;
                              }}},
            .survivors = {{"0 to 0 + 1", "the early end saves time: its sums are zero anyway"},
                          {"0 to 0 + 1, 2", "the early end saves time: its sums are zero anyway"},
                          {"0.0 to 0.999 of it", "zero has no fraction"},
                          {"no statement 2",
                           "the early end saves time: its sums are zero anyway"},
                          {"statements 2 and 3 swapped", "the early end changes nothing"},
                          {"statements 2 and 4 swapped", "the early end changes nothing"}},
        };
    }
#endif
};

inline const bool press_entered = enter<PressOne>();

}  // namespace nutshell::exercises
