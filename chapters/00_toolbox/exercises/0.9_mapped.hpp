// Exercise 0.9: a matrix times a vector.
#pragma once
#include <nutshell/toolbox.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct Mapped {
    static constexpr const char *id = "0.9", *function = "mapped";
    static constexpr auto subject = NUTSHELL_CALL(mapped);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Matrix2 one{{1.3, -0.7}, {2.1, 0.4}}, other{{-0.6, 1.8}, {0.9, 1.5}};
        const Vector2 v{0.9, 1.6}, w{-1.2, -0.5};
        for (const auto& [A, at] : {std::pair{one, v}, {one, w}, {other, v}}) {
            paper.input("A, by columns", A, "v", at);
            const Vector2 found = answer(A, at);
            paper.output("A v", found, A, at);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<Mapped> about() {
        return {
            .title = "Matrix times vector",
            .hints = {"Each number of v says how much of one column to take.",
                      "A.col(0) is the first column.",
                      "v.x() of the first column and v.y() of the second, added."},
            .picture = "matrix.svg",
            .mistakes = {{"rows for columns", "classic: the matrix transposed",
                          "Everything turns the wrong way.",
                          "You take the rows as columns: that is the transposed matrix.",
                          [](const Matrix2& A, const Vector2& v) -> Vector2 {
                              return A.transpose() * v;
                          }},
                         {"column by column, not added", "classic: element by element",
                          "Things are stretched and never turned.",
                          "You multiply only the diagonal. The other two numbers of the matrix "
                          "carry x into y and y into x.",
                          [](const Matrix2& A, const Vector2& v) -> Vector2 {
                              return A.diagonal().cwiseProduct(v);
                          }},
                         {"the columns exchanged", "classic", "The picture is mirrored.",
                          "The first column belongs to v.x, the second to v.y.",
                          [](const Matrix2& A, const Vector2& v) -> Vector2 {
                              return v.y() * A.col(0) + v.x() * A.col(1);
                          }},
                         {"the new x used for y", "classic",
                          "The step is right only where the matrix leaves x alone.",
                          "The second line reads an x that the first has overwritten already. "
                          "Both lines need the old x and y.",
                          [](const Matrix2& A, const Vector2& v) -> Vector2 {
                              const double x = A(0, 0) * v.x() + A(0, 1) * v.y();
                              return {x, A(1, 0) * x + A(1, 1) * v.y()};
                          }},
                         {"minus where plus belongs", "classic",
                          "Everything is mirrored somehow.",
                          "You subtract the second products: that is how a determinant is made. "
                          "Here they are added.",
                          [](const Matrix2& A, const Vector2& v) -> Vector2 {
                              return {A(0, 0) * v.x() - A(0, 1) * v.y(),
                                      A(1, 0) * v.x() - A(1, 1) * v.y()};
                          }}},
            .alternatives = {{"Eigen's product",
                              [](const Matrix2& A, const Vector2& v) -> Vector2 {
                                  return A * v;
                              }},
                             {"row by row",
                              [](const Matrix2& A, const Vector2& v) -> Vector2 {
                                  return {A(0, 0) * v.x() + A(0, 1) * v.y(),
                                          A(1, 0) * v.x() + A(1, 1) * v.y()};
                              }}},
        };
    }
#endif
};

inline const bool mapped_entered = enter<Mapped>();

}  // namespace nutshell::exercises
