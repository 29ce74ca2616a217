// The loops that make a step in one pass over memory, as a method of the lab.
#pragma once
#include <nutshell/chain_scenes.hpp>
#include <nutshell/newton_methods.hpp>

struct OnePass {
    nutshell::Vector3Array sums;
    template <class Scene>
    nutshell::Particles operator()(nutshell::Particles all, const Scene& scene, double, double dt) {
        advance(all, scene, sums, dt);
        return all;
    }
};
inline constexpr nutshell::Method one_pass{"one pass", nutshell::methods::semi_implicit_euler.look, 1, 0,
                                           [](const auto&) { return OnePass(); }};
