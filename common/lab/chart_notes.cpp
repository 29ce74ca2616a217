// What is written into the drawing: the tolerance and other levels, slope guides, rings. Each finds a free
// place.
#include <algorithm>
#include <cmath>

#include "chart_parts.hpp"

namespace nutshell::lab::parts {
namespace {

constexpr double off_border = 6;  // text keeps this far from the plot's border

Box box_at(double left, double top, double width, double height) {
    return {left, top, left + width, top + height};
}

Box moved_inside(Box box, const Box& plot) {
    const double right = std::max(0.0, box.right - plot.right + off_border),
                 left = std::max(0.0, plot.left + off_border - box.left);
    const double down = std::max(0.0, box.bottom - plot.bottom + 2),
                 up = std::max(0.0, plot.top + 2 - box.top);
    box.left += left - right, box.right += left - right;
    box.top += up - down, box.bottom += up - down;
    return box;
}

/// Writes lines of text into the freest of the candidate boxes.
std::string write_note(const std::vector<std::string>& lines, const std::vector<Box>& candidates,
                       Obstacles& obstacles) {
    const Box box = candidates[freest(candidates, obstacles)];
    obstacles.boxes.push_back(box);
    std::string out;
    double y = box.top + 15;
    for (const std::string& line : lines) out += draw_text("note", box.left, y, line), y += line_height;
    return out;
}

double widest(const std::vector<std::string>& lines) {
    double width = 0;
    for (const std::string& line : lines) width = std::max(width, text_width(line, note_size));
    return width;
}

std::string draw_level(const Frame& frame, const Level& level, bool on_y, Obstacles& obstacles) {
    const Box& plot = frame.plot;
    const Ruler& ruler = on_y ? frame.y : frame.x;
    if (!ruler.shows(level.value)) return "";
    const double at = ruler(level.value);
    const Point a = on_y ? Point{plot.left, at} : Point{at, plot.top},
                b = on_y ? Point{plot.right, at} : Point{at, plot.bottom};
    std::string out = "<path class='level' d='" + path({{a, b}}) + "'><title>" + escaped(level.reason) +
                      "</title></path>\n";
    const auto lines = wrapped(level.reason, note_size, (on_y ? 0.9 : 0.4) * plot.width());
    if (lines.empty()) return out;
    const double width = widest(lines), height = line_height * static_cast<double>(lines.size());
    std::vector<Box> candidates;
    for (const double part : {0.0, 0.5, 1.0, 0.25, 0.75}) {
        if (on_y) {
            const double left = plot.left + off_border + part * (plot.width() - width - 2 * off_border);
            for (const double top : {at - height - 2, at + 3})
                candidates.push_back(box_at(left, top, width, height));
        } else {
            const double top = plot.top + 4 + part * (plot.height() - height - 8);
            for (const double left : {at + 6, at - width - 6})
                candidates.push_back(box_at(left, top, width, height));
        }
    }
    for (Box& box : candidates) box = moved_inside(box, plot);
    out += write_note(lines, candidates, obstacles);
    obstacles.lines.push_back({a, b});
    return out;
}

}  // namespace

std::string draw_levels(const Chart& chart, const Frame& frame, Obstacles& obstacles) {
    std::string out;
    for (const Level& level : chart.levels_y) out += draw_level(frame, level, true, obstacles);
    for (const Level& level : chart.levels_x) out += draw_level(frame, level, false, obstacles);
    if (chart.tolerance) out += draw_level(frame, *chart.tolerance, true, obstacles);
    return out;
}

std::string draw_guides(const Chart& chart, const Frame& frame, Obstacles& obstacles) {
    if (chart.guides.empty()) return "";
    const auto per_decade = [](const Ruler& ruler) {
        return std::abs(ruler.high - ruler.low) / std::log10(ruler.range.to / ruler.range.from);
    };
    std::vector<double> slopes = chart.guides;  // shallowest first: it carries the word
    std::sort(slopes.begin(), slopes.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    // A fan of rays from one point; longer until the numbers at their ends stay apart.
    struct Ray {
        Point end;  // from the fan's point
        std::string text;
        Box label;
    };
    std::vector<Ray> rays;
    const double aspect = per_decade(frame.y) / per_decade(frame.x);
    for (double radius = 60; radius <= 150; radius += 10) {
        rays.clear();
        double apart = INFINITY;
        for (const double slope : slopes) {
            const double angle = std::atan(-slope * aspect);
            const std::string number = spoken(std::abs(slope));
            const std::string text = rays.empty() ? chart.guide_name + " " + number : number;
            const Point end{radius * std::cos(angle), radius * std::sin(angle)};
            const Point label{(radius + 6) * std::cos(angle), (radius + 9) * std::sin(angle)};
            const double width = text_width(text, note_size);
            if (!rays.empty()) apart = std::min(apart, std::abs(end.y - rays.back().end.y));
            rays.push_back({end, text, box_at(label.x, label.y - line_height / 2, width, line_height)});
        }
        if (apart >= 15) break;
    }
    Box fan{0, 0, 0, 0};
    for (const Ray& ray : rays)
        fan = {0, std::min(fan.top, ray.label.top), std::max(fan.right, ray.label.right),
               std::max(fan.bottom, ray.label.bottom)};
    std::vector<Box> candidates;
    constexpr int places = 16;
    for (int i = places; i >= 0; --i)
        for (int j = 0; j <= places; ++j)
            candidates.push_back(
                box_at(frame.plot.left + 8 + (frame.plot.width() - fan.width() - 16) * j / places,
                       frame.plot.top + 4 + (frame.plot.height() - fan.height() - 8) * i / places,
                       fan.width(), fan.height()));
    const Box place = candidates[freest(candidates, obstacles)];
    obstacles.boxes.push_back(place);
    const Point apex{place.left, place.top - fan.top};
    std::string out = "<g class='guide'>\n<path d='";
    for (const Ray& ray : rays) out += path({{apex, {apex.x + ray.end.x, apex.y + ray.end.y}}});
    out += "'/>\n";
    for (const Ray& ray : rays)
        out += draw_text("note", apex.x + ray.label.left, apex.y + ray.label.top + 15, ray.text);
    return out + "</g>\n";
}

std::string draw_rings(const Chart& chart, const Frame& frame, Obstacles& obstacles) {
    std::vector<Ring> rings = chart.rings;
    if (chart.ring_cheapest)
        if (const auto ring = cheapest(chart)) rings.push_back(*ring);
    constexpr double radius = 10.5;
    std::string out;
    for (const Ring& ring : rings) {
        if (!frame.x.shows(ring.x) || !frame.y.shows(ring.y)) continue;
        const Point at = frame(ring.x, ring.y);
        out += "<circle class='ring' cx='" + unit(at.x) + "' cy='" + unit(at.y) + "' r='" + unit(radius) +
               "'><title>" +
               escaped(ring.text + ": " + chart.x.name + " " + spoken(ring.x) + ", " + chart.y.name + " " +
                       spoken(ring.y)) +
               "</title></circle>\n";
        const auto lines = wrapped(ring.text, note_size, 0.45 * frame.plot.width());
        if (lines.empty()) continue;
        const double width = widest(lines), height = line_height * static_cast<double>(lines.size());
        std::vector<Box> candidates;
        for (const double away : {1.0, 1.8, 3.0, 4.5})
            for (const auto& [dx, dy] :
                 {std::pair{-1, 1}, {1, -1}, {-1, 0}, {1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}}) {
                const double gap = away * (radius + 2);
                const double left = dx < 0 ? at.x - gap - width : dx > 0 ? at.x + gap : at.x - width / 2;
                const double top = dy < 0   ? at.y - gap - height + 4
                                   : dy > 0 ? at.y + gap - 4
                                            : at.y - height / 2;
                const Box box = moved_inside(box_at(left, top, width, height), frame.plot);
                const bool over_ring = box.left < at.x + radius && box.right > at.x - radius &&
                                       box.top < at.y + radius && box.bottom > at.y - radius;
                if (!over_ring) candidates.push_back(box);
            }
        if (!candidates.empty()) out += write_note(lines, candidates, obstacles);
    }
    return out;
}

}  // namespace nutshell::lab::parts
