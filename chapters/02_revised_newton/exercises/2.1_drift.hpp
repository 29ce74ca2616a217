// Exercise 2.1: the drift of a particle that is described by its momentum.
#pragma once
#include <nutshell/revised_newton.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct DriftInMomentum {
    static constexpr const char *id = "2.1", *function = "drift";
    static constexpr auto subject = NUTSHELL_CALL(drift);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const double dt = paper.step(0.3);
        const Vector3 a{1.2, -0.7, 2.1}, b{-3.4, 5.1, 2.6}, c{0.8, 1.9, -4.2};
        for (const Particle& start :
             {Particle{2.5, a, b}, {0.4, a, b}, {2.5, c, b}, {2.5, a, c}}) {
            paper.input("mass", start.mass, "position", start.position, "momentum",
                        start.momentum, "dt", dt);
            Particle body = start;
            answer(body, dt);
            paper.changed("the position after the drift [m]", body.position, start.position,
                          start.momentum / start.mass * dt);
            paper.changed("the momentum after the drift [kg m/s]", body.momentum, start.momentum);
            paper.changed("the mass after the drift [kg]", body.mass, start.mass);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<DriftInMomentum> about() {
        return {
            .title = "Drift with a momentum",
            .hints = {"In chapter 1 the body moved by its velocity times dt. Here nobody tells "
                      "you the velocity.",
                      "Momentum is mass times velocity. Turn that round: what is the velocity?",
                      "Momentum over mass is the velocity; the body moves that far in one "
                      "second, and you have dt seconds."},
            .mistakes = {{"momentum for velocity", "classic: a body of 1 kg",
                          "Heavy things race, light things crawl; a body of 1 kg looks right.",
                          "You move the body by its momentum. The same momentum moves a heavier "
                          "body more slowly: divide by the mass.",
                          [](Particle& body, double dt) { body.position += body.momentum * dt; }},
                         {"the mass above the line", "classic",
                          "The heavier a thing is, the faster it flies off.",
                          "You multiply by the mass. A velocity is momentum divided by mass.",
                          [](Particle& body, double dt) {
                              body.position += body.momentum * body.mass * dt;
                          }},
                         {"a second in every step", "classic: moving by frames",
                          "Everything jumps a whole second ahead in every frame.",
                          "You move the body by its velocity, which is the way of one second. "
                          "The step has dt seconds.",
                          [](Particle& body, double) {
                              body.position += body.momentum / body.mass;
                          }},
                         {"starts from the origin every time", "classic: = for +=",
                          "The body trembles near the origin and never gets away.",
                          "You replace the position by the way of this step. The way must be "
                          "added to where the body was.",
                          [](Particle& body, double dt) {
                              body.position = body.momentum / body.mass * dt;
                          }}},
            .alternatives = {{"velocity first",
                              [](Particle& body, double dt) {
                                  const Vector3 v = velocity(body);
                                  body.position = dt * v + body.position;
                              }}},
        };
    }
#endif
};

inline const bool drift_in_momentum_entered = enter<DriftInMomentum>();

}  // namespace nutshell::exercises
