// Exercise 6.13: a turning body as seven numbers, where the torque is in the wrong frame.
#pragma once
#include <nutshell/lie_methods.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct RateInBody {
    static constexpr const char *id = "6.13", *function = "rate_in_body";
    static constexpr auto subject = NUTSHELL_CALL(rate_in_body);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const Quaternion a = Quaternion(0.4, 0.3, -0.5, 0.7).normalized(),
                         b = Quaternion(0.9, -0.6, 0.2, 0.1).normalized();
        const Vector3 J(0.9, 0.45, 0.35), H(0.4, 1.6, 0.7), M(2.3, -4.1, 1.7), N(-1.9, 3.2, 4.4),
            push(3.1, 5.2, -4.3), pull(-6.1, 2.4, 3.9);
        const auto one = [&](const Quaternion& q, const Vector3& m,
                             const Vector3& inverse_moments, const Vector3& torque) {
            FlatPinned y;
            y << q.coeffs(), m;
            paper.input("y", y, "J", inverse_moments, "torque", torque);
            paper.frame(q);
            const FlatPinned rate = answer(y, inverse_moments, torque);
            const Eigen::Vector4d pose = rate.head<4>();
            const Vector3 change = rate.tail<3>();
            paper.output("the rate of the 4-vector [1/s]", pose, m.norm());
            paper.output("the rate of M [N m]", change, m.squaredNorm(), torque.norm());
        };
        one(a, M, J, push), one(b, M, J, push), one(a, N, J, push), one(a, M, H, push);
        one(a, M, J, pull), one(a, M, J, {0, 0, 0});
    }

#ifndef NUTSHELL_SHEET
    /// All of it, with the rate of M given.
    template <class Change>
    static FlatPinned with(const FlatPinned& y, const Vector3& J, const Change& change) {
        const Quaternion q(Eigen::Vector4d(y.head<4>()));
        const Vector3 M = y.tail<3>(), w = J.cwiseProduct(M);
        FlatPinned rate;
        rate << (q * four_vector(w / 2, 0)).coeffs(), change(q, M, w);
        return rate;
    }
    static About<RateInBody> about() {
        using F = const FlatPinned&;
        using V = const Vector3&;
        using Q = const Quaternion&;
        return {
            .title = "Seven numbers and their rates",
            .hints =
                {"Four numbers of the pose, three of M. Each has a rate you know: the pose's "
                 "from "
                 "chapter 5, but here omega is in the body's axes; M's from exercise 6.9.",
                 "In the body's axes (omega, 0) stands on the right of q. The torque is given in "
                 "the world's axes, M lives in the body's.",
                 "q is made of y.head<4>(), M is y.tail<3>(). The rate of M is "
                 "gyroscopic_term(J, "
                 "M) plus the torque turned by the inverse of q."},
            .picture = "s8.svg",
            .mistakes =
                {{"the torque in the world's axes", "classic: the wrong frame",
                  "The top staggers, the more the further it has turned.",
                  "You add the torque as it stands in the world to an M that lives in the body. "
                  "Turn it into the body first.",
                  [](F y, V J, V torque) -> FlatPinned {
                      return with(y, J,
                                  [&](Q, V M, V w) -> Vector3 { return M.cross(w) + torque; });
                  }},
                 {"the torque turned the wrong way", "E51: the transposed rotation",
                  "The top jerks to and fro as it spins.",
                  "The pose leads from the body to the world. The torque comes from the world: "
                  "the inverse.",
                  [](F y, V J, V torque) -> FlatPinned {
                      return with(y, J, [&](Q q, V M, V w) -> Vector3 {
                          return M.cross(w) + q * torque;
                      });
                  }},
                 {"no gyroscopic term", "classic: the default of several engines",
                  "The top nods and goes round almost four times too slowly.",
                  "M changes by the torque only. Seen from the body, L turns back as well.",
                  [](F y, V J, V torque) -> FlatPinned {
                      return with(y, J,
                                  [&](Q q, V, V) -> Vector3 { return q.conjugate() * torque; });
                  }},
                 {"the gyroscopic term twice", "classic: added by two hands",
                  "Tops and handles tumble too fast.", "The gyroscopic term is counted twice.",
                  [](F y, V J, V torque) -> FlatPinned {
                      return with(y, J, [&](Q q, V M, V w) -> Vector3 {
                          return 2 * M.cross(w) + q.conjugate() * torque;
                      });
                  }},
                 {"the gyroscopic term of the wrong sign", "classic: omega x L",
                  "Energy and |L| are perfect, and L swings round.",
                  "Seen from the body, L turns the other way round: M x omega.",
                  [](F y, V J, V torque) -> FlatPinned {
                      return with(y, J, [&](Q q, V M, V w) -> Vector3 {
                          return w.cross(M) + q.conjugate() * torque;
                      });
                  }},
                 {"the pose's rate for world axes", "E20: the side is not said",
                  "Only bodies that start upright turn rightly.",
                  "(omega, 0) stands on the left of q, where an omega of the world's axes "
                  "belongs. This one is in the body's: right.",
                  [](F y, V J, V torque) -> FlatPinned {
                      FlatPinned rate = with(y, J, [&](Q q, V M, V w) -> Vector3 {
                          return M.cross(w) + q.conjugate() * torque;
                      });
                      const Quaternion q(Eigen::Vector4d(y.head<4>()));
                      const Vector3 w = J.cwiseProduct(Vector3(y.tail<3>()));
                      rate.head<4>() = (four_vector(w / 2, 0) * q).coeffs();
                      return rate;
                  }},
                 {"the half forgotten", "classic", "Everything turns twice as fast.",
                  "q knows half of the angle: its rate is half of the product.",
                  [](F y, V J, V torque) -> FlatPinned {
                      FlatPinned rate = with(y, J, [&](Q q, V M, V w) -> Vector3 {
                          return M.cross(w) + q.conjugate() * torque;
                      });
                      rate.head<4>() *= 2;
                      return rate;
                  }},
                 {"the rates in another order", "classic", "Pose and spin change places.",
                  "Both rates are right, but the 4-vector's comes first, as in y.",
                  [](F y, V J, V torque) -> FlatPinned {
                      const FlatPinned rate = with(y, J, [&](Q q, V M, V w) -> Vector3 {
                          return M.cross(w) + q.conjugate() * torque;
                      });
                      FlatPinned other;
                      other << rate.tail<3>(), rate.head<4>();
                      return other;
                  }},
                 {"the rate of omega for that of M", "classic: L and omega mixed up",
                  "Light tops fall too fast, heavy ones too slowly.",
                  "You multiply the rate of M by the inverse moments. That makes it the rate of "
                  "omega, an angular acceleration; the last three numbers hold M.",
                  [](F y, V J, V torque) -> FlatPinned {
                      return with(y, J, [&](Q q, V M, V w) -> Vector3 {
                          return J.cwiseProduct(Vector3(M.cross(w) + q.conjugate() * torque));
                      });
                  }},
                 {"omega handed over as M", "classic: two vectors mixed up",
                  "The top nods at another pace.",
                  "You hand omega to the gyroscopic term. It wants M, and finds omega by itself.",
                  [](F y, V J, V torque) -> FlatPinned {
                      return with(y, J, [&](Q q, V, V w) -> Vector3 {
                          return w.cross(J.cwiseProduct(w)) + q.conjugate() * torque;
                      });
                  }}},
            .alternatives = {{"number by number",
                              [](F y, V J, V torque) -> FlatPinned {
                                  const Vector3 o = J.cwiseProduct(Vector3(y.tail<3>()));
                                  const Quaternion q(y[3], y[0], y[1], y[2]);
                                  const Vector3 t = q.toRotationMatrix().transpose() * torque;
                                  FlatPinned r;
                                  r[0] = (y[3] * o[0] + y[1] * o[2] - y[2] * o[1]) / 2;
                                  r[1] = (y[3] * o[1] + y[2] * o[0] - y[0] * o[2]) / 2;
                                  r[2] = (y[3] * o[2] + y[0] * o[1] - y[1] * o[0]) / 2;
                                  r[3] = -(y[0] * o[0] + y[1] * o[1] + y[2] * o[2]) / 2;
                                  r[4] = (J[2] - J[1]) * y[5] * y[6] + t[0];
                                  r[5] = (J[0] - J[2]) * y[6] * y[4] + t[1];
                                  r[6] = (J[1] - J[0]) * y[4] * y[5] + t[2];
                                  return r;
                              }}},
        };
    }
#endif
};

inline const bool rate_in_body_entered = enter<RateInBody>();

}  // namespace nutshell::exercises
