#include "words.hpp"

#include <algorithm>
#include <cmath>

namespace nutshell::picture {

namespace {

double overlap(const Taken& a, const Taken& b) {
    const double w = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double h = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    return w > 0 && h > 0 ? w * h : 0;
}

}  // namespace

std::vector<Line> place_anchored(Size size, const std::vector<AnchoredWords>& all, double height,
                                 std::vector<Taken> taken) {
    const double edge = 0.3 * height;
    std::vector<Line> lines;
    for (const AnchoredWords& words : all) {
        if (words.text.empty()) continue;
        const double width = text_width(words.text, height, Weight::bold), rise = 0.72 * height;
        const double preferred = std::atan2(words.toward_y, words.toward_x);
        Taken best{};
        double least = -1;
        for (int ring = 0; ring < 5; ++ring) {
            for (int turn = 0; turn < 8;
                 ++turn) {  // the preferred side first, then by turns left and right of it
                const double angle = preferred + (turn % 2 ? 1 : -1) * ((turn + 1) / 2) * 0.785398;
                const double away = height * (0.55 + 0.8 * ring), c = std::cos(angle), s = std::sin(angle);
                const double side = std::clamp(1.42 * c, -1.0, 1.0), level = std::clamp(1.42 * s, -1.0, 1.0);
                const double cx = words.x + c * away + side * width / 2,
                             cy = words.y + s * away + level * rise / 2;
                const double left =
                    std::clamp(cx - width / 2, edge, std::max(edge, size.width - width - edge));
                const double top = std::clamp(cy - rise / 2, edge, std::max(edge, size.height - rise - edge));
                const Taken place{left, top, left + width, top + rise};
                double cost = 0.15 * height * (turn + 4 * ring);
                for (const Taken& other : taken) cost += other.weight * overlap(place, other);
                const Taken anchor{words.x - 3, words.y - 3, words.x + 3, words.y + 3};
                cost += 20 * overlap(place, anchor) + std::hypot(left + width / 2 - cx, top + rise / 2 - cy);
                if (least < 0 || cost < least) {
                    least = cost;
                    best = place;
                }
            }
        }
        Line line{.text = words.text, .left = best.left, .right = best.right, .baseline = best.bottom};
        line.height = height, line.ink = words.ink, line.ends = best.right < words.x;
        lines.push_back(std::move(line));
        const double air = 0.3 * height;  // more than a halo
        taken.push_back({best.left - air, best.top - air, best.right + air, best.bottom + air, 5});
    }
    return lines;
}

}  // namespace nutshell::picture
