// Chapter 7 · Collisions.  ./course run 7  runs it; results in out/07_collisions.
#include <nutshell/lab/parts.hpp>
#include "program.hpp"

int main(int argc, char** argv) {
    using namespace nutshell;
    return lab::program(argc, argv, "07_collisions",
                        {// 07_collisions: impacts and friction
                         {"head on", head_on},
                         {"glancing", glancing},
                         {"pool", pool},
                         {"bouncing", bouncing},
                         {"bad floors", bad_floors},
                         {"too fast", too_fast},
                         {"levers", levers},
                         {"gaining", gaining},
                         {"friction", friction},
                         {"cradle", cradle},
                         {"pictures", pictures},
                         // 07a_piles: rest, stacks, piles, the universe
                         {"stack", stack},
                         {"switches", switches},
                         {"pile", pile},
                         {"pile cost", pile_cost},
                         {"dominoes", dominoes},
                         {"universe", universe},
                         {"rest diagrams", rest_diagrams},
                         {"rest pictures", rest_pictures},
                         // 07b_arch: a side road, convex pieces
                         {"arch", arch}});
}
