// One look for each method on every chart: colour is the method's family, mark and dash its member.
#pragma once
#include <nutshell/look.hpp>
#include <string>
#include <string_view>

namespace nutshell::chart {

/// How one series looks. Each colour has a contrast of at least 4.5 with its paper, so its name can be
/// written in it.
struct Style {
    Family family = Family::plain;
    Mark mark = Mark::circle;
    bool hollow = false;     ///< a variant of the method whose mark it has
    std::string light = {};  ///< colour on white paper, as #RRGGBB
    std::string dark = {};   ///< colour on dark paper
    std::string dash = {};   ///< SVG stroke-dasharray, empty = solid
};

/// A look with its colours.
Style style_of(const Look& look);

/// The style of what is no method ("30 Hz", "60 Hz"): each of the first twelve numbers has its own.
Style plain_style(int number);

/// (Until every series carries a Look.) The look of a method. Case and the kind of hyphen do not matter. "Verlet, naive" or "Verlet (naive)" is a
/// variant of Verlet: its colour and mark, hollow and finely dashed. A name that is no method gets the plain
/// style of this number.
Style style_of(std::string_view name, int plain_number = 0);

/// True if `name` (or what stands before its comma or bracket) is in the course's table of methods.
bool is_method(std::string_view name);

}  // namespace nutshell::chart
