// Chapter 5 · Spinning.  ./course run 5  runs it; results in out/05_spinning.
#include "program.hpp"

int main(int argc, char** argv) {
    return nutshell::lab::program(argc, argv, "05_spinning", [](nutshell::lab::Report& report) {
        nutshell::velocity(report);
        nutshell::steady_spin(report);
        nutshell::ten_turns(report);
        nutshell::engines(report);
        nutshell::coning(report);
        nutshell::wagon(report);
        nutshell::pictures(report);
    });
}
