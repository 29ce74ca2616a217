// The key below a narrow plot: how each thing is drawn, with its name, in rows.
#include <algorithm>

#include "chart_parts.hpp"

namespace nutshell::chart::parts {
namespace {

constexpr double sample_width = 30, gap = 8, between = 18, row_gap = 3;

}  // namespace

double arrange_key(std::vector<KeyEntry>& entries, double width, double top) {
    const double widest = width - 2 * border - sample_width - gap;
    double x = border, y = top, row_height = 0;
    for (KeyEntry& entry : entries) {
        entry.lines = balanced(entry.text, text_size, widest);
        double text = 0;
        for (const std::string& line : entry.lines) text = std::max(text, text_width(line, text_size));
        const double needs = sample_width + gap + text;
        if (x > border && x + needs > width - border) x = border, y += row_height + row_gap, row_height = 0;
        entry.at = {x, y};
        row_height = std::max(row_height, line_height * static_cast<double>(entry.lines.size()));
        x += needs + between;
    }
    return y + row_height;
}

std::string draw_key(const KeyEntry& entry) {
    std::string out =
        "<g transform='translate(" + unit(entry.at.x) + ' ' + unit(entry.at.y) + ")'>\n" + entry.sample;
    double y = 15.5;
    for (const std::string& line : entry.lines) {
        out += draw_text(entry.css_class, sample_width + gap, y, line);
        y += line_height;
    }
    return out + "</g>\n";
}

}  // namespace nutshell::chart::parts
