// Exercise 4.5: a small turn to first order, where the source's (30) and (31) are wrong twice.
#pragma once
#include <nutshell/rotations.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct SmallTurn {
    static constexpr const char *id = "4.5", *function = "small_turn";
    static constexpr auto subject = NUTSHELL_CALL(small_turn);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Quaternion a = Quaternion(0.4, 0.3, -0.5, 0.7).normalized(),
                         b = Quaternion(0.9, -0.6, 0.2, 0.1).normalized();
        for (const auto& [q, beta] : {std::pair(a, Vector3(0.3, -0.2, 0.5)),
                                      {a, Vector3(-0.1, 0.4, 0.25)},
                                      {b, Vector3(0.3, -0.2, 0.5)},
                                      {b, Vector3(1.1, 0.7, -1.6)}}) {
            paper.input("q", q, "beta", beta);
            paper.frame(q);
            const Quaternion next = answer(q, beta);
            paper.output("the 4-vector", next, 1.0);
        }
    }

#ifndef NUTSHELL_SHEET
    /// (31) with its rows as printed: the scalar first.
    static Eigen::Vector4d printed_rows(const Vector3& beta, const Quaternion& q) {
        const Quaternion change = four_vector(beta, 0) * q;
        return {change.w(), change.x(), change.y(), change.z()};
    }
    static About<SmallTurn> about() {
        return {
            .title = "A small turn",
            .hints =
                {"For a small angle the sine is the angle and the cosine is one. What is then "
                 "left of the product (4.d)?",
                 "The change is half of what vector_product gives. Adding it makes the "
                 "4-vector longer: mend that.",
                 "Add half of the change's four numbers to those of q (.coeffs() has them), "
                 "make a Quaternion of the sum, and divide by its length (.normalized())."},
            .picture = "small_turns.svg",
            .mistakes =
                {{"never divided by its length", "E18", "Spinning bodies grow, slowly at first.",
                  "The sum is longer than one, by sqrt(1 + beta^2/4) each time. Divide by its "
                  "length.",
                  [](const Quaternion& q, const Vector3& beta) -> Quaternion {
                      return Quaternion(q.coeffs() + (four_vector(beta, 0) * q).coeffs() / 2);
                  }},
                 {"only the change made of length one", "classic: brackets",
                  "Every turn is of one size, however small it should be.",
                  "The change is divided by its own length, so its size is lost. It is the sum "
                  "that must be as long as one.",
                  [](const Quaternion& q, const Vector3& beta) -> Quaternion {
                      return Quaternion(q.coeffs() +
                                        (four_vector(beta, 0) * q).normalized().coeffs() / 2);
                  }},
                 {"the rows of (31) as printed", "E19",
                  "A body turns about a wrong axis, sticks, and grows without end.",
                  "The printed (31) begins with the scalar row, but (27) stores the scalar last. "
                  "Its rows belong in the order x, y, z, w.",
                  [](const Quaternion& q, const Vector3& beta) -> Quaternion {
                      return Quaternion(Eigen::Vector4d(q.coeffs() + printed_rows(beta, q) / 2))
                          .normalized();
                  }},
                 {"(30) and (31) as printed", "E18, E19",
                  "A body jumps, and then grows without bound.",
                  "The rows stand in the wrong order (the scalar belongs last), and nobody "
                  "divides "
                  "by the length.",
                  [](const Quaternion& q, const Vector3& beta) -> Quaternion {
                      return Quaternion(Eigen::Vector4d(q.coeffs() + printed_rows(beta, q) / 2));
                  }},
                 {"about the body's axes", "E20: the wrong side",
                  "The gyroscope drifts as soon as the body is tilted.",
                  "You multiply (beta, 0) from the right, which turns about the body's axes. "
                  "beta "
                  "is given in the world's: it stands on the left.",
                  [](const Quaternion& q, const Vector3& beta) -> Quaternion {
                      return Quaternion(q.coeffs() + (q * four_vector(beta, 0)).coeffs() / 2)
                          .normalized();
                  }},
                 {"the half forgotten", "classic", "Everything turns twice as fast.",
                  "The 4-vector knows half of the angle: add half of the product.",
                  [](const Quaternion& q, const Vector3& beta) -> Quaternion {
                      return Quaternion(q.coeffs() + (four_vector(beta, 0) * q).coeffs())
                          .normalized();
                  }},
                 {"the exact turn", "not a mistake in a game",
                  "Nothing: it turns by the whole angle.",
                  "You turn by exactly beta, which is better than this exercise asks for: here "
                  "the "
                  "first order is wanted, so that we can see what it loses.",
                  [](const Quaternion& q, const Vector3& beta) -> Quaternion {
                      return Quaternion(Eigen::AngleAxisd(beta.norm(), beta.normalized())) * q;
                  }},
                 {"beta added without a product", "classic",
                  "A body that is turned already turns about the wrong axis.",
                  "You add half of beta to the vector part. What is added is half of the product "
                  "(beta, 0) q.",
                  [](const Quaternion& q, const Vector3& beta) -> Quaternion {
                      return Quaternion(q.w(), q.x() + beta.x() / 2, q.y() + beta.y() / 2,
                                        q.z() + beta.z() / 2)
                          .normalized();
                  }},
                 {"the turn back", "classic", "Everything turns the other way.",
                  "You take the change away: it is added.",
                  [](const Quaternion& q, const Vector3& beta) -> Quaternion {
                      const Quaternion p = Quaternion(0, beta.x(), beta.y(), beta.z()) * q;
                      return Quaternion(q.coeffs() - p.coeffs() / 2).normalized();
                  }},
                 {"the change for the result", "classic", "The pose jumps by half a turn.",
                  "You return the change alone: it is added to q.",
                  [](const Quaternion& q, const Vector3& beta) -> Quaternion {
                      return (Quaternion(0, beta.x(), beta.y(), beta.z()) * q).normalized();
                  }},
                 {"four numbers in another order", "classic",
                  "Everything turns by nearly half a turn.",
                  "Eigen's constructor from four numbers takes w first: the one went into z.",
                  [](const Quaternion& q, const Vector3& beta) -> Quaternion {
                      return (Quaternion(beta.x() / 2, beta.y() / 2, beta.z() / 2, 1) * q)
                          .normalized();
                  }}},
            .alternatives = {{"a turn by twice the arc tangent of half the angle",
                              [](const Quaternion& q, const Vector3& beta) -> Quaternion {
                                  const double angle = 2 * std::atan(beta.norm() / 2);
                                  return Quaternion(Eigen::AngleAxisd(angle, beta.normalized())) *
                                         q;
                              }},
                             {"the product with (beta/2, 1)",
                              [](const Quaternion& q, const Vector3& beta) -> Quaternion {
                                  return (four_vector(beta / 2, 1) * q).normalized();
                              }}},
        };
    }
#endif
};

inline const bool small_turn_entered = enter<SmallTurn>();

}  // namespace nutshell::exercises
