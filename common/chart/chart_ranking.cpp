// What a need costs: methods in rows, ranked, a dot for each cost, its value and its ratio to the least
// beside it.
#include <nutshell/write_file.hpp>

#include <algorithm>
#include <cmath>

#include "chart_parts.hpp"

namespace nutshell::chart {
namespace parts {
namespace {

using Row = Ranking::Row;

constexpr double row_height = 32, narrow_row = 52, lane_gap = 28, value_gap = 12;

/// Counts in full, everything else with three digits.
std::string cost_text(double value) {
    if (value == std::round(value) && value < 1e7) return decimal(value, 0);
    if (value >= 1000 && value < 1e7) {
        const double unit_of_last = std::pow(10, std::floor(std::log10(value)) - 2);
        return decimal(std::round(value / unit_of_last) * unit_of_last, 0);
    }
    const int digits = static_cast<int>(std::floor(std::log10(value)));
    return digits < -4 ? spoken(value) : decimal(value, std::max(0, 2 - digits));
}

std::string ratio_text(double ratio) {
    return decimal(ratio, ratio < 9.95 ? 1 : 0) + "\u00d7";
}

/// The value, and how many times the least it is.
std::string end_text(double value, double least, bool some_free) {
    if (value == 0) return "none";
    if (some_free && value <= least * 1.0005) return cost_text(value);
    return value <= least * 1.0005 ? cost_text(value) + ", the least"
                                   : cost_text(value) + " (" + ratio_text(value / least) + ")";
}

std::vector<Row> ranked(const Ranking& ranking) {
    std::vector<Row> rows = ranking.rows;
    std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
        if (a.values.empty() || b.values.empty()) return !a.values.empty() && b.values.empty();
        return a.values.front() < b.values.front();
    });
    return rows;
}

/// A column: where it is drawn, and from the least to the dearest value of it.
struct Lane {
    double left, right;
    Ruler ruler;
    double least;
    bool some_free;  // a cost of nothing is less than the least above zero
};

std::vector<Lane> lanes_of(const std::vector<Row>& rows, std::size_t columns, double left, double right) {
    const double width =
        (right - left - lane_gap * static_cast<double>(columns - 1)) / static_cast<double>(columns);
    std::vector<Lane> lanes;
    for (std::size_t k = 0; k < columns; ++k) {
        double least = INFINITY, most = 0, text = 0;
        const bool some_free = std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
            return !row.values.empty() && row.values[k] == 0;
        });
        for (const Row& row : rows)
            if (!row.values.empty() && row.values[k] > 0)  // a cost of nothing stands at the left end
                least = std::min(least, row.values[k]), most = std::max(most, row.values[k]);
        for (const Row& row : rows)
            if (!row.values.empty())
                text = std::max(text, text_width(end_text(row.values[k], least, some_free), note_size));
        const double start = left + static_cast<double>(k) * (width + lane_gap);
        const double room = std::max(width - text - value_gap - 6, 24.0);  // for the dots
        if (!(most > 0)) least = 1, most = 10;
        lanes.push_back(
            {start,
             start + width,
             {Scale::logarithmic, {least / 1.5, std::max(most, 1.5 * least)}, start, start + room},
             least,
             some_free});
    }
    return lanes;
}

/// A line at each power of ten of each lane that has two or more.
std::string draw_decades(const std::vector<Lane>& lanes, double top, double bottom) {
    std::string out;
    for (const Lane& lane : lanes) {
        const Range range = lane.ruler.range;
        const auto first = static_cast<int>(std::ceil(std::log10(range.from))),
                   last = static_cast<int>(std::floor(std::log10(range.to)));
        if (first == last) continue;  // one alone says nothing
        for (int e = first; e <= last; ++e) {
            const std::string x = unit(lane.ruler(std::pow(10, e)));
            out += "<line class='grid' x1='" + x + "' y1='" + unit(top) + "' x2='" + x + "' y2='" +
                   unit(bottom) + "'/>\n";
        }
    }
    return out;
}

Layout arranged(const Ranking& ranking, double width) {
    const std::vector<Row> rows = ranked(ranking);
    const bool narrow = width <= narrow_width;
    double names = 0, top = 0;
    for (const Row& row : rows) names = std::max(names, text_width(row.name, text_size) + 30);
    Layout layout{width, 0, draw_heading(ranking.title, ranking.subtitle, width, false, top)};
    const double left = narrow ? border : border + names + 14;
    const std::vector<Lane> lanes = lanes_of(rows, ranking.columns.size(), left, width - border);
    double below = top;
    for (std::size_t k = 0; k < lanes.size(); ++k) {
        double y = top + 4;
        for (const std::string& line : wrapped(ranking.columns[k], text_size, lanes[k].right - lanes[k].left))
            layout.body += draw_text("panel", lanes[k].left, y += line_height, line);
        below = std::max(below, y);
    }
    double y = below + 12;
    const std::size_t grid_at = layout.body.size();
    layout.body += "<g class='all'>\n";
    for (const Row& row : rows) {
        const Style style = row.look ? style_of(*row.look) : plain_style(0);
        const double name_at = narrow ? y + 18 : y + row_height / 2 + 5.5;
        const double middle = narrow ? y + 36 : y + row_height / 2;
        layout.body += open_group(style, "series", row.name) +
                       draw_mark(style, {border + 7, name_at - 5.5}, "") +
                       draw_text("label", border + 22, name_at, row.name);
        for (std::size_t k = 0; k < row.values.size(); ++k) {
            const Lane& lane = lanes[k];
            const Point at{row.values[k] > 0 ? lane.ruler(row.values[k]) : lane.left, middle};
            const std::string title = row.name + ": " + ranking.columns[k] + " " + spoken(row.values[k]) +
                                      (row.note.empty() ? "" : "; " + row.note);
            layout.body +=
                "<path class='stem' d='" + path({{{lane.left, middle}, at}}) + "'/>\n" +
                draw_mark(style, at, title) +
                draw_text(!lane.some_free && row.values[k] <= lane.least * 1.0005 ? "note least" : "note",
                          at.x + value_gap, middle + 5.5,
                          end_text(row.values[k], lane.least, lane.some_free));
        }
        if (row.values.empty()) {
            const double from = narrow ? border + 22 : left;
            double line_y = middle + 5.5 - line_height;
            for (const std::string& line : wrapped(row.instead, text_size, width - border - from))
                layout.body += draw_text("sub", from, line_y += line_height, line);
            y = std::max(y, line_y - (narrow ? narrow_row : row_height) + 10);
        }
        layout.body += "</g>\n";
        y += narrow ? narrow_row : row_height;
    }
    layout.body += "</g>\n";
    const std::string decades = draw_decades(lanes, below + 10, y);
    layout.body.insert(grid_at, decades);
    const std::string scale = decades.empty() ? "" : "From one grey line to the next: ten times as much.";
    for (const std::string& line : wrapped(scale, text_size, width - border - left))
        layout.body += draw_text("sub", left, y += line_height, line);
    layout.height = y + 14;
    return layout;
}

std::string told(const Ranking& ranking) {
    if (!ranking.description.empty()) return ranking.description;
    std::string text = ranking.subtitle;
    int place = 0;
    for (const Row& row : ranked(ranking)) {
        text += " " + (row.values.empty() ? row.name : std::to_string(++place) + ", " + row.name) + ": " +
                row.instead;
        for (std::size_t k = 0; k < row.values.size(); ++k)
            text += (k ? ", " : "") + ranking.columns[k] + " " + cost_text(row.values[k]);
        text += ".";
    }
    return text;
}

}  // namespace
}  // namespace parts

std::string svg(const Ranking& ranking) {
    parts::check(ranking);
    return parts::document(ranking.name.empty() ? ranking.title : ranking.name, ranking.title,
                           parts::told(ranking), parts::arranged(ranking, ranking.width),
                           parts::arranged(ranking, parts::narrow_width));
}

void write_svg(const Ranking& ranking, const std::filesystem::path& path) {
    Ranking named = ranking;
    if (named.name.empty()) named.name = path.stem().string();
    Chart none;
    parts::compare(none, named.name, named.subtitle);
    write_file(path, svg(named));
}

}  // namespace nutshell::chart
