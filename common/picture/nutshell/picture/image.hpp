// A finished picture: its pixels, how pictures are joined, and how one is saved with its note.
#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "nutshell/picture/camera.hpp"

namespace nutshell::picture {

/// Pixels: rows from the top, three bytes (red, green, blue; sRGB) a pixel.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb{};

    const std::uint8_t* pixel(int x, int y) const {
        return &rgb[3 * (std::size_t(y) * std::size_t(width) + std::size_t(x))];
    }
};

/// This machine cannot draw; what() says which package is missing. A course goes on without the picture.
struct NoGraphics : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Two pictures of equal height side by side, each with its words at its top.
/// @throws std::invalid_argument if the heights differ
Image side_by_side(const Image& left, const Image& right, const std::string& left_words,
                   const std::string& right_words);

/// Pictures of equal size, one instant each, in rows of at most `columns`, each with its words at its top.
/// @throws std::invalid_argument if there is none, the sizes differ or there are not as many words
Image filmstrip(const std::vector<Image>& instants, const std::vector<std::string>& words, int columns = 4);

}  // namespace nutshell::picture
