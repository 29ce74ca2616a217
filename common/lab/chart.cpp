// A chart from data to SVG: checks at the door, where things go, and the document round the drawing.
#include <nutshell/lab/output.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "chart_parts.hpp"

namespace nutshell::lab {
namespace parts {
namespace {

constexpr double border = 16;         // free on all sides
constexpr double label_gap = 16;      // between the plot and its labels
constexpr double widest_label = 0.3;  // of the picture's width; longer names are broken
constexpr double axis_room = 52;      // below the plot: ticks and the axis' name

std::string number_of(std::size_t n) {
    return std::to_string(n);
}

void check_axis(const Chart& chart, const Axis& axis, const char* which) {
    const auto refuse_axis = [&](const std::string& what) {
        refuse(chart, std::string("axis ") + which + " " + what);
    };
    for (const double end : {axis.from, axis.to}) {
        if (std::isinf(end)) refuse_axis("ends at infinity; give a finite end, or leave it automatic");
        if (axis.scale == Scale::logarithmic && end <= 0)
            refuse_axis("is logarithmic and ends at " + spoken(end) + "; give an end above zero");
    }
    if (axis.from >= axis.to)
        refuse_axis("goes from " + spoken(axis.from) + " to " + spoken(axis.to) + "; give from < to");
}

void check_level(const Chart& chart, const Axis& axis, double value, const std::string& what) {
    if (!std::isfinite(value) || (axis.scale == Scale::logarithmic && value <= 0))
        refuse(chart, what + " is " + spoken(value) + ", which axis \"" + axis.name +
                          "\" cannot show; give a finite value, above zero on a logarithmic axis");
}

void check_region(const Chart& chart, const Region& region) {
    const std::string name = "region \"" + region.name + "\" ";
    if (region.columns < 2 || region.rows < 2) refuse(chart, name + "needs a grid of at least 2 by 2");
    const auto wanted = static_cast<std::size_t>(region.columns) * static_cast<std::size_t>(region.rows);
    if (region.values.size() != wanted)
        refuse(chart, name + "has " + number_of(region.values.size()) + " values for a grid of " +
                          number_of(wanted));
    if (!(region.left < region.right && region.bottom < region.top) ||
        !std::isfinite(region.right - region.left) || !std::isfinite(region.top - region.bottom))
        refuse(chart, name + "needs finite left < right and bottom < top");
}

void check(const Chart& chart) {
    if (chart.title.empty()) refuse(chart, "has no title; give it the question or the finding");
    if (chart.width < 200 || chart.height < 150) refuse(chart, "is too small; give at least 200 by 150");
    check_axis(chart, chart.x, "x"), check_axis(chart, chart.y, "y");
    if (chart.series.empty() && chart.regions.empty() && chart.bars.empty())
        refuse(chart, "has nothing to draw; give it series, regions or bars");
    if (!chart.bars.empty() && !(chart.series.empty() && chart.regions.empty()))
        refuse(chart, "has bars and something else; draw two charts");
    if ((!chart.regions.empty() || chart.equal_aspect) &&
        (chart.x.scale == Scale::logarithmic || chart.y.scale == Scale::logarithmic))
        refuse(chart, "shows a plane (regions or equal_aspect) on a logarithmic axis; make both axes linear");
    if (!chart.guides.empty() && (chart.x.scale != Scale::logarithmic || chart.y.scale != Scale::logarithmic))
        refuse(chart,
               "has slope guides but not two logarithmic axes; make both logarithmic or drop the guides");
    for (const Series& s : chart.series) {
        const std::string name = "series \"" + s.name + "\" has ";
        if (s.x.size() != s.y.size())
            refuse(chart, name + number_of(s.x.size()) + " values of x and " + number_of(s.y.size()) +
                              " of y; give as many of each");
        if (s.x.empty()) refuse(chart, name + "no points; give it data or leave it out");
        if (!s.notes.empty() && s.notes.size() != s.x.size())
            refuse(chart, name + number_of(s.notes.size()) + " notes for " + number_of(s.x.size()) +
                              " points; give one each or none");
    }
    for (const Region& region : chart.regions) check_region(chart, region);
    for (const Bar& bar : chart.bars) {
        check_level(chart, chart.x, bar.value, "bar \"" + bar.name + "\"");
        if (!std::isnan(bar.floor))
            check_level(chart, chart.x, bar.floor, "the floor of bar \"" + bar.name + "\"");
    }
    for (const double slope : chart.guides)
        if (!std::isfinite(slope)) refuse(chart, "has a slope guide that is not finite");
    for (const Level& level : chart.levels_x)
        check_level(chart, chart.x, level.value, "level \"" + level.reason + "\"");
    for (const Level& level : chart.levels_y)
        check_level(chart, chart.y, level.value, "level \"" + level.reason + "\"");
    if (chart.tolerance) check_level(chart, chart.y, chart.tolerance->value, "the tolerance");
    for (const Ring& ring : chart.rings) {
        check_level(chart, chart.x, ring.x, "ring \"" + ring.text + "\"");
        check_level(chart, chart.y, ring.y, "ring \"" + ring.text + "\"");
    }
}

std::string draw_heading(const Chart& chart, double width, double& bottom) {
    std::string out;
    double y = 12;
    for (const std::string& line : wrapped(chart.title, heading_size, width - 2 * border))
        out += draw_text("title", border, y += 24, line);
    y += 2;
    for (const std::string& line : wrapped(chart.subtitle, text_size, width - 2 * border))
        out += draw_text("sub", border, y += 21, line);
    if (chart.bars.empty() && !chart.y.name.empty()) out += draw_text("name", border, y += 32, chart.y.name);
    bottom = y + 12;
    return out;
}

/// One unit of x as long as one of y: sets the plot's height, and widens a range where that would be too tall
/// or flat.
void make_equal(Frame& frame, double top, double width) {
    const double tallest = 1.05 * width, flattest = 160;
    Range &x = frame.x.range, &y = frame.y.range;
    const auto widen = [](Range& range, double length) {
        const double middle = (range.from + range.to) / 2;
        range = {middle - length / 2, middle + length / 2};
    };
    double per_unit = frame.plot.width() / (x.to - x.from);
    if (per_unit * (y.to - y.from) > tallest) {
        per_unit = tallest / (y.to - y.from);
        widen(x, frame.plot.width() / per_unit);
    }
    if (per_unit * (y.to - y.from) < flattest) widen(y, flattest / per_unit);
    frame.plot.bottom = top + per_unit * (y.to - y.from);
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
    if (chart.equal_aspect || !chart.regions.empty()) make_equal(frame, top, chart.width);
    frame.plot.bottom = std::max(frame.plot.bottom, top + labels_height);
    if (chart.equal_aspect || !chart.regions.empty()) {  // more room for labels shows more of the plane
        const double per_unit = frame.plot.width() / (frame.x.range.to - frame.x.range.from);
        const double middle = (frame.y.range.from + frame.y.range.to) / 2,
                     half = frame.plot.height() / per_unit / 2;
        frame.y.range = {middle - half, middle + half};
    }
    frame.x.low = frame.plot.left, frame.x.high = frame.plot.right;
    frame.y.low = frame.plot.bottom, frame.y.high = frame.plot.top;
    return frame;
}

struct Margin {
    double width = border, height = 0;
    std::vector<std::vector<std::string>> lines;  // of each owner: series first, then regions
};

Margin margin_for(const Chart& chart, const std::vector<bool>& region_inside) {
    Margin margin;
    const auto add = [&](const std::string& name, bool shown) {
        margin.lines.push_back(shown ? wrapped(name, text_size, widest_label * chart.width)
                                     : std::vector<std::string>{});
        for (const std::string& line : margin.lines.back())
            margin.width = std::max(margin.width, label_gap + text_width(line, text_size) + 8);
        margin.height += line_height * static_cast<double>(margin.lines.back().size());
    };
    for (const Series& series : chart.series) add(series.name, true);
    for (std::size_t i = 0; i < chart.regions.size(); ++i) add(chart.regions[i].name, !region_inside[i]);
    return margin;
}

std::string draw_plot(const Chart& chart, double top, double& height) {
    const std::vector<Style> styles = styles_of(chart);
    const std::size_t series_count = chart.series.size(), region_count = chart.regions.size();
    std::vector<bool> inside(region_count, true);
    for (;;) {  // again with a wider margin if a region turns out to have no room for its name
        const Margin margin = margin_for(chart, inside);
        const Frame frame = laid_out(chart, top, margin.width, margin.height);
        height = frame.plot.bottom + axis_room;
        Obstacles obstacles;
        std::vector<Trace> traces;
        std::vector<Contour> contours;
        for (std::size_t i = 0; i < series_count; ++i) {
            traces.push_back(trace(chart, chart.series[i], styles[i], frame));
            for (const Line& line : traces.back().lines) obstacles.lines.push_back(line);
            for (const auto& [at, index] : traces.back().marks)
                obstacles.lines.push_back({{at.x - 5, at.y}, {at.x + 5, at.y}});
        }
        for (std::size_t i = 0; i < region_count; ++i) {
            contours.push_back(contour(chart.regions[i], styles[series_count + i], frame));
            for (const Line& line : contours.back().fill) obstacles.lines.push_back(line);
        }
        std::vector<std::optional<Box>> places(region_count);
        bool all_placed = true;
        for (std::size_t i = 0; i < region_count; ++i) {
            if (!inside[i] || chart.regions[i].name.empty()) continue;
            places[i] = place_inside(chart, i, frame, obstacles);
            if (places[i])
                obstacles.boxes.push_back(*places[i]);
            else
                inside[i] = all_placed = false;
        }
        if (!all_placed) continue;

        std::vector<Label> labels;
        for (std::size_t i = 0; i < series_count + region_count; ++i)
            if (!margin.lines[i].empty())
                labels.push_back({i, margin.lines[i],
                                  i < series_count ? traces[i].anchor : contours[i - series_count].anchor});
        const double label_x = frame.plot.right + label_gap;
        arrange(labels, label_x, frame.plot.top, frame.plot.bottom);
        for (const Label& label : labels)
            obstacles.lines.push_back({label.anchor, {frame.plot.right, label.middle}});

        const auto label_of = [&](std::size_t owner) {
            for (const Label& label : labels)
                if (label.owner == owner) return draw_label(label, label_x);
            return std::string();
        };
        std::string out = draw_grid(chart, frame);
        out += draw_text("name", (frame.plot.left + frame.plot.right) / 2, frame.plot.bottom + 42,
                         chart.x.name, "middle");
        const std::string levels = draw_levels(chart, frame, obstacles),
                          rings = draw_rings(chart, frame, obstacles);
        out += draw_guides(chart, frame, obstacles) + "<g class='all'>\n";
        for (std::size_t i = 0; i < region_count; ++i) {
            out += open_group(contours[i].style, "series") + draw_region(chart.regions[i], contours[i]);
            if (places[i])
                out += draw_text("label halo", (places[i]->left + places[i]->right) / 2,
                                 places[i]->bottom - 5, chart.regions[i].name, "middle");
            out += label_of(series_count + i) + "</g>\n";
        }
        for (const bool ghosts : {true, false})  // ghosts lie under the others
            for (std::size_t i = 0; i < series_count; ++i)
                if ((traces[i].draw == Draw::ghost) == ghosts)
                    out += open_group(styles[i], "series") + draw_series(chart, chart.series[i], traces[i]) +
                           label_of(i) + "</g>\n";
        return out + "</g>\n" + levels + rings;
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

void refuse(const Chart& chart, const std::string& what) {
    throw std::invalid_argument("chart \"" + (chart.name.empty() ? chart.title : chart.name) + "\": " + what);
}

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

}  // namespace nutshell::lab
