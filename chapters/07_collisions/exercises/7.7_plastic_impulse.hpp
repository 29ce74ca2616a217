// Exercise 7.7: does the contact stick or slide? Friction's bound.
#pragma once
#include <nutshell/impulse.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct PlasticImpulse {
    static constexpr const char *id = "7.7", *function = "plastic_impulse";
    static constexpr auto subject = NUTSHELL_CALL(plastic_impulse);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        Matrix3 K, other, pulls;
        K << 2.1, 0.4, -0.3, 0.4, 1.4, 0.5, -0.3, 0.5, 2.8;
        other << 1.2, -0.3, 0.2, -0.3, 2.2, -0.6, 0.2, -0.6, 1.9;
        pulls << 4.2, 3.6, 0.1, 3.6, 3.4, 0.2, 0.1, 0.2, 1.3;  // to stick it would have to pull
        const Vector3 up(0, 1, 0), n = Vector3(2, 6, -3) / 7, u(1.3, -2.2, 0.9);
        ask_one(paper, answer, K, u, up, 0.9);
        ask_one(paper, answer, K, u, up, 0.1);
        ask_one(paper, answer, K, u, up, 0.3);
        ask_one(paper, answer, K, u, up, 0);
        ask_one(paper, answer, other, u, up, 0.1);
        ask_one(paper, answer, other, u, up, 1.5);
        ask_one(paper, answer, K, {0.2, -2.2, -0.7}, up, 0.15);
        ask_one(paper, answer, K, u, n, 0.1);
        ask_one(paper, answer, K, u, n, 0.9);
        ask_one(paper, answer, pulls, {-3, -2.2, 0.1}, up, 0.4);
        ask_one(paper, answer, pulls, {-3, -2.2, 0.1}, up, 3);  // in the cone of that pull, too
        // just inside and just outside of the cone; inside of a pyramid in both cases
        const Vector3 stick(0.3, 1, 0.4), came = -K * stick;
        ask_one(paper, answer, K, came, up, 0.51);
        ask_one(paper, answer, K, came, up, 0.49);
        ask_one(paper, answer, K, came, up, 0.42);
    }

  private:
    template <class Answer>
    static void ask_one(Paper& paper, const Answer& answer, const Matrix3& K, const Vector3& u,
                        const Vector3& n, double mu) {
        paper.input("K", K, "u", u, "n", n, "mu", mu);
        const Vector3 J = answer(K, u, n, mu);
        paper.output("the impulse [N s]", J, Vector3(K.inverse() * u));
    }

  public:
#ifndef NUTSHELL_SHEET
    static About<PlasticImpulse> about() {
        using M = const Matrix3&;
        using V = const Vector3&;
        return {
            .title = "Stick or slide",
            .hints =
                {"First suppose that the contact sticks: after the impulse the relative "
                 "velocity u + K J is zero. Which J is that?",
                 "Split this impulse into its part along the normal, a number, and the rest, "
                 "friction. When may the floor give that much friction? And can it pull?",
                 "If the normal part is positive and the friction no longer than mu times it, "
                 "that is the answer; else sliding_impulse is, or smooth_impulse with e = 0 "
                 "where that finds nothing."},
            .mistakes =
                {{"friction without a bound",
                  "classic: friction not bounded by mu times the "
                  "normal impulse",
                  "Everything sticks to everything, on ice too.",
                  "You never ask mu. Friction holds at most mu times the normal impulse.",
                  [](M K, V u, V, double) -> Vector3 { return -K.inverse() * u; }},
                 {"a pyramid for the cone", "classic: each axis bounded by itself",
                  "A block that must slide stands still if it points between the axes.",
                  "You bound the two components of friction each by itself. It is the length of "
                  "friction that is bounded.",
                  [](M K, V u, V n, double mu) -> Vector3 {
                      const Vector3 stick = -K.inverse() * u;
                      const double normal = n.dot(stick);
                      const Vector3 friction = stick - normal * n;
                      if (normal > 0 && friction.lpNorm<Eigen::Infinity>() <= mu * normal)
                          return stick;
                      return sliding_impulse(K, u, n, mu).value_or(smooth_impulse(K, u, n, 0));
                  }},
                 {"friction cut afterwards", "classic: clamped after the fact",
                  "A contact that slides still closes in, or leaves by itself.",
                  "You cut the friction of the sticking impulse and keep its normal part. With "
                  "less friction the normal impulse is another one too.",
                  [](M K, V u, V n, double mu) -> Vector3 {
                      const Vector3 stick = -K.inverse() * u;
                      const double normal = n.dot(stick);
                      const Vector3 friction = stick - normal * n;
                      if (friction.norm() <= mu * normal) return stick;
                      return normal * n + mu * normal * friction.normalized();
                  }},
                 {"no friction when it slides", "classic: all or nothing",
                  "What slides never stops.",
                  "You drop friction where it cannot hold the contact. It still pulls with mu "
                  "times the normal impulse.",
                  [](M K, V u, V n, double mu) -> Vector3 {
                      const Vector3 stick = -K.inverse() * u;
                      const double normal = n.dot(stick);
                      const Vector3 friction = stick - normal * n;
                      if (normal > 0 && friction.norm() <= mu * normal) return stick;
                      return smooth_impulse(K, u, n, 0);
                  }},
                 {"always sliding", "classic: dynamic friction only",
                  "A ball that should roll trembles to and fro.",
                  "You always take the sliding impulse. First ask whether friction can hold the "
                  "contact.",
                  [](M K, V u, V n, double mu) -> Vector3 {
                      return sliding_impulse(K, u, n, mu).value_or(smooth_impulse(K, u, n, 0));
                  }},
                 {"bounded by the whole impulse", "classic", "Things stick a little too well.",
                  "You compare friction with mu times the whole impulse. It is the normal part "
                  "that presses.",
                  [](M K, V u, V n, double mu) -> Vector3 {
                      const Vector3 stick = -K.inverse() * u;
                      const double normal = n.dot(stick);
                      const Vector3 friction = stick - normal * n;
                      if (normal > 0 && friction.norm() <= mu * stick.norm()) return stick;
                      return sliding_impulse(K, u, n, mu).value_or(smooth_impulse(K, u, n, 0));
                  }},
                 {"all of the impulse for its part across", "classic",
                  "Things slide that friction could hold.",
                  "You let it slide though friction could hold it: mu times the normal part "
                  "bounds what is "
                  "across the normal, not all of the impulse.",
                  [](M K, V u, V n, double mu) -> Vector3 {
                      const Vector3 stick = -K.inverse() * u;
                      const double normal = n.dot(stick);
                      if (normal > 0 && stick.norm() <= mu * normal) return stick;
                      return sliding_impulse(K, u, n, mu).value_or(smooth_impulse(K, u, n, 0));
                  }},
                 {"mu on the wrong side", "classic", "Smooth things stick, rough ones slide.",
                  "You multiply the friction by mu. It may be at most mu times the normal part.",
                  [](M K, V u, V n, double mu) -> Vector3 {
                      const Vector3 stick = -K.inverse() * u;
                      const double normal = n.dot(stick);
                      if (normal > 0 && mu * (stick - normal * n).norm() <= normal) return stick;
                      return sliding_impulse(K, u, n, mu).value_or(smooth_impulse(K, u, n, 0));
                  }},
                 {"it pulls", "classic: the size of the normal part",
                  "Things stick to what they graze.",
                  "Your impulse pulls where sticking would need a pull. A contact can push only: "
                  "the normal part "
                  "must be positive.",
                  [](M K, V u, V n, double mu) -> Vector3 {
                      const Vector3 stick = -K.inverse() * u;
                      const double normal = n.dot(stick);
                      if ((stick - normal * n).norm() <= mu * std::abs(normal)) return stick;
                      return sliding_impulse(K, u, n, mu).value_or(smooth_impulse(K, u, n, 0));
                  }},
                 {"normal and friction each for itself",
                  "classic: two impulses, one after the other",
                  "A rod that lands askew still closes in, or leaves by itself.",
                  "You find the normal impulse as if there were no friction, and friction as if "
                  "nothing pressed. K mixes the two: each changes the velocity that the other is "
                  "to undo.",
                  [](M K, V u, V n, double mu) -> Vector3 {
                      const double normal = -n.dot(u) / n.dot(K * n);
                      const Vector3 slide = u - n.dot(u) * n, t = slide.normalized();
                      return normal * n - std::min(mu * normal, slide.norm() / t.dot(K * t)) * t;
                  }}},
            .alternatives = {{"by the angle",
                              [](M K, V u, V n, double mu) -> Vector3 {
                                  const Vector3 stick = K.ldlt().solve(-u);
                                  const double along = n.dot(stick),
                                               across = n.cross(stick).norm();
                                  if (along > 0 && across <= mu * along) return stick;
                                  if (const auto slides = sliding_impulse(K, u, n, mu))
                                      return *slides;
                                  return smooth_impulse(K, u, n, 0);
                              }}},
            .survivors = {{"0 to 0 + 1, 2",
                           "for the mobilities of bodies a direction of sliding is always found"},
                          {"n to u, 4",
                           "for the mobilities of bodies a direction of sliding is always found"},
                          {"u to n, 3",
                           "for the mobilities of bodies a direction of sliding is always found"},
                          {"<= to <", "on the border of the cone sticking and sliding are one"},
                          {"> to >=", "what does not press does not rub either"}},
        };
    }
#endif
};

inline const bool plastic_impulse_entered = enter<PlasticImpulse>();

}  // namespace nutshell::exercises
