// Chapter 2 · Revised Newton.  ./course run 2  runs it; results in out/02_revised_newton.
#include <nutshell/lab/parts.hpp>
#include "program.hpp"

int main(int argc, char** argv) {
    using namespace nutshell;
    return lab::program(argc, argv, "02_revised_newton",
                        {{"momentum throw", momentum_throw},
                         {"many forces", many_forces},
                         {"leaky cart", leaky_cart},
                         {"raindrop", raindrop},
                         {"rocket", rocket},
                         {"launch", launch},
                         {"momentum books", momentum_books},
                         {"diagrams", diagrams},
                         {"pictures", pictures}});
}
