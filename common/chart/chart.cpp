// A chart from data to SVG: checks at the door, its two layouts, and what a reader who does not see it is
// told.
#include <nutshell/write_file.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "chart_parts.hpp"

namespace nutshell::chart {
namespace parts {

std::string draw_heading(const std::string& title, const std::string& subtitle, double width, bool panel,
                         double& bottom) {
    std::string out;
    double y = panel ? 0 : 12;
    for (const std::string& line : wrapped(title, panel ? text_size : heading_size, width - 2 * border))
        out += draw_text(panel ? "panel" : "title", border, y += panel ? 21 : 24, line);
    y += 2;
    for (const std::string& line : wrapped(subtitle, text_size, width - 2 * border))
        out += draw_text("sub", border, y += 21, line);
    bottom = y + 10;
    return out;
}

Layout layout_of(const Chart& chart, bool panel) {
    Layout layout{double(chart.width), 0, {}};
    double top = 0;
    layout.body = draw_heading(chart.title, chart.subtitle, layout.width, panel, top);
    if (chart.bars.empty())
        for (const std::string& line : wrapped(chart.y.name, text_size, layout.width - 2 * border))
            layout.body += draw_text("name", border, top += 21, line);
    top += is_narrow(chart) ? 20 : 14;  // a phone's powers of ten stand higher
    layout.body += chart.bars.empty() ? draw_plot(chart, top, layout.height)
                                      : draw_bars(chart, layout.width, layout.height, top);
    if (panel) return layout;
    for (const std::string& line : wrapped(quiet_names({chart}), note_size, layout.width - 2 * border))
        layout.body += draw_text("note", border, (layout.height += line_height) - 12, line);
    return layout;
}

std::string quiet_names(const std::vector<Chart>& charts) {
    std::string names;
    for (const Chart& chart : charts)
        for (const Series& series : chart.series)
            if (series.quiet && !series.name.empty() && names.find(series.name) == std::string::npos)
                names += (names.empty() ? "" : ", ") + series.name;
    return names.empty() ? "" : "Thin and grey: " + names + ".";
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
            text += " " + s.name + ": " + std::to_string(s.x.size()) +
                    (s.x.size() == 1 ? " point" : " points") + ", from " + spoken(s.y.front()) + " at " +
                    spoken(s.x.front()) + " to " + spoken(s.y.back()) + " at " + spoken(s.x.back()) + ".";
    for (const Region& region : chart.regions) text += " Region: " + region.name + ".";
    for (const Bar& bar : chart.bars) text += " " + bar.name + ": " + spoken(bar.value) + ".";
    if (chart.tolerance)
        text += " Tolerance " + spoken(chart.tolerance->value) + ": " + chart.tolerance->reason + ".";
    if (chart.ring_cheapest)
        if (const auto ring = cheapest(chart)) text += " " + ring->text + ", at " + spoken(ring->x) + ".";
    return text;
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
    Chart narrow = chart;
    narrow.width = std::min(chart.width, narrow_width);
    return document(chart.name.empty() ? chart.title : chart.name, chart.title, summary(chart),
                    layout_of(chart, false), layout_of(narrow, false));
}

void write_svg(const Chart& chart, const std::filesystem::path& path) {
    Chart named = chart;
    if (named.name.empty()) named.name = path.stem().string();
    parts::compare(named, named.name, named.subtitle);
    write_file(path, svg(named));
}

}  // namespace nutshell::chart
