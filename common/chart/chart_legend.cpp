// What each look means, for the page that explains them: groups in columns, each entry drawn as charts draw
// it.
#include <nutshell/write_file.hpp>

#include <algorithm>

#include "chart_parts.hpp"

namespace nutshell::chart {
namespace parts {
namespace {

constexpr double row = 30, line_length = 64;

double height_of(const Legend::Group& group) {
    return row * static_cast<double>(group.entries.size()) + 44;
}

std::string draw_group(const Legend::Group& group, double left, double top, double width) {
    std::string out;
    double y = top + 8;
    for (const std::string& line : wrapped(group.name, text_size, width))
        out += draw_text("name", left, y += 20, line);
    y += 6;
    for (const Legend::Entry& entry : group.entries) {
        const Style style = style_of(entry.look);
        const double middle = y + row / 2;
        const bool ghost = style.family == Family::exact;
        const std::string dash = style.dash.empty() || ghost ? "" : " stroke-dasharray='" + style.dash + "'";
        out += open_group(style, "series") + "<path class='" + (ghost ? "ghost" : "curve") + "' d='" +
               path({{{left, middle}, {left + line_length, middle}}}) + "'" + dash + "/>\n" +
               draw_mark(style, {left + line_length / 2, middle}, "") +
               draw_text("label", left + line_length + 12, middle + 5.5, entry.name) + "</g>\n";
        y += row;
    }
    return out;
}

Layout arranged(const Legend& legend, double width) {
    double top = 0;
    Layout layout{width, 0, draw_heading(legend.title, legend.subtitle, width, false, top)};
    const int columns = width <= narrow_width ? 1 : 2;
    std::vector<double> bottoms(static_cast<std::size_t>(columns), top);
    const double each = (width - 2 * border) / columns;
    for (const Legend::Group& group : legend.groups) {  // into the shortest column
        const auto column = std::min_element(bottoms.begin(), bottoms.end());
        const double left = border + each * static_cast<double>(column - bottoms.begin());
        layout.body += draw_group(group, left, *column, each - 16);
        *column += height_of(group);
    }
    layout.height = *std::max_element(bottoms.begin(), bottoms.end()) + 14;
    return layout;
}

std::string told(const Legend& legend) {
    if (!legend.description.empty()) return legend.description;
    std::string text = legend.subtitle;
    for (const Legend::Group& group : legend.groups) {
        text += " " + group.name + ":";
        for (const Legend::Entry& entry : group.entries)
            text += (&entry == &group.entries.front() ? " " : ", ") + entry.name;
        text += ".";
    }
    return text;
}

}  // namespace
}  // namespace parts

std::string svg(const Legend& legend) {
    const std::string& name = legend.name.empty() ? legend.title : legend.name;
    if (legend.title.empty()) parts::refuse(name, "has no title; give it what the looks mean");
    if (legend.groups.empty()) parts::refuse(name, "has no group of looks");
    return parts::document(name, legend.title, parts::told(legend), parts::arranged(legend, legend.width),
                           parts::arranged(legend, parts::narrow_width));
}

void write_svg(const Legend& legend, const std::filesystem::path& path) {
    Legend named = legend;
    if (named.name.empty()) named.name = path.stem().string();
    write_file(path, svg(named));
}

}  // namespace nutshell::chart
