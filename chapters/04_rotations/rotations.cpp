// Chapter 4 · Rotations.  ./course run 4  runs it; results in out/04_rotations.
#include "program.hpp"

int main(int argc, char** argv) {
    return nutshell::lab::program(argc, argv, "04_rotations", [](nutshell::lab::Report& report) {
        nutshell::order(report);
        nutshell::printed_matrices(report);
        nutshell::small_turns(report);
        nutshell::between_poses(report);
        nutshell::three_angles(report);
        nutshell::million_turns(report);
        nutshell::cost(report);
        nutshell::pictures(report);
    });
}
