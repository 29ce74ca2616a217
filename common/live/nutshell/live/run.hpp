// A run by one of several methods, chosen while it stands in the page.
#pragma once
#include <functional>
#include <nutshell/live/figure.hpp>
#include <nutshell/method.hpp>
#include <nutshell/require.hpp>

namespace nutshell::live {

/// A method as a button.
template <class Method>
Choice choice_of(const Method& method) {
    return {method.key(), method.name, method.look};
}

/// The methods of a list as buttons.
template <class List>
std::vector<Choice> choices_of(const List& methods) {
    std::vector<Choice> choices;
    each(methods, [&](const auto& method) { choices.push_back(choice_of(method)); });
    return choices;
}

/// One run: where it is, where it was a step ago, and how it goes on.
template <class State>
struct Run {
    State newest, previous;
    double time = 0;
    long steps = 0;

    Run() = default;
    /// @param which  of the list's methods    @throws std::invalid_argument if there is no such one
    template <class List, class Scene>
    Run(const List& methods, int which, const Scene& scene) : newest(scene.start), previous(scene.start) {
        int i = 0;
        each(methods, [&](const auto& method) {
            if (i++ != which) return;
            make_ = [stepper = method.start(scene), scene](const State& s, double t, double dt) mutable {
                return stepper(s, scene, t, dt);
            };
        });
        require(make_ != nullptr, "a run: there is no method number " + digits(which));
    }
    void step(double dt) {
        previous = newest;
        newest = make_(newest, time, dt);
        time += dt;
        ++steps;
    }
    /// Between the last two states: 0 the one before, 1 the newest.
    Eigen::Vector3d position(double part) const {
        return previous.position + part * (newest.position - previous.position);
    }

  private:
    std::function<State(const State&, double, double)> make_;
};

}  // namespace nutshell::live
