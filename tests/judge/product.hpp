// A file made by a command out of other files: made again when the command or one of the files has changed.
#pragma once
#include <filesystem>
#include <string>
#include <vector>
#include "process.hpp"

namespace nutshell::judge {

struct Product {
    std::filesystem::path file;
    std::vector<std::string> command;  ///< writes what it read to file + ".d", as make likes it
    Limits limits;

    bool is_fresh() const;
    /// @throws MachineFault if it was the machine that failed
    Ran make() const;
    /// All files it was made from; itself where that is not known.
    std::vector<std::filesystem::path> sources() const;
};

}  // namespace nutshell::judge
