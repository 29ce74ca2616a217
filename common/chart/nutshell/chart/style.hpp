// From a look to what is drawn: colour is the method's family, mark and dash its member.
#pragma once
#include <nutshell/look.hpp>
#include <string>

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

}  // namespace nutshell::chart
