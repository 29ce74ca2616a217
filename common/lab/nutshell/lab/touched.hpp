// Which exercises' bodies each file of a program has run. `./course run N --mine` puts a line into every
// body, so that its next run makes anew only what a changed answer can change.
#pragma once
#include <array>
#include <vector>

namespace nutshell::lab {

struct Touched;
inline std::vector<Touched*>& all_touched() {
    static std::vector<Touched*> all;
    return all;
}

/// One file's bodies: that of exercise N.M has the place 32 N + M.
struct Touched {
    const char* file;
    std::array<bool, 512> bodies{};
    explicit Touched(const char* source) : file(source) { all_touched().push_back(this); }
};

static Touched touched_here{__BASE_FILE__};

}  // namespace nutshell::lab
