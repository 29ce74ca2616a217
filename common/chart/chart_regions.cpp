// Regions of a plane: the border of {f <= 0} by marching squares over a grid of values of f.
#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "chart_parts.hpp"

namespace nutshell::chart::parts {
namespace {

/// The grid with a ring of outside nodes laid on its border, so that every contour closes.
struct PaddedGrid {
    const Region& region;
    int columns() const { return region.columns + 2; }
    int rows() const { return region.rows + 2; }
    bool pad(int i, int j) const { return i == 0 || j == 0 || i == columns() - 1 || j == rows() - 1; }
    double value(int i, int j) const {
        constexpr double outside = 1e9;
        if (pad(i, j)) return outside;
        const double v =
            region.values[static_cast<std::size_t>(j - 1) * static_cast<std::size_t>(region.columns) +
                          static_cast<std::size_t>(i - 1)];
        return std::isnan(v) ? outside : std::clamp(v, -outside, outside);
    }
    Point place(int i, int j) const {
        const double u = std::clamp(i - 1, 0, region.columns - 1) / static_cast<double>(region.columns - 1);
        const double v = std::clamp(j - 1, 0, region.rows - 1) / static_cast<double>(region.rows - 1);
        return {region.left + u * (region.right - region.left),
                region.bottom + v * (region.top - region.bottom)};
    }
};

/// Where the border cuts an edge of the grid, and the two cuts it is joined to.
struct Cut {
    Point at;
    bool on_border = false;
    std::array<long, 2> next{-1, -1};
    void join(long other) { next[next[0] < 0 ? 0 : 1] = other; }
};

struct Border {
    std::unordered_map<long, Cut> cuts;
    std::vector<long> order;  // in which cuts were met: the same picture every run

    Cut& at(long edge) {
        const auto [found, fresh] = cuts.try_emplace(edge);
        if (fresh) order.push_back(edge);
        return found->second;
    }
};

Border march(const PaddedGrid& grid) {
    Border border;
    const auto horizontal = [&](int i, int j) { return 2L * (static_cast<long>(j) * grid.columns() + i); };
    const auto vertical = [&](int i, int j) { return horizontal(i, j) + 1; };
    for (int j = 0; j + 1 < grid.rows(); ++j)
        for (int i = 0; i + 1 < grid.columns(); ++i) {
            const std::array<std::pair<int, int>, 4> corner{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
            const std::array<long, 4> edge{horizontal(i, j), vertical(i + 1, j), horizontal(i, j + 1),
                                           vertical(i, j)};
            std::array<double, 4> f{};
            for (std::size_t k = 0; k < 4; ++k) f[k] = grid.value(corner[k].first, corner[k].second);
            std::vector<long> hit;
            for (std::size_t k = 0; k < 4; ++k) {
                const std::size_t n = (k + 1) % 4;
                if ((f[k] <= 0) == (f[n] <= 0)) continue;
                const double t = f[k] / (f[k] - f[n]);
                const Point a = grid.place(corner[k].first, corner[k].second),
                            b = grid.place(corner[n].first, corner[n].second);
                Cut& cut = border.at(edge[k]);
                cut.at = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
                cut.on_border = grid.pad(corner[k].first, corner[k].second) ||
                                grid.pad(corner[n].first, corner[n].second);
                hit.push_back(edge[k]);
            }
            // four cuts, a saddle: the middle decides which corners hang together
            const bool middle_inside = f[0] + f[1] + f[2] + f[3] <= 0;
            if (hit.size() == 4 && (f[0] <= 0) != middle_inside)
                std::rotate(hit.begin(), hit.begin() + 3, hit.end());
            for (std::size_t k = 0; k + 1 < hit.size(); k += 2)
                border.at(hit[k]).join(hit[k + 1]), border.at(hit[k + 1]).join(hit[k]);
        }
    return border;
}

double value_near(const Region& region, double x, double y) {
    const auto index = [](double from, double to, double v, int count) {
        return static_cast<int>(std::lround((v - from) / (to - from) * (count - 1)));
    };
    const int i = index(region.left, region.right, x, region.columns),
              j = index(region.bottom, region.top, y, region.rows);
    if (i < 0 || j < 0 || i >= region.columns || j >= region.rows) return INFINITY;
    return PaddedGrid{region}.value(i + 1, j + 1);
}

std::size_t nodes_inside(const Region& region) {
    return static_cast<std::size_t>(
        std::count_if(region.values.begin(), region.values.end(), [](double v) { return v <= 0; }));
}

}  // namespace

Contour contour(const Region& region, const Style& style, const Frame& frame) {
    Contour result{style, {}, {}, {frame.plot.right, frame.plot.bottom}};
    Border cuts = march(PaddedGrid{region});
    std::unordered_map<long, bool> done;
    double farthest = -INFINITY;
    for (const long start : cuts.order) {
        if (done[start]) continue;
        Line loop, run;
        std::vector<bool> loop_border;
        for (long here = start; here >= 0;) {
            done[here] = true;
            const Cut& cut = cuts.cuts[here];
            loop.push_back(frame(cut.at.x, cut.at.y));
            loop_border.push_back(cut.on_border);
            here = !done[cut.next[0]] ? cut.next[0] : !done[cut.next[1]] ? cut.next[1] : -1;
        }
        loop.push_back(loop.front()), loop_border.push_back(loop_border.front());
        for (std::size_t i = 0; i < loop.size(); ++i) {
            if (loop[i].x > farthest) farthest = loop[i].x, result.anchor = loop[i];
            if (!loop_border[i]) run.push_back(loop[i]);
            if ((loop_border[i] || i + 1 == loop.size()) && run.size() > 1)
                result.outline.push_back(simplified(run, 0.1));
            if (loop_border[i]) run.clear();
        }
        result.fill.push_back(simplified(loop, 0.1));
    }
    return result;
}

std::string draw_region(const Region& region, const Contour& contour) {
    const std::string title =
        region.name.empty() ? "/>\n" : "><title>" + escaped(region.name) + "</title></path>\n";
    const std::string dash =
        contour.style.dash.empty() ? "" : " stroke-dasharray='" + contour.style.dash + "'";
    return "<path class='area' d='" + path(contour.fill, true) + "'" + title + "<path class='curve' d='" +
           path(contour.outline) + "'" + dash + "/>\n";
}

std::optional<Box> place_inside(const Chart& chart, std::size_t index, const Frame& frame,
                                const Obstacles& obstacles) {
    const Region& region = chart.regions[index];
    const double width = text_width(region.name, text_size), height = line_height;
    std::vector<const Region*> smaller_regions;
    for (const Region& other : chart.regions)
        if (nodes_inside(other) < nodes_inside(region)) smaller_regions.push_back(&other);
    constexpr int places = 32;
    constexpr double least_gap = 5, step = 5;
    double best_gap = 0;
    std::optional<Box> best;
    for (int i = 1; i < places; ++i)
        for (int j = 1; j < places; ++j) {
            const double u = frame.x.range.from + (frame.x.range.to - frame.x.range.from) * j / places;
            const double v = frame.y.range.from + (frame.y.range.to - frame.y.range.from) * i / places;
            if (!(value_near(region, u, v) <= 0)) continue;
            if (std::any_of(smaller_regions.begin(), smaller_regions.end(),
                            [&](const Region* other) { return value_near(*other, u, v) <= 0; }))
                continue;
            const Point at = frame(u, v);
            double gap = std::max(least_gap, best_gap + step);
            const auto around = [&](double g) {
                return Box{at.x - width / 2 - g, at.y - height / 2 - g, at.x + width / 2 + g,
                           at.y + height / 2 + g};
            };
            const auto free = [&](double g) {
                const Box box = around(g);
                return box.left >= frame.plot.left && box.right <= frame.plot.right &&
                       box.top >= frame.plot.top && box.bottom <= frame.plot.bottom &&
                       obstacles.clutter(box) == 0;
            };
            for (; free(gap) && gap < 60; gap += step) best_gap = gap, best = around(0);
        }
    return best;
}

}  // namespace nutshell::chart::parts
