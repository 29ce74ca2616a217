// Exercise 7.9: a polygon cut along a line, as Sutherland and Hodgman do it.
#pragma once
#include <nutshell/box_contacts.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct Clipped {
    static constexpr const char *id = "7.9", *function = "clipped";
    static constexpr auto subject = NUTSHELL_CALL(clipped);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const std::vector<Vector3> leaning{
            {-0.7, -0.4, 0.11}, {0.8, -0.6, 0.05}, {0.9, 0.7, -0.03}, {-0.5, 0.6, 0.02}};
        const std::vector<Vector3> triangle{{0.2, -0.9, 0.1}, {1.3, 0.4, 0.3}, {-0.6, 0.5, -0.2}};
        const std::vector<Vector3> diamond{{0, -1, 0.1}, {1, 0, 0.2}, {0, 1, 0.3}, {-1, 0, 0.4}};
        const std::vector<Vector3> five{
            {0, -1, 0.1}, {1, -0.3, 0.2}, {0.6, 0.9, 0.3}, {-0.6, 0.8, 0.4}, {-1, -0.2, 0.5}};
        one(paper, answer, leaning, 0, 1, 0.5, 1);
        one(paper, answer, five, 0, 1, 0.4, 1);
        one(paper, answer, five, 1, 1, 0.5, 3);
        one(paper, answer, leaning, 0, -1, 0.25, 2);
        one(paper, answer, leaning, 1, 1, 0.3, 3);
        one(paper, answer, leaning, 1, -1, 0.45, 4);
        one(paper, answer, triangle, 0, 1, 0.6, 1);
        one(paper, answer, triangle, 1, -1, 0.1, 4);
        one(paper, answer, diamond, 0, 1, 0.5, 1);
        one(paper, answer, diamond, 1, 1, 1.5, 3);  // nothing to cut
        one(paper, answer, diamond, 0, -1, -2, 2);  // nothing is left
        one(paper, answer, diamond, 0, 1, 0, 1);    // two corners on the line
        one(paper, answer, diamond, 1, -1, 1, 4);   // one corner on the line
    }

  private:
    template <class Answer>
    static void one(Paper& paper, const Answer& answer, const std::vector<Vector3>& corners,
                    int axis, double sign, double limit, int side) {
        Polygon from;
        from.corner.fill({0.05, 0.04, 3}), from.name.fill(99);  // places that nobody may read
        Eigen::MatrixXd columns(3, static_cast<Eigen::Index>(corners.size()));
        for (std::size_t i = 0; i < corners.size(); ++i) {
            from.add(corners[i], (corners.size() == 4 ? 5 : 3) * static_cast<int>(i + 1));
            columns.col(static_cast<Eigen::Index>(i)) = corners[i];
        }
        paper.input("from", columns, "axis", static_cast<double>(axis), "sign", sign, "limit",
                    limit, "side", static_cast<double>(side));
        const Polygon left = answer(from, axis, sign, limit, side);
        // eight places, those that are not used filled with sevens
        Eigen::Matrix<double, 3, 8> places = Eigen::Matrix<double, 3, 8>::Constant(7);
        Eigen::Matrix<double, 8, 1> names = Eigen::Matrix<double, 8, 1>::Zero();
        for (int i = 0; i < std::min(left.size, 8); ++i) {
            places.col(i) = left.corner[static_cast<std::size_t>(i)];
            names[i] = left.name[static_cast<std::size_t>(i)];
        }
        paper.output("how many corners are left", static_cast<double>(left.size), 1.0);
        paper.output("the corners [m]", places, 1.0);
        paper.output("their names", names, 100.0);
    }

  public:
#ifndef NUTSHELL_SHEET
    struct Slip {
        bool no_cuts = false, other_side = false, half_way = false, wrong_end = false,
             one_way = false, ignore_sign = false, open = false, outer = false, no_five = false,
             short_loop = false;
    };
    static Polygon with(const Slip& slip, const Polygon& from, int axis, double sign,
                        double limit, int side) {
        Polygon left;
        for (int k = 0; k < from.size - (slip.short_loop ? 1 : 0); ++k) {
            const auto here = static_cast<std::size_t>(k),
                       next = static_cast<std::size_t>((k + 1) % from.size);
            const Vector3 &p = from.corner[here], &q = from.corner[next];
            const double s = slip.ignore_sign ? 1 : sign;
            double over_p = s * p[axis] - limit, over_q = s * q[axis] - limit;
            if (slip.other_side) over_p = -over_p, over_q = -over_q;
            if (over_p <= 0) left.add(p, from.name[here]);
            const bool leaves = over_p < 0 && over_q > 0, enters = over_p > 0 && over_q < 0;
            if (slip.open && k + 1 == from.size) continue;
            if (slip.no_cuts || !(leaves || (enters && !slip.one_way))) continue;
            double part = over_p / (over_p - over_q);
            if (slip.half_way) part = 0.5;
            if (slip.wrong_end) part = 1 - part;
            left.add(p + part * (q - p),
                     over_p < 0   ? 10 * from.name[here] + side
                     : slip.outer ? 10 * from.name[here] + 5 + side
                                  : 10 * from.name[next] + (slip.no_five ? 0 : 5) + side);
        }
        return left;
    }
    static auto wrong(const Slip& slip) {
        return [slip](const Polygon& from, int axis, double sign, double limit,
                      int side) -> Polygon { return with(slip, from, axis, sign, limit, side); };
    }
    static About<Clipped> about() {
        return {
            .title = "Cut a polygon",
            .hints =
                {"Go round the edges. An edge goes from a corner p to the next one, q. Which "
                 "of the two is on the side that stays?",
                 "A corner on the side that stays, stays. An edge whose ends are on "
                 "different sides adds the point where it crosses. How far along is that?",
                 "With over_p and over_q, how far the ends are beyond the limit, the "
                 "crossing is over_p/(over_p - over_q) of the way from p to q. It is named "
                 "after the edge's inner end, as the type says."},
            .mistakes =
                {{"corners only", "classic: no new corners",
                  "A box that hangs over an edge falls through it.",
                  "You keep the corners inside but add none where an edge is cut. A face that "
                  "covers another in the shape of a cross has no corner inside at all.",
                  wrong({.no_cuts = true})},
                 {"the wrong half", "classic: < for >", "Boxes touch where they do not.",
                  "You keep what is beyond the limit and throw away what is within.",
                  wrong({.other_side = true})},
                 {"cut in the middle", "classic", "A box slides and its contacts jump.",
                  "You cut every edge in its middle. It must be cut where its coordinate is the "
                  "limit.",
                  wrong({.half_way = true})},
                 {"measured from the wrong end", "classic",
                  "Contacts wander out of the face when a box turns.",
                  "You go the fraction from q that belongs to p. The one that is farther from "
                  "the limit is farther from the cut.",
                  wrong({.wrong_end = true})},
                 {"only on the way out", "classic",
                  "A box over an edge has three contacts of "
                  "four.",
                  "You add the crossing where the outline leaves, not where it comes back in.",
                  wrong({.one_way = true})},
                 {"always the upper side", "classic: the sign is not used",
                  "Boxes stand well on one half of a table.",
                  "You do not use sign: the limits at -x and -y are never cut.",
                  wrong({.ignore_sign = true})},
                 {"the last edge is never cut", "classic: not closed",
                  "A corner is missing now and then.",
                  "The edge from the last corner back to the first is never cut: after the last "
                  "comes the first "
                  "again, (k + 1) % size.",
                  wrong({.open = true})},
                 {"named after the outer end", "classic", "Contacts forget what they carried.",
                  "Where the outline comes back in, the new corner is named after the edge's "
                  "outer end. It is "
                  "the inner one, next, that stays.",
                  wrong({.outer = true})},
                 {"named as where it leaves", "classic: the 5 forgotten",
                  "Two contacts take over each other's past.",
                  "Where the outline comes back in, the name has a 5 added, so that no other "
                  "corner has it.",
                  wrong({.no_five = true})},
                 {"the last corner is forgotten", "classic: k + 1 < size",
                  "A box stands on three of its corners.",
                  "Your loop ends before the last corner. It is lost, and so is the edge that "
                  "leads from it back to the first one.",
                  wrong({.short_loop = true})}},
            .alternatives = {{"from each corner back to the one before",
                              [](const Polygon& from, int axis, double sign, double limit,
                                 int side) -> Polygon {
                                  // the same walk, one corner on; then turned back into its place
                                  Polygon left;
                                  for (int k = 0; k < from.size; ++k) {
                                      const auto p = static_cast<std::size_t>(k),
                                                 q = static_cast<std::size_t>(
                                                     k + 1 == from.size ? 0 : k + 1);
                                      const double a = limit - sign * from.corner[p][axis],
                                                   b = limit - sign * from.corner[q][axis];
                                      if (a >= 0) left.add(from.corner[p], from.name[p]);
                                      if (a * b >= 0) continue;
                                      const Vector3 cut =
                                          (b * from.corner[p] - a * from.corner[q]) / (b - a);
                                      left.add(cut, a > 0 ? 10 * from.name[p] + side
                                                          : 10 * from.name[q] + 5 + side);
                                  }
                                  return left;
                              }}},
            .survivors = {{"< to <=, 6", "a cut is made only where p is not on the line"}},
        };
    }
#endif
};

inline const bool clipped_entered = enter<Clipped>();

}  // namespace nutshell::exercises
