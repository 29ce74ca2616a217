// Chapter 4 · Rotations.  ./course run 4  runs it; results in out/04_rotations.
#include <nutshell/lab/parts.hpp>
#include "program.hpp"

int main(int argc, char** argv) {
    using namespace nutshell;
    return lab::program(argc, argv, "04_rotations",
                        {{"order", order},
                         {"printed matrices", printed_matrices},
                         {"small turns", small_turns},
                         {"between poses", between_poses},
                         {"three angles", three_angles},
                         {"million turns", million_turns},
                         {"cost", cost},
                         {"pictures", pictures}});
}
