// Exercise 4.2: the matrix of a turn about any axis; the source's (26) has two wrong entries.
#pragma once
#include <nutshell/rotations.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

#ifndef NUTSHELL_SHEET
/// one * 1 + along * n n^T + across * [n x], which is the rotation for cos, 1 - cos and sin.
inline Matrix3 of_parts(const Vector3& axis, double one, double along, double across) {
    const Vector3 n = axis.normalized();
    Matrix3 k;
    k << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
    return one * Matrix3::Identity() + along * n * n.transpose() + across * k;
}
#endif

struct RotationAbout {
    static constexpr const char *id = "4.2", *function = "rotation_about";
    static constexpr auto subject = NUTSHELL_CALL(rotation_about);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Vector3 unit = Vector3(1, -2, 3) / std::sqrt(14.0), longer(-0.7, 1.9, -1.3);
        for (const Vector3& axis : {unit, longer})
            for (const double angle : {0.8, -2.3, 4.1}) {
                paper.input("axis", axis, "angle", angle);
                const Matrix3 r = answer(axis, angle);
                paper.output("the matrix", r, 1.0);
            }
        paper.input("axis", longer, "angle", 0.0);
        const Matrix3 none = answer(longer, 0);
        paper.output("the matrix", none, 1.0);
    }

#ifndef NUTSHELL_SHEET
    /// Rodrigues' formula as a matrix.
    static Matrix3 rodrigues(const Vector3& n, double cosine, double sine) {
        Matrix3 cross;
        cross << 0, -n[2], n[1], n[2], 0, -n[0], -n[1], n[0], 0;
        const Matrix3 along = n * n.transpose();
        return along + cosine * (Matrix3::Identity() - along) + sine * cross;
    }
    static About<RotationAbout> about() {
        return {
            .title = "A turn about any axis",
            .hints =
                {"Split a point into the part along the axis, which stays, and the part "
                 "across, which turns in its plane.",
                 "Rodrigues' formula, written with the half angle, gives the nine numbers of "
                 "(26*). Compare each printed entry with its partner across the diagonal.",
                 "Partners across the diagonal differ in the sign of the s c term only. Make "
                 "the axis as long as one first: direction_of does."},
            .picture = "printed.png",
            .mistakes =
                {{"the third entry of the first row as printed", "E13",
                  "A cube that yaws is sheared flat.",
                  "The entry (0,2) of the printed (26) has the wrong sign: about y, z must go "
                  "towards +x. It is 2(n0 n2 s^2 + n1 s c).",
                  [](const Vector3& axis, double angle) -> Matrix3 {
                      const Vector3 n = axis.normalized();
                      const double c = std::cos(angle / 2), s = std::sin(angle / 2);
                      Matrix3 r = rodrigues(n, std::cos(angle), std::sin(angle));
                      r(0, 2) = 2 * (n[0] * n[2] * s * s - n[1] * s * c);
                      return r;
                  }},
                 {"the first entry of the third row as printed", "E14",
                  "A cube that turns about x and z at once leans over.",
                  "The entry (2,0) of the printed (26) has lost its first term. It is 2(n0 n2 "
                  "s^2 "
                  "- n1 s c).",
                  [](const Vector3& axis, double angle) -> Matrix3 {
                      const Vector3 n = axis.normalized();
                      const double c = std::cos(angle / 2), s = std::sin(angle / 2);
                      Matrix3 r = rodrigues(n, std::cos(angle), std::sin(angle));
                      r(2, 0) = 2 * (n[0] * s * c - n[1] * s * c);
                      return r;
                  }},
                 {"equation (26) as printed", "E13, E14",
                  "A cube that turns becomes a skewed box of another volume.",
                  "Two entries of the printed (26) are wrong, (0,2) and (2,0): each differs from "
                  "its partner across the diagonal by more than a sign.",
                  [](const Vector3& axis, double angle) -> Matrix3 {
                      const Vector3 n = axis.normalized();
                      const double c = std::cos(angle / 2), s = std::sin(angle / 2);
                      Matrix3 r = rodrigues(n, std::cos(angle), std::sin(angle));
                      r(0, 2) = 2 * (n[0] * n[2] * s * s - n[1] * s * c);
                      r(2, 0) = 2 * (n[0] * s * c - n[1] * s * c);
                      return r;
                  }},
                 {"the transpose", "E51: the source's class Rotation",
                  "Everything turns the other way.",
                  "Your matrix turns by minus the angle: rows and columns are exchanged.",
                  [](const Vector3& axis, double angle) -> Matrix3 {
                      return rodrigues(axis.normalized(), std::cos(angle), -std::sin(angle));
                  }},
                 {"the cross product not taken twice", "classic: 1 - c beside K, not K K",
                  "Things are sheared when they turn.",
                  "In Rodrigues' formula 1 - cos goes with the cross product taken twice, K K; "
                  "K alone goes with the sine.",
                  [](const Vector3& axis, double angle) -> Matrix3 {
                      const Matrix3 once =
                          rodrigues(axis.normalized(), 0, 1) - rodrigues(axis.normalized(), 0, 0);
                      return Matrix3::Identity() + (std::sin(angle) + 1 - std::cos(angle)) * once;
                  }},
                 {"the whole angle where half belongs", "classic",
                  "Everything turns twice as far.",
                  "c and s are cosine and sine of half the angle: the matrix is quadratic in "
                  "them, "
                  "and squares double angles.",
                  [](const Vector3& axis, double angle) -> Matrix3 {
                      return rodrigues(axis.normalized(), std::cos(2 * angle),
                                       std::sin(2 * angle));
                  }},
                 {"the axis not as long as one", "classic",
                  "Things grow when they turn about a long axis.",
                  "The formula wants an axis of length one, and the door promises any length: "
                  "divide it by its length first.",
                  [](const Vector3& axis, double angle) -> Matrix3 {
                      return rodrigues(axis, std::cos(angle), std::sin(angle));
                  }},
                 {"the part along the axis counted whole", "classic",
                  "Things are stretched along the axis.",
                  "What stands along the axis enters with n n^T, and 1 - cos of the angle "
                  "belongs before it.",
                  [](const Vector3& axis, double angle) -> Matrix3 {
                      return of_parts(axis, std::cos(angle), 1, std::sin(angle));
                  }},
                 {"no part along the axis", "classic", "Things are squeezed flat along the axis.",
                  "The points of the axis must stay: (1 - cos) n n^T is missing.",
                  [](const Vector3& axis, double angle) -> Matrix3 {
                      return of_parts(axis, std::cos(angle), 0, std::sin(angle));
                  }},
                 {"the unturned point counted whole", "classic", "Things grow when they turn.",
                  "The identity stands with the cosine, if n n^T stands with 1 - cos.",
                  [](const Vector3& axis, double angle) -> Matrix3 {
                      return of_parts(axis, 1, 1 - std::cos(angle), std::sin(angle));
                  }},
                 {"the square of the cross product's matrix without its factor", "classic",
                  "Things grow when they turn.",
                  "1 - cos of the angle belongs before the second power.",
                  [](const Vector3& axis, double angle) -> Matrix3 {
                      return of_parts(axis, 0, 1, std::sin(angle));
                  }},
                 {"cosine for one less cosine", "classic", "Along the axis things shrink.",
                  "Before n n^T stands 1 - cos, not cos.",
                  [](const Vector3& axis, double angle) -> Matrix3 {
                      return of_parts(axis, std::cos(angle), std::cos(angle), std::sin(angle));
                  }},
                 {"the first order only", "classic", "Things grow when they turn.",
                  "1 + sin times the cross product's matrix is right for small angles only.",
                  [](const Vector3& axis, double angle) -> Matrix3 {
                      return of_parts(axis, 1, 0, std::sin(angle));
                  }},
                 {"an angle in degrees", "classic", "Everything turns wildly.",
                  "You treat the angle as degrees. It comes in radians.",
                  [](const Vector3& axis, double angle) -> Matrix3 {
                      return Matrix3(Eigen::AngleAxisd(angle * pi / 180, axis.normalized()));
                  }}},
            .alternatives = {{"Rodrigues' formula",
                              [](const Vector3& axis, double angle) -> Matrix3 {
                                  return rodrigues(axis.normalized(), std::cos(angle),
                                                   std::sin(angle));
                              }},
                             {"the images of x, y and z as columns",
                              [](const Vector3& axis, double angle) -> Matrix3 {
                                  const Vector3 n = direction_of(axis);
                                  Matrix3 r;
                                  r << turned(Vector3::UnitX(), n, angle),
                                      turned(Vector3::UnitY(), n, angle),
                                      turned(Vector3::UnitZ(), n, angle);
                                  return r;
                              }}},
        };
    }
#endif
};

inline const bool rotation_about_entered = enter<RotationAbout>();

}  // namespace nutshell::exercises
