// Words on pictures: where they stand, and their letters. A page shows them as text over the picture; a
// picture that stands alone has them drawn in.
#pragma once
#include <string>
#include <vector>

#include "nutshell/picture/camera.hpp"
#include "nutshell/picture/colour.hpp"
#include "nutshell/picture/drawing.hpp"
#include "nutshell/picture/image.hpp"

namespace nutshell::picture {

enum class Weight { regular, bold };

/// @param height of the letters' line [pixels]
double text_width(const std::string& text, double height, Weight weight);

/// One line of words where it stands on a picture [pixels from the top left corner].
struct Line {
    enum class Part { title, caption, grid, label } part = Part::label;
    std::string text{};  ///< UTF-8
    double left = 0, right = 0, baseline = 0, height = 20;
    Weight weight = Weight::bold;
    Colour ink = palette::ink;
    bool ends = false;  ///< it stands left of what it names: its right end is the one that counts
};

/// All words of a drawing: title, caption, how long a square of the grid is, labels of points and arrows.
std::vector<Line> place_words(const Drawing& drawing, const Camera& camera, Size size);

/// Words that want to stand at a point of the picture, preferably on one side of it.
struct AnchoredWords {
    double x = 0, y = 0;                 ///< the anchor [pixels]
    double toward_x = 1, toward_y = -1;  ///< the preferred side
    std::string text;
    Colour ink;
};

/// A rectangle of the picture that is taken, and how bad it is to cover it.
struct Taken {
    double left, top, right, bottom;
    double weight = 1;
};

/// Places the words near their anchors, inside the picture and off each other where there is room.
std::vector<Line> place_anchored(Size size, const std::vector<AnchoredWords>& all, double height,
                                 std::vector<Taken> taken);

/// Draws the lines in Lato, with a halo so that they can be read on anything.
void write_words(Image& image, const std::vector<Line>& lines, Theme theme);

}  // namespace nutshell::picture
