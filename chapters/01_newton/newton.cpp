// Chapter 1 · Newton.  ./course run 1  runs it; results in out/01_newton.
#include <nutshell/lab/parts.hpp>
#include "program.hpp"

int main(int argc, char** argv) {
    using namespace nutshell;
    return lab::program(argc, argv, "01_newton",
                        {{"straight line", straight_line},
                         {"thrown ball", thrown_ball},
                         {"planet", planet},
                         {"frame rate", frame_rate},
                         {"game loop", game_loop},
                         {"diagrams", diagrams},
                         {"pictures", pictures}});
}
