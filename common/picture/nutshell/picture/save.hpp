// How a picture is saved with its note.
#pragma once
#include <filesystem>
#include <functional>
#include <nutshell/require.hpp>

#include "nutshell/picture/image.hpp"
#include "nutshell/picture/sheet.hpp"

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
    std::string states{};                ///< of a moving figure: what its page can put it into
};

/// The note of one run: the names are the scene's and the method's. @param dt  [s]
template <class Scene, class Method>
Note note_of(const std::string& command, const Scene& scene, const Method& method, double dt,
             std::vector<NotedNumber> numbers = {}) {
    return {command, scene.name, method.name, digits(dt) + " s", std::move(numbers)};
}

/// Writes `file` (a .png) and its note, the same name ending in .txt; each appears whole or not at all.
/// @throws std::runtime_error naming the file if it cannot be written
void save(const Image& image, const std::filesystem::path& file, const Note& note);

/// Draws and saves a picture of the book: `file` with its words drawn in, to be looked at by itself, its
/// note, and for the page NAME.page.html with its JPEGs. Where this machine cannot draw, as below.
/// @returns whether the picture was drawn
/// @throws std::runtime_error naming the file if it cannot be written
bool save(const std::filesystem::path& file, const Note& note, const std::function<Sheet()>& draw);

/// Draws and saves; where this machine cannot draw, the note alone is written, with the line
/// `not drawn: REASON`, an older picture of that name is removed, and the program goes on.
/// @returns whether the picture was drawn
/// @throws std::runtime_error naming the file if it cannot be written
bool save(const std::filesystem::path& file, const Note& note, const std::function<Image()>& draw);

}  // namespace nutshell::picture
