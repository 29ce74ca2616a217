// Labels that never overlap, and the little geometry that keeps lines short and text off them.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "chart_parts.hpp"

namespace nutshell::chart::parts {
namespace {

/// Places middles in the given order: the least sum of squared moves from the anchors that keeps labels apart
/// and between top and bottom. With the heights above each label taken off this is isotonic regression, so
/// neighbours that push each other merge into blocks that stand at their mean.
void place_in_order(std::vector<Label>& labels, double top, double bottom) {
    struct Block {
        double sum;
        std::size_t count;
        double mean() const { return sum / static_cast<double>(count); }
    };
    std::vector<Block> blocks;
    std::vector<double> above(labels.size(), 0);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (i) above[i] = above[i - 1] + (labels[i - 1].height() + labels[i].height()) / 2;
        blocks.push_back({labels[i].anchor.y - above[i], 1});
        while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() >= blocks.back().mean()) {
            const Block last = blocks.back();
            blocks.pop_back();
            blocks.back().sum += last.sum, blocks.back().count += last.count;
        }
    }
    const double least = top + labels.front().height() / 2;
    const double most = std::max(least, bottom - labels.back().height() / 2 - above.back());
    std::size_t i = 0;
    for (const Block& block : blocks)
        for (std::size_t k = 0; k < block.count; ++k, ++i)
            labels[i].middle = std::clamp(block.mean(), least, most) + above[i];
}

constexpr double free_around = 5;  // text keeps this far from other things where it can

/// Twice the area of the triangle a, b, c; its sign tells on which side of a-b the point c lies.
double turn(Point a, Point b, Point c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool crossing(Point a, Point b, Point c, Point d) {
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

}  // namespace

std::optional<std::pair<Point, Point>> clipped(Point a, Point b, const Box& box) {
    double enter = 0, leave = 1;
    const double dx = b.x - a.x, dy = b.y - a.y;
    const auto keep = [&](double slope, double room) {  // inside where slope * t <= room
        if (slope == 0) return room >= 0;
        const double t = room / slope;
        if (slope < 0)
            enter = std::max(enter, t);
        else
            leave = std::min(leave, t);
        return enter <= leave;
    };
    if (!keep(-dx, a.x - box.left) || !keep(dx, box.right - a.x) || !keep(-dy, a.y - box.top) ||
        !keep(dy, box.bottom - a.y))
        return std::nullopt;
    return std::pair{Point{a.x + enter * dx, a.y + enter * dy}, Point{a.x + leave * dx, a.y + leave * dy}};
}

Line simplified(const Line& line, double tolerance) {
    if (line.size() < 3) return line;
    std::vector<bool> kept(line.size(), false);
    kept.front() = kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> spans{{0, line.size() - 1}};
    while (!spans.empty()) {
        const auto [first, last] = spans.back();
        spans.pop_back();
        const Point a = line[first], b = line[last];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        double most = tolerance;
        std::size_t farthest = 0;
        for (std::size_t i = first + 1; i < last; ++i) {
            // beyond the ends of a-b (a loop, a reversal) the distance to the ends counts, not that to the
            // line
            const double along =
                length > 0 ? ((line[i].x - a.x) * (b.x - a.x) + (line[i].y - a.y) * (b.y - a.y)) / length
                           : -1;
            const double away = along < 0        ? std::hypot(line[i].x - a.x, line[i].y - a.y)
                                : along > length ? std::hypot(line[i].x - b.x, line[i].y - b.y)
                                                 : std::abs(turn(a, b, line[i])) / length;
            if (away > most) most = away, farthest = i;
        }
        if (farthest == 0) continue;
        kept[farthest] = true;
        spans.emplace_back(first, farthest), spans.emplace_back(farthest, last);
    }
    Line result;
    for (std::size_t i = 0; i < line.size(); ++i)
        if (kept[i]) result.push_back(line[i]);
    return result;
}

double Obstacles::clutter(const Box& box) const {
    double sum = 0;
    for (const Line& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i)
            if (const auto part = clipped(line[i - 1], line[i], box))
                sum += 1 + std::hypot(part->second.x - part->first.x, part->second.y - part->first.y);
    for (const Box& other : boxes)
        if (box.left < other.right && other.left < box.right && box.top < other.bottom &&
            other.top < box.bottom)
            sum += 1000;
    return sum;
}

std::size_t freest(const std::vector<Box>& candidates, const Obstacles& obstacles) {
    std::vector<double> clutter;
    for (const Box& box : candidates) clutter.push_back(obstacles.clutter(box.wider(free_around)));
    return static_cast<std::size_t>(std::min_element(clutter.begin(), clutter.end()) - clutter.begin());
}

Point free_end(const std::vector<Line>& own, const std::vector<Line>& others, Point otherwise) {
    constexpr double close = 10, worth = 70;  // a free point may lie so much farther to the left
    const auto near_another = [&](Point p) {
        const Box around{p.x - close, p.y - close, p.x + close, p.y + close};
        for (const Line& line : others)
            for (std::size_t i = 1; i < line.size(); ++i)
                if (clipped(line[i - 1], line[i], around)) return true;
        return false;
    };
    double rightmost = -INFINITY, best = -INFINITY;
    for (const Line& line : own)
        for (const Point& p : line) rightmost = std::max(rightmost, p.x);
    Point result = otherwise;
    for (const Line& line : own)
        for (const Point& p : line) {
            if (p.x < rightmost - worth || p.x <= best) continue;
            const double value = p.x - (near_another(p) ? worth : 0);
            if (value > best) best = value, result = p;
        }
    return result;
}

void arrange(std::vector<Label>& labels, double hairline_end, double top, double bottom) {
    if (labels.empty()) return;
    std::stable_sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) {
        return a.anchor.y != b.anchor.y ? a.anchor.y < b.anchor.y : a.anchor.x > b.anchor.x;
    });
    place_in_order(labels, top, bottom);
    // each swap shortens the hairlines, so this ends; the bound is for ties
    for (std::size_t round = 0; round < labels.size() * labels.size(); ++round) {
        bool swapped = false;
        for (std::size_t i = 1; i < labels.size(); ++i) {
            const Label &a = labels[i - 1], &b = labels[i];
            if (!crossing(a.anchor, {hairline_end, a.middle}, b.anchor, {hairline_end, b.middle})) continue;
            std::swap(labels[i - 1], labels[i]);
            place_in_order(labels, top, bottom);
            swapped = true;
        }
        if (!swapped) return;
    }
}

std::string draw_label(const Label& label, double x) {
    std::string out;
    const double start = label.anchor.x + 7, end = x - 4;
    if (end - start > 3)
        out +=
            "<line class='hair' x1='" + unit(start) + "' y1='" +
            unit(label.anchor.y + (label.middle - label.anchor.y) * 7 / std::max(end - label.anchor.x, 7.0)) +
            "' x2='" + unit(end) + "' y2='" + unit(label.middle) + "'/>\n";
    double y = label.middle - label.height() / 2 + 15.5;
    for (const std::string& line : label.lines) {
        out += draw_text(label.css_class, x, y, line);
        y += line_height;
    }
    return out;
}

}  // namespace nutshell::chart::parts
