// Curves: what of a series can be shown, how few points draw it, and arrows for what lies off the chart.
#include <algorithm>
#include <cmath>

#include "chart_parts.hpp"

namespace nutshell::chart::parts {
namespace {

constexpr std::size_t most_marked = 40;  // above this a series is a line without marks
constexpr double fine = 0.15;            // how far a drawn line may lie from its points

Side side_of(const Chart& chart, const Frame& frame, double x, double y) {
    if (!std::isfinite(y)) return y < 0 ? Side::bottom : Side::top;
    if (frame.y.scale == Scale::logarithmic && y <= 0) return Side::bottom;
    if (!frame.x.takes(x)) return x > 0 ? Side::right : Side::left;
    if (!frame.x.shows(x) && !chart.equal_aspect) return Side::beyond;
    if (!frame.y.shows(y)) return y > frame.y.range.to ? Side::top : Side::bottom;
    if (!frame.x.shows(x)) return x > frame.x.range.to ? Side::right : Side::left;
    return Side::inside;
}

/// Keeps first, lowest, highest and last point of each column of one unit: the line looks the same.
Line thinned(const Line& line) {
    const bool steady = std::is_sorted(line.begin(), line.end(), [](Point a, Point b) { return a.x < b.x; });
    if (!steady || line.size() <= most_marked) return line;
    Line result;
    for (std::size_t first = 0; first < line.size();) {
        std::size_t end = first, low = first, high = first;
        while (end < line.size() && std::floor(line[end].x) == std::floor(line[first].x)) {
            if (line[end].y < line[low].y) low = end;
            if (line[end].y > line[high].y) high = end;
            ++end;
        }
        std::vector<std::size_t> kept{first, low, high, end - 1};
        std::sort(kept.begin(), kept.end());
        kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
        for (const std::size_t i : kept) result.push_back(line[i]);
        first = end;
    }
    return result;
}

void add_clipped(const Line& line, const Box& plot, std::vector<Line>& pieces) {
    bool joined = false;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const auto part = clipped(line[i - 1], line[i], plot);
        if (!part) {
            joined = false;
            continue;
        }
        const auto [a, b] = *part;
        if (!joined) pieces.push_back({a});
        pieces.back().push_back(b);
        joined = b.x == line[i].x && b.y == line[i].y;
    }
}

/// Where the arrow of an off-chart point stands: where the curve leaves, else at the border nearest to the
/// point.
Point exit_point(const Frame& frame, const Series& series, std::size_t i, Side side, Point last) {
    const Box& plot = frame.plot;
    const auto takes = [&](std::size_t k) {
        return frame.x.takes(series.x[k]) && frame.y.takes(series.y[k]);
    };
    if (i > 0 && takes(i) && takes(i - 1))
        if (const auto part =
                clipped(frame(series.x[i - 1], series.y[i - 1]), frame(series.x[i], series.y[i]), plot))
            return part->second;
    Point at{frame.x.takes(series.x[i]) ? frame.x(series.x[i]) : last.x,
             frame.y.takes(series.y[i]) ? frame.y(series.y[i]) : last.y};
    if (side == Side::top) at.y = plot.top;
    if (side == Side::bottom) at.y = plot.bottom;
    if (side == Side::left) at.x = plot.left;
    if (side == Side::right) at.x = plot.right;
    return {std::clamp(at.x, plot.left, plot.right), std::clamp(at.y, plot.top, plot.bottom)};
}

std::string point_title(const Chart& chart, const Series& series, std::size_t i) {
    std::string text = series.name.empty() ? "" : series.name + ": ";
    if (i < series.notes.size() && !series.notes[i].empty()) text += series.notes[i] + "; ";
    return text + chart.x.name + " " + spoken(series.x[i]) + ", " + chart.y.name + " " + spoken(series.y[i]);
}

std::string draw_arrow(const Chart& chart, const Series& series, const Arrow& arrow) {
    static constexpr const char* turns[] = {"0", "0", "180", "270", "90", "0"};
    static constexpr const char* words[] = {"", "above", "below", "to the left", "to the right", ""};
    const auto side = static_cast<std::size_t>(arrow.side);
    const std::string title = (series.name.empty() ? "" : series.name + ": ") + std::to_string(arrow.count) +
                              (arrow.count == 1 ? " point" : " points") + " off the chart " + words[side] +
                              "; the first at " + chart.x.name + " " + spoken(series.x[arrow.first]) + ", " +
                              chart.y.name + " " + spoken(series.y[arrow.first]);
    return "<path class='arrow' d='M0 -12L7 1L0 -2L-7 1Z' transform='translate(" + unit(arrow.at.x) + ' ' +
           unit(arrow.at.y) + ") rotate(" + turns[side] + ")'><title>" + escaped(title) + "</title></path>\n";
}

}  // namespace

std::vector<Style> styles_of(const Chart& chart) {
    std::vector<Style> styles;
    int plain = 0;
    const auto add = [&](const auto& shown) {
        styles.push_back(shown.look ? style_of(*shown.look) : plain_style(plain++));
    };
    for (const Series& series : chart.series) {
        if (series.like_last && !styles.empty())
            styles.push_back(Style(styles.back()));
        else if (series.quiet)
            styles.push_back(style_of(Look{Family::peer}));
        else if (series.draw == Draw::theory && !series.look)
            styles.push_back(style_of(Look{Family::reference}));
        else
            add(series);
    }
    for (const Region& region : chart.regions) add(region);
    for (const Bar& bar : chart.bars) add(bar);
    return styles;
}

Trace trace(const Chart& chart, const Series& series, const Style& style, const Frame& frame) {
    Trace result{style, series.draw, {}, {}, {}, {frame.plot.right, frame.plot.bottom}, series.quiet};
    if (series.quiet) result.draw = Draw::line;
    if (result.draw == Draw::as_suits)
        result.draw = style.family == Family::exact    ? Draw::ghost
                      : series.x.size() <= most_marked ? Draw::line_and_marks
                                                       : Draw::line;
    const bool marks = result.draw != Draw::ghost && result.draw != Draw::theory && !series.quiet;
    Line run;
    Point last{frame.plot.left, frame.plot.bottom};
    double farthest = -INFINITY;
    const auto end_run = [&] {
        if (run.size() == 1) run.push_back(run.front());  // a lone point is a dot
        if (result.draw != Draw::marks) add_clipped(simplified(thinned(run), fine), frame.plot, result.lines);
        run.clear();
    };
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        const double x = series.x[i], y = series.y[i];
        const Side side = side_of(chart, frame, x, y);
        Point at;
        if (frame.x.takes(x) && frame.y.takes(y))
            run.push_back(at = frame(x, y));
        else
            end_run();
        if (side == Side::beyond) continue;
        if (result.draw == Draw::line) result.marks.clear();  // only where it ends
        if (side == Side::inside) {
            last = at;
            if (marks) result.marks.emplace_back(at, i);
        } else if (!chart.cut && !series.quiet) {
            const auto known = std::find_if(result.arrows.begin(), result.arrows.end(),
                                            [side](const Arrow& arrow) { return arrow.side == side; });
            if (known != result.arrows.end()) {
                ++known->count;
                continue;
            }
            at = exit_point(frame, series, i, side, last);
            result.arrows.push_back({side, at, i, 1});
        } else {
            continue;
        }
        if (at.x >= farthest) farthest = at.x, result.anchor = at;
    }
    end_run();
    return result;
}

std::string open_group(const Style& style, const char* css_class, const std::string& name) {
    const std::string stop =
        name.empty() ? "" : " tabindex='0' role='img' aria-label='" + escaped(name) + "'";
    return std::string("<g class='") + css_class + "' color='" + style.light + "' style='--d:" + style.dark +
           "'" + stop + ">\n";
}

std::string path(const std::vector<Line>& lines, bool closed) {
    std::string d;
    for (const Line& line : lines) {
        char letter = 'M';
        for (const Point& p : line) {
            d += letter + unit(p.x) + ' ' + unit(p.y);
            letter = 'L';
        }
        if (closed) d += 'Z';
    }
    return d;
}

std::string draw_mark(const Style& style, Point at, const std::string& title) {
    static constexpr const char* shapes[] = {
        "M-4.6 0a4.6 4.6 0 1 0 9.2 0a4.6 4.6 0 1 0 -9.2 0Z",  // circle
        "M-4.2 -4.2H4.2V4.2H-4.2Z",                           // square
        "M0 -5.4L5.2 3.8H-5.2Z",                              // triangle
        "M0 -6L5.4 0L0 6L-5.4 0Z",                            // diamond
        "M0 5.4L5.2 -3.8H-5.2Z",                              // triangle down
        "M0 -6.4L1.6 -2.2L6.1 -2L2.6 0.8L3.8 5.2L0 2.7L-3.8 5.2L-2.6 0.8L-6.1 -2L-1.6 -2.2Z",    // star
        "M-1.8 -5.4H1.8V-1.8H5.4V1.8H1.8V5.4H-1.8V1.8H-5.4V-1.8H-1.8Z",                          // plus
        "M-5 -2.6L-2.6 -5L0 -2.4L2.6 -5L5 -2.6L2.4 0L5 2.6L2.6 5L0 2.4L-2.6 5L-5 2.6L-2.4 0Z"};  // cross
    return std::string("<path class='") + (style.hollow ? "hollow" : "mark") + "' d='" +
           shapes[static_cast<std::size_t>(style.mark)] + "' transform='translate(" + unit(at.x) + ' ' +
           unit(at.y) + ")'" + (title.empty() ? "/>\n" : "><title>" + escaped(title) + "</title></path>\n");
}

std::string draw_series(const Chart& chart, const Series& series, const Trace& trace) {
    const bool thin =
        trace.draw == Draw::line && chart.equal_aspect;  // it passes near itself, orbit after orbit
    const bool ghost = trace.draw == Draw::ghost, theory = trace.draw == Draw::theory;
    std::string out;
    if (!trace.lines.empty()) {
        const std::string dash =
            ghost || trace.style.dash.empty() || theory ? "" : " stroke-dasharray='" + trace.style.dash + "'";
        out += std::string("<path class='") +
               (ghost    ? "ghost"
                : theory ? "theory"
                : thin   ? "curve thin"
                         : "curve") +
               "' d='" + path(trace.lines) + "'" + dash;
        out += series.name.empty() ? "/>\n" : "><title>" + escaped(series.name) + "</title></path>\n";
    }
    for (const auto& [at, index] : trace.marks)
        out += draw_mark(trace.style, at, point_title(chart, series, index));
    for (const Arrow& arrow : trace.arrows) out += draw_arrow(chart, series, arrow);
    return out;
}

}  // namespace nutshell::chart::parts
