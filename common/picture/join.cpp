// Pictures joined into one.
#include <algorithm>
#include <stdexcept>

#include "words.hpp"

namespace nutshell::picture {

namespace {

void copy(const Image& from, Image& to, int left, int top) {
    for (int y = 0; y < from.height; ++y) {
        const std::size_t start = 3 * (std::size_t(top + y) * std::size_t(to.width) + std::size_t(left));
        std::copy_n(from.pixel(0, y), 3 * std::size_t(from.width), to.rgb.begin() + std::ptrdiff_t(start));
    }
}

Image blank(int width, int height) {
    return {width, height, std::vector<std::uint8_t>(3 * std::size_t(width) * std::size_t(height), 255)};
}

/// Cells of one row or several, each `width` wide, with white gaps between.
Image join(const std::vector<Image>& cells, const std::vector<std::string>& words, int columns) {
    const int gap = 6, rows = (int(cells.size()) + columns - 1) / columns;
    const int width = cells.front().width, height = cells.front().height;
    Image out = blank(columns * width + (columns - 1) * gap, rows * height + (rows - 1) * gap);
    const double letters = std::clamp(0.05 * width, 15.0, 27.0);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const int left = (int(i) % columns) * (width + gap), top = (int(i) / columns) * (height + gap);
        copy(cells[i], out, left, top);
        Line line{.text = words[i], .left = left + 0.7 * letters, .baseline = top + 1.4 * letters};
        line.height = letters;
        write_words(out, {line}, Theme::light);
    }
    return out;
}

void check_image(const Image& image) {
    const bool good = image.width > 0 && image.height > 0 &&
                      image.rgb.size() == 3 * std::size_t(image.width) * std::size_t(image.height);
    if (!good)
        throw std::invalid_argument("picture: an image to be joined is empty or not width x height pixels");
}

}  // namespace

Image side_by_side(const Image& left, const Image& right, const std::string& left_words,
                   const std::string& right_words) {
    return filmstrip({left, right}, {left_words, right_words}, 2);
}

Image filmstrip(const std::vector<Image>& instants, const std::vector<std::string>& words, int columns) {
    if (instants.empty()) throw std::invalid_argument("picture: a filmstrip needs at least one image");
    if (columns < 1) throw std::invalid_argument("picture: a filmstrip needs at least one column");
    if (words.size() != instants.size()) {
        throw std::invalid_argument("picture: a filmstrip of " + std::to_string(instants.size()) +
                                    " images has " + std::to_string(words.size()) + " words");
    }
    for (const Image& image : instants) {
        check_image(image);
        if (image.width != instants.front().width || image.height != instants.front().height) {
            throw std::invalid_argument("picture: images to be joined differ in size");
        }
    }
    return join(instants, words, std::min(columns, int(instants.size())));
}

}  // namespace nutshell::picture
