// Chapter 5 · Spinning.  ./course run 5  runs it; results in out/05_spinning.
#include <nutshell/lab/parts.hpp>
#include "program.hpp"

int main(int argc, char** argv) {
    using namespace nutshell;
    return lab::program(argc, argv, "05_spinning",
                        {{"velocity", velocity},
                         {"steady spin", steady_spin},
                         {"ten turns", ten_turns},
                         {"engines", engines},
                         {"coning", coning},
                         {"wagon", wagon},
                         {"pictures", pictures}});
}
