// Charts: fill in a Chart, get one self-contained SVG: no script, light and dark, wide and narrow (a
// phone's), same bytes every run.
//
//     Chart chart;
//     chart.title = "Which method gives the most accuracy for the work?";
//     chart.subtitle = "Planet, e = 0.6, one orbit. Down and left is better.";
//     chart.x = {"force evaluations", Scale::logarithmic};
//     chart.y = {"largest position error [m]", Scale::logarithmic};
//     chart.series.push_back(series_of(methods::euler));     // a method's name and look
//     chart.series.back().add(euler_cost, euler_error);
//     chart.tolerance = {1e-3, "1 mm: a pixel at 2 m"};
//     chart.guides = {-1, -2, -4};
//     chart.ring_cheapest = true;
//     write_svg(chart, "out/01_newton/planet.svg");
//
// Other kinds: a time series (leave the scales linear), an orbit (equal_aspect, Draw::ghost for the exact
// one), regions of a plane (`regions`, with Draw::theory over them), and `bars` for costs against the
// machine's floor.
#pragma once
#include <filesystem>
#include <limits>
#include <nutshell/look.hpp>
#include <optional>
#include <string>
#include <vector>

namespace nutshell::chart {

enum class Scale { linear, logarithmic };

inline constexpr double automatic = std::numeric_limits<double>::quiet_NaN();

struct Axis {
    std::string name = {};  ///< in words, with the unit: "largest position error [m]"
    Scale scale = Scale::linear;
    double from = automatic, to = automatic;  ///< ends of the axis; automatic = from the data
};

enum class Draw {
    as_suits,  ///< line and marks up to 40 points, a line beyond; ghost if the look's family is exact
    line_and_marks,
    line,
    marks,
    ghost,  ///< a broad pale line under the others: what they should have been
    theory  ///< a thin dashed line of ink over the others: what a formula says
};

/// A curve. A point that is not finite breaks the line. A point that the chart cannot show (not finite, not
/// positive on a logarithmic axis, beyond the axis' ends) becomes an arrow at the border, with how many and
/// the first in its tooltip.
struct Series {
    std::string name = {};  ///< written beside its right end; empty = not written
    std::vector<double> x = {}, y = {};
    Draw draw = Draw::as_suits;
    std::vector<std::string> notes = {};  ///< for the tooltips, one a point: "dt = 1/60 s"
    std::optional<Look> look = {};        ///< of the method it is; none = no method: the next plain style
    bool like_last = false;               ///< in the colours of the series before it: its floor, its theory
    bool quiet = false;  ///< thin and grey, without marks and label: named in a line below the chart

    void add(double at, double value) { x.push_back(at), y.push_back(value); }
};

/// The curve of a method, in its look. @tparam Method  has name and look
template <class Method>
Series series_of(const Method& method, Draw draw = Draw::as_suits) {
    Series series{method.name, {}, {}, draw};
    series.look = method.look;
    return series;
}

/// A value on an axis with a meaning: drawn as a thin line across the chart, its reason written on it.
struct Level {
    double value = 0;
    std::string reason = {};
};

/// A circle round one point, with a word beside it.
struct Ring {
    double x = 0, y = 0;
    std::string text = {};
};

/// The part of a plane where a function, given on a grid, is <= 0: for instance |R(z)| - 1 over z = lambda
/// dt.
struct Region {
    std::string name = {};
    double left = 0, right = 0, bottom = 0, top = 0;  ///< the grid's first and last columns and rows
    int columns = 0, rows = 0;
    std::vector<double> values =
        {};                         ///< row by row from the bottom, each from the left; not finite = outside
    std::optional<Look> look = {};  ///< as of a Series
};

/// One row of a bar chart: a bar from zero on a linear axis, a dot on a logarithmic one.
struct Bar {
    std::string name = {};
    double value = 0;
    double floor =
        automatic;          ///< the least the machine could do: a tick; the ratio is written at the bar's end
    std::string text = {};  ///< at the bar's end; empty = the value and its ratio to the floor
    std::optional<Look> look = {};
};

struct Chart {
    std::string title = {};     ///< the question, or what was found
    std::string subtitle = {};  ///< which scene; which way is better
    Axis x = {}, y = {};
    std::vector<Series> series = {};
    std::vector<Region> regions = {};
    std::vector<Bar> bars = {};           ///< alone on their chart; x is their axis
    std::optional<Level> tolerance = {};  ///< on y: what the scene needs
    std::vector<Level> levels_x = {}, levels_y = {};
    std::vector<double> guides =
        {};  ///< slopes d(log y)/d(log x) of a small fan, logarithmic axes; left out where no place is free
    std::string guide_name = "order";
    bool ring_cheapest = false;  ///< ring the point that `cheapest` finds
    std::vector<Ring> rings = {};
    bool cut = false;               ///< what lies beyond the axes' ends is left out without an arrow
    bool equal_aspect = false;      ///< one unit of x is as long as one of y; the height follows
    int width = 640, height = 440;  ///< units of the picture; the height grows where labels need it
    std::string name = {};  ///< makes the SVG's id, with a hash; write_svg takes the file's name when empty
    std::string description = {};  ///< for readers who do not see it; empty = made from the data
};

/// Several charts as one picture: side by side on a wide screen, one below the other on a phone. A panel's
/// title is its small heading; it may be empty.
struct Figure {
    std::string title = {}, subtitle = {};
    std::vector<Chart> panels = {};
    int columns = 2;
    int width = 920;
    std::string name = {}, description = {};  ///< as of a Chart
};

/// What a need costs: methods ranked by the first column, a dot for each and column on a logarithmic axis,
/// the value and its ratio to the least beside it. Who does not get there says so in words, last.
struct Ranking {
    struct Row {
        std::string name = {};
        std::optional<Look> look = {};
        std::vector<double> values = {};  ///< one a column, not negative; empty where `instead` is not
        std::string instead = {};         ///< "does not get there: still 0.3 m off with 100 000 steps"
        std::string note = {};            ///< for the tooltip: "dt = 1/60 s"
    };
    std::string title = {}, subtitle = {};
    std::vector<std::string> columns = {};  ///< what is counted, with its unit: "evaluations of the force"
    std::vector<Row> rows = {};             ///< in any order
    int width = 760;
    std::string name = {}, description = {};  ///< as of a Chart
};

/// What each look means: in groups, a line and a mark as a chart draws them, and the name.
struct Legend {
    struct Entry {
        std::string name = {};
        Look look = {};
    };
    struct Group {
        std::string name = {};  ///< "explicit, one step"
        std::vector<Entry> entries = {};
    };
    std::string title = {}, subtitle = {};
    std::vector<Group> groups = {};
    int width = 760;
    std::string name = {}, description = {};  ///< as of a Chart
};

/// The cheapest method that meets the chart's tolerance: the point with the least x whose y is at most the
/// tolerance, and so is that of every point of its series with greater x. None without a tolerance or without
/// such a point.
std::optional<Ring> cheapest(const Chart& chart);

/// The picture as text: one SVG that holds two layouts and shows the one that suits the room it has.
/// @throws std::invalid_argument that names the chart, what is wrong and what to do: nothing to draw, lists
/// of different lengths, a range that is not finite or not positive on a logarithmic axis, a grid of the
/// wrong size
std::string svg(const Chart& chart);
std::string svg(const Figure& figure);
std::string svg(const Ranking& ranking);
std::string svg(const Legend& legend);

/// Writes the picture, whole or not at all. @throws like `svg`, and std::runtime_error if the file cannot be
/// written
void write_svg(const Chart& chart, const std::filesystem::path& path);
void write_svg(const Figure& figure, const std::filesystem::path& path);
void write_svg(const Ranking& ranking, const std::filesystem::path& path);
void write_svg(const Legend& legend, const std::filesystem::path& path);

}  // namespace nutshell::chart
