// A chart from data to SVG: checks at the door, where things go, and the document round the drawing.
#include <nutshell/write_file.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "chart_parts.hpp"

namespace nutshell::chart {
namespace parts {
namespace {

constexpr double border = 16;         // free on all sides
constexpr double label_gap = 20;      // between the plot and its labels
constexpr double widest_label = 0.3;  // of the picture's width; longer names are broken
constexpr double axis_room = 52;      // below the plot: ticks and the axis' name

std::string number_of(std::size_t n) {
    return std::to_string(n);
}

std::string draw_heading(const Chart& chart, double width, double& bottom) {
    std::string out;
    double y = 12;
    for (const std::string& line : wrapped(chart.title, heading_size, width - 2 * border))
        out += draw_text("title", border, y += 24, line);
    y += 2;
    for (const std::string& line : wrapped(chart.subtitle, text_size, width - 2 * border))
        out += draw_text("sub", border, y += 21, line);
    y += 10;
    if (chart.bars.empty())
        for (const std::string& line : wrapped(chart.y.name, text_size, width - 2 * border))
            out += draw_text("name", border, y += 21, line);
    bottom = y + 14;
    return out;
}

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
    const double height = std::max(chart.height - top - axis_room, std::max(labels_height, 80.0));
    double ticks_width = 0;
    for (const Tick& tick : ticks(chart.y.scale, frame.y.range, height, false))
        ticks_width = std::max(ticks_width, width_of_markup(tick.markup, tick_size));
    frame.plot = {border + ticks_width + 8, top, chart.width - right_margin, top + height};
    // the last tick's label may hang over the plot's end
    const auto x_ticks = ticks(chart.x.scale, frame.x.range, frame.plot.width(), true);
    if (!x_ticks.empty())
        frame.plot.right = std::min(frame.plot.right,
                                    chart.width - 6 - width_of_markup(x_ticks.back().markup, tick_size) / 2);
    if (is_plane(chart)) make_equal(frame, std::max(labels_height, 160.0), 0.85 * chart.width);
    frame.x.low = frame.plot.left, frame.x.high = frame.plot.right;
    frame.y.low = frame.plot.bottom, frame.y.high = frame.plot.top;
    return frame;
}

struct Margin {
    double width = border, height = 0;
    std::vector<std::vector<std::string>> lines;  // of each owner: series, then regions, then levels on y
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
    for (const Series& series : chart.series) add(series.name, true, widest_label * chart.width);
    for (std::size_t i = 0; i < chart.regions.size(); ++i)
        add(chart.regions[i].name, !region_inside[i], widest_label * chart.width);
    const auto levels = levels_on_y(chart);
    const double names_width =
        std::max(margin.width - label_gap - 8, 0.2 * chart.width);  // reasons make it no wider
    for (std::size_t i = 0; i < levels.size(); ++i) add(levels[i].reason, !level_inside[i], names_width);
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

/// The whole of a chart that has no bars. Tried again, with more in the margin, while a region or a level
/// turns out to have no room for its text.
std::string draw_plot(const Chart& chart, double top, double& height) {
    const std::size_t series_count = chart.series.size(), region_count = chart.regions.size();
    const std::size_t first_level = series_count + region_count;
    const std::vector<Level> levels = levels_on_y(chart);
    std::vector<bool> region_inside(region_count, true), level_inside(levels.size(), true);
    for (;;) {
        const Margin margin = margin_for(chart, region_inside, level_inside);
        auto [frame, traces, contours, obstacles] =
            drawing_of(chart, laid_out(chart, top, margin.width, margin.height));
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
        std::vector<Label> labels;
        for (std::size_t i = 0; i < margin.lines.size(); ++i) {
            if (margin.lines[i].empty()) continue;
            const Point anchor = i < series_count ? traces[i].anchor
                                 : i < first_level
                                     ? contours[i - series_count].anchor
                                     : Point{frame.plot.right, frame.y(levels[i - first_level].value)};
            labels.push_back({i, margin.lines[i], anchor, i < first_level ? "label" : "reason"});
        }
        const double label_x = frame.plot.right + label_gap;
        arrange(labels, label_x, frame.plot.top, frame.plot.bottom);
        for (const Label& label : labels) obstacles.lines.push_back({label.anchor, {label_x, label.middle}});

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

        const auto label_of = [&](std::size_t owner) {
            for (const Label& label : labels)
                if (label.owner == owner) return draw_label(label, label_x);
            return std::string();
        };
        std::string out = draw_grid(chart, frame) + draw_x_name(chart, frame.plot, chart.width, height);
        out += guides + "<g class='all'>\n";
        for (std::size_t i = 0; i < region_count; ++i) {
            out += open_group(contours[i].style, "series") + draw_region(chart.regions[i], contours[i]);
            if (const auto& box = places[i])
                out += draw_text("label halo", (box->left + box->right) / 2, box->bottom - 5,
                                 chart.regions[i].name, "middle");
            out += label_of(series_count + i) + "</g>\n";
        }
        for (const bool ghosts : {true, false})  // ghosts lie under the others
            for (std::size_t i = 0; i < series_count; ++i)
                if ((traces[i].draw == Draw::ghost) == ghosts)
                    out += open_group(traces[i].style, "series") +
                           draw_series(chart, chart.series[i], traces[i]) + label_of(i) + "</g>\n";
        out += "</g>\n" + open_group(style_of("theory"), "series");
        for (std::size_t i = 0; i < levels.size(); ++i) out += label_of(first_level + i);
        return out + "</g>\n" + over;
    }
}

/// What a reader who does not see the chart is told.
std::string summary(const Chart& chart) {
    if (!chart.description.empty()) return chart.description;
    std::string text = chart.subtitle.empty() ? "" : chart.subtitle + " ";
    const auto scale = [](const Axis& axis) {
        return axis.scale == Scale::logarithmic ? " (logarithmic)" : "";
    };
    if (chart.bars.empty()) text += chart.y.name + scale(chart.y) + " against ";
    text += chart.x.name + scale(chart.x) + ".";
    for (const Series& s : chart.series)
        if (!s.name.empty())
            text += " " + s.name + ": " + number_of(s.x.size()) + (s.x.size() == 1 ? " point" : " points") +
                    ", from " + spoken(s.y.front()) + " at " + spoken(s.x.front()) + " to " +
                    spoken(s.y.back()) + " at " + spoken(s.x.back()) + ".";
    for (const Region& region : chart.regions) text += " Region: " + region.name + ".";
    for (const Bar& bar : chart.bars) text += " " + bar.name + ": " + spoken(bar.value) + ".";
    if (chart.tolerance)
        text += " Tolerance " + spoken(chart.tolerance->value) + ": " + chart.tolerance->reason + ".";
    if (chart.ring_cheapest)
        if (const auto ring = cheapest(chart)) text += " " + ring->text + ", at " + spoken(ring->x) + ".";
    return text;
}

/// A name for the SVG and its style sheet: letters of the chart's name, and a hash of all it shows (FNV-1a).
std::string id_of(const Chart& chart, const std::string& body) {
    std::string id = "chart-";
    for (const char c : (chart.name.empty() ? chart.title : chart.name).substr(0, 40)) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (letter)
            id += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
        else if (id.back() != '-')
            id += '-';
    }
    if (id.back() != '-') id += '-';
    std::uint32_t hash = 2166136261U;
    for (const char c : body) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    for (int k = 0; k < 6; ++k, hash >>= 4) id += "0123456789abcdef"[hash & 15U];
    return id;
}

}  // namespace

}  // namespace parts

std::optional<Ring> cheapest(const Chart& chart) {
    if (!chart.tolerance) return std::nullopt;
    const auto meets = [&](double y) {
        return y <= chart.tolerance->value;
    };  // false for what is not a number
    std::optional<Ring> best;
    for (const Series& series : chart.series) {
        if (series.draw == Draw::ghost || series.draw == Draw::theory) continue;
        double dearest_failure = -INFINITY;
        for (std::size_t i = 0; i < series.x.size(); ++i)
            if (!meets(series.y[i])) dearest_failure = std::max(dearest_failure, series.x[i]);
        for (std::size_t i = 0; i < series.x.size(); ++i)
            if (series.x[i] > dearest_failure && (!best || series.x[i] < best->x))
                best = Ring{series.x[i], series.y[i], "cheapest: " + series.name};
    }
    return best;
}

std::string svg(const Chart& chart) {
    using namespace parts;
    check(chart);
    double width = chart.width, height = 0, top = 0;
    std::string body = draw_heading(chart, width, top);
    body += chart.bars.empty() ? draw_plot(chart, top, height) : draw_bars(chart, width, height, top);
    const std::string told = summary(chart);
    return document(chart, id_of(chart, body + told), width, height, body, told);
}

void write_svg(const Chart& chart, const std::filesystem::path& path) {
    Chart named = chart;
    if (named.name.empty()) named.name = path.stem().string();
    write_file(path, svg(named));
}

}  // namespace nutshell::chart
