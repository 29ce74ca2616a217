// One slip away: small changes are tried on a wrong answer; if one makes it right, that is where it is wrong.
#pragma once
#include <optional>
#include "check.hpp"
#include "clues.hpp"

namespace nutshell::judge {

/// Tries to give a name of its own to every expression of vectors that is kept by `auto`.
/// @return the clue if that makes the answer right
std::optional<Clue> dangling_auto(const Rooms& rooms, const Chapter& chapter, Number number);
/// Tries every small change (see slips_of). @return what to look at, without giving the change away
std::optional<std::string> one_slip_away(const Rooms& rooms, const Chapter& chapter, Number number);

}  // namespace nutshell::judge
