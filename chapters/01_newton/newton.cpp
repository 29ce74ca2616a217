// Chapter 1 · Newton.  ./course run 1  runs it; results in out/01_newton.
#include "program.hpp"

int main(int argc, char** argv) {
    return nutshell::lab::program(argc, argv, "01_newton", [](nutshell::lab::Report& report) {
        nutshell::straight_line(report);
        nutshell::thrown_ball(report);
        nutshell::planet(report);
        nutshell::frame_rate(report);
        nutshell::game_loop(report);
        nutshell::diagrams(report);
        nutshell::pictures(report);
    });
}
