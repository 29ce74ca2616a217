// The picture of chapter 7's question, and the stills of its moving figures.
#include <nutshell/live/stills.hpp>
#include "program.hpp"

namespace nutshell {

void pictures(lab::Report& report) {
    live::draw_stills(report);
}

}  // namespace nutshell
