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
        const double dt = paper.step(0.1);
        const Vector3 force{14, -23, 9};
        for (const double mass : {2.5, 0.4}) {
            const Particle start{mass, {1.2, -0.7, 2.1}, {-3.4, 5.1, 2.6}};
            paper.input("mass", mass, "momentum", start.momentum, "force", force, "dt", dt);
            Particle body = start;
            answer(body, force, dt);
            paper.output("the momentum after the kick [kg m/s]", body.momentum, start.momentum,
                         force * dt);
            paper.output("the position after the kick [m]", body.position, start.position);
        }
    }
#ifndef NUTSHELL_SHEET
    static Exercise about();
#endif
};

inline const bool kick_in_momentum_entered = enter<KickInMomentum>();

}  // namespace nutshell::exercises

#ifndef NUTSHELL_SHEET

namespace nutshell::mistakes {

inline void kick_over_mass(Particle& body, const Vector3& force, double dt) {
    body.momentum += force / body.mass * dt;
}
inline void kick_times_mass(Particle& body, const Vector3& force, double dt) {
    body.momentum += body.mass * force * dt;
}
inline void kick_without_dt(Particle& body, const Vector3& force, double) {
    body.momentum += force;
}
inline void kick_from_rest(Particle& body, const Vector3& force, double dt) {
    body.momentum = force * dt;
}

}  // namespace nutshell::mistakes

namespace nutshell::alternatives {

inline void kick_by_impulse(Particle& body, const Vector3& force, double dt) {
    const Vector3 impulse = dt * force;
    body.momentum = body.momentum + impulse;
}

}  // namespace nutshell::alternatives

namespace nutshell::exercises {

inline Exercise KickInMomentum::about() {
    return {
        .title = "Kick a momentum",
        .hints = {"In chapter 1 a kick changed a velocity, and the same kick moved a light body "
                  "more. What does it do to a momentum?",
                  "Equation (11), with a mass that stays: the force is the change of momentum "
                  "per second.",
                  "The change of momentum in dt seconds is the force times dt. No mass in it."},
        .mistakes = {{"divided by the mass", "classic: chapter 1's kick",
                      "Heavy things hardly fall; a body of 1 kg looks right.",
                      "You divide the force by the mass, as a velocity wants it. A momentum has "
                      "the mass in it already; the drift divides.",
                      attempt<KickInMomentum>(NUTSHELL_CALL(mistakes::kick_over_mass))},
                     {"the force taken for an acceleration", "classic: gravity given as g",
                      "Heavy things fall faster than light ones.",
                      "You multiply the force by the mass. The push you are given is a force "
                      "[N]; its law has put the mass in where it belongs.",
                      attempt<KickInMomentum>(NUTSHELL_CALL(mistakes::kick_times_mass))},
                     {"a second in every kick", "classic: moving by frames",
                      "The shorter the frame, the harder everything falls.",
                      "You add the whole force. A force is the change of momentum per second, "
                      "and the kick lasts dt seconds.",
                      attempt<KickInMomentum>(NUTSHELL_CALL(mistakes::kick_without_dt))},
                     {"forgets how it moved", "classic: = for +=",
                      "Bodies have no inertia: they stop as soon as the force does.",
                      "You replace the momentum by the kick's. The kick must be added to the "
                      "momentum the body had.",
                      attempt<KickInMomentum>(NUTSHELL_CALL(mistakes::kick_from_rest))}},
        .alternatives = {{"the impulse first",
                          attempt<KickInMomentum>(NUTSHELL_CALL(alternatives::kick_by_impulse))}},
    };
}

}  // namespace nutshell::exercises

#endif
