// Chapter 3 · Types of forces.  ./course run 3  runs it; results in out/03_forces.
#include <nutshell/lab/parts.hpp>
#include "program.hpp"
#include "scale.hpp"

namespace nutshell {

/// The comparison with Boost.odeint is a program of its own (tests/peers), run after this one
/// where Boost is installed. Until then a note stands where its charts will be, and none of an
/// earlier run.
void announce_comparison(lab::Report& report) {
    for (const std::string scene : {"S2", "S2d", "S3", "S5"}) {
        std::filesystem::path file = report.path("odeint_" + scene + ".txt");
        write_file(file, "command: " + report.command() +
                             "\nnot drawn: the comparison with Boost.odeint was not made in "
                             "this run. It needs Boost (Debian: libboost-dev)\n");
        std::filesystem::remove(file.replace_extension(".svg"));
    }
}

}  // namespace nutshell

int main(int argc, char** argv) {
    using namespace nutshell;
    return lab::program(argc, argv, "03_forces",
                        {{"falling", falling},
                         {"springs", springs},
                         {"limits", limits},
                         {"planet again", planet_again},
                         {"model ladder", model_ladder},
                         {"diagrams", diagrams},
                         {"pictures", pictures},
                         {"announce comparison", announce_comparison},
                         {"hanging chain", hanging_chain},
                         {"net limits", net_limits},
                         {"hanging cloth", hanging_cloth},
                         {"stiff cloth", stiff_cloth},
                         {"scale", scale}});
}
