// Text on pictures: set in Lato, with a halo so that it can be read on anything.
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

/// Draws one line of UTF-8 text. @param x, baseline [pixels from the top left corner]
void draw_text(Image& image, double x, double baseline, const std::string& text, double height, Weight weight,
               const Colour& ink, const Colour& halo = palette::paper);

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

/// Draws the words near their anchors, inside the picture and off each other where there is room.
void draw_anchored(Image& image, const std::vector<AnchoredWords>& all, double height,
                   std::vector<Taken> taken);

/// All words of a drawing: title, caption, how long a square of the grid is, labels of points and arrows.
void write_words(Image& image, const Drawing& drawing, const Camera& camera, Size size);

}  // namespace nutshell::picture
