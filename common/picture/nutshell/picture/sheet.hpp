// A picture of the book: one shot or several beside each other, for light pages and dark ones, with its words
// as text over it.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "nutshell/picture/camera.hpp"
#include "nutshell/picture/drawing.hpp"

namespace nutshell::picture {

/// What one camera sees. The drawing's title and caption are the shot's words.
struct Shot {
    Drawing drawing{};
    Camera camera{};
    Size size{};
};

/// Shots in a row; a narrow screen stacks them.
struct Sheet {
    std::vector<Shot> shots{};
    int columns = 0;  ///< 0: all in one row

    Sheet() = default;
    Sheet(Shot shot) : shots{std::move(shot)} {}
    Sheet(std::vector<Shot> some, int in_a_row = 0) : shots(std::move(some)), columns(in_a_row) {}
};

/// A sheet as files.
struct Printed {
    int width = 0, height = 0;
    std::string png{};  ///< all shots for light paper, with their words drawn in: to be looked at by itself
    std::vector<std::pair<std::string, std::string>> files{};  ///< name and bytes of the page's JPEGs
    std::string page{};  ///< HTML: those pictures with their words over them
};

/// Paints a sheet. @param stem of the page's files: STEM.1.jpg, STEM.1.dark.jpg, STEM.2.jpg ...
/// @throws NoGraphics if this machine cannot draw
/// @throws std::invalid_argument if there is no shot, and as render does
Printed print(const Sheet& sheet, const std::string& stem);

}  // namespace nutshell::picture
