// Exercise 2.4: mass comes and goes, and its momentum with it.
#pragma once
#include <nutshell/revised_newton.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct ExchangeMass {
    static constexpr const char *id = "2.4", *function = "exchange";
    static constexpr auto subject = NUTSHELL_CALL(exchange);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Vector3 place{1.2, -0.7, 2.1}, fast{-13, 5.1, 8.6}, slow{2.1, -0.9, 1.4};
        for (const Particle& start :
             {Particle{2.5, place, fast}, {4.5, place, fast}, {2.5, place, slow}})
            for (const double dm : {-0.9, 1.4}) {
                const Vector3 v = start.momentum / start.mass;
                for (const Vector3& w : {Vector3{-7, 2.4, 4.1}, Vector3{0, 0, 0}, Vector3(-v)}) {
                    paper.input("mass", start.mass, "momentum", start.momentum, "dm", dm, "w", w);
                    Particle body = start;
                    answer(body, dm, w);
                    paper.changed("the mass after the exchange [kg]", body.mass, start.mass, dm);
                    paper.changed("the momentum after the exchange [kg m/s]", body.momentum,
                                  start.momentum, dm * v, dm * w);
                    paper.changed("the position after the exchange [m]", body.position,
                                  start.position);
                }
            }
    }

#ifndef NUTSHELL_SHEET
    static About<ExchangeMass> about() {
        return {
            .title = "Mass with its momentum",
            .hints = {"What leaves the cart keeps moving. It has a mass and a velocity, so it "
                      "has a momentum: whose was that before?",
                      "The exchanged mass moves at the body's velocity plus w. Body and "
                      "exchanged mass together must keep their momentum.",
                      "Find the exchanged mass's velocity while the body still has its old mass; "
                      "dm times it is what the momentum gains. For a loss dm is negative, and so "
                      "is the gain. Then change the mass."},
            .picture = "cart.png",
            .mistakes =
                {{"the mass changes, the momentum does not", "E05",
                  "The leaky cart speeds up by itself: 20 m/s when half the mass has left.",
                  "You read F = dK/dt with K = m v as if what leaves took no momentum along. It "
                  "does: it moves, so it carries some away. Only mass that is at rest in the "
                  "world carries none.",
                  [](Particle& body, double dm, const Vector3&) { body.mass += dm; }},
                 {"no thrust", "classic",
                  "The leaky cart is right, but no rocket ever takes off, and rain does not slow "
                  "the drop.",
                  "You let everything come and go at the body's own velocity. The exchanged mass "
                  "moves at that velocity plus w.",
                  [](Particle& body, double dm, const Vector3&) {
                      body.momentum += dm * velocity(body);
                      body.mass += dm;
                  }},
                 {"w measured from the ground", "classic",
                  "A rocket's thrust fades as it gets faster.",
                  "You use w as the exchanged mass's velocity in the world. It is the velocity "
                  "relative to the body: add the body's own.",
                  [](Particle& body, double dm, const Vector3& w) {
                      body.momentum += dm * w;
                      body.mass += dm;
                  }},
                 {"the mass changed too early", "classic: order of statements",
                  "The leaky cart gains or loses a little with every parcel.",
                  "You change the mass and then ask for the velocity, which is no longer that of "
                  "the moment when the parcel left.",
                  [](Particle& body, double dm, const Vector3& w) {
                      body.mass += dm;
                      body.momentum += dm * (velocity(body) + w);
                  }},
                 {"gain and loss swapped", "classic: a sign",
                  "The rocket is pulled into its own exhaust.",
                  "You take away dm times the velocity. dm is what the body gains; where it "
                  "loses mass dm is negative already.",
                  [](Particle& body, double dm, const Vector3& w) {
                      body.momentum -= dm * (velocity(body) + w);
                      body.mass += dm;
                  }},
                 {"the mass stays", "classic", "A rocket gets no lighter.",
                  "The momentum changes and the mass does not: add dm to it.",
                  [](Particle& body, double dm, const Vector3& w) {
                      body.momentum += dm * (velocity(body) + w);
                  }},
                 {"the mass lost where it is gained", "classic", "A rain drop shrinks.",
                  "You take dm off the mass. dm is what the body gains: negative where it loses.",
                  [](Particle& body, double dm, const Vector3& w) {
                      body.momentum += dm * (velocity(body) + w);
                      body.mass -= dm;
                  }},
                 {"w taken off the velocity", "classic",
                  "The rocket is pulled into its own exhaust.",
                  "You subtract w. The parcel's velocity in the world is the body's plus w.",
                  [](Particle& body, double dm, const Vector3& w) {
                      body.momentum += dm * (velocity(body) - w);
                      body.mass += dm;
                  }},
                 {"w dm over the mass before", "classic: the limit dv = w dm/m",
                  "A rocket of few parcels is too slow.",
                  "In effect the velocity changes by w dm over the mass before, which is right "
                  "for tiny parcels only. What body and parcel have together is then not kept: "
                  "the body gains what the parcel carries, dm (v + w).",
                  [](Particle& body, double dm, const Vector3& w) {
                      body.momentum += dm * w;
                      body.momentum *= (body.mass + dm) / body.mass;
                      body.mass += dm;
                  }},
                 {"w only where mass comes in", "classic: what leaves is left behind",
                  "Rain slows the drop, and no rocket ever takes off.",
                  "Where dm is negative you leave w out. What leaves moves at the body's "
                  "velocity plus w too: that is what pushes a rocket.",
                  [](Particle& body, double dm, const Vector3& w) {
                      body.momentum +=
                          dm * (dm > 0 ? Vector3(velocity(body) + w) : velocity(body));
                      body.mass += dm;
                  }}},
            .alternatives = {{"by the velocity after",
                              [](Particle& body, double dm, const Vector3& w) {
                                  const double after = body.mass + dm;
                                  const Vector3 v = body.momentum / body.mass + dm / after * w;
                                  body.mass = after;
                                  body.momentum = after * v;
                              }}},
        };
    }
#endif
};

inline const bool exchange_mass_entered = enter<ExchangeMass>();

}  // namespace nutshell::exercises
