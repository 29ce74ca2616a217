// Exercise 7.1: the impulse of an impact, along the normal and only if the two close in.
#pragma once
#include "pairs.hpp"

namespace nutshell::exercises {

struct ImpactImpulse {
    static constexpr const char *id = "7.1", *function = "impact_impulse";
    static constexpr auto subject = NUTSHELL_CALL(impact_impulse);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const Pair& pair : pairs()) {
            input(paper, pair);
            const double impulse = answer(pair.a, pair.b, pair.normal, pair.e);
            paper.output("the impulse [N s]", impulse, size_of(pair));
        }
        const Particle wall{immovable}, ball{1.6, {0, 1, 0}, {2.1, -3.3, 0.4}};
        paper.input("a", "a wall", "momentum of b", ball.momentum, "mass of b", ball.mass, "n",
                    Vector3(0, 1, 0), "e", 0.6);
        const double impulse = answer(wall, ball, Vector3(0, 1, 0), 0.6);
        paper.output("the impulse from a wall [N s]", impulse, 2 * ball.momentum.norm());
    }

#ifndef NUTSHELL_SHEET
    static About<ImpactImpulse> about() {
        using P = const Particle&;
        using V = const Vector3&;
        return {
            .title = "The impulse of an impact",
            .hints =
                {"Two cases: do they close in at all? separating_speed tells, by its sign.",
                 "An impulse j changes the velocity of b by j over its mass and that of a by "
                 "as much over the other, the other way. By how much does the separating "
                 "speed grow in all?",
                 "The separating speed has to grow from s to -e s. Divide that change by the "
                 "sum of one over each mass."},
            .mistakes =
                {{"no approach test", "E35, E36", "Balls that fly apart are pulled together.",
                  "You give an impulse to a pair that is moving apart already. A contact can "
                  "push "
                  "only what closes in.",
                  [](P a, P b, V n, double e) -> double {
                      return -(1 + e) * separating_speed(a, b, n) / (1 / a.mass + 1 / b.mass);
                  }},
                 {"the whole velocity", "E34, E35",
                  "A ball that only grazes another is thrown off as hard as head-on.",
                  "You use the length of the relative velocity. Only its part along the normal "
                  "knows of the impact.",
                  [](P a, P b, V n, double e) -> double {
                      if (separating_speed(a, b, n) >= 0) return 0;
                      const double u = (velocity(b) - velocity(a)).norm();
                      return (1 + e) * u / (1 / a.mass + 1 / b.mass);
                  }},
                 {"the normal the wrong way", "classic: from b to a",
                  "Balls go through each other, and those that part are thrown apart.",
                  "Your normal points from b to a. It points from a to b: closing in is a "
                  "negative separating speed.",
                  [](P a, P b, V n, double e) -> double {
                      const double s = -separating_speed(a, b, n);
                      if (s >= 0) return 0;
                      return -(1 + e) * s / (1 / a.mass + 1 / b.mass);
                  }},
                 {"a change of velocity", "classic: impulse not weighed by the masses",
                  "Light and heavy balls kick each other equally hard.",
                  "You return a change of speed. An impulse is that over the sum of one over "
                  "each "
                  "mass.",
                  [](P a, P b, V n, double e) -> double {
                      const double s = separating_speed(a, b, n);
                      return s < 0 ? -(1 + e) * s : 0;
                  }},
                 {"both masses added", "classic", "A fly stops a truck.",
                  "You multiply by the sum of the masses. What counts is one over each mass: the "
                  "lighter one gives way.",
                  [](P a, P b, V n, double e) -> double {
                      const double s = separating_speed(a, b, n);
                      return s < 0 ? -(1 + e) * s * std::min(1e3, a.mass + b.mass) : 0;
                  }},
                 {"stops, but does not bounce", "classic: e for 1 + e",
                  "Elastic balls stick, and sticky ones go through each other.",
                  "You give e times the impulse that stops them. First they must stop, then "
                  "leave: 1 + e.",
                  [](P a, P b, V n, double e) -> double {
                      const double s = separating_speed(a, b, n);
                      return s < 0 ? -e * s / (1 / a.mass + 1 / b.mass) : 0;
                  }},
                 {"infinity over infinity at a wall", "classic: m1 m2/(m1 + m2)",
                  "A ball that meets a wall disappears.",
                  "A wall's mass is infinite, and m1 m2/(m1 + m2) is infinity over infinity "
                  "there. "
                  "1/(1/m1 + 1/m2) is the same for balls, and right for walls.",
                  [](P a, P b, V n, double e) -> double {
                      const double s = separating_speed(a, b, n);
                      return s < 0 ? -(1 + e) * s * (a.mass * b.mass) / (a.mass + b.mass) : 0;
                  }},
                 {"the mean of the masses", "classic", "A fly stops a truck.",
                  "You take the mean of both masses. The lighter one gives way: one over the sum "
                  "of one over "
                  "each mass.",
                  [](P a, P b, V n, double e) -> double {
                      const double s = separating_speed(a, b, n);
                      return s < 0 ? -(1 + e) * s * (a.mass + b.mass) / 2 : 0;
                  }},
                 {"the comparison the wrong way round", "classic: < for >=",
                  "Balls go through each other, and those that part are pulled together.",
                  "What closes in gets no impulse, and what moves apart gets one: closing in is "
                  "a negative "
                  "separating speed.",
                  [](P a, P b, V n, double e) -> double {
                      const double s = separating_speed(a, b, n);
                      return s < 0 ? 0 : -(1 + e) * s / (1 / a.mass + 1 / b.mass);
                  }},
                 {"the root of e", "classic: restitution taken for an energy",
                  "Balls bounce too high.",
                  "You take the root of e, as if it were the part of the energy that is kept. "
                  "Restitution is a ratio of speeds.",
                  [](P a, P b, V n, double e) -> double {
                      const double s = separating_speed(a, b, n);
                      return s < 0 ? -(1 + std::sqrt(e)) * s / (1 / a.mass + 1 / b.mass) : 0;
                  }},
                 {"as if a were a wall", "classic: one mass only",
                  "Balls hit each other too hard; walls are right.",
                  "You weigh with the mass of b alone. That is right if a cannot move; a ball "
                  "gives way too.",
                  [](P a, P b, V n, double e) -> double {
                      const double s = separating_speed(a, b, n);
                      return s < 0 ? -(1 + e) * s * b.mass : 0;
                  }}},
            .alternatives = {{"by the lighter of both",
                              [](P a, P b, V n, double e) -> double {
                                  const double s =
                                      n.dot(b.momentum) / b.mass - n.dot(a.momentum) / a.mass;
                                  const double m = b.mass / (1 + b.mass / a.mass);
                                  return std::max(0.0, -m * s * (1 + e));
                              }}},
            .survivors = {{"< to <=", "at a separating speed of zero the impulse is zero"}},
        };
    }
#endif
};

inline const bool impact_impulse_entered = enter<ImpactImpulse>();

}  // namespace nutshell::exercises
