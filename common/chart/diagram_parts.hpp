// How a diagram's things become strokes; used by diagram_*.cpp only.
#pragma once
#include <nutshell/chart/diagram.hpp>

#include "chart_parts.hpp"

namespace nutshell::chart::parts {

/// Draws with everything that text must keep away from; texts are placed when all else is known.
struct Pen {
    std::string out;
    Obstacles obstacles;
    double left, top, scale;  // where the caller's (x least, y most) goes
    Box world;

    Point operator()(Place p) const {
        return {left + (p.x - world.left) * scale, top + (world.bottom - p.y) * scale};
    }
    Line line(const std::vector<Place>& points) const {
        Line result;
        for (const Place p : points) result.push_back((*this)(p));
        return result;
    }
    void keep_off(const Line& line) { obstacles.lines.push_back(line); }
};

inline constexpr double label_room = 46;  ///< round the drawing, for labels beside it

/// All that is drawn, in the caller's coordinates (so that `top` is the least y).
Box extent_of(const Diagram& diagram);
void draw_things(Pen& pen, const Diagram& diagram);
/// Labels, each at a free place beside what it names, none beyond `width`.
void write_words(Pen& pen, const Diagram& diagram, double width);

}  // namespace nutshell::chart::parts
