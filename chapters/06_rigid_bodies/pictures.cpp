// The stills of chapter 6's moving figures, those of both halves.
#include <nutshell/live/stills.hpp>
#include "program.hpp"

namespace nutshell {

void pictures(lab::Report& report) {
    live::draw_stills(report);
}

}  // namespace nutshell
