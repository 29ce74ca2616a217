// Exercise 7.2: one impulse changes both momenta.
#pragma once
#include "pairs.hpp"

namespace nutshell::exercises {

struct CollideParticles {
    static constexpr const char *id = "7.2", *function = "collide";
    static constexpr auto subject = NUTSHELL_CALL(collide);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const Pair& pair : pairs()) {
            input(paper, pair);
            Particle a = pair.a, b = pair.b;
            answer(a, b, pair.normal, pair.e);
            const double size = size_of(pair);
            paper.changed("the momentum of a [kg m/s]", a.momentum, pair.a.momentum, size);
            paper.changed("the momentum of b [kg m/s]", b.momentum, pair.b.momentum, size);
            paper.changed("the position of b [m]", b.position, pair.b.position);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<CollideParticles> about() {
        using P = Particle&;
        using V = const Vector3&;
        return {
            .title = "One impulse, two momenta",
            .hints =
                {"impact_impulse gives a number. Times the normal it is an impulse: a vector.",
                 "What one gains the other loses. The normal points from a to b: which of "
                 "the two is pushed along it?",
                 "Add the vector to the momentum of b and take it from that of a. No mass is "
                 "needed any more."},
            .mistakes =
                {{"the whole velocity turned round", "E35, E36",
                  "A ball that is hit at 45 degrees stops dead.",
                  "You reverse the whole relative velocity, as eqs. (67) and (68) are printed. "
                  "Only its part along the normal turns round.",
                  [](P a, P b, V n, double e) {
                      if (separating_speed(a, b, n) >= 0) return;
                      const Vector3 u = velocity(b) - velocity(a);
                      const Vector3 J = -(1 + e) / (1 / a.mass + 1 / b.mass) * u;
                      a.momentum -= J, b.momentum += J;
                  }},
                 {"both the same way", "classic: Newton's third law forgotten",
                  "Two balls that meet fly off together, out of nothing.",
                  "Both of your momenta change by the same vector. What b gains, a loses.",
                  [](P a, P b, V n, double e) {
                      const Vector3 J = impact_impulse(a, b, n, e) * n;
                      a.momentum += J, b.momentum += J;
                  }},
                 {"signs exchanged", "classic: normal from b to a",
                  "The balls suck each other in and pass through.",
                  "You push a along the normal and b against it. The normal points from a to b, "
                  "so b is pushed along it.",
                  [](P a, P b, V n, double e) {
                      const Vector3 J = impact_impulse(a, b, n, e) * n;
                      a.momentum += J, b.momentum -= J;
                  }},
                 {"divided by the mass", "classic: velocity for momentum",
                  "Only balls of one kilogram bounce rightly.",
                  "You divide the impulse by the mass. That is the change of a velocity; a "
                  "momentum changes by the impulse itself.",
                  [](P a, P b, V n, double e) {
                      const Vector3 J = impact_impulse(a, b, n, e) * n;
                      a.momentum -= J / a.mass, b.momentum += J / b.mass;
                  }},
                 {"only one of both", "classic",
                  "Everything bounces off a ball that never moves.",
                  "You change b only. The impulse has an opposite: a gets it.",
                  [](P a, P b, V n, double e) { b.momentum += impact_impulse(a, b, n, e) * n; }},
                 {"the second sees the first's new speed", "classic: read after write",
                  "Every impact loses some momentum.",
                  "You ask for the impulse again after a has changed. Both get the same one: "
                  "compute it once.",
                  [](P a, P b, V n, double e) {
                      a.momentum -= impact_impulse(a, b, n, e) * n;
                      b.momentum += impact_impulse(a, b, n, e) * n;
                  }}},
            .alternatives = {{"through the centre of mass",
                              [](P a, P b, V n, double e) {
                                  const double s = separating_speed(a, b, n);
                                  if (s >= 0) return;
                                  const double total = a.mass + b.mass;
                                  b.momentum -= (1 + e) * s * a.mass * b.mass / total * n;
                                  a.momentum += (1 + e) * s * a.mass * b.mass / total * n;
                              }}},
        };
    }
#endif
};

inline const bool collide_particles_entered = enter<CollideParticles>();

}  // namespace nutshell::exercises
