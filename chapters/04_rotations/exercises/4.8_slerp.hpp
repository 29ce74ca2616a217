// Exercise 4.8: part of the way between two poses.
#pragma once
#include <nutshell/rotations.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct Slerp {
    static constexpr const char *id = "4.8", *function = "slerp";
    static constexpr auto subject = NUTSHELL_CALL(slerp);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Quaternion a = Quaternion(0.4, 0.3, -0.5, 0.7).normalized(),
                         b = Quaternion(0.9, -0.6, 0.2, 0.1).normalized(),
                         c = Quaternion(-0.7, 0.1, 0.4, -0.5).normalized();
        for (const auto& [from, to] : {std::pair(a, b), {b, a}, {a, c}, {c, b}, {b, b}})
            for (const double part : {0.25, 0.6, 0.0, 1.0}) {
                paper.input("from", from, "to", to, "part", part);
                paper.frame(from);
                const Quaternion q = answer(from, to, part);
                paper.output("the pose", q, 1.0);
            }
        // two poses that are 1.4e-5 rad apart: a slow camera
        const Vector3 way(1.2e-5, -6e-6, 4e-6);
        const Quaternion close = (four_vector(way / 2, 1) * a).normalized();
        for (const double part : {0.25, 0.6}) {
            paper.input("from", a, "to", close, "part", part);
            const Quaternion turn = answer(a, close, part) * a.conjugate();
            const Vector3 made = (turn.w() < 0 ? -2 : 2) * turn.vec();
            paper.output("the turn made [rad]", made, Vector3(part * way));
        }
    }

#ifndef NUTSHELL_SHEET
    static Quaternion sines(const Quaternion& from, const Quaternion& to, double part) {
        const double angle = std::acos(std::min(1.0, from.dot(to)));
        if (angle < 1e-6) return from;
        return Quaternion((std::sin((1 - part) * angle) * from.coeffs() +
                           std::sin(part * angle) * to.coeffs()) /
                          std::sin(angle));
    }
    static Quaternion nearer(const Quaternion& from, const Quaternion& to) {
        return from.dot(to) < 0 ? Quaternion(-to.coeffs()) : to;
    }
    static About<Slerp> about() {
        return {
            .title = "Part of the way",
            .hints =
                {"Which one turn leads from the first pose to the second? You know how to "
                 "undo a turn, and how to make one after another.",
                 "That turn has a rotation vector. Part of the way is the same axis and part "
                 "of the angle.",
                 "The turn that leads there is the second pose times the inverse of the "
                 "first. Take its logarithm, a part of it, and go back; then turn `from`."},
            .picture = "way.png",
            .mistakes =
                {{"the straight line", "classic: nlerp taken for slerp",
                  "The camera starts slowly, hurries, and stops slowly.",
                  "You go straight from one 4-vector to the other and normalise: the same way, "
                  "faster in the middle.",
                  [](const Quaternion& from, const Quaternion& to, double part) -> Quaternion {
                      return nlerp(from, to, part);
                  }},
                 {"the straight line, not normalised", "classic", "The body shrinks half-way.",
                  "The straight line cuts through the sphere of 4-vectors: in its middle they "
                  "are "
                  "shorter than one.",
                  [](const Quaternion& from, const Quaternion& to, double part) -> Quaternion {
                      return Quaternion((1 - part) * from.coeffs() +
                                        part * nearer(from, to).coeffs());
                  }},
                 {"the longer way", "classic", "The camera swings round through the floor.",
                  "For 4-vectors more than a right angle apart you go the longer way: -q is the "
                  "same pose as q, and nearer.",
                  [](const Quaternion& from, const Quaternion& to, double part) -> Quaternion {
                      return sines(from, to, part);
                  }},
                 {"from the wrong end", "classic", "The tween plays backwards.",
                  "At part 0 you are at `to`.",
                  [](const Quaternion& from, const Quaternion& to, double part) -> Quaternion {
                      return sines(from, nearer(from, to), 1 - part);
                  }},
                 {"the turn alone", "classic",
                  "The body jumps to its rest pose and starts from there.",
                  "You return the part of the turn, but not of which pose: turn `from` by it.",
                  [](const Quaternion& from, const Quaternion& to, double part) -> Quaternion {
                      const Quaternion turn = nearer(from, to) * from.conjugate();
                      return sines(four_vector({0, 0, 0}, 1), turn, part);
                  }},
                 {"the world's turn about the body's axes", "E20: the wrong side",
                  "The tween begins right and ends in a wrong pose.",
                  "The turn that leads there stands on the wrong side of `from`: its axis is "
                  "given "
                  "in the world's axes.",
                  [](const Quaternion& from, const Quaternion& to, double part) -> Quaternion {
                      const Quaternion turn = nearer(from, to) * from.conjugate();
                      return from * sines(four_vector({0, 0, 0}, 1), turn, part);
                  }},
                 {"a blend of the rotation vectors", "classic", "The tween wobbles.",
                  "You blend the two logarithms. That is right about one axis only: take the "
                  "turn that leads from one to the other.",
                  [](const Quaternion& from, const Quaternion& to, double part) -> Quaternion {
                      return exponential((1 - part) * logarithm(from) + part * logarithm(to));
                  }},
                 {"the turn back", "classic", "The tween runs away from its goal.",
                  "The turn leads from `to` to `from`. The later one stands on the left, the "
                  "inverse of the earlier on the right.",
                  [](const Quaternion& from, const Quaternion& to, double part) -> Quaternion {
                      return product(exponential(part * logarithm(product(from, inverse(to)))),
                                     from);
                  }},
                 {"the part of the end", "classic", "The tween begins at no turn at all.",
                  "You take a part of the end's own turn and put it on the start. Take a part of "
                  "the turn that leads from one to the other.",
                  [](const Quaternion& from, const Quaternion& to, double part) -> Quaternion {
                      return product(exponential(part * logarithm(to)), from);
                  }},
                 {"the angle of the turn in the sines", "classic: half the angle forgotten",
                  "The body changes its size on the way.",
                  "Your formula of sines has the angle of the turn. The 4-vectors are half of it "
                  "apart.",
                  [](const Quaternion& from, const Quaternion& to, double part) -> Quaternion {
                      const Quaternion end = nearer(from, to);
                      const double angle = 2 * std::acos(std::min(1.0, from.dot(end)));
                      if (angle < 1e-6) return from;
                      return Quaternion((std::sin((1 - part) * angle) * from.coeffs() +
                                         std::sin(part * angle) * end.coeffs()) /
                                        std::sin(angle));
                  }},
                 {"the body's turn about the world's axes",
                  "classic: the inverse on the wrong side",
                  "The camera ends where nobody sent it.",
                  "With the inverse of `from` on the left you have the turn about the body's "
                  "axes, and you make it about the world's: before `from`, not behind it.",
                  [](const Quaternion& from, const Quaternion& to, double part) -> Quaternion {
                      return exponential(part * logarithm(from.conjugate() * to)) * from;
                  }}},
            .alternatives =
                {{"Shoemake's sines",
                  [](const Quaternion& from, const Quaternion& to, double part) -> Quaternion {
                      return sines(from, nearer(from, to), part);
                  }},
                 {"about the body's axes",
                  [](const Quaternion& from, const Quaternion& to, double part) -> Quaternion {
                      return product(from,
                                     exponential(part * logarithm(product(inverse(from), to))));
                  }}},
        };
    }
#endif
};

inline const bool slerp_entered = enter<Slerp>();

}  // namespace nutshell::exercises
