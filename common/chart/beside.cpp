#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <nutshell/chart/beside.hpp>
#include <nutshell/write_file.hpp>
#include <system_error>
#include "chart_parts.hpp"

namespace nutshell::chart {

namespace fs = std::filesystem;

namespace {

struct Beside {
    fs::path keep, compare;
    std::string whose;
};
Beside& beside() {
    static Beside all;
    return all;
}

std::string digits(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

/// Curves as text: a line `= NAME`, then one point a line.
std::vector<Series> kept(const fs::path& file) {
    std::vector<Series> all;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        if (line.rfind("= ", 0) == 0) {
            all.push_back({line.substr(2)});
            continue;
        }
        const auto space = line.find(' ');
        if (all.empty() || space == std::string::npos) continue;
        all.back().add(std::strtod(line.c_str(), nullptr), std::strtod(line.c_str() + space, nullptr));
    }
    return all;
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
        return x == y || std::abs(x - y) <= 1e-6 * std::abs(y) || (std::isnan(x) && std::isnan(y));
    });
}

/// The ghost of a curve: only what lies within the chart's own data, so that it moves no axis.
Series ghost_of(const Series& kept, const Chart& chart) {
    double left = INFINITY, right = -INFINITY, bottom = INFINITY, top = -INFINITY;
    for (const Series& series : chart.series)
        for (std::size_t i = 0; i < series.x.size(); ++i) {
            if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) continue;
            left = std::min(left, series.x[i]), right = std::max(right, series.x[i]);
            bottom = std::min(bottom, series.y[i]), top = std::max(top, series.y[i]);
        }
    Series ghost{kept.name.empty() ? "" : kept.name + ", the reference"};
    ghost.draw = Draw::ghost;
    for (std::size_t i = 0; i < kept.x.size(); ++i)
        if (kept.x[i] >= left && kept.x[i] <= right && kept.y[i] >= bottom && kept.y[i] <= top)
            ghost.add(kept.x[i], kept.y[i]);
    return ghost;
}

}  // namespace

void keep_points(const fs::path& folder) {
    beside().keep = folder;
}

void draw_beside(const fs::path& folder, const std::string& whose) {
    beside().compare = folder, beside().whose = whose;
}

namespace parts {

void compare(Chart& chart, const std::string& name, std::string& subtitle) {
    if (!beside().keep.empty()) {
        std::string text;
        for (const Series& series : chart.series) {
            text += "= " + series.name + "\n";
            for (std::size_t i = 0; i < series.x.size(); ++i)
                text += digits(series.x[i]) + " " + digits(series.y[i]) + "\n";
        }
        write_file(beside().keep / (name + ".points"), text);
    }
    if (beside().compare.empty()) return;
    const auto reference = kept(beside().compare / (name + ".points"));
    std::vector<Series> ghosts;
    for (std::size_t i = 0; i < chart.series.size() && i < reference.size(); ++i) {
        Series& own = chart.series[i];
        // a time that was measured differs in every run and says nothing of the code
        const bool measured = chart.y.name.find("[ns]") != std::string::npos ||
                              chart.y.name.find("processor time") != std::string::npos;
        if (own.name != reference[i].name || measured || same(own.y, reference[i].y)) continue;
        if (Series ghost = ghost_of(reference[i], chart); ghost.x.size() > 1)
            ghosts.push_back(std::move(ghost));
        if (!own.name.empty()) own.name += ", yours";
    }
    const bool differs = !ghosts.empty();
    chart.series.insert(chart.series.begin(), ghosts.begin(), ghosts.end());
    subtitle += (subtitle.empty() ? "" : " ") + std::string("Drawn by ") + beside().whose +
                (differs ? "; pale: the reference." : ".");
}

}  // namespace parts

}  // namespace nutshell::chart
