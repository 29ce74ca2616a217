// Exercise 2.3: many forces are one force.
#pragma once
#include <nutshell/revised_newton.hpp>
#include "exercise.hpp"

namespace nutshell::exercises {

struct TotalForce {
    static constexpr const char *id = "2.3", *function = "total_force";
    static constexpr auto subject = NUTSHELL_CALL(total_force);

    template <class Answer>
    static void ask(Paper& paper, const Answer& answer) {
        const std::vector<Vector3> all{{3, -19.6, 2},     {-7.5, 4.2, 11},  {5.4, 31, -6.1},
                                       {-2.2, 8.3, -4.7}, {6.1, -3.9, 1.8}, {0.7, 2.6, 9.4}};
        for (const std::size_t count : {std::size_t{3}, all.size(), std::size_t{5},
                                        std::size_t{2}, std::size_t{1}, std::size_t{0}}) {
            const std::vector<Vector3> forces(all.begin(),
                                              all.begin() + static_cast<std::ptrdiff_t>(count));
            paper.input("how many forces", static_cast<double>(count), "forces", numbers(forces));
            const Vector3 total = answer(std::span<const Vector3>(forces));
            paper.output("the total force [N]", total, forces, 1.0);
        }
    }

#ifndef NUTSHELL_SHEET
    static About<TotalForce> about() {
        return {
            .title = "Many forces are one",
            .hints = {"Each force adds its own change of momentum. What does the body get from "
                      "all of them together?",
                      "Equation (16) is a sum of vectors. What is the sum of an empty list?",
                      "Begin with a zero vector and add every force of the list to it."},
            .mistakes =
                {{"the mean of the forces", "classic",
                  "The more springs hold a thing, the weaker they get.",
                  "You divide by the number of forces. Forces do not share a body among them: "
                  "each acts in full.",
                  [](std::span<const Vector3> forces) -> Vector3 {
                      Vector3 sum = Vector3::Zero();
                      for (const Vector3& force : forces) sum += force;
                      return forces.empty() ? sum
                                            : Vector3(sum / static_cast<double>(forces.size()));
                  }},
                 {"the last force wins",
                  "classic: = for +=", "Switch the wind on and gravity is gone.",
                  "You keep the last force of the list only. Each one must be added to what the "
                  "ones before gave.",
                  [](std::span<const Vector3> forces) -> Vector3 {
                      return forces.empty() ? Vector3(Vector3::Zero()) : forces.back();
                  }},
                 {"the strongest force wins", "classic",
                  "A breeze does nothing beside gravity: smoke falls straight down.",
                  "You take the strongest force and drop the others. A weak force acts too, "
                  "whatever stands beside it.",
                  [](std::span<const Vector3> forces) -> Vector3 {
                      Vector3 strongest = Vector3::Zero();
                      for (const Vector3& force : forces)
                          if (force.norm() > strongest.norm()) strongest = force;
                      return strongest;
                  }},
                 {"the first force is skipped", "classic: an index from 1",
                  "Whatever stands first in the list does nothing.",
                  "Your sum begins with the second force. In C++ the first one has index 0.",
                  [](std::span<const Vector3> forces) -> Vector3 {
                      Vector3 sum = Vector3::Zero();
                      for (std::size_t i = 1; i < forces.size(); ++i) sum += forces[i];
                      return sum;
                  }},
                 {"sizes without signs", "classic",
                  "Two equal pulls from both sides move the ring instead of holding it.",
                  "You add sizes. Forces are vectors: opposite ones cancel.",
                  [](std::span<const Vector3> forces) -> Vector3 {
                      Vector3 sum = Vector3::Zero();
                      for (const Vector3& force : forces) sum += force.cwiseAbs();
                      return sum;
                  }},
                 {"the last force is skipped", "classic: one too few",
                  "Whatever stands last in the list does nothing.",
                  "Your sum ends before the last force.",
                  [](std::span<const Vector3> forces) -> Vector3 {
                      Vector3 sum = Vector3::Zero();
                      for (std::size_t i = 0; i + 1 < forces.size(); ++i) sum += forces[i];
                      return sum;
                  }},
                 {"the first force twice", "classic", "Gravity counts double.",
                  "You begin with the first force and then add it once more in the loop. Begin "
                  "with zero.",
                  [](std::span<const Vector3> forces) -> Vector3 {
                      Vector3 sum = forces.empty() ? Vector3(Vector3::Zero()) : forces[0];
                      for (const Vector3& force : forces) sum += force;
                      return sum;
                  }},
                 {"all but the first taken away", "classic",
                  "Whatever acts second acts backwards.",
                  "You subtract. Forces add up, with the signs they bring.",
                  [](std::span<const Vector3> forces) -> Vector3 {
                      Vector3 sum = Vector3::Zero();
                      for (const Vector3& force : forces) sum -= force;
                      return forces.empty() ? sum : Vector3(sum + 2 * forces[0]);
                  }}},
            .alternatives = {{"component by component, from the back",
                              [](std::span<const Vector3> forces) -> Vector3 {
                                  double x = 0, y = 0, z = 0;
                                  for (std::size_t i = forces.size(); i-- > 0;)
                                      x += forces[i].x(), y += forces[i].y(), z += forces[i].z();
                                  return {x, y, z};
                              }}},
            .survivors = {{"fraction cut off", "zero has no fraction"}},
        };
    }
#endif
};

inline const bool total_force_entered = enter<TotalForce>();

}  // namespace nutshell::exercises
