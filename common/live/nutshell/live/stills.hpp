// The stills of a chapter's moving figures: what paper, and a reader without script, sees.
#pragma once
#include <nutshell/lab/output.hpp>
#include <nutshell/live/figure.hpp>
#include <nutshell/picture/sheet.hpp>

namespace nutshell::live {

/// The still of some of a figure's states: a shot for each, or a strip of one state's instants.
pic::Sheet still(Figure& figure, const std::vector<State>& states);

/// Draws NAME.png for every figure of this program (those of its states that are drawn side by side), with a
/// note that says its states, so that the page can check its links.
void draw_stills(lab::Report& report);

}  // namespace nutshell::live
