// Runs another program under limits and keeps what it says.
#pragma once
#include <cstddef>
#include <string>
#include <vector>
#include "machine.hpp"

namespace nutshell::judge {

struct Limits {
    double wall_seconds;          ///< then it is killed, with all it started
    unsigned cpu_seconds = 0;     ///< 0: no limit of its own
    std::size_t memory = 0;       ///< address space [bytes]; 0: no limit
    std::size_t printed = 65536;  ///< kept of each stream [bytes]; beyond 16 times that it is killed
    std::string reply = {};       ///< given to its standard input once it has written to the pipe
    bool caged = false;           ///< it may start no process and signal none but itself
};

struct Ran {
    int exit_code = -1;  ///< -1 if a signal ended it
    int signal = 0;
    bool out_of_time = false;  ///< of either clock
    bool printed_too_much = false;
    std::string out, err;  ///< the first bytes of its streams
    std::string pipe;      ///< what it wrote to the descriptor `pipe_number`
    double seconds = 0;    ///< processor time, its children's included
};

inline constexpr int pipe_number = 3;  ///< the descriptor of the extra pipe in the program that is run

/// @param words  the program (searched in PATH) and its arguments   @throws MachineFault if it cannot be
/// started
Ran run(const std::vector<std::string>& words, const Limits& limits);

}  // namespace nutshell::judge
