// Bars: what something costs, against the least the machine could do.
#include <algorithm>
#include <cmath>

#include "chart_parts.hpp"

namespace nutshell::chart::parts {
namespace {

constexpr double row = 40, narrow_row = 52, thick = 18;  // a narrow row has its name above the bar

std::string end_text(const Bar& bar) {
    if (!bar.text.empty()) return bar.text;
    const std::string value = spoken(bar.value);
    return std::isnan(bar.floor) ? value : value + " (" + decimal(bar.value / bar.floor, 1) + "\u00d7 floor)";
}

}  // namespace

std::string draw_bars(const Chart& chart, double& width, double& height, double top) {
    const bool narrow = is_narrow(chart);
    double names = 0, ends = 0;
    std::vector<std::vector<std::string>> names_of;
    for (const Bar& bar : chart.bars) {
        names_of.push_back(narrow ? std::vector{bar.name} : balanced(bar.name, text_size, 0.3 * width));
        for (const std::string& line : names_of.back()) names = std::max(names, text_width(line, text_size));
        ends = std::max(ends, text_width(end_text(bar), note_size));
    }
    const bool floors = std::any_of(chart.bars.begin(), chart.bars.end(),
                                    [](const Bar& bar) { return !std::isnan(bar.floor); });
    Frame frame;
    frame.plot = {narrow ? border : 24 + names, top + (floors ? 30 : 8), width - ends - 24, 0};
    if (frame.plot.width() < 120) width += 120 - frame.plot.width(), frame.plot.right = frame.plot.left + 120;
    const double each = narrow ? narrow_row : row;
    frame.plot.bottom = frame.plot.top + each * static_cast<double>(chart.bars.size());
    frame.x = {chart.x.scale, range_of_x(chart), frame.plot.left, frame.plot.right};

    std::string out = draw_grid(chart, frame);
    out += draw_x_name(chart, frame.plot, width, height);
    const std::vector<Style> styles = styles_of(chart);
    const bool dots = chart.x.scale == Scale::logarithmic;
    bool floor_named = false;
    for (std::size_t i = 0; i < chart.bars.size(); ++i) {
        const Bar& bar = chart.bars[i];
        const double middle = frame.plot.top + each * (static_cast<double>(i) + 0.5) + (narrow ? 11 : 0),
                     end = frame.x(bar.value);
        const double start =
            dots ? (std::isnan(bar.floor) ? frame.plot.left : frame.x(bar.floor)) : frame.x(0);
        const std::string title = bar.name + ": " + chart.x.name + " " + spoken(bar.value);
        out += open_group(styles[i], "series", bar.name);
        if (dots) {
            out += "<path class='curve' d='" + path({{{start, middle}, {end, middle}}}) + "'/>\n";
            out += draw_mark(styles[i], {end, middle}, title);
        } else {
            out += "<rect class='bar' x='" + unit(std::min(start, end)) + "' y='" + unit(middle - thick / 2) +
                   "' width='" + unit(std::abs(end - start)) + "' height='" + unit(thick) + "'><title>" +
                   escaped(title) + "</title></rect>\n";
        }
        if (narrow) {
            out += draw_text("label", border, middle - thick / 2 - 6, bar.name);
        } else {
            double y = middle - line_height * static_cast<double>(names_of[i].size()) / 2 + 15.5;
            for (const std::string& line : names_of[i])
                out += draw_text("label", frame.plot.left - 10, y, line, "end"), y += line_height;
        }
        out += "</g>\n";
        const double right = std::isnan(bar.floor) ? end : std::max(end, frame.x(bar.floor));
        out += draw_text("note", std::max(right, start) + (dots ? 12 : 8), middle + 5.5, end_text(bar));
        if (std::isnan(bar.floor)) continue;
        const double x = frame.x(bar.floor);
        out += "<path class='floor' d='" +
               path({{{x, middle - thick / 2 - 4}, {x, middle + thick / 2 + 4}}}) + "'><title>" +
               escaped(bar.name + ": the machine's reference, " + spoken(bar.floor)) + "</title></path>\n";
        if (!floor_named) {
            const std::string words = "the machine\u2019s reference";
            const double half = text_width(words, note_size) / 2;
            out += draw_text("note", std::clamp(x, 8 + half, width - 8 - half), frame.plot.top - 6, words,
                             "middle");
        }
        floor_named = true;
    }
    return out;
}

}  // namespace nutshell::chart::parts
