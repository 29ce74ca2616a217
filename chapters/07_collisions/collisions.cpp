// Chapter 7 · Collisions.  ./course run 7  runs it; results in out/07_collisions.
#include "program.hpp"

int main(int argc, char** argv) {
    return nutshell::lab::program(argc, argv, "07_collisions", [](nutshell::lab::Report& report) {
        // 07_collisions: impacts and friction
        nutshell::head_on(report);
        nutshell::glancing(report);
        nutshell::pool(report);
        nutshell::bouncing(report);
        nutshell::bad_floors(report);
        nutshell::too_fast(report);
        nutshell::levers(report);
        nutshell::gaining(report);
        nutshell::friction(report);
        nutshell::cradle(report);
        nutshell::pictures(report);
        // 07a_piles: rest, stacks, piles, the universe
        nutshell::stack(report);
        nutshell::switches(report);
        nutshell::pile(report);
        nutshell::dominoes(report);
        nutshell::universe(report);
        nutshell::rest_diagrams(report);
        nutshell::rest_pictures(report);
        // 07b_arch: a side road, convex pieces
        nutshell::arch(report);
    });
}
