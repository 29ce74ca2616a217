// A method as one value: everything the course says of it comes from here, and its name is written once.
//
// A chapter's *_methods.hpp holds its values, in namespace nutshell::methods, beside the plain functions that
// the learner reads. A run begins with `auto step = method.start(scene)` and goes on with `state =
// step(state, scene, t, dt)`: what is kept from step to step (the last push, arrays for forces) belongs to
// that stepper.
#pragma once
#include <cctype>
#include <nutshell/look.hpp>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace nutshell {

/// A name as part of a number's name: "Dormand-Prince 5(4)" becomes "dormand_prince_5_4".
inline std::string key_of(std::string_view name) {
    std::string key;
    for (const char c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)))
            key += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!key.empty() && key.back() != '_')
            key += '_';
    }
    while (!key.empty() && key.back() == '_') key.pop_back();
    return key;
}

/// The order of a method that is exact on its scene.
inline constexpr int no_order = 0;

/// Evaluations a step of a method that solves an equation: as many as its iteration takes.
inline constexpr int as_needed = -1;

template <class Start>
struct Method {
    const char* name;  ///< in tables, on charts and, as key(), in numbers.csv
    Look look;         ///< on every chart and picture
    int order;         ///< of convergence, where the forces are such as the method is made for
    int evaluations;   ///< of the forces, in each step after the first
    Start start;       ///< start(scene) gives the stepper of one run

    std::string key() const { return key_of(name); }
};
template <class Start>
Method(const char*, Look, int, int, Start) -> Method<Start>;

/// Calls visit(method) for every method of a list; a list is a tuple of values.
template <class List, class Visit>
void each(const List& methods, const Visit& visit) {
    std::apply([&](const auto&... method) { (visit(method), ...); }, methods);
}

/// What a scene's forces(state, t) gives: a force for one body, arrays of forces for many.
template <class Scene>
using PushOf = std::decay_t<decltype(std::declval<const Scene&>()(std::declval<const Scene&>().start, 0.0))>;

/// Evaluates the push into `into`: in place where the scene can, so that a step allocates nothing.
template <class Forces, class State, class Push>
void evaluate(const Forces& forces, const State& state, double t, Push& into) {
    if constexpr (requires { forces(state, t, into); })
        forces(state, t, into);
    else
        into = forces(state, t);
}

// What a run must hold so that its scene can be asked for a push: nothing, where a push is a value. A chapter
// whose pushes are arrays has overloads of these two.
struct NoRoom {};
template <class Scene>
NoRoom room_for(const Scene&) {
    return {};
}
template <class Forces>
const Forces& asking(const Forces& forces, NoRoom&) {
    return forces;
}

/// The stepper of a method that keeps nothing from step to step: a plain function, and room for its pushes.
template <class Step, class Room>
struct PlainStepper {
    Step step;
    Room room;

    template <class State, class Forces>
    State operator()(State state, const Forces& forces, double t, double dt) {
        return step(std::move(state), asking(forces, room), t, dt);
    }
};

/// How a run of such a method starts. @param step  called as step(state, forces, t, dt)
template <class Step>
constexpr auto plainly(Step step) {
    return [step](const auto& scene) {
        return PlainStepper<Step, decltype(room_for(scene))>{step, room_for(scene)};
    };
}

}  // namespace nutshell
