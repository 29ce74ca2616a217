// Chapter 2 · Revised Newton.  ./course run 2  runs it; results in out/02_revised_newton.
#include "program.hpp"

int main(int argc, char** argv) {
    return nutshell::lab::program(argc, argv, "02_revised_newton",
                                  [](nutshell::lab::Report& report) {
                                      nutshell::momentum_throw(report);
                                      nutshell::many_forces(report);
                                      nutshell::leaky_cart(report);
                                      nutshell::raindrop(report);
                                      nutshell::rocket(report);
                                      nutshell::launch(report);
                                      nutshell::momentum_books(report);
                                      nutshell::diagrams(report);
                                      nutshell::pictures(report);
                                  });
}
