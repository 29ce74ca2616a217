// Exercise 7.12: the broad phase, each pair of neighbours once.
#pragma once
#include <nutshell/grid.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct VisitPairs {
    static constexpr const char *id = "7.12", *function = "visit_pairs";
    static constexpr auto subject = NUTSHELL_CALL(visit_pairs);

    /// A point in the middle of each of 3 x 4 x 3 cubes, in a mixed order, and some twice.
    static std::vector<Vector3> all_cubes() {
        std::vector<Vector3> points;
        for (int i = 0; i < 36; ++i) {
            const int k = (i * 7) % 36;
            points.emplace_back(0.5 + k % 3, 0.5 + k / 3 % 4, 0.5 + k / 12);
        }
        points.emplace_back(0.6, 0.6, 0.6), points.emplace_back(1.4, 2.4, 1.6);
        return points;
    }

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        one(paper, answer, "a point in each cube", all_cubes());
        one(paper, answer, "two points in one cube", {{0, 0, 0}, {0.2, 0.1, 0.3}});
        one(paper, answer, "across a corner, rising",
            {{0, 0, 0}, {0.9, 0.9, 0.9}, {1.1, 1.1, 1.1}, {2.9, 2.9, 2.9}});
        one(paper, answer, "ends of two rows",
            {{0, 0, 0}, {3.5, 0, 0}, {0, 0, 1.5}, {3.5, 0, 1.5}});
    }

  private:
    template <class Answer>
    static void one(Paper& paper, const Answer& answer, const char* what,
                    const std::vector<Vector3>& points) {
        Grid grid;
        grid.sort(points, 1.0);
        const auto n = static_cast<Eigen::Index>(points.size());
        Eigen::MatrixXd visits = Eigen::MatrixXd::Zero(n, n);
        answer(grid, [&](int i, int j) { visits(std::max(i, j), std::min(i, j)) += 1; });
        paper.input("points", what);
        std::vector<double> counts;
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index j = 0; j <= i; ++j) counts.push_back(visits(i, j));
        paper.output("how many visits there are", visits.sum(), 1.0);
        paper.output("how often each pair was visited", counts, 1.0);
    }

  public:
#ifndef NUTSHELL_SHEET
    /// All of a grid's cubes and items, and what one does for each.
    template <class Body>
    static void for_each_item(const Grid& grid, const Body& body) {
        for (int y = 0; y < grid.size()[1]; ++y)
            for (int z = 0; z < grid.size()[2]; ++z)
                for (int x = 0; x < grid.size()[0]; ++x)
                    for (int i = grid.first(x, y, z); i < grid.first(x + 1, y, z); ++i)
                        body(i, x, y, z);
    }
    static About<VisitPairs> about() {
        return {
            .title = "Neighbours, each pair once",
            .hints = {"Two points nearer than a cube's side may be in different cubes: how many "
                      "cubes lie around one, across its faces, edges and corners?",
                      "Each pair once: if a cube looks at the next one, that one need not look "
                      "back. Which half of the 26 do you look at? And the points of the own "
                      "cube?",
                      "with_row from i + 1 in the own cube and the one to the right; then the "
                      "row behind, x - 1 to x + 1; then the three rows of the layer above."},
            .mistakes =
                {{"the own cube only", "classic: cell borders missed",
                  "Balls pass through each other along the lines of an invisible lattice.",
                  "You look into the own cube only. A neighbour a millimetre away may be across "
                  "the border.",
                  [](const Grid& grid, const auto& visit) -> void {
                      for_each_item(grid, [&](int i, int x, int y, int z) {
                          grid.with_row(i, i + 1, x, x, y, z, visit);
                      });
                  }},
                 {"no corners", "classic: faces only",
                  "Two balls that meet at the corner of a cube do not collide.",
                  "You look across faces only. Edges and corners have neighbours too.",
                  [](const Grid& grid, const auto& visit) -> void {
                      for_each_item(grid, [&](int i, int x, int y, int z) {
                          grid.with_row(i, i + 1, x, x + 1, y, z, visit);
                          grid.with_row(i, 0, x, x, y, z + 1, visit);
                          grid.with_row(i, 0, x, x, y + 1, z, visit);
                      });
                  }},
                 {"upwards only", "classic: half of the half",
                  "Balls pass through each other when the left one is higher.",
                  "You look to x + 1 but not to x - 1 in the other rows: no other cube will look "
                  "back for you.",
                  [](const Grid& grid, const auto& visit) -> void {
                      for_each_item(grid, [&](int i, int x, int y, int z) {
                          grid.with_row(i, i + 1, x, x + 1, y, z, visit);
                          grid.with_row(i, 0, x, x + 1, y, z + 1, visit);
                          for (int dz = 0; dz <= 1; ++dz)
                              grid.with_row(i, 0, x, x + 1, y + 1, z + dz, visit);
                      });
                  }},
                 {"each pair twice", "classic: all 26",
                  "Every contact is solved twice, and the machine is half as fast.",
                  "You look at all 26 neighbours, so each pair is seen from both sides.",
                  [](const Grid& grid, const auto& visit) -> void {
                      for_each_item(grid, [&](int i, int x, int y, int z) {
                          grid.with_row(i, i + 1, x, x, y, z, visit);
                          for (int dy = -1; dy <= 1; ++dy)
                              for (int dz = -1; dz <= 1; ++dz) {
                                  if (dy != 0 || dz != 0)
                                      grid.with_row(i, 0, x - 1, x + 1, y + dy, z + dz, visit);
                              }
                          grid.with_row(i, 0, x + 1, x + 1, y, z, visit);
                          if (x > 0) grid.with_row(i, 0, x - 1, x - 1, y, z, visit);
                      });
                  }},
                 {"a body with itself", "classic: i for i + 1",
                  "Every body is thrown out by itself.",
                  "In the own cube you begin with the point itself. Begin with the next one.",
                  [](const Grid& grid, const auto& visit) -> void {
                      for_each_item(grid, [&](int i, int x, int y, int z) {
                          grid.with_row(i, i, x, x + 1, y, z, visit);
                          grid.with_row(i, 0, x - 1, x + 1, y, z + 1, visit);
                          for (int dz = -1; dz <= 1; ++dz)
                              grid.with_row(i, 0, x - 1, x + 1, y + 1, z + dz, visit);
                      });
                  }},
                 {"above, one row is missing", "classic: dz from 0",
                  "Balls pass through each other along one edge.",
                  "In the layer above all three rows count, dz from -1 to 1: one is missing.",
                  [](const Grid& grid, const auto& visit) -> void {
                      for_each_item(grid, [&](int i, int x, int y, int z) {
                          grid.with_row(i, i + 1, x, x + 1, y, z, visit);
                          grid.with_row(i, 0, x - 1, x + 1, y, z + 1, visit);
                          for (int dz = 0; dz <= 1; ++dz)
                              grid.with_row(i, 0, x - 1, x + 1, y + 1, z + dz, visit);
                      });
                  }},
                 {"no row beside the own", "classic",
                  "Balls on one floor pass through each other.",
                  "Within a layer the rows next to each other are missed: with_row for y and z + "
                  "1.",
                  [](const Grid& grid, const auto& visit) -> void {
                      for_each_item(grid, [&](int i, int x, int y, int z) {
                          grid.with_row(i, i + 1, x, x + 1, y, z, visit);
                          for (int dz = -1; dz <= 1; ++dz)
                              grid.with_row(i, 0, x - 1, x + 1, y + 1, z + dz, visit);
                      });
                  }},
                 {"nothing to the left", "classic: x for x - 1",
                  "Balls pass through each other from one side.",
                  "In the other rows you look from x on: what lies to the left, x - 1, is "
                  "missed.",
                  [](const Grid& grid, const auto& visit) -> void {
                      for_each_item(grid, [&](int i, int x, int y, int z) {
                          grid.with_row(i, i + 1, x, x + 1, y, z, visit);
                          grid.with_row(i, 0, x, x + 1, y, z + 1, visit);
                          for (int dz = -1; dz <= 1; ++dz)
                              grid.with_row(i, 0, x, x + 1, y + 1, z + dz, visit);
                      });
                  }},
                 {"all 27, the own cube too", "classic",
                  "Every body hits itself, and each other one twice.",
                  "You look at all the cubes around and at the own one from its start: each pair "
                  "is seen from "
                  "both sides, and each point with itself. Look at the half that comes after.",
                  [](const Grid& grid, const auto& visit) -> void {
                      for_each_item(grid, [&](int i, int x, int y, int z) {
                          for (int dy = -1; dy <= 1; ++dy)
                              for (int dz = -1; dz <= 1; ++dz)
                                  grid.with_row(i, 0, x - 1, x + 1, y + dy, z + dz, visit);
                      });
                  }},
                 {"above, only the row straight above", "classic: 7 of the 13",
                  "Balls pass through each other along some edges.",
                  "In the layer above you look into the row straight above only. The rows beside "
                  "that one, z - 1 and z + 1, have neighbours too.",
                  [](const Grid& grid, const auto& visit) -> void {
                      for_each_item(grid, [&](int i, int x, int y, int z) {
                          grid.with_row(i, i + 1, x, x + 1, y, z, visit);
                          grid.with_row(i, 0, x - 1, x + 1, y, z + 1, visit);
                          grid.with_row(i, 0, x - 1, x + 1, y + 1, z, visit);
                      });
                  }},
                 {"behind, nothing to the left", "classic: one edge forgotten",
                  "Balls pass through each other across one edge of an invisible lattice.",
                  "In the row behind you look at x and x + 1, not at x - 1. No other cube will "
                  "look across that edge.",
                  [](const Grid& grid, const auto& visit) -> void {
                      for_each_item(grid, [&](int i, int x, int y, int z) {
                          grid.with_row(i, i + 1, x, x + 1, y, z, visit);
                          grid.with_row(i, 0, x, x + 1, y, z + 1, visit);
                          for (int dz = -1; dz <= 1; ++dz)
                              grid.with_row(i, 0, x - 1, x + 1, y + 1, z + dz, visit);
                      });
                  }}},
            .alternatives = {{"the half below",
                              [](const Grid& grid, const auto& visit) -> void {
                                  for_each_item(grid, [&](int i, int x, int y, int z) {
                                      grid.with_row(i, i + 1, x, x, y, z, visit);
                                      if (x > 0) grid.with_row(i, 0, x - 1, x - 1, y, z, visit);
                                      grid.with_row(i, 0, x - 1, x + 1, y, z - 1, visit);
                                      for (int dz = -1; dz <= 1; ++dz)
                                          grid.with_row(i, 0, x - 1, x + 1, y - 1, z + dz, visit);
                                  });
                              }}},
            .survivors =
                {{"+ to -, 4",
                  "the row behind instead of the one in front: each pair still once"},
                 {"+ to -, 6", "the rows below instead of those above: each pair still once"},
                 {"+ to -, 7", "dz takes -1, 0 and 1, the other way round"},
                 {"0 to 0 + 1", "the points of later rows come after i, so after point 0"},
                 {"0 to 0 + 1, 2", "the points of later rows come after i, so after point 0"},
                 {"1 to 0.999 of it, 3",
                  "as an int x - 1; where that is -1, 0, where the grid ends"},
                 {"1 to 0.999 of it, 8",
                  "as an int x - 1; where that is -1, 0, where the grid ends"},
                 {"<= at 1.25 * 1", "dz is whole"},
                 {"statements 1 and 3 swapped", "pairs may be visited in any order"},
                 {"statements 2 and 3 swapped", "pairs may be visited in any order"},
                 {"visit frozen", "every question counts in the same place"}},
        };
    }
#endif
};

inline const bool visit_pairs_entered = enter<VisitPairs>();

}  // namespace nutshell::exercises
