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
        const std::vector<Vector3> all{{3, -19.6, 2}, {-7.5, 4.2, 11}, {5.4, 31, -6.1}};
        for (const std::size_t count :
             {std::size_t{3}, std::size_t{2}, std::size_t{1}, std::size_t{0}}) {
            const std::vector<Vector3> forces(all.begin(),
                                              all.begin() + static_cast<std::ptrdiff_t>(count));
            paper.input("how many forces", static_cast<double>(count), "forces", numbers(forces));
            const Vector3 total = answer(std::span<const Vector3>(forces));
            paper.output("the total force [N]", total, forces, 1.0);
        }
    }
#ifndef NUTSHELL_SHEET
    static Exercise about();
#endif
};

inline const bool total_force_entered = enter<TotalForce>();

}  // namespace nutshell::exercises

#ifndef NUTSHELL_SHEET

namespace nutshell::mistakes {

inline Vector3 mean_force(std::span<const Vector3> forces) {
    Vector3 sum = Vector3::Zero();
    for (const Vector3& force : forces) sum += force;
    return forces.empty() ? sum : Vector3(sum / static_cast<double>(forces.size()));
}
inline Vector3 last_force(std::span<const Vector3> forces) {
    return forces.empty() ? Vector3(Vector3::Zero()) : forces.back();
}
inline Vector3 strongest_force(std::span<const Vector3> forces) {
    Vector3 strongest = Vector3::Zero();
    for (const Vector3& force : forces)
        if (force.norm() > strongest.norm()) strongest = force;
    return strongest;
}
inline Vector3 all_but_the_first(std::span<const Vector3> forces) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 1; i < forces.size(); ++i) sum += forces[i];
    return sum;
}
inline Vector3 sum_of_sizes(std::span<const Vector3> forces) {
    Vector3 sum = Vector3::Zero();
    for (const Vector3& force : forces) sum += force.cwiseAbs();
    return sum;
}

}  // namespace nutshell::mistakes

namespace nutshell::alternatives {

inline Vector3 total_from_the_back(std::span<const Vector3> forces) {
    double x = 0, y = 0, z = 0;
    for (std::size_t i = forces.size(); i-- > 0;)
        x += forces[i].x(), y += forces[i].y(), z += forces[i].z();
    return {x, y, z};
}

}  // namespace nutshell::alternatives

namespace nutshell::exercises {

inline Exercise TotalForce::about() {
    return {
        .title = "Many forces are one",
        .hints = {"Each force adds its own change of momentum. What does the body get from all "
                  "of them together?",
                  "Equation (16) is a sum of vectors. What is the sum of an empty list?",
                  "Begin with a zero vector and add every force of the list to it."},
        .mistakes = {{"the mean of the forces", "classic",
                      "The more springs hold a thing, the weaker they get.",
                      "You divide by the number of forces. Forces do not share a body among "
                      "them: each acts in full.",
                      attempt<TotalForce>(NUTSHELL_CALL(mistakes::mean_force))},
                     {"the last force wins",
                      "classic: = for +=", "Switch the wind on and gravity is gone.",
                      "You keep the last force of the list only. Each one must be added to what "
                      "the ones before gave.",
                      attempt<TotalForce>(NUTSHELL_CALL(mistakes::last_force))},
                     {"the strongest force wins", "classic",
                      "A breeze does nothing beside gravity: smoke falls straight down.",
                      "You take the strongest force and drop the others. A weak force acts too, "
                      "whatever stands beside it.",
                      attempt<TotalForce>(NUTSHELL_CALL(mistakes::strongest_force))},
                     {"the first force is skipped", "classic: an index from 1",
                      "Whatever stands first in the list does nothing.",
                      "Your sum begins with the second force. In C++ the first one has index 0.",
                      attempt<TotalForce>(NUTSHELL_CALL(mistakes::all_but_the_first))},
                     {"sizes without signs", "classic",
                      "Two equal pulls from both sides move the ring instead of holding it.",
                      "You add sizes. Forces are vectors: opposite ones cancel.",
                      attempt<TotalForce>(NUTSHELL_CALL(mistakes::sum_of_sizes))}},
        .alternatives = {{"component by component, from the back",
                          attempt<TotalForce>(NUTSHELL_CALL(alternatives::total_from_the_back))}},
    };
}

}  // namespace nutshell::exercises

#endif
