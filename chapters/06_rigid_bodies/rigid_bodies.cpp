// Chapter 6 · Rigid bodies.  ./course run 6  runs it; results in out/06_rigid_bodies.
#include "program.hpp"

int main(int argc, char** argv) {
    return nutshell::lab::program(argc, argv, "06_rigid_bodies",
                                  [](nutshell::lab::Report& report) {
                                      // 6: torque, inertia, assembling
                                      nutshell::diagrams(report);
                                      nutshell::levers(report);
                                      nutshell::pendulum(report);
                                      nutshell::assembly(report);
                                      nutshell::ladder(report);
                                      // 6A: free bodies and tops
                                      nutshell::free_bodies(report);
                                      nutshell::free_study(report);
                                      nutshell::heavy_tops(report);
                                      nutshell::thrown(report);
                                      nutshell::many_bodies(report);
                                      nutshell::top_pictures(report);
                                      // both
                                      nutshell::pictures(report);
                                  });
}
