// Where the things of a chart go that has no bars: margins as wide as what stands in them, names beside their
// curves or, in a narrow layout without room for that, in a key below.
#include <algorithm>
#include <cmath>

#include "chart_parts.hpp"

namespace nutshell::chart::parts {
namespace {

constexpr double label_gap = 20;       // between the plot and its labels
constexpr double widest_label = 0.3;   // of the picture's width; longer names are broken
constexpr double narrow_margin = 100;  // a narrow layout gives its labels no more room than this
constexpr double axis_room = 52;       // below the plot: ticks and the axis' name
constexpr double narrow_plot = 0.58;   // height of a narrow plot, as a part of the wide picture's

/// One unit of x as long as one of y: the plot gets as high as y needs, or narrower where that would be too
/// high.
void make_equal(Frame& frame, double least_height, double most_height) {
    Range& y = frame.y.range;
    const double x_length = frame.x.range.to - frame.x.range.from;
    const double per_unit = std::min(frame.plot.width() / x_length, most_height / (y.to - y.from));
    const double height =
        std::max(per_unit * (y.to - y.from), least_height);  // too flat: more of the plane is shown
    const double middle = (y.from + y.to) / 2, half = height / per_unit / 2;
    y = {middle - half, middle + half};
    frame.plot.right = frame.plot.left + per_unit * x_length;
    frame.plot.bottom = frame.plot.top + height;
}

/// The frame of everything but bars: margins as wide as what stands in them.
Frame laid_out(const Chart& chart, double top, double right_margin, double labels_height) {
    Frame frame;
    frame.x.range = range_of_x(chart), frame.y.range = range_of_y(chart);
    frame.x.scale = chart.x.scale, frame.y.scale = chart.y.scale;
    const double wanted = is_narrow(chart) ? narrow_plot * chart.height : chart.height - top - axis_room;
    const double height = std::max(wanted, std::max(labels_height, 80.0));
    double ticks_width = 0;
    for (const Tick& tick : ticks(chart.y.scale, frame.y.range, height, false))
        ticks_width = std::max(ticks_width, width_of_markup(tick.markup, tick_size));
    frame.plot = {border + ticks_width + 8, top, chart.width - right_margin, top + height};
    // the last tick's label may hang over the plot's end
    const auto x_ticks = ticks(chart.x.scale, frame.x.range, frame.plot.width(), true);
    if (!x_ticks.empty())
        frame.plot.right = std::min(frame.plot.right,
                                    chart.width - 6 - width_of_markup(x_ticks.back().markup, tick_size) / 2);
    if (is_plane(chart))
        make_equal(frame, std::max(labels_height, 160.0), (is_narrow(chart) ? 1.1 : 0.85) * chart.width);
    frame.x.low = frame.plot.left, frame.x.high = frame.plot.right;
    frame.y.low = frame.plot.bottom, frame.y.high = frame.plot.top;
    return frame;
}

struct Margin {
    double width = border, height = 0;
    std::vector<std::vector<std::string>> lines;  // of each owner: series, then regions, then levels on y
    bool keyed = false;                           // no room beside the plot: the names go into a key below it
};

Margin margin_for(const Chart& chart, const std::vector<bool>& region_inside,
                  const std::vector<bool>& level_inside) {
    Margin margin;
    const auto add = [&](const std::string& name, bool shown, double widest) {
        margin.lines.push_back(shown ? balanced(name, text_size, widest) : std::vector<std::string>{});
        for (const std::string& line : margin.lines.back())
            margin.width = std::max(margin.width, label_gap + text_width(line, text_size) + 8);
        margin.height += line_height * static_cast<double>(margin.lines.back().size());
    };
    for (const Series& series : chart.series) add(series.name, !series.quiet, widest_label * chart.width);
    for (std::size_t i = 0; i < chart.regions.size(); ++i)
        add(chart.regions[i].name, !region_inside[i], widest_label * chart.width);
    const auto levels = levels_on_y(chart);
    const double names_width =
        std::max(margin.width - label_gap - 8, 0.2 * chart.width);  // reasons make it no wider
    for (std::size_t i = 0; i < levels.size(); ++i) add(levels[i].reason, !level_inside[i], names_width);
    if (is_narrow(chart) && margin.width > narrow_margin)
        margin.width = border, margin.height = 0, margin.keyed = true;
    return margin;
}

/// Everything drawn from data, before any text is placed.
struct Drawing {
    Frame frame;
    std::vector<Trace> traces;
    std::vector<Contour> contours;
    Obstacles obstacles;
};

Drawing drawing_of(const Chart& chart, const Frame& frame) {
    const std::vector<Style> styles = styles_of(chart);
    Drawing drawing{frame, {}, {}, {}};
    std::vector<std::vector<Line>> lines;  // of each series, then of each region
    for (const Series& series : chart.series) {
        drawing.traces.push_back(trace(chart, series, styles[lines.size()], frame));
        lines.push_back(drawing.traces.back().lines);
        for (const auto& [at, index] : drawing.traces.back().marks)
            drawing.obstacles.lines.push_back({{at.x - 5, at.y}, {at.x + 5, at.y}});
    }
    for (const Region& region : chart.regions) {
        drawing.contours.push_back(contour(region, styles[lines.size()], frame));
        lines.push_back(drawing.contours.back().fill);
    }
    for (const auto& some : lines)
        drawing.obstacles.lines.insert(drawing.obstacles.lines.end(), some.begin(), some.end());
    for (const Level& level : levels_on_y(chart)) {
        const double y = frame.y(level.value);
        drawing.obstacles.lines.push_back({{frame.plot.left, y}, {frame.plot.right, y}});
    }
    for (const Ring& ring : rings_of(chart)) {
        const Point at = frame(ring.x, ring.y);
        drawing.obstacles.boxes.push_back(
            {at.x - ring_radius, at.y - ring_radius, at.x + ring_radius, at.y + ring_radius});
    }
    if (!is_plane(chart)) return drawing;
    for (std::size_t i = 0; i < lines.size();
         ++i) {  // curves of a plane end anywhere: tie names to where they are alone
        std::vector<Line> others;
        for (std::size_t k = 0; k < lines.size(); ++k)
            if (k != i) others.insert(others.end(), lines[k].begin(), lines[k].end());
        const std::size_t series_count = drawing.traces.size();
        Point& anchor =
            i < series_count ? drawing.traces[i].anchor : drawing.contours[i - series_count].anchor;
        anchor = free_end(lines[i], others, anchor);
    }
    return drawing;
}

/// How a series is drawn, in the key.
std::string sample_of(const Trace& trace) {
    const bool ghost = trace.draw == Draw::ghost, theory = trace.draw == Draw::theory;
    std::string out;
    if (trace.draw != Draw::marks)
        out = std::string("<path class='") +
              (ghost    ? "ghost"
               : theory ? "theory"
                        : "curve") +
              "' d='M1 10L29 10'" +
              (ghost || theory || trace.style.dash.empty() ? ""
                                                           : " stroke-dasharray='" + trace.style.dash + "'") +
              "/>\n";
    return trace.marks.empty() ? out : out + draw_mark(trace.style, {15, 10}, "");
}

constexpr const char* sample_of_region =
    "<path class='area' d='M3 2H27V18H3Z'/>\n<path class='curve' d='M3 2H27V18H3Z'/>\n";
constexpr const char* sample_of_level = "<path class='level' d='M1 10L29 10'/>\n";

/// Names in the margin or the key, of one chart.
struct Names {
    std::vector<Label> labels;
    std::vector<KeyEntry> key;
    double label_x = 0;
    std::string of(std::size_t owner) const {
        for (const Label& label : labels)
            if (label.owner == owner) return draw_label(label, label_x);
        for (const KeyEntry& entry : key)
            if (entry.owner == owner) return draw_key(entry);
        return "";
    }
};

Names names_of(const Chart& chart, const Margin& margin, const Drawing& drawing) {
    const std::size_t series_count = chart.series.size(), first_level = series_count + chart.regions.size();
    const std::vector<Level> levels = levels_on_y(chart);
    const Box& plot = drawing.frame.plot;
    Names names{{}, {}, plot.right + label_gap};
    for (std::size_t i = 0; i < margin.lines.size(); ++i) {
        if (margin.lines[i].empty()) continue;
        const bool series = i < series_count, level = i >= first_level;
        const Point anchor = series  ? drawing.traces[i].anchor
                             : level ? Point{plot.right, drawing.frame.y(levels[i - first_level].value)}
                                     : drawing.contours[i - series_count].anchor;
        const char* css_class = level ? "reason" : "label";
        names.labels.push_back({i, margin.lines[i], anchor, css_class});
        if (!margin.keyed) continue;
        names.key.push_back({i,
                             series  ? sample_of(drawing.traces[i])
                             : level ? sample_of_level
                                     : sample_of_region,
                             series  ? chart.series[i].name
                             : level ? levels[i - first_level].reason
                                     : chart.regions[i - series_count].name,
                             css_class});
    }
    if (margin.keyed) {  // from the top of the plot's right side down
        const auto height_of = [&](const KeyEntry& entry) {
            for (const Label& label : names.labels)
                if (label.owner == entry.owner) return label.anchor.y;
            return 0.0;
        };
        std::stable_sort(names.key.begin(), names.key.end(),
                         [&](const KeyEntry& a, const KeyEntry& b) { return height_of(a) < height_of(b); });
        names.labels.clear();
    } else {
        arrange(names.labels, names.label_x, plot.top, plot.bottom);
    }
    return names;
}

}  // namespace

std::string draw_plot(const Chart& chart, double top, double& height) {
    const std::size_t series_count = chart.series.size(), region_count = chart.regions.size();
    const std::vector<Level> levels = levels_on_y(chart);
    std::vector<bool> region_inside(region_count, true), level_inside(levels.size(), true);
    for (;;) {  // again, with more in the margin, while a region or a level has no room for its text
        const Margin margin = margin_for(chart, region_inside, level_inside);
        Drawing drawing = drawing_of(chart, laid_out(chart, top, margin.width, margin.height));
        const Frame& frame = drawing.frame;
        Obstacles& obstacles = drawing.obstacles;
        bool all_placed = true;
        std::vector<std::optional<Box>> places(region_count);
        for (std::size_t i = 0; i < region_count; ++i) {
            if (!region_inside[i] || chart.regions[i].name.empty()) continue;
            places[i] = place_inside(chart, i, frame, obstacles);
            if (places[i])
                obstacles.boxes.push_back(*places[i]);
            else
                region_inside[i] = all_placed = false;
        }
        Names names = names_of(chart, margin, drawing);
        for (const Label& label : names.labels)
            obstacles.lines.push_back({label.anchor, {names.label_x, label.middle}});

        std::string over = draw_levels_on_x(chart, frame, obstacles);
        for (std::size_t i = 0; i < levels.size(); ++i) {
            if (!frame.y.shows(levels[i].value)) continue;
            over += draw_level_line(levels[i], frame, true);
            if (!level_inside[i] || levels[i].reason.empty()) continue;
            if (const auto note = place_on_level(levels[i], frame, obstacles)) {
                obstacles.boxes.push_back(note->box);
                over += draw_note(*note);
            } else {
                level_inside[i] = all_placed = false;
            }
        }
        if (!all_placed) continue;
        const std::string guides = draw_guides(chart, frame, obstacles);
        over += draw_rings(chart, frame, obstacles);

        std::string out = draw_grid(chart, frame) + draw_x_name(chart, frame.plot, chart.width, height);
        if (!names.key.empty()) height = arrange_key(names.key, chart.width, height) + 14;
        out += guides + "<g class='all'>\n";
        for (std::size_t i = 0; i < region_count; ++i) {
            out += open_group(drawing.contours[i].style, "series", chart.regions[i].name) +
                   draw_region(chart.regions[i], drawing.contours[i]);
            if (const auto& box = places[i])
                out += draw_text("label halo", (box->left + box->right) / 2, box->bottom - 5,
                                 chart.regions[i].name, "middle");
            out += names.of(series_count + i) + "</g>\n";
        }
        const auto layer = [](const Trace& trace) {  // quiet lines lie lowest, then ghosts, then the others
            return trace.quiet ? 0 : trace.draw == Draw::ghost ? 1 : 2;
        };
        for (const int wanted : {0, 1, 2})
            for (std::size_t i = 0; i < series_count; ++i)
                if (layer(drawing.traces[i]) == wanted)
                    out += open_group(drawing.traces[i].style, wanted == 0 ? "series quiet" : "series",
                                      chart.series[i].name) +
                           draw_series(chart, chart.series[i], drawing.traces[i]) + names.of(i) + "</g>\n";
        out += "</g>\n" + open_group(style_of(Look{Family::reference}), "levels");
        for (std::size_t i = 0; i < levels.size(); ++i) out += names.of(series_count + region_count + i);
        return out + "</g>\n" + over;
    }
}

}  // namespace nutshell::chart::parts
