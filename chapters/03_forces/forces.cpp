// Chapter 3 · Types of forces.  ./course run 3  runs it; results in out/03_forces.
#include "program.hpp"
#include "scale.hpp"

int main(int argc, char** argv) {
    return nutshell::lab::program(argc, argv, "03_forces", [](nutshell::lab::Report& report) {
        nutshell::falling(report);
        nutshell::springs(report);
        nutshell::limits(report);
        nutshell::planet_again(report);
        nutshell::model_ladder(report);
        nutshell::pictures(report);
        nutshell::chains_and_cloths(report);
        nutshell::scale(report);
    });
}
