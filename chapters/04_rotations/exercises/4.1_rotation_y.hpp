// Exercise 4.1: the matrix of a turn about y.
#pragma once
#include <nutshell/rotations.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct RotationY {
    static constexpr const char *id = "4.1", *function = "rotation_y";
    static constexpr auto subject = NUTSHELL_CALL(rotation_y);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        for (const double angle : {0.7, -2.1, 3.9, 0.0}) {
            paper.input("angle", angle);
            const Matrix3 r = answer(angle);
            paper.output("the matrix", r, 1.0);
        }
    }

#ifndef NUTSHELL_SHEET
    static Matrix3 rows(double a, double b, double c, double d, double e, double f, double g,
                        double h, double i) {
        Matrix3 r;
        r << a, b, c, d, e, f, g, h, i;
        return r;
    }
    static About<RotationY> about() {
        return {
            .title = "A turn about y",
            .hints =
                {"The columns of a rotation matrix are the images of x, y and z. Where does y "
                 "go when you turn about y?",
                 "Draw z to the right and x upwards, y pointing at you: in this order the "
                 "plane looks like that of x and y for a turn about z.",
                 "z goes towards x, so the third column has the sine in its first row; x goes "
                 "towards -z. The rest is cosines, a one, and zeros."},
            .picture = "order.png",
            .mistakes =
                {{"the minus on the wrong sine", "classic: eqs. (23) and (25) copied",
                  "Everything that yaws turns the other way.",
                  "Your matrix turns by minus the angle. About x and z the minus stands above "
                  "the "
                  "diagonal; about y below it, because z turns to x and not x to z.",
                  [](double angle) -> Matrix3 {
                      const double c = std::cos(angle), s = std::sin(angle);
                      return rows(c, 0, -s, 0, 1, 0, s, 0, c);
                  }},
                 {"about z", "classic", "The ship rolls when it should yaw.",
                  "Your matrix turns x and y and leaves z. A turn about y leaves y.",
                  [](double angle) -> Matrix3 {
                      const double c = std::cos(angle), s = std::sin(angle);
                      return rows(c, -s, 0, s, c, 0, 0, 0, 1);
                  }},
                 {"sine and cosine exchanged", "classic",
                  "The angle 0 turns everything by 90 degrees.",
                  "At the angle 0 nothing may move: the diagonal wants the cosine.",
                  [](double angle) -> Matrix3 {
                      const double c = std::cos(angle), s = std::sin(angle);
                      return rows(s, 0, c, 0, 1, 0, -c, 0, s);
                  }},
                 {"an angle in degrees", "classic", "A turn by 0.7 is hardly to be seen.",
                  "You take the angle for degrees. Angles are radians everywhere in the course.",
                  [](double angle) -> Matrix3 {
                      const double c = std::cos(angle * pi / 180), s = std::sin(angle * pi / 180);
                      return rows(c, 0, s, 0, 1, 0, -s, 0, c);
                  }},
                 {"both sines positive", "classic", "The ship grows and shrinks as it turns.",
                  "Your columns are not at right angles: x must go towards -z where z goes "
                  "towards "
                  "x.",
                  [](double angle) -> Matrix3 {
                      const double c = std::cos(angle), s = std::sin(angle);
                      return rows(c, 0, s, 0, 1, 0, s, 0, c);
                  }}},
            .alternatives = {{"Eigen's",
                              [](double angle) -> Matrix3 {
                                  return Eigen::AngleAxisd(angle, Vector3::UnitY())
                                      .toRotationMatrix();
                              }}},
        };
    }
#endif
};

inline const bool rotation_y_entered = enter<RotationY>();

}  // namespace nutshell::exercises
