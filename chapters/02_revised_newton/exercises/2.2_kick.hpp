// Exercise 2.2: the kick of a particle that is described by its momentum.
#pragma once
#include <nutshell/revised_newton.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct KickInMomentum {
    static constexpr const char *id = "2.2", *function = "kick";
    static constexpr auto subject = NUTSHELL_CALL(kick);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const double dt = paper.step(0.3);
        const Vector3 a{1.2, -0.7, 2.1}, b{-3.4, 5.1, 2.6}, f{14, -23, 9}, g{-6, 3.5, 11};
        for (const auto& [start, force] : {std::pair{Particle{2.5, a, b}, f},
                                           {Particle{0.4, a, b}, f},
                                           {Particle{2.5, a, a}, f},
                                           {Particle{2.5, a, b}, g}}) {
            paper.input("mass", start.mass, "momentum", start.momentum, "force", force, "dt", dt);
            Particle body = start;
            answer(body, force, dt);
            paper.changed("the momentum after the kick [kg m/s]", body.momentum, start.momentum,
                          force * dt);
            paper.changed("the position after the kick [m]", body.position, start.position);
            paper.changed("the mass after the kick [kg]", body.mass, start.mass);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<KickInMomentum> about() {
        return {
            .title = "Kick a momentum",
            .hints =
                {"In chapter 1 a kick changed a velocity, and the same kick moved a light body "
                 "more. What does it do to a momentum?",
                 "Equation (11), with a mass that stays: the force is the change of momentum per "
                 "second.",
                 "The change of momentum in dt seconds is the force times dt. No mass in it."},
            .mistakes = {{"divided by the mass", "classic: chapter 1's kick",
                          "Heavy things hardly fall; a body of 1 kg looks right.",
                          "You divide the force by the mass, as a velocity wants it. A momentum "
                          "has the mass in it already; the drift divides.",
                          [](Particle& body, const Vector3& force, double dt) {
                              body.momentum += force / body.mass * dt;
                          }},
                         {"the force taken for an acceleration", "classic: gravity given as g",
                          "Heavy things fall faster than light ones.",
                          "You multiply the force by the mass. The push you are given is a force "
                          "[N]; its law has put the mass in where it belongs.",
                          [](Particle& body, const Vector3& force, double dt) {
                              body.momentum += body.mass * force * dt;
                          }},
                         {"a second in every kick", "classic: moving by frames",
                          "The shorter the frame, the harder everything falls.",
                          "You add the whole force. A force is the change of momentum per "
                          "second, and the kick lasts dt seconds.",
                          [](Particle& body, const Vector3& force, double) {
                              body.momentum += force;
                          }},
                         {"forgets how it moved", "classic: = for +=",
                          "Bodies have no inertia: they stop as soon as the force does.",
                          "You replace the momentum by the kick's. The kick must be added to the "
                          "momentum the body had.",
                          [](Particle& body, const Vector3& force, double dt) {
                              body.momentum = force * dt;
                          }}},
            .alternatives = {{"the impulse first",
                              [](Particle& body, const Vector3& force, double dt) {
                                  const Vector3 impulse = dt * force;
                                  body.momentum = body.momentum + impulse;
                              }}},
        };
    }
#endif
};

inline const bool kick_in_momentum_entered = enter<KickInMomentum>();

}  // namespace nutshell::exercises
