// What is written into the drawing: the tolerance and other levels, slope guides, rings. Each finds a free
// place.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "chart_parts.hpp"

namespace nutshell::chart::parts {
namespace {

constexpr std::size_t most_lines = 4;  // a longer reason stands in the margin
constexpr double off_border = 6;       // text keeps this far from the plot's border

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

double widest(const std::vector<std::string>& lines) {
    double width = 0;
    for (const std::string& line : lines) width = std::max(width, text_width(line, note_size));
    return width;
}

Note note_at(const std::vector<std::string>& lines, double left, double top) {
    return {lines, box_at(left, top, widest(lines), line_height * static_cast<double>(lines.size()))};
}

}  // namespace

std::vector<Level> levels_on_y(const Chart& chart) {
    std::vector<Level> levels = chart.levels_y;
    if (chart.tolerance) levels.push_back(*chart.tolerance);
    return levels;
}

std::optional<Note> place_on_level(const Level& level, const Frame& frame, const Obstacles& obstacles) {
    const Box& plot = frame.plot;
    const double at = frame.y(level.value);
    for (const double part : {0.9, 0.5, 0.35}) {  // of the plot's width: in one line, or broken
        const auto lines = balanced(level.reason, note_size, part * plot.width());
        if (lines.size() > most_lines) break;
        const Note note = note_at(lines, 0, 0);
        const double free = plot.width() - note.box.width() - 2 * off_border;
        constexpr int places = 12;
        for (int i = 0; i <= places; ++i)
            for (const bool above : {true, false}) {
                const double top = above ? at - note.box.height() - 1 : at + 2;
                const Note there = note_at(lines, plot.left + off_border + free * i / places, top);
                const Box& box = there.box;  // kept free all round, but for the line itself
                const Box around{box.left - 4, box.top - (above ? 3 : 0), box.right + 4,
                                 box.bottom + (above ? 0 : 3)};
                if (free >= 0 && box.top >= plot.top && box.bottom <= plot.bottom &&
                    obstacles.clutter(around) == 0)
                    return there;
            }
    }
    return std::nullopt;
}

std::string draw_level_line(const Level& level, const Frame& frame, bool on_y) {
    const Box& plot = frame.plot;
    const double at = on_y ? frame.y(level.value) : frame.x(level.value);
    const Line line =
        on_y ? Line{{plot.left, at}, {plot.right, at}} : Line{{at, plot.top}, {at, plot.bottom}};
    return "<path class='level' d='" + path({line}) + "'><title>" + escaped(level.reason) +
           "</title></path>\n";
}

std::string draw_levels_on_x(const Chart& chart, const Frame& frame, Obstacles& obstacles) {
    const Box& plot = frame.plot;
    std::string out;
    for (const Level& level : chart.levels_x) {
        if (!frame.x.shows(level.value)) continue;
        out += draw_level_line(level, frame, false);
        const double at = frame.x(level.value);
        const auto lines = balanced(level.reason, note_size, 0.4 * plot.width());
        const Note note = note_at(lines, 0, 0);
        constexpr int places = 12;
        std::vector<Box> candidates;
        for (int i = 0; i <= places; ++i)
            for (const double left : {at + 6, at - note.box.width() - 6})
                if (left > plot.left && left + note.box.width() < plot.right)
                    candidates.push_back(
                        box_at(left, plot.top + 4 + (plot.height() - note.box.height() - 8) * i / places,
                               note.box.width(), note.box.height()));
        if (candidates.empty())
            candidates.push_back(
                moved_inside(box_at(at + 6, plot.top + 4, note.box.width(), note.box.height()), plot));
        const Box box = candidates[freest(candidates, obstacles)];
        obstacles.boxes.push_back(box);
        obstacles.lines.push_back({{at, plot.top}, {at, plot.bottom}});
        out += draw_note({lines, box});
    }
    return out;
}

std::string draw_note(const Note& note) {
    std::string out;
    double y = note.box.top + 15;
    for (const std::string& line : note.lines) {
        out += draw_text("note", note.box.left, y, line);
        y += line_height;
    }
    return out;
}

std::vector<Ring> rings_of(const Chart& chart) {
    std::vector<Ring> rings = chart.rings;
    if (chart.ring_cheapest)
        if (const auto ring = cheapest(chart))  // the curve it stands on has its name already
            rings.push_back({ring->x, ring->y, "cheapest"});
    return rings;
}

std::string draw_guides(const Chart& chart, const Frame& frame, Obstacles& obstacles) {
    if (chart.guides.empty()) return "";
    const auto per_decade = [](const Ruler& ruler) {
        return std::abs(ruler.high - ruler.low) / (std::log10(ruler.range.to) - std::log10(ruler.range.from));
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
    constexpr double crowded = 120;  // px of other lines across the fan: it would be read as one of them
    if (obstacles.clutter(place) > crowded) return "";
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
    std::string out;
    for (const Ring& ring : rings_of(chart)) {
        if (!frame.x.shows(ring.x) || !frame.y.shows(ring.y)) continue;
        const Point at = frame(ring.x, ring.y);
        out += "<circle class='ring' cx='" + unit(at.x) + "' cy='" + unit(at.y) + "' r='" +
               unit(ring_radius) + "'><title>" +
               escaped(ring.text + ": " + chart.x.name + " " + spoken(ring.x) + ", " + chart.y.name + " " +
                       spoken(ring.y)) +
               "</title></circle>\n";
        const auto lines = balanced(ring.text, note_size, 0.45 * frame.plot.width());
        if (lines.empty()) continue;
        const Note size = note_at(lines, 0, 0);
        std::vector<Box> candidates;
        for (const double gap : {14.0, 24.0, 36.0, 50.0, 70.0, 95.0, 125.0})
            for (int k = 0; k < 16;
                 ++k) {  // all round, from the left below where work-precision charts are empty
                const double angle = std::numbers::pi * (0.75 + k / 8.0);
                const double dx = (gap + size.box.width() / 2) * std::cos(angle),
                             dy = (gap + size.box.height() / 2) * std::sin(angle);
                candidates.push_back(
                    moved_inside(box_at(at.x + dx - size.box.width() / 2, at.y + dy - size.box.height() / 2,
                                        size.box.width(), size.box.height()),
                                 frame.plot));
            }
        const Box box = candidates[freest(candidates, obstacles)];
        obstacles.boxes.push_back(box);
        const Point nearest{std::clamp(at.x, box.left, box.right),
                            std::clamp(at.y, box.top + 4, box.bottom - 4)};
        const double away = std::hypot(nearest.x - at.x, nearest.y - at.y);
        if (away > ring_radius + 6) {
            const double part = ring_radius / away;
            out += "<path class='lead' d='" +
                   path({{{at.x + part * (nearest.x - at.x), at.y + part * (nearest.y - at.y)}, nearest}}) +
                   "'/>\n";
        }
        out += draw_note({lines, box});
    }
    return out;
}

}  // namespace nutshell::chart::parts
