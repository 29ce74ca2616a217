// What `run --mine` must make anew after an answer has changed: the parts of the chapter's program that ran
// the changed bodies last time, and the files of it that hold their code.
#pragma once
#include <filesystem>
#include <string>
#include <vector>
#include "rooms.hpp"

namespace nutshell::judge {

/// A line for the start of a body: it notes that the body ran (nutshell/lab/touched.hpp).
std::string touch_line(Number number);

struct Anew {
    bool all = true;                          ///< nothing is known, or more than bodies has changed
    std::vector<std::string> parts, sources;  ///< else: these
};
/// Compares the headers in mine/ with those of the last run whose results went to `out`.
Anew anew_for(const Rooms& rooms, const Chapter& chapter, const std::filesystem::path& out);

/// Where the program writes what its parts ran, and after it has come to its end: keeps that and the headers.
std::filesystem::path touched_file(const Chapter& chapter);
void remember(const Rooms& rooms, const Chapter& chapter, const std::filesystem::path& out, const Anew& made);
void forget(const Chapter& chapter);

/// Compiles only these sources of mine_NN_name, and links them before the others: a function that several
/// files hold is then the new one. @return false if that cannot be done or fails
bool build_sources(const std::string& target, const std::vector<std::string>& sources);

}  // namespace nutshell::judge
