// Exercise 3.9: one spring put right, the inner step of position-based dynamics.
#pragma once
#include <nutshell/stiff_steps.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct AtRestLength {
    static constexpr const char *id = "3.9", *function = "at_rest_length";
    static constexpr auto subject = NUTSHELL_CALL(at_rest_length);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Vector3 a{1.3, -0.4, 2.2}, far{-2.1, 3.4, 0.3}, near{0.9, 0.1, 1.7};
        ask_one(paper, answer, a, far, 1.6, 0.7, 1.9);   // too long
        ask_one(paper, answer, a, near, 1.6, 0.7, 1.9);  // too short
        ask_one(paper, answer, a, far, 1.6, 1.9, 0.7);
        ask_one(paper, answer, a, far, 2.7, 0.7, 1.9);
        ask_one(paper, answer, near, far, 1.6, 0.7, 1.9);
        ask_one(paper, answer, a, far, 1.6, 1.3, 1.3);
        ask_one(paper, answer, a, far, 1.6, 0, 1.9);  // a is held
        ask_one(paper, answer, a, far, 1.6, 0.7, 0);  // b is held
        ask_one(paper, answer, a, far, 1.6, 0, 0);    // both are
        ask_one(paper, answer, a, far, 0, 0.7, 1.9);
        ask_one(paper, answer, a, a + Vector3(4e-6, 0, -3e-6), 1.6, 0.7, 1.9);  // nearly meet
        ask_one(paper, answer, a, a, 1.6, 0.7, 1.9);                            // meet
        ask_one(paper, answer, a, far, 1.6, 2e-5, 3e-5);                        // both heavy
    }

  private:
    template <class Answer>
    static void ask_one(Paper& paper, const Answer& answer, const Vector3& a, const Vector3& b,
                        double rest_length, double inverse_mass_a, double inverse_mass_b) {
        paper.input("a", a, "b", b, "rest_length", rest_length, "inverse_mass_a", inverse_mass_a,
                    "inverse_mass_b", inverse_mass_b);
        const Ends ends = answer(a, b, rest_length, inverse_mass_a, inverse_mass_b);
        paper.output("where a comes to [m]", ends.a, a, b, rest_length);
        paper.output("where b comes to [m]", ends.b, a, b, rest_length);
    }

  public:
#ifndef NUTSHELL_SHEET
    static About<AtRestLength> about() {
        return {
            .title = "One spring put right",
            .hints =
                {"Draw two balls, one heavy and one light, joined by a spring that is too long. "
                 "How much too long is it, and which ball should go farther?",
                 "All that is too much is the part 1 - rest_length / length of the way from a to "
                 "b. End a goes its share of that way forwards, end b the other share backwards; "
                 "the shares are in the ratio of the inverse masses and add up to one.",
                 "Take way, length and the sum of the inverse masses. If length or sum is zero, "
                 "give back both ends. Else a plus its inverse mass over the sum times the part "
                 "of the way, and b minus its own share."},
            .mistakes =
                {{"half the way each", "classic: equal masses taken for granted",
                  "A heavy lamp on a light cable jumps about as if it weighed nothing, and hooks "
                  "come off the wall.",
                  "You move both ends alike. The lighter one must go farther, in proportion to "
                  "its inverse mass, and an end whose inverse mass is zero not at all.",
                  [](const Vector3& a, const Vector3& b, double rest_length, double,
                     double) -> Ends {
                      const Vector3 way = b - a;
                      if (way.norm() == 0) return {a, b};
                      const Vector3 half = (1 - rest_length / way.norm()) / 2 * way;
                      return {a + half, b - half};
                  }},
                 {"shares exchanged", "classic: masses for inverse masses",
                  "The heavy end runs to the light one.",
                  "Each end has got the share of the other. What has the larger inverse mass is "
                  "light, and goes farther.",
                  [](const Vector3& a, const Vector3& b, double rest_length,
                     double inverse_mass_a, double inverse_mass_b) -> Ends {
                      const Ends other =
                          at_rest_length(a, b, rest_length, inverse_mass_b, inverse_mass_a);
                      return other;
                  }},
                 {"the whole way at both ends", "classic: the sum forgotten",
                  "The cloth shakes: every spring that was too long is now too short.",
                  "Each end makes up for all that is too much. Together they must do it once: "
                  "their shares add up to one.",
                  [](const Vector3& a, const Vector3& b, double rest_length,
                     double inverse_mass_a, double inverse_mass_b) -> Ends {
                      const Vector3 way = b - a;
                      if (way.norm() == 0) return {a, b};
                      const Vector3 all = (1 - rest_length / way.norm()) * way;
                      return {inverse_mass_a > 0 ? Vector3(a + all) : a,
                              inverse_mass_b > 0 ? Vector3(b - all) : b};
                  }},
                 {"both ends the same way", "classic: the sign of the second end",
                  "The net wanders off, and no spring gets its length.",
                  "Both ends move the same way. They must go towards each other, or away from "
                  "each other: one sign differs.",
                  [](const Vector3& a, const Vector3& b, double rest_length,
                     double inverse_mass_a, double inverse_mass_b) -> Ends {
                      const Ends ends =
                          at_rest_length(a, b, rest_length, inverse_mass_a, inverse_mass_b);
                      return {ends.a, b + (b - ends.b)};
                  }},
                 {"a longer spring gets longer", "classic: the sign of the way",
                  "The net explodes in the first frame.",
                  "You move the ends apart where the spring is too long. The way from a to b is "
                  "b - a: a goes along it, b against it.",
                  [](const Vector3& a, const Vector3& b, double rest_length,
                     double inverse_mass_a, double inverse_mass_b) -> Ends {
                      const Ends ends =
                          at_rest_length(a, b, rest_length, inverse_mass_a, inverse_mass_b);
                      return {a - (ends.a - a), b - (ends.b - b)};
                  }},
                 {"no guard where the ends meet", "classic: a direction of nothing",
                  "Two points of the cloth meet, and a hole of NaN spreads from there.",
                  "Where both ends are at one place there is no direction: you divide by a "
                  "length "
                  "of zero. Give both ends back.",
                  [](const Vector3& a, const Vector3& b, double rest_length,
                     double inverse_mass_a, double inverse_mass_b) -> Ends {
                      const Vector3 way = b - a;
                      const double both = inverse_mass_a + inverse_mass_b;
                      if (both == 0) return {a, b};
                      const Vector3 all = (1 - rest_length / way.norm()) / both * way;
                      return {a + inverse_mass_a * all, b - inverse_mass_b * all};
                  }},
                 {"no guard where both ends are held", "classic: the frame of the cloth",
                  "The seam that is nailed to the wall turns into NaN.",
                  "With both ends held the inverse masses add up to zero, and you divide by it. "
                  "Give both ends back.",
                  [](const Vector3& a, const Vector3& b, double rest_length,
                     double inverse_mass_a, double inverse_mass_b) -> Ends {
                      const Vector3 way = b - a;
                      if (way.norm() == 0) return {a, b};
                      const Vector3 all = (1 - rest_length / way.norm()) /
                                          (inverse_mass_a + inverse_mass_b) * way;
                      return {a + inverse_mass_a * all, b - inverse_mass_b * all};
                  }},
                 {"a rope, not a spring", "classic: published cloth steps that only shorten",
                  "Pushed together, the cloth crumples to a ball without volume.",
                  "You leave a spring that is too short as it is. This one is to have its rest "
                  "length afterwards: it pushes too.",
                  [](const Vector3& a, const Vector3& b, double rest_length,
                     double inverse_mass_a, double inverse_mass_b) -> Ends {
                      if ((b - a).norm() < rest_length) return {a, b};
                      return at_rest_length(a, b, rest_length, inverse_mass_a, inverse_mass_b);
                  }},
                 {"b is put right after a has moved", "classic: the new place used too early",
                  "Springs keep part of what was too much, and the centre of mass creeps.",
                  "You move a, and then take the way from there for b. Both shares belong to the "
                  "way as it was.",
                  [](const Vector3& a, const Vector3& b, double rest_length,
                     double inverse_mass_a, double inverse_mass_b) -> Ends {
                      const Vector3 moved =
                          at_rest_length(a, b, rest_length, inverse_mass_a, inverse_mass_b).a;
                      return {moved, at_rest_length(moved, b, rest_length, inverse_mass_a,
                                                    inverse_mass_b)
                                         .b};
                  }},
                 {"shares that do not add up to one", "classic: not divided by the sum",
                  "Light cloth explodes, heavy cloth stretches.",
                  "Each end goes its inverse mass times the way. Divide by the sum of both "
                  "inverse masses.",
                  [](const Vector3& a, const Vector3& b, double rest_length,
                     double inverse_mass_a, double inverse_mass_b) -> Ends {
                      const Vector3 way = b - a;
                      if (way.norm() == 0) return {a, b};
                      const Vector3 all = (1 - rest_length / way.norm()) * way;
                      return {a + inverse_mass_a * all, b - inverse_mass_b * all};
                  }},
                 {"a direction that is not of length one", "classic",
                  "Long springs shoot past their length.",
                  "You multiply what is too much by the whole way between the ends. Its "
                  "direction is the way "
                  "over its length.",
                  [](const Vector3& a, const Vector3& b, double rest_length,
                     double inverse_mass_a, double inverse_mass_b) -> Ends {
                      const Vector3 way = b - a;
                      const double both = inverse_mass_a + inverse_mass_b;
                      if (way.norm() == 0 || both == 0) return {a, b};
                      const Vector3 all = (way.norm() - rest_length) / both * way;
                      return {a + inverse_mass_a * all, b - inverse_mass_b * all};
                  }},
                 {"divided by the rest length", "classic",
                  "Springs shorter than nothing explode.",
                  "You take what is too much in parts of the rest length. Of the length that is "
                  "there it is "
                  "1 - rest_length / length.",
                  [](const Vector3& a, const Vector3& b, double rest_length,
                     double inverse_mass_a, double inverse_mass_b) -> Ends {
                      const Vector3 way = b - a;
                      const double both = inverse_mass_a + inverse_mass_b;
                      if (way.norm() == 0 || both == 0) return {a, b};
                      const Vector3 all = (way.norm() / rest_length - 1) * way;
                      return {a + inverse_mass_a / both * all, b - inverse_mass_b / both * all};
                  }},
                 {"one held end holds both", "classic: or for and",
                  "Cloth stretches without end beside its hooks.",
                  "Where one end is held you give back both. Then the other end has to go all of "
                  "the way; only where both are held nothing moves.",
                  [](const Vector3& a, const Vector3& b, double rest_length,
                     double inverse_mass_a, double inverse_mass_b) -> Ends {
                      if (inverse_mass_a == 0 || inverse_mass_b == 0) return {a, b};
                      return at_rest_length(a, b, rest_length, inverse_mass_a, inverse_mass_b);
                  }},
                 {"half of what is too much", "classic: half for each, twice",
                  "Cloth stretches like rubber.",
                  "Your two shares together make up for half of what is too much. They must do "
                  "it for all of it.",
                  [](const Vector3& a, const Vector3& b, double rest_length,
                     double inverse_mass_a, double inverse_mass_b) -> Ends {
                      const Ends ends =
                          at_rest_length(a, b, rest_length, inverse_mass_a, inverse_mass_b);
                      return {(a + ends.a) / 2, (b + ends.b) / 2};
                  }}},
            .alternatives = {{"by the centre of mass",
                              [](const Vector3& a, const Vector3& b, double rest_length,
                                 double inverse_mass_a, double inverse_mass_b) -> Ends {
                                  const double both = inverse_mass_a + inverse_mass_b;
                                  if (both == 0 || a == b) return {a, b};
                                  const double part = inverse_mass_a / both;
                                  const Vector3 centre = (1 - part) * a + part * b;
                                  const Vector3 along = (b - a).normalized();
                                  return {centre - part * rest_length * along,
                                          centre + (1 - part) * rest_length * along};
                              }}},
            .survivors = {},
        };
    }
#endif
};

inline const bool at_rest_length_entered = enter<AtRestLength>();

}  // namespace nutshell::exercises
