// The things of a diagram, and the words beside them.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagram_parts.hpp"

namespace nutshell::chart {
namespace parts {
namespace {

constexpr double head = 13, half_head = 5.5;  // of an arrow
constexpr double hatch = 9;                   // between the strokes of a wall

Shades shades_of(Quantity quantity) {
    switch (quantity) {
        case Quantity::force:
            return palette::force;
        case Quantity::velocity:
            return palette::velocity;
        case Quantity::momentum:
            return palette::momentum;
        case Quantity::torque:
            return palette::torque;
        case Quantity::angular_velocity:
            return palette::angular_velocity;
        case Quantity::angular_momentum:
            return palette::angular_momentum;
        case Quantity::plain:
            break;
    }
    return palette::ink;
}

const char* class_of(Diagram::Line line) {
    switch (line) {
        case Diagram::Line::body:
            return "body";
        case Diagram::Line::ghost:
            return "body was";
        case Diagram::Line::spring:
            return "spring";
        case Diagram::Line::rope:
            return "rope";
        case Diagram::Line::rod:
            return "rod";
        case Diagram::Line::path:
            return "way";
        case Diagram::Line::dashed:
            return "dashed";
        case Diagram::Line::axis:
            break;
    }
    return "axis";
}

struct Extent {
    Box box{INFINITY, INFINITY, -INFINITY, -INFINITY};
    void take(Place p, double radius = 0) {
        if (!std::isfinite(p.x + p.y + radius)) box = {NAN, NAN, NAN, NAN};  // stays so: no comparison holds
        box = {std::min(box.left, p.x - radius), std::min(box.top, p.y - radius),
               std::max(box.right, p.x + radius), std::max(box.bottom, p.y + radius)};
    }
};

void draw_shape(Pen& pen, const Diagram::Shape& shape) {
    const std::string open = std::string("<path class='") + class_of(shape.line) + "' d='";
    if (shape.radius > 0) {
        const Point at = pen(shape.points.front());
        const double r = std::max(shape.radius * pen.scale, 4.0);
        Line rim;
        for (int i = 0; i <= 16; ++i)
            rim.push_back({at.x + r * std::cos(std::numbers::pi * i / 8),
                           at.y + r * std::sin(std::numbers::pi * i / 8)});
        pen.keep_off(rim);
        pen.out += "<circle class='" + std::string(class_of(shape.line)) + "' cx='" + unit(at.x) + "' cy='" +
                   unit(at.y) + "' r='" + unit(r) + "'/>\n";
        return;
    }
    const Line line = pen.line(shape.points);
    pen.keep_off(line);
    if (shape.closed)  // words stay off the inside too
        for (std::size_t i = 0; i < line.size(); ++i)
            for (std::size_t k = i + 1; k < line.size(); ++k) pen.keep_off({line[i], line[k]});
    pen.out += open + path({simplified(line, 0.15)}, shape.closed) + "'/>\n";
}

void draw_wall(Pen& pen, const Diagram::Wall& wall) {
    const Point a = pen(wall.from), b = pen(wall.to);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const Point along{(b.x - a.x) / length, (b.y - a.y) / length}, right{-along.y, along.x};
    std::vector<Line> strokes;
    for (double s = hatch / 2; s < length; s += hatch)
        strokes.push_back({{a.x + s * along.x, a.y + s * along.y},
                           {a.x + (s - 7) * along.x + 8 * right.x, a.y + (s - 7) * along.y + 8 * right.y}});
    pen.out +=
        "<path class='rod' d='" + path({{a, b}}) + "'/>\n<path class='hatch' d='" + path(strokes) + "'/>\n";
    for (const double away : {0.0, 4.0, 8.0})
        pen.keep_off(
            {{a.x + away * right.x, a.y + away * right.y}, {b.x + away * right.x, b.y + away * right.y}});
}

/// A triangle whose tip is the end of the line; the line is cut so that it does not reach through.
std::string head_at_end(Line& line, double size) {
    const Point tip = line.back();
    double left_over = 0.8 * size;
    while (line.size() > 2 &&
           std::hypot(tip.x - line[line.size() - 2].x, tip.y - line[line.size() - 2].y) < left_over)
        line.pop_back();
    const Point before = line[line.size() - 2];
    const double length = std::hypot(tip.x - before.x, tip.y - before.y);
    const Point along{(tip.x - before.x) / length, (tip.y - before.y) / length};
    left_over = std::min(left_over, 0.95 * length);
    line.back() = {tip.x - left_over * along.x, tip.y - left_over * along.y};
    const double half = half_head * size / head;
    const Line corners{tip,
                       {tip.x - size * along.x - half * along.y, tip.y - size * along.y + half * along.x},
                       {tip.x - size * along.x + half * along.y, tip.y - size * along.y - half * along.x}};
    return "<path class='head' d='" + path({corners}, true) + "'/>\n";
}

constexpr double least_arrow = 1;  // a shorter one is not drawn: there is no force to see

double length_of(const Line& line) {
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
        length += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
    return length;
}

std::string coloured(const Shades& shades, const std::string& inside) {
    return std::string("<g class='levels' color='") + shades.light + "' style='--d:" + shades.dark + "'>\n" +
           inside + "</g>\n";
}

void draw_arrow(Pen& pen, const Diagram::Arrow& arrow) {
    Line line = pen.line(arrow.shaft);
    const double length = length_of(line);
    if (length < least_arrow) return;
    pen.keep_off(line);
    const std::string inside = arrow.head ? head_at_end(line, std::min(head, 0.7 * length)) : "";
    const char* css_class = arrow.quantity == Quantity::plain ? "shaft fine" : "shaft";
    pen.out += coloured(shades_of(arrow.quantity), std::string("<path class='") + css_class + "' d='" +
                                                       path({simplified(line, 0.1)}) + "'/>\n" + inside);
}

void draw_dimension(Pen& pen, const Diagram::Dimension& dimension) {
    const Point a = pen(dimension.from), b = pen(dimension.to);
    const double length = std::max(std::hypot(b.x - a.x, b.y - a.y), 1e-9);
    const Point side{-(b.y - a.y) / length * 6, (b.x - a.x) / length * 6};
    pen.out += "<path class='measure' d='" +
               path({{a, b},
                     {{a.x + side.x, a.y + side.y}, {a.x - side.x, a.y - side.y}},
                     {{b.x + side.x, b.y + side.y}, {b.x - side.x, b.y - side.y}}}) +
               "'/>\n";
    pen.keep_off({a, b});
}

void draw_dot(Pen& pen, const Diagram::Dot& dot) {
    const Point at = pen(dot.at);
    const std::string place = "transform='translate(" + unit(at.x) + ' ' + unit(at.y) + ")'";
    pen.out += dot.centre ? "<g " + place +
                                "><circle class='disc' r='7'/><path class='quarters' d='M0 0V-7A7 7 0 0 1 7 "
                                "0ZM0 0V7A7 7 0 0 1 -7 0Z'/></g>\n"
                          : "<circle class='touch' r='5' " + place + "/>\n";
    pen.keep_off({{at.x - 7, at.y}, {at.x + 7, at.y}});
    pen.keep_off({{at.x, at.y - 7}, {at.x, at.y + 7}});
}

/// Whether another arrow begins or ends where this one has its tip.
bool meets_another(const Pen& pen, const Diagram& d, const Diagram::Arrow& arrow, Point tip) {
    constexpr double near = 16;
    return std::any_of(d.arrows.begin(), d.arrows.end(), [&](const Diagram::Arrow& other) {
        if (&other == &arrow) return false;
        const Point first = pen(other.shaft.front()), last = pen(other.shaft.back());
        return std::min(std::hypot(first.x - tip.x, first.y - tip.y),
                        std::hypot(last.x - tip.x, last.y - tip.y)) < near;
    });
}

/// A point to write beside, and on which side rather.
struct Anchor {
    Point at, preferred;
};

/// Puts a text where it is freest round a point, the preferred direction first; farther from the first point
/// only after a place close to the next one was tried.
void write_beside(Pen& pen, const std::vector<Anchor>& anchors, double away, const std::string& text,
                  const char* css_class, const Shades& shades, double width) {
    if (text.empty()) return;
    const auto lines = balanced(text, text_size, 0.42 * width);
    double widest = 0;
    for (const std::string& line : lines) widest = std::max(widest, text_width(line, text_size));
    const double height = line_height * static_cast<double>(lines.size());
    std::vector<Box> candidates;
    for (const double more : {0.0, 8.0, 18.0, 32.0, 50.0})
        for (const auto& [at, preferred] : anchors)
            for (const int turn : {0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6, -6, 7, -7, 8}) {
                const double angle = std::atan2(preferred.y, preferred.x) + turn * std::numbers::pi / 8,
                             c = std::cos(angle), s = std::sin(angle);
                // the box touches the circle of this radius from outside
                const double reach = away + more;
                const Point middle{at.x + c * (reach + widest / 2), at.y + s * (reach + height / 2)};
                Box box{middle.x - widest / 2, middle.y - height / 2, middle.x + widest / 2,
                        middle.y + height / 2};
                if (box.left < 4 || box.right > width - 4) continue;
                candidates.push_back(box);
            }
    const Point at = anchors.front().at;
    if (candidates.empty()) candidates.push_back({border, at.y - height, border + widest, at.y});
    const Box box = candidates[freest(candidates, pen.obstacles)];
    pen.obstacles.boxes.push_back(box);
    std::string inside;
    double y = box.top + 15.5;
    for (const std::string& line : lines) inside += draw_text(css_class, box.left, y, line), y += line_height;
    pen.out += coloured(shades, inside);
}

}  // namespace

Box extent_of(const Diagram& d) {
    Extent extent;
    for (const auto& shape : d.shapes)
        for (const Place p : shape.points) extent.take(p, shape.radius);
    for (const auto& wall : d.walls) extent.take(wall.from), extent.take(wall.to);
    for (const auto& arrow : d.arrows)
        for (const Place p : arrow.shaft) extent.take(p);
    for (const auto& dimension : d.dimensions) extent.take(dimension.from), extent.take(dimension.to);
    for (const auto& dot : d.dots) extent.take(dot.at);
    for (const auto& word : d.words) extent.take(word.at);
    return extent.box;
}

void draw_things(Pen& pen, const Diagram& d) {
    for (const auto& wall : d.walls) draw_wall(pen, wall);
    for (const auto& shape : d.shapes) draw_shape(pen, shape);
    for (const auto& dimension : d.dimensions) draw_dimension(pen, dimension);
    for (const auto& arrow : d.arrows) draw_arrow(pen, arrow);
    for (const auto& dot : d.dots) draw_dot(pen, dot);
}

void write_words(Pen& pen, const Diagram& d, double width) {
    for (const auto& dimension : d.dimensions) {
        const Point a = pen(dimension.from), b = pen(dimension.to);
        const Point side = std::abs(b.x - a.x) >= std::abs(b.y - a.y) ? Point{0, 1} : Point{1, 0};
        write_beside(pen, {{{(a.x + b.x) / 2, (a.y + b.y) / 2}, side}}, 4, dimension.text, "measured",
                     palette::ink, width);
    }
    for (const auto& arrow : d.arrows) {
        const Line line = pen.line(arrow.shaft);
        if (length_of(line) < least_arrow) continue;
        const bool arc = line.size() > 2;
        const Point at = arc ? line[line.size() / 2] : line.back();
        const Point from =
            arc ? Point{(line.front().x + line.back().x) / 2, (line.front().y + line.back().y) / 2}
                : line[line.size() - 2];
        std::vector<Anchor> anchors{{at, {at.x - from.x, at.y - from.y}}};
        if (!arc)  // at its tip, or beside its middle: rather there where another arrow comes to the tip
            anchors.push_back({{(at.x + from.x) / 2, (at.y + from.y) / 2}, {at.y - from.y, from.x - at.x}});
        if (!arc && meets_another(pen, d, arrow, at)) std::swap(anchors.front(), anchors.back());
        write_beside(pen, anchors, 7, arrow.label, "label", shades_of(arrow.quantity), width);
    }
    for (const auto& word : d.words)
        write_beside(pen, {{pen(word.at), {0, -1}}}, word.away, word.text,
                     word.away > 0 ? "label halo" : "measured", palette::ink, width);
}

}  // namespace parts
}  // namespace nutshell::chart
