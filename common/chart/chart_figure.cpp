// Several charts as one picture: panels in rows where it is wide, one below the other where it is narrow.
#include <nutshell/write_file.hpp>

#include <algorithm>

#include "chart_parts.hpp"

namespace nutshell::chart {
namespace parts {
namespace {

Layout arranged(const Figure& figure, double width, int columns) {
    double top = 0;
    Layout layout{width, 0, draw_heading(figure.title, figure.subtitle, width, false, top)};
    const int each = static_cast<int>(width) / columns;
    double row_top = top, row_bottom = top;
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
        const auto column = static_cast<int>(i) % columns;
        if (column == 0) row_top = row_bottom;
        Chart panel = figure.panels[i];
        panel.width = each;
        const Layout part = layout_of(panel, true);
        layout.body += "<g transform='translate(" + unit(column * each) + ' ' + unit(row_top) + ")'>\n" +
                       part.body + "</g>\n";
        row_bottom = std::max(row_bottom, row_top + part.height + 6);
    }
    layout.height = row_bottom;
    for (const std::string& line : wrapped(quiet_names(figure.panels), note_size, width - 2 * border))
        layout.body += draw_text("note", border, (layout.height += line_height) - 8, line);
    return layout;
}

}  // namespace
}  // namespace parts

std::string svg(const Figure& figure) {
    const std::string& name = figure.name.empty() ? figure.title : figure.name;
    if (figure.title.empty()) parts::refuse(name, "has no title; give it the question or the finding");
    if (figure.panels.empty() || figure.columns < 1) parts::refuse(name, "needs a panel and a column");
    std::string told = figure.description.empty() ? figure.subtitle : figure.description;
    for (const Chart& panel : figure.panels) {
        Chart titled = panel;
        titled.name = name;
        if (titled.title.empty()) titled.title = figure.title;
        parts::check(titled);
        if (figure.description.empty()) told += " " + panel.title + ": " + parts::summary(panel);
    }
    return parts::document(name, figure.title, told,
                           parts::arranged(figure, figure.width,
                                           std::min(figure.columns, static_cast<int>(figure.panels.size()))),
                           parts::arranged(figure, parts::narrow_width, 1));
}

void write_svg(const Figure& figure, const std::filesystem::path& path) {
    Figure named = figure;
    if (named.name.empty()) named.name = path.stem().string();
    for (std::size_t i = 0; i < named.panels.size(); ++i) {
        std::string whole =
            i == 0 ? named.subtitle : "";  // the panels are small: the figure says whose it is
        parts::compare(named.panels[i], named.name + "_" + std::to_string(i), whole);
        if (i == 0) named.subtitle = whole;
    }
    write_file(path, svg(named));
}

}  // namespace nutshell::chart
