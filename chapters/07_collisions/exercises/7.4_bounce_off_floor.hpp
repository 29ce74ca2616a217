// Exercise 7.4: the floor for a method that steps, and what is wrong with the printed one.
#pragma once
#include <nutshell/bouncing_ball.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct BounceOffFloor {
    static constexpr const char *id = "7.4", *function = "bounce_off_floor";
    static constexpr auto subject = NUTSHELL_CALL(bounce_off_floor);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        BouncingBall level, low, large, lively, slanted;
        low.floor.offset = -0.3, large.ball.radius = 0.45;
        lively.restitution = 0.35;
        slanted.floor = {Vector3(3, 6, -2) / 7, 0.6};
        const Vector3 below(0.7, 0.04, -1.1), deep(0.7, -0.31, -1.1), above(0.7, 1.9, -1.1);
        const Vector3 down(1.2, -3.4, 0.8), up(1.2, 2.1, 0.8);
        for (const BouncingBall& scene : {level, low, large, lively, slanted})
            for (const Particle& start :
                 {Particle{1.7, below, down}, Particle{1.7, deep, down}, Particle{1.7, below, up},
                  Particle{0.6, below, down}, Particle{1.7, above, down}})
                ask_one(paper, answer, scene, start);
        BouncingBall half = level;
        half.ball.radius = 0.5;  // its lowest point exactly on the floor
        ask_one(paper, answer, half, {1.7, {0.7, 0.5, -1.1}, down});
        ask_one(paper, answer, half, {1.7, {0.7, 0.5, -1.1}, up});
    }

  private:
    template <class Answer>
    static void ask_one(Paper& paper, const Answer& answer, const BouncingBall& scene,
                        const Particle& start) {
        paper.input("radius", scene.ball.radius, "normal of the floor", scene.floor.normal,
                    "offset of the floor", scene.floor.offset, "restitution", scene.restitution,
                    "mass", start.mass, "position", start.position, "momentum", start.momentum);
        Particle body = start;
        answer(scene, body);
        paper.changed("the position [m]", body.position, start.position, 1.0);
        paper.changed("the momentum [kg m/s]", body.momentum, start.momentum,
                      start.momentum.norm());
    }

  public:
#ifndef NUTSHELL_SHEET
    static About<BounceOffFloor> about() {
        using S = const BouncingBall&;
        using P = Particle&;
        static constexpr auto depth_of = [](S scene, const Particle& body) {
            return scene.ball.radius - distance_to(scene.floor, body.position);
        };
        return {
            .title = "A floor for steps",
            .hints =
                {"How deep is the ball in the floor? Its lowest point is a radius below its "
                 "centre; distance_to knows the floor.",
                 "The floor is a particle of mass `immovable`; collide does the rest, and "
                 "tests the approach. Its normal points from a to b: which one is the floor?",
                 "If the depth is not negative: collide the earth with the ball along the "
                 "floor's normal, then move the ball out along the normal by the depth."},
            .picture = "bounce.png",
            .mistakes =
                {{"the centre on the floor", "E64", "The ball sinks in by its radius.",
                  "You test the centre. It is the surface that touches: a radius earlier.",
                  [](S scene, P body) {
                      const double depth = -distance_to(scene.floor, body.position);
                      if (depth < 0) return;
                      Particle earth{immovable};
                      collide(earth, body, scene.floor.normal, scene.restitution);
                      body.position += depth * scene.floor.normal;
                  }},
                 {"no approach test", "E62",
                  "A ball on its way up is sent down again, and rattles "
                  "in the floor.",
                  "You turn the normal speed round whatever its sign. A ball that is on its way "
                  "out needs no impact.",
                  [](S scene, P body) {
                      const double depth = depth_of(scene, body);
                      if (depth < 0) return;
                      const Vector3& n = scene.floor.normal;
                      body.momentum -= (1 + scene.restitution) * n.dot(body.momentum) * n;
                      body.position += depth * n;
                  }},
                 {"the whole momentum turned round", "E37",
                  "A ball that is thrown across the room comes back at the first bounce.",
                  "You reverse all of the momentum. The floor only answers along its normal.",
                  [](S scene, P body) {
                      const double depth = depth_of(scene, body);
                      if (depth < 0) return;
                      if (scene.floor.normal.dot(body.momentum) < 0)
                          body.momentum *= -scene.restitution;
                      body.position += depth * scene.floor.normal;
                  }},
                 {"nobody gets out", "classic", "The ball sinks a little deeper at every bounce.",
                  "You leave the ball as deep as it is. Set it on the floor.",
                  [](S scene, P body) {
                      if (depth_of(scene, body) < 0) return;
                      Particle earth{immovable};
                      collide(earth, body, scene.floor.normal, scene.restitution);
                  }},
                 {"pushed out by half", "classic: Baumgarte's part of the depth",
                  "The ball stands half in the floor.",
                  "You move it out by a part of the depth only.",
                  [](S scene, P body) {
                      const double depth = depth_of(scene, body);
                      if (depth < 0) return;
                      Particle earth{immovable};
                      collide(earth, body, scene.floor.normal, scene.restitution);
                      body.position += depth / 2 * scene.floor.normal;
                  }},
                 {"every floor is level", "E64: Y = 0 in the code", "Balls sink into ramps.",
                  "You use the y axis. The floor has a normal and an offset of its own.",
                  [](S scene, P body) {
                      const double depth =
                          scene.ball.radius - body.position.y() + scene.floor.offset;
                      if (depth < 0) return;
                      Particle earth{immovable};
                      collide(earth, body, {0, 1, 0}, scene.restitution);
                      body.position.y() += depth;
                  }},
                 {"elastic", "classic: restitution forgotten", "The ball never gets lower.",
                  "You turn the speed round without loss. The scene has a restitution.",
                  [](S scene, P body) {
                      const double depth = depth_of(scene, body);
                      if (depth < 0) return;
                      Particle earth{immovable};
                      collide(earth, body, scene.floor.normal, 1);
                      body.position += depth * scene.floor.normal;
                  }},
                 {"no impact, for the normal points the wrong way",
                  "classic: from the ball to the floor",
                  "Balls are lifted out of the floor and fall in again.",
                  "The momentum stays: for collide your two move apart. Its normal points from "
                  "its first body "
                  "to its second, and the floor's from the earth to the ball.",
                  [](S scene, P body) {
                      const double depth = depth_of(scene, body);
                      if (depth < 0) return;
                      Particle earth{immovable};
                      collide(body, earth, scene.floor.normal, scene.restitution);
                      body.position += depth * scene.floor.normal;
                  }},
                 {"a level floor at height zero", "E64: Y = 0 in the code",
                  "Balls sink into ramps and cellars.",
                  "You take the floor's normal for y and its height for zero. scene.floor has "
                  "both.",
                  [](S scene, P body) {
                      if (body.position.y() > scene.ball.radius) return;
                      body.position.y() = scene.ball.radius;
                      if (body.momentum.y() < 0) body.momentum.y() *= -scene.restitution;
                  }},
                 {"what just touches is let through", "classic: <= for <",
                  "Now and then a bounce is late.",
                  "What just touches (depth 0) and comes down bounces too: it is too early only "
                  "for a depth < 0.",
                  [](S scene, P body) {
                      const double depth = depth_of(scene, body);
                      if (depth <= 0) return;
                      Particle earth{immovable};
                      collide(earth, body, scene.floor.normal, scene.restitution);
                      body.position += depth * scene.floor.normal;
                  }},
                 {"put above the world's origin",
                  "classic: = for +=", "Every ball jumps to one place when it bounces.",
                  "You set the ball's place anew, a radius above the origin of the axes. It is "
                  "lifted by its depth, along the normal, from where it is.",
                  [](S scene, P body) {
                      if (depth_of(scene, body) < 0) return;
                      Particle earth{immovable};
                      collide(earth, body, scene.floor.normal, scene.restitution);
                      body.position = scene.ball.radius * scene.floor.normal;
                  }}},
            .alternatives = {{"by hand",
                              [](S scene, P body) {
                                  const Vector3& n = scene.floor.normal;
                                  const double gap = n.dot(body.position) - scene.floor.offset,
                                               speed = n.dot(body.momentum);
                                  if (gap > scene.ball.radius) return;
                                  body.position += (scene.ball.radius - gap) * n;
                                  body.momentum +=
                                      (std::max(0.0, -scene.restitution * speed) +
                                       std::max(0.0, speed) * (speed > 0 ? 1 : 0) - speed) *
                                      n;
                              }}},
            .survivors = {{"statements 2 and 3 swapped", "neither uses what the other does"},
                          {"statements 4 and 5 swapped",
                           "one changes the momentum, the other the position"}},
        };
    }
#endif
};

inline const bool bounce_off_floor_entered = enter<BounceOffFloor>();

}  // namespace nutshell::exercises
