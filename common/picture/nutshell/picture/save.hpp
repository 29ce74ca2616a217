// How a picture is saved with its note.
#pragma once
#include <filesystem>
#include <functional>

#include "nutshell/picture/image.hpp"

namespace nutshell::picture {

/// A number worth writing beside a picture.
struct NotedNumber {
    std::string name{};
    double value = 0;
    std::string unit{};
};

/// What is written beside each picture, so that it can be made again.
struct Note {
    std::string command{};  ///< that makes this picture
    std::string scene{};
    std::string method{};
    std::string dt{};                    ///< the step with its unit, e.g. "0.1 s"
    std::vector<NotedNumber> numbers{};  ///< final numbers
};

/// Writes `file` (a .png) and its note, the same name ending in .txt; each appears whole or not at all.
/// @throws std::runtime_error naming the file if it cannot be written
void save(const Image& image, const std::filesystem::path& file, const Note& note);

/// Draws and saves; where this machine cannot draw, the note alone is written, with the line
/// `not drawn: REASON`, an older picture of that name is removed, and the program goes on.
/// @returns whether the picture was drawn
/// @throws std::runtime_error naming the file if it cannot be written
bool save(const std::filesystem::path& file, const Note& note, const std::function<Image()>& draw);

}  // namespace nutshell::picture
