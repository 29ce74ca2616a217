// What a learner cannot change of a chapter's sheets, compiled once, ahead of them.
//
// A compiler makes all that a function needs, Eigen's templates above all, whether the function is called or
// not: most of a sheet's time would go into functions that nobody asked about. So the headers are split. In
// the sheet the functions outside the exercises are declarations; their bodies come from an object file,
// which finds the exercises that it calls in the sheet. The questions are compiled ahead in the same way.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>
#include "rooms.hpp"

namespace nutshell::judge {

struct Ahead {
    std::filesystem::path bodies;     ///< object file: all that is no exercise
    std::filesystem::path for_sheet;  ///< folder: the headers of other chapters, as declarations
    std::vector<Marked> skeletons;    ///< of the chapter's own headers, declarations but for the exercises
    std::filesystem::path for_questions;  ///< folder: all of them, and the exercises too, as declarations
    std::vector<Number> templates = {};   ///< and exercises beside them: they are asked within the sheet
    std::map<Number, std::set<std::string>> reads = {};  ///< headers that an exercise's questions include

    bool can_be_asked_from_outside(const std::vector<Number>& numbers) const;
    /// Lines that include what the questions about these exercises include.
    std::string headers_for(const std::vector<Number>& numbers) const;
};

/// Makes it if it is missing or out of date. Nothing if all exercises are templates, or if it might not fit:
/// if `own`, the chapter's headers as they are to be judged, differ outside the exercises from what the
/// course gave (in more than comments and white space), or if the learner has headers beside them. A sheet
/// is then compiled as a whole.
std::optional<Ahead> ahead_of(const Rooms& rooms, const Chapter& chapter, const std::vector<Marked>& own);

}  // namespace nutshell::judge
