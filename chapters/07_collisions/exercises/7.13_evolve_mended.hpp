// Exercise 7.13: the source's Universe::evolve, mended.
#pragma once
#include <nutshell/universe.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct EvolveMended {
    static constexpr const char *id = "7.13", *function = "evolve_mended";
    static constexpr auto subject = NUTSHELL_CALL(evolve_mended);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Vector3 down(0.5, -1.5, 0.25), fast(0.5, -2.5, 0.25), up(0.5, 1.75, 0.25);
        one(paper, answer, {0.3, 2.5, -0.2}, down, 1, 0.75, {0.2, -4, 0.1});  // in the air
        one(paper, answer, {0.3, 1.01, -0.2}, down, 1, 0.75, {0.2, -4, 0.1});
        one(paper, answer, {0.3, 1.01, -0.2}, fast, 1, 0.5, {0.2, -4, 0.1});
        one(paper, answer, {0.3, 0.51, -0.2}, down, 0.5, 0.75, {0.2, -4, 0.1});
        one(paper, answer, {0.3, 1.01, -0.2}, down, 1, 0.75, {0.3, -9, -0.2});
        one(paper, answer, {0.3, 2.5, -0.2}, down, 1, 0.75, {0.2, -4, 0.1}, 3.2);  // heavier
        one(paper, answer, {0.3, 0.6, -0.2}, up, 1, 0.75, {0.2, -4, 0.1});  // on its way up
        one(paper, answer, {0.3, 0.6, -0.2}, {0.5, 0.6, 0.25}, 1, 0.75,
            {0.2, -4, 0.1});                                                   // slowly
        one(paper, answer, {0.3, -0.5, -0.2}, down, 1, 0.9, {0.2, -4, 0.1});   // centre below
        one(paper, answer, {0.3, -2.5, -0.2}, down, 1, 0.75, {0.2, -4, 0.1});  // all of it below
        one(paper, answer, {0.3, 1.0, -0.2}, {0, 0, 0}, 1, 0.75, {0, -4, 0});  // at rest on it
    }

  private:
    template <class Answer>
    static void one(Paper& paper, const Answer& answer, const Vector3& place,
                    const Vector3& momentum, double radius, double e, const Vector3& force,
                    double mass = 2) {
        Universe universe;
        universe.mass = mass, universe.radius = radius, universe.restitution = e;
        universe.force = force;
        Body ball;
        ball.mass = mass, ball.inertia = Vector3::Constant(0.8);
        ball.position = place, ball.momentum = momentum;
        ball.orientation = Quaternion(0.8, 0.3, -0.4, 0.33).normalized();
        ball.angular_momentum = {0.4, -0.3, 0.7};
        const Body start = ball;
        const double dt = paper.step(0.05);
        paper.input("position", place, "momentum", momentum, "radius", radius, "restitution", e,
                    "force", force, "mass", mass, "dt", dt);
        answer(universe, ball, dt);
        paper.changed("the position [m]", ball.position, start.position, radius);
        paper.changed("the momentum [kg m/s]", ball.momentum, start.momentum, force * dt);
        paper.changed("the angular momentum [kg m^2/s]", ball.angular_momentum,
                      start.angular_momentum);
        paper.output("the orientation", ball.orientation, 1.0);
    }

  public:
#ifndef NUTSHELL_SHEET
    /// How a wrong answer differs from the right one.
    struct Slip {
        bool centre = false, down_again = false, spin = false, left_in = false, slowed = false,
             printed_order = false, fixed = false, weight = false, mirror = false,
             slowed_up = false;
    };
    static void with(const Slip& slip, const Universe& universe, Body& ball, double dt) {
        if (slip.printed_order) drift(ball, dt);
        kick(ball, {(slip.weight ? ball.mass : 1) * universe.force, Vector3::Zero()}, dt);
        if (!slip.printed_order) drift(ball, dt);
        const double surface = slip.centre ? 0 : universe.radius;
        if (slip.slowed) ball.momentum *= 0.98;
        if (ball.position.y() >= surface) return;
        if (slip.mirror)
            ball.position.y() = 2 * surface - ball.position.y();
        else if (!slip.left_in)
            ball.position.y() = surface;
        const double up = ball.momentum.y();
        if (ball.momentum.y() < 0 || slip.down_again)
            ball.momentum.y() *= slip.fixed ? -0.9 : -universe.restitution;
        if (slip.slowed_up) ball.momentum.y() = universe.restitution * std::abs(up);
        if (slip.spin) ball.angular_momentum *= 0.9;
    }
    static auto wrong(const Slip& slip) {
        return [slip](const Universe& universe, Body& ball, double dt) -> void {
            with(slip, universe, ball, dt);
        };
    }
    static About<EvolveMended> about() {
        return {
            .title = "The universe, mended",
            .hints = {"Which of chapter 6's verbs comes first, so that energy does not grow? "
                      "Then: where is the ball's lowest point?",
                      "Kick, drift. If the lowest point is in the floor, put the ball onto it; "
                      "and only if it still comes down, turn its momentum round.",
                      "If position.y is below the radius, set it to the radius; and a negative "
                      "momentum.y becomes the restitution times its opposite. The spin stays."},
            .picture = "universe.png",
            .mistakes =
                {{"the centre is tested", "E64", "The ball sinks half into the floor.",
                  "You test the centre of the ball. Its lowest point is one radius below.",
                  wrong({.centre = true})},
                 {"sent down again", "E62", "A ball on its way up is pulled back.",
                  "You turn the momentum round whichever way it points. A ball that is rising "
                  "has bounced already.",
                  wrong({.down_again = true})},
                 {"a tenth of the spin", "E63",
                  "A resting ball stops turning, and in the end its R is not a number.",
                  "You scale the angular momentum. A push through the centre has no lever: "
                  "without friction the spin stays.",
                  wrong({.spin = true})},
                 {"drift, then kick", "E59: the printed order",
                  "The ball bounces a little higher each time.",
                  "You move with the momentum from before the force: Euler's order, which gains "
                  "energy. Kick first.",
                  wrong({.printed_order = true})},
                 {"left in the floor", "classic: the speed only",
                  "The ball sinks deeper with each bounce.",
                  "You turn the speed and leave the ball where it is, in the floor.",
                  wrong({.left_in = true})},
                 {"everything is slowed down", "classic: v *= 0.98 in every step",
                  "A ball that flies is braked by nothing, and more so on a fast machine.",
                  "You take a fiftieth of the momentum in every step, to make things come to "
                  "rest. What brings this ball to rest is its restitution, at the floor.",
                  wrong({.slowed = true})},
                 {"the fixed 0.9", "E64: 0.9 written into the code", "Clay bounces like rubber.",
                  "You write 0.9 where the universe has its restitution.",
                  wrong({.fixed = true})},
                 {"the force times the mass", "classic: a force taken for an acceleration",
                  "Heavy balls fall faster.",
                  "universe.force is a force already: the mass does not belong to it.",
                  wrong({.weight = true})},
                 {"mirrored at the floor", "classic", "Balls that lie still begin to hop.",
                  "You mirror the ball at the floor, which lifts it by twice its depth. Set it "
                  "on the floor.",
                  wrong({.mirror = true})},
                 {"slowed down on its way up", "classic: e |p|",
                  "A ball that has not left the floor after a step bounces lower.",
                  "You give the momentum e of its size and send it up, whichever way it points. "
                  "A ball that is rising has bounced already and keeps all of it.",
                  wrong({.slowed_up = true})}},
            .alternatives = {{"the floor as an impact with the earth",
                              [](const Universe& universe, Body& ball, double dt) -> void {
                                  ball.momentum += universe.force * dt;
                                  drift(ball, dt);
                                  const double depth = universe.radius - ball.position.y();
                                  if (!(depth > 0)) return;
                                  ball.position += depth * Vector3::UnitY();
                                  const double closing = std::min(0.0, ball.momentum.y());
                                  ball.momentum -=
                                      (1 + universe.restitution) * closing * Vector3::UnitY();
                              }}},
            .survivors = {{"statements 4 and 5 swapped", "neither uses what the other sets"},
                          {"< to <=", "a momentum of zero stays zero"},
                          {">= to >", "a ball that just touches is put where it is"}},
        };
    }
#endif
};

inline const bool evolve_mended_entered = enter<EvolveMended>();

}  // namespace nutshell::exercises
