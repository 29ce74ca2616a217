// How learners' code is compiled: the compiler, with the build's own flags and folders, and Eigen compiled
// beforehand.
#pragma once
#include <filesystem>
#include <string>
#include <vector>
#include "rooms.hpp"

namespace nutshell::judge {

/// The build's own flags, and the folders that no chapter owns.
std::vector<std::string> build_flags(const Rooms& rooms);

/// How all of a sheet is compiled: the compiler, the build's own flags, and the sheet's.
std::vector<std::string> compiler_words(const Rooms& rooms, bool optimised);
/// Makes the header that is compiled beforehand if it is missing or out of date. @return the words that have
/// it read
std::vector<std::string> precompiled(const Rooms& rooms, bool optimised);

}  // namespace nutshell::judge
