// The key to every chart, from the methods' own values: each method's colour, mark and dash, by family.
#pragma once
#include <algorithm>
#include <array>
#include <nutshell/chart/chart.hpp>
#include <nutshell/method.hpp>
#include <string>
#include <utility>

namespace nutshell::lab {

/// The looks of a list of methods, a group for each family that has a member in it, in the palette's order.
/// Methods that share a name share a look and stand once.
template <class List>
chart::Legend looks(const List& methods, const std::string& title) {
    constexpr std::array<std::pair<Family, const char*>, 6> families{
        {{Family::explicit_one_step, "explicit, one step"},
         {Family::symplectic, "symplectic: kicks and drifts"},
         {Family::runge_kutta, "Runge–Kutta"},
         {Family::implicit, "implicit"},
         {Family::exponential, "exponential: a part solved exactly"},
         {Family::exact, "exact"}}};
    chart::Legend legend{title, "Colour is the family, mark and dash are the member; hollow: a variant."};
    for (const auto& [family, words] : families) {
        chart::Legend::Group group{words};
        each(methods, [&, wanted = family](const auto& method) {
            const auto same = [&](const chart::Legend::Entry& e) { return e.name == method.name; };
            if (method.look.family == wanted &&
                std::none_of(group.entries.begin(), group.entries.end(), same))
                group.entries.push_back({method.name, method.look});
        });
        if (!group.entries.empty()) legend.groups.push_back(group);
    }
    return legend;
}

}  // namespace nutshell::lab
