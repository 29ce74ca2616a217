// A diagram from its things to SVG: one scale for all of it, and its two layouts.
#include <nutshell/write_file.hpp>

#include <algorithm>
#include <cmath>

#include "diagram_parts.hpp"

namespace nutshell::chart {
namespace parts {
namespace {

/// Units of the picture for one of the caller's, so that what lies in `box` fits.
double scale_for(const Diagram& d, double width, const Box& box) {
    const double across = (width - 2 * (border + label_room)) / std::max(box.width(), 1e-300);
    return std::min(across, (d.height - 2 * label_room) / std::max(box.height(), 1e-300));
}

/// A diagram at `scale` below `top`, moved up to it if `close_up`, in the middle of `width`.
Layout drawn(const Diagram& d, double width, double top, double scale, const Box& world, bool close_up) {
    Pen pen{{}, {}, width / 2 - world.width() * scale / 2, top + label_room, scale, world};
    draw_things(pen, d);
    write_words(pen, d, width);
    double bottom = top + label_room + world.height() * scale + 14, highest = top + label_room;
    for (const Box& box : pen.obstacles.boxes)
        bottom = std::max(bottom, box.bottom + 10), highest = std::min(highest, box.top);
    const double unused = close_up ? std::max(0.0, highest - top - 8) : 0;  // above the first thing
    return {width, bottom - unused,
            "<g transform='translate(0 " + unit(-unused) + ")'>\n" + pen.out + "</g>\n"};
}

void check_places(const Diagram& d, const std::string& name) {
    const Box box = extent_of(d);
    if (std::isnan(box.left) || std::isinf(box.width() + box.height()))
        refuse(name, box.left == INFINITY ? "has nothing to draw; give it a body, a spring, an arrow"
                                          : "has a place that is not finite");
    if (!(box.width() + box.height() > 0))
        refuse(name, "shows a single point; give it something with a length");
}

std::string told(const Diagram& d) {
    if (!d.description.empty()) return d.description;
    std::string text = d.subtitle;
    for (const auto& arrow : d.arrows)
        if (!arrow.label.empty()) text += (text.empty() ? "" : "; ") + arrow.label;
    for (const auto& dimension : d.dimensions) text += (text.empty() ? "" : "; ") + dimension.text;
    return text;
}

Layout arranged(const Diagrams& all, double width, bool stacked) {
    double top = 0;
    Layout layout{width, 0, draw_heading(all.title, all.subtitle, width, false, top)};
    const double each = stacked ? width : width / static_cast<double>(all.panels.size());
    Box world{INFINITY, INFINITY, -INFINITY, -INFINITY};
    for (const Diagram& d : all.panels) {
        const Box own = extent_of(d);
        world = {std::min(world.left, own.left), std::min(world.top, own.top),
                 std::max(world.right, own.right), std::max(world.bottom, own.bottom)};
    }
    const double scale = scale_for(all.panels.front(), each, world);
    double bottom = top, x = 0;
    for (const Diagram& d : all.panels) {
        double heading = 0;
        const std::string head_text = draw_heading(d.title, d.subtitle, each, true, heading);
        const Layout part = drawn(d, each, d.title.empty() ? 0 : heading, scale, world, stacked);
        layout.body += "<g transform='translate(" + unit(x) + ' ' + unit(stacked ? bottom : top) + ")'>\n" +
                       (d.title.empty() ? "" : head_text) + part.body + "</g>\n";
        bottom = stacked ? bottom + part.height : std::max(bottom, top + part.height);
        if (!stacked) x += each;
    }
    layout.height = bottom;
    return layout;
}

Layout arranged(const Diagram& d, double width) {
    double top = 0;
    Layout layout{width, 0, draw_heading(d.title, d.subtitle, width, false, top)};
    const Box world = extent_of(d);
    const Layout part = drawn(d, width, top, scale_for(d, width, world), world, true);
    layout.body += part.body, layout.height = part.height;
    return layout;
}

}  // namespace
}  // namespace parts

std::string svg(const Diagram& d) {
    const std::string& name = d.name.empty() ? d.title : d.name;
    if (d.title.empty()) parts::refuse(name, "has no title; give it what the diagram shows");
    parts::check_places(d, name);
    return parts::document(name, d.title, parts::told(d), parts::arranged(d, d.width),
                           parts::arranged(d, parts::narrow_width));
}

std::string svg(const Diagrams& all) {
    const std::string& name = all.name.empty() ? all.title : all.name;
    if (all.title.empty()) parts::refuse(name, "has no title; give it what the diagrams show");
    if (all.panels.empty()) parts::refuse(name, "has no diagram");
    std::string told = all.description;
    for (const Diagram& d : all.panels) {
        parts::check_places(d, name);
        if (all.description.empty())
            told += (told.empty() ? "" : " ") + d.title + ": " + parts::told(d) + ".";
    }
    return parts::document(name, all.title, told, parts::arranged(all, all.width, false),
                           parts::arranged(all, parts::narrow_width, true));
}

void write_svg(const Diagram& diagram, const std::filesystem::path& path) {
    Diagram named = diagram;
    if (named.name.empty()) named.name = path.stem().string();
    write_file(path, svg(named));
}

void write_svg(const Diagrams& diagrams, const std::filesystem::path& path) {
    Diagrams named = diagrams;
    if (named.name.empty()) named.name = path.stem().string();
    write_file(path, svg(named));
}

}  // namespace nutshell::chart
