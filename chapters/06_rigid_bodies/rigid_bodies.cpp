// Chapter 6 · Rigid bodies.  ./course run 6  runs it; results in out/06_rigid_bodies.
#include <nutshell/lab/parts.hpp>
#include "program.hpp"

int main(int argc, char** argv) {
    using namespace nutshell;
    return lab::program(argc, argv, "06_rigid_bodies",
                        {// 6: torque, inertia, assembling
                         {"diagrams", diagrams},
                         {"levers", levers},
                         {"pendulum", pendulum},
                         {"assembly", assembly},
                         {"ladder", ladder},
                         // 6A: free bodies and tops
                         {"free bodies", free_bodies},
                         {"free study", free_study},
                         {"heavy tops", heavy_tops},
                         {"thrown", thrown},
                         {"many bodies", many_bodies},
                         {"top pictures", top_pictures},
                         // both
                         {"pictures", pictures}});
}
