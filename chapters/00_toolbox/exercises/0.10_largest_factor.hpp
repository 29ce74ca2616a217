// Exercise 0.10: the size of the larger eigenvalue.
#pragma once
#include <Eigen/Eigenvalues>
#include <nutshell/toolbox.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct LargestFactor {
    static constexpr const char *id = "0.10", *function = "largest_factor";
    static constexpr auto subject = NUTSHELL_CALL(largest_factor);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const Matrix2& A :
             {Matrix2{{0.9, 0.4}, {0.3, 0.2}}, Matrix2{{-1.1, 0.2}, {0.5, 0.3}},
              Matrix2{{1.0, 0.5}, {-0.7, 0.8}}}) {
            paper.input("A, by columns", A);
            const double factor = answer(A);
            paper.output("the size of the larger eigenvalue", factor, 1.0);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<LargestFactor> about() {
        return {
            .title = "Will it explode?",
            .hints = {"Solve the quadratic equation. What stands under the root, and what if it "
                      "is negative?",
                      "Below zero the two are a complex pair. Their product is the determinant, "
                      "and they have the same size.",
                      "Otherwise the larger in size is the one where half the trace and the root "
                      "do not work against each other: |half trace| + root."},
            .picture = "matrix.svg",
            .mistakes =
                {{"the larger, not the larger in size", "classic: a sign",
                  "A step that overshoots is called stable, and explodes to and fro.",
                  "You take half the trace plus the root. If the trace is negative, the other "
                  "one is larger in size.",
                  [](const Matrix2& A) -> double {
                      const double h = A.trace() / 2, d = A.determinant(), in = h * h - d;
                      return in < 0 ? std::sqrt(d) : h + std::sqrt(in);
                  }},
                 {"the real part of a pair", "classic: Euler seems to hold",
                  "A spring is called stable and flies apart.",
                  "For a complex pair you return the real part. Its size is the root of the sum "
                  "of squares of both parts, the square root of the determinant.",
                  [](const Matrix2& A) -> double {
                      const double h = A.trace() / 2, d = A.determinant(), in = h * h - d;
                      return in < 0 ? std::abs(h) : std::abs(h) + std::sqrt(in);
                  }},
                 {"the determinant", "classic: area is not growth",
                  "A step that stretches one way and squeezes the other is called stable.",
                  "The determinant is the product of both eigenvalues: it says what happens to "
                  "areas. One may grow while the other shrinks.",
                  [](const Matrix2& A) -> double { return std::abs(A.determinant()); }},
                 {"the pair's size squared", "classic: a root forgotten",
                  "What fades seems to fade twice as fast.",
                  "For a complex pair you return the determinant, which is the square of the "
                  "size.",
                  [](const Matrix2& A) -> double {
                      const double h = A.trace() / 2, d = A.determinant(), in = h * h - d;
                      return in < 0 ? d : std::abs(h) + std::sqrt(in);
                  }},
                 {"the 4 of the whole trace", "classic", "What explodes is called stable.",
                  "With half the trace, what stands under the root is its square less the "
                  "determinant. The 4 belongs to the whole trace.",
                  [](const Matrix2& A) -> double {
                      const double h = A.trace() / 2, d = A.determinant();
                      const double in = h * h - 4 * d;
                      return in < 0 ? std::sqrt(std::abs(d)) : std::abs(h) + std::sqrt(in);
                  }},
                 {"the smaller one", "classic", "What explodes is called stable.",
                  "You take the root away from half the trace: that is the smaller one in size.",
                  [](const Matrix2& A) -> double {
                      const double h = A.trace() / 2, d = A.determinant();
                      const double in = h * h - d;
                      return in < 0 ? std::sqrt(d) : std::abs(std::abs(h) - std::sqrt(in));
                  }},
                 {"the other sign under the root", "classic", "Real factors are taken for pairs.",
                  "Under the root stands the square of half the trace less the determinant, not "
                  "the other way round.",
                  [](const Matrix2& A) -> double {
                      const double h = A.trace() / 2, d = A.determinant();
                      const double in = d - h * h;
                      return in < 0 ? std::sqrt(std::abs(d)) : std::abs(h) + std::sqrt(in);
                  }},
                 {"the length of the matrix", "classic", "Stable steps are forbidden.",
                  "The root of the squares of all entries is a bound and not the eigenvalue.",
                  [](const Matrix2& A) -> double {
                      const double h = A.trace() / 2, d = A.determinant();
                      return A.norm() + 0 * h * d;
                  }},
                 {"the longest stretch of one step", "classic: singular value for eigenvalue",
                  "Stable steps are forbidden.",
                  "You return how much a single step can stretch a vector at most, the largest "
                  "singular value. What many steps do is told by the larger eigenvalue.",
                  [](const Matrix2& A) -> double {
                      const Matrix2 S = A.transpose() * A;
                      const double h = S.trace() / 2;
                      return std::sqrt(h + std::sqrt(std::max(0.0, h * h - S.determinant())));
                  }},
                 {"the entries of the diagonal", "classic", "What explodes is called stable.",
                  "You take the larger entry of the diagonal. It is an eigenvalue only if one of "
                  "the two entries beside it is zero.",
                  [](const Matrix2& A) -> double { return A.diagonal().cwiseAbs().maxCoeff(); }}},
            .alternatives = {{"in complex numbers",
                              [](const Matrix2& A) -> double {
                                  const Complex root = std::sqrt(
                                      Complex{A.trace() * A.trace() / 4 - A.determinant()});
                                  return std::max(std::abs(A.trace() / 2 + root),
                                                  std::abs(A.trace() / 2 - root));
                              }},
                             {"Eigen's solver",
                              [](const Matrix2& A) -> double {
                                  return Eigen::EigenSolver<Matrix2>(A, false)
                                      .eigenvalues()
                                      .cwiseAbs()
                                      .maxCoeff();
                              }}},
            .survivors = {{"< to <=", "at a double eigenvalue both give half the trace"}},
        };
    }
#endif
};

inline const bool largest_factor_entered = enter<LargestFactor>();

}  // namespace nutshell::exercises
