// The parts a chart is made of; used by chart*.cpp only. Lengths are units of the picture, y downwards.
#pragma once
#include <nutshell/chart/chart.hpp>
#include <nutshell/chart/style.hpp>

#include <string_view>

namespace nutshell::chart::parts {

struct Point {
    double x = 0, y = 0;
};

struct Box {
    double left = 0, top = 0, right = 0, bottom = 0;
    double width() const { return right - left; }
    double height() const { return bottom - top; }
    Box wider(double by) const { return {left - by, top - by, right + by, bottom + by}; }
};

using Line = std::vector<Point>;

/// Width of the narrow layout, in units: on a screen of 360 px a unit is 0.85 px there. What is no wider than
/// this is laid out for a phone: names in a key below the plot, or above their bars.
inline constexpr int narrow_width = 380;
inline bool is_narrow(const Chart& chart) {
    return chart.width <= narrow_width;
}

// --- text (chart_text.cpp)
inline constexpr double heading_size = 20, text_size = 16, tick_size = 15, note_size = 15, line_height = 20;

/// Width of text set in bold Lato: an upper bound for the regular weight, and for the fonts named after it
/// nearly so.
double text_width(std::string_view utf8, double size);
std::vector<std::string> wrapped(std::string_view utf8, double size, double width);
/// As few lines as `wrapped`, of lengths as equal as they can be.
std::vector<std::string> balanced(std::string_view utf8, double size, double width);
std::string escaped(std::string_view text);
std::string unit(double length);                          ///< at most one decimal
std::string decimal(double value, int decimals);          ///< a real minus, thin spaces between thousands
std::string spoken(double value);                         ///< four digits, for tooltips
std::string power_of_ten(double mantissa, int exponent);  ///< as SVG
double width_of_markup(std::string_view markup, double size);

// --- axes (chart_axes.cpp)
struct Range {
    double from = 0, to = 1;
};

/// True for what an axis of this scale can show: finite, positive if logarithmic, within 1e300 so that no sum
/// overflows.
bool can_show(Scale scale, double value);

/// Takes a value to its place: a linear or logarithmic scale whose `from` lies at `low` and `to` at `high`.
struct Ruler {
    Scale scale = Scale::linear;
    Range range;
    double low = 0, high = 1;
    bool takes(double value) const;  ///< can_show on its scale
    bool shows(double value) const;  ///< and between the ends
    double operator()(double value) const;
};

struct Tick {
    double value;
    std::string markup;
};

struct Frame {
    Box plot;
    Ruler x, y;
    Point operator()(double u, double v) const { return {x(u), y(v)}; }
};

Range range_of_x(const Chart& chart);
Range range_of_y(const Chart& chart);
/// Ticks at round values, such that their labels stay apart: `along` the axis' length, `horizontal` for x.
std::vector<Tick> ticks(Scale scale, Range range, double along, bool horizontal);
std::string draw_grid(const Chart& chart, const Frame& frame);
/// The name of x below its ticks; `bottom` receives where the picture ends.
std::string draw_x_name(const Chart& chart, const Box& plot, double width, double& bottom);
bool is_plane(const Chart& chart);  ///< both axes in the same unit of length

// --- geometry and labels (chart_labels.cpp)
/// The part of a segment inside a box, if any (Liang-Barsky).
std::optional<std::pair<Point, Point>> clipped(Point a, Point b, const Box& box);
/// Drops points that lie within `tolerance` of the line without them (Ramer-Douglas-Peucker).
Line simplified(const Line& line, double tolerance);

/// What text must not be written over.
struct Obstacles {
    std::vector<Line> lines;
    std::vector<Box> boxes;
    double clutter(const Box& box) const;  ///< length of line in the box, and a lot for other text
};
/// The candidate with the least clutter, the first of equals.
std::size_t freest(const std::vector<Box>& candidates, const Obstacles& obstacles);

/// A name in the right margin, tied to a point of its curve.
struct Label {
    std::size_t owner = 0;
    std::vector<std::string> lines = {};
    Point anchor = {};
    std::string css_class = "label";
    double middle = 0;  ///< where it was put
    double height() const { return line_height * static_cast<double>(lines.size()); }
};
/// The point of a curve with the greatest x; where another curve is close to it, rather a free one not far to
/// its left.
Point free_end(const std::vector<Line>& own, const std::vector<Line>& others, Point otherwise);
/// Puts labels as near to their anchors as they can be without overlapping, between top and bottom, and so
/// that no two hairlines cross.
void arrange(std::vector<Label>& labels, double hairline_end, double top, double bottom);
std::string draw_label(const Label& label, double x);
std::string draw_text(const std::string& css_class, double x, double y, std::string_view text,
                      const char* anchor = "start");

// --- series (chart_series.cpp)
enum class Side {
    inside,
    top,
    bottom,
    left,
    right,
    beyond
};  ///< beyond: outside of x, where the caller looks away

struct Arrow {
    Side side;
    Point at;
    std::size_t first, count;
};

/// A series as it will be drawn.
struct Trace {
    Style style;
    Draw draw;
    std::vector<Line> lines;
    std::vector<std::pair<Point, std::size_t>> marks;  ///< and the index of their data
    std::vector<Arrow> arrows;
    Point anchor;  ///< its right end
    bool quiet = false;
};
std::vector<Style> styles_of(const Chart& chart);
Trace trace(const Chart& chart, const Series& series, const Style& style, const Frame& frame);
std::string draw_series(const Chart& chart, const Series& series, const Trace& trace);
/// The group of one series; a name makes it a stop of the keyboard, which shows it alone as the mouse does.
std::string open_group(const Style& style, const char* css_class, const std::string& name = {});
std::string path(const std::vector<Line>& lines, bool closed = false);
std::string draw_mark(const Style& style, Point at, const std::string& title);

// --- regions (chart_regions.cpp)
struct Contour {
    Style style;
    std::vector<Line> fill,
        outline;  ///< the outline leaves out what only closes the fill at the grid's border
    Point anchor;
};
Contour contour(const Region& region, const Style& style, const Frame& frame);
std::string draw_region(const Region& region, const Contour& contour);
/// A free place inside a region for its name: in no smaller region, over no line. None if there is none.
std::optional<Box> place_inside(const Chart& chart, std::size_t region, const Frame& frame,
                                const Obstacles& obstacles);

// --- levels, guides, rings (chart_notes.cpp)
inline constexpr double ring_radius = 10.5;
/// A level on y and, if there is a free place on its line, where its reason is written.
struct Note {
    std::vector<std::string> lines;
    Box box;
};
std::vector<Level> levels_on_y(const Chart& chart);  ///< with the tolerance
std::optional<Note> place_on_level(const Level& level, const Frame& frame, const Obstacles& obstacles);
std::string draw_level_line(const Level& level, const Frame& frame, bool on_y);
std::string draw_levels_on_x(const Chart& chart, const Frame& frame, Obstacles& obstacles);
std::string draw_note(const Note& note);
std::vector<Ring> rings_of(const Chart& chart);  ///< with the cheapest method's
std::string draw_guides(const Chart& chart, const Frame& frame, Obstacles& obstacles);
std::string draw_rings(const Chart& chart, const Frame& frame, Obstacles& obstacles);

// --- bars (chart_bars.cpp)
/// `width` may grow; `height` receives the picture's.
std::string draw_bars(const Chart& chart, double& width, double& height, double top);

// --- the key of narrow layouts (chart_key.cpp)
/// A row of the key: how a thing is drawn, and its name.
struct KeyEntry {
    std::size_t owner = 0;  ///< as of a Label
    std::string sample;     ///< drawn in 30 x 20 units
    std::string text;
    std::string css_class;
    Point at = {};                        ///< left top of its place
    std::vector<std::string> lines = {};  ///< of its text
};
/// Puts entries into rows from `top`, between the chart's borders. @return the bottom
double arrange_key(std::vector<KeyEntry>& entries, double width, double top);
std::string draw_key(const KeyEntry& entry);

// --- the whole (chart_plot.cpp, chart_document.cpp, chart.cpp)
inline constexpr double border = 16;  ///< free on all sides
/// One arrangement of a picture.
struct Layout {
    double width = 0, height = 0;
    std::string body = {};
};
/// Title and subtitle; `panel` makes them smaller. `bottom` receives where they end.
std::string draw_heading(const std::string& title, const std::string& subtitle, double width, bool panel,
                         double& bottom);
/// The whole of a chart without bars, below `top`.
std::string draw_plot(const Chart& chart, double top, double& height);
Layout layout_of(const Chart& chart, bool panel);
/// The names of quiet series in a sentence of their own; empty without any.
std::string quiet_names(const std::vector<Chart>& charts);
std::string summary(const Chart& chart);  ///< what a reader who does not see the chart is told
/// The SVG round its two layouts: root, title and description, style sheet, paper.
std::string document(const std::string& name, const std::string& title, const std::string& told,
                     const Layout& wide, const Layout& narrow);
/// Keeps a chart's points and compares it, where that is asked for; see beside.hpp. (beside.cpp)
void compare(Chart& chart, const std::string& name, std::string& subtitle);
/// Throws what svg() promises to throw. (chart_check.cpp)
void check(const Chart& chart);
void check(const Ranking& ranking);
[[noreturn]] void refuse(const Chart& chart, const std::string& what);
[[noreturn]] void refuse(const std::string& name, const std::string& what);

}  // namespace nutshell::chart::parts
