// Axes: the range that the data need, round ticks, the grid.
#include <algorithm>
#include <cmath>

#include "chart_parts.hpp"

namespace nutshell::chart::parts {
namespace {

constexpr double room = 0.04;  // left free at each end of an automatic range, as a part of it

constexpr double closest = 1e-9;  // ends of an axis are at least this far apart, relative to their size

struct Extent {
    double least = INFINITY, most = -INFINITY;
    void take(double value, Scale scale) {
        if (!can_show(scale, value)) return;
        least = std::min(least, value), most = std::max(most, value);
    }
};

/// 1, 2 or 5 times a power of ten, not below `least`.
double round_step(double least) {
    const double ten = std::pow(10, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * ten >= least * (1 - 1e-9)) return factor * ten;
    return 10 * ten;
}

/// The caller's ends where given, else these.
Range ends(const Chart& chart, const Axis& axis, double low, double high) {
    const Range range{std::isnan(axis.from) ? low : axis.from, std::isnan(axis.to) ? high : axis.to};
    const double size = std::max(std::abs(range.from), std::abs(range.to));
    const double least = axis.scale == Scale::linear ? std::max(closest * size, 1e-290) : closest * size;
    if (!(range.to - range.from > least))
        refuse(chart, "has no room on axis \"" + axis.name + "\", which goes from " + spoken(range.from) +
                          " to " + spoken(range.to) +
                          ": all data lie beyond, or the ends are too close; set both ends or none");
    return range;
}

Range finished(const Chart& chart, const Axis& axis, Extent extent, bool pad) {
    if (!std::isnan(axis.from)) extent.take(axis.from, axis.scale);
    if (!std::isnan(axis.to)) extent.take(axis.to, axis.scale);
    if (extent.least > extent.most)
        refuse(
            chart,
            "has no point that its axis \"" + axis.name +
                "\" can show (finite, and positive on a logarithmic axis); give it data or set from and to");
    double low = extent.least, high = extent.most;
    if (axis.scale == Scale::logarithmic) {
        if (high - low <= closest * high) low /= 3, high *= 3;
        const double margin = pad ? std::pow(10, room * (std::log10(high) - std::log10(low))) : 1;
        low = std::max(low / margin, 1e-302), high = std::min(high * margin, 1e302);
    } else {
        const double size = std::max(std::abs(low), std::abs(high));
        if (high - low <= closest * size || size < 1e-290) {
            const double some = size < 1e-290 ? 1 : size / 2;
            low -= some, high += some;
        }
        if (pad && !chart.equal_aspect) {
            if (low > 0 && low < 0.3 * high) low = 0;
            if (high < 0 && high > 0.3 * low) high = 0;
            const double step = round_step(high / 10 - low / 10);
            low = step * std::floor(low / step + 1e-9), high = step * std::ceil(high / step - 1e-9);
        } else if (chart.equal_aspect) {
            const double margin = room * (high - low);
            low -= margin, high += margin;
        }
    }
    return ends(chart, axis, low, high);
}

/// Decimals that tell multiples of `step` apart.
int decimals_for(double step) {
    return std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 12);
}

std::string tick_text(double value, double step) {
    const double size = std::abs(value);
    if (size < step * 1e-6) return "0";
    if (std::max(size, step) < 1e6 && step >= 1e-4) return decimal(value, decimals_for(step));
    int exponent = static_cast<int>(std::floor(std::log10(size) + 1e-12));
    double mantissa = value / std::pow(10, exponent);
    mantissa = std::round(mantissa * 1e6) / 1e6;
    return power_of_ten(mantissa, exponent);
}

std::vector<Tick> linear_ticks(Range range, double step) {
    std::vector<Tick> result;
    const double first = std::ceil(range.from / step - 1e-6);
    for (double k = first; k * step <= range.to + 1e-6 * step; ++k)
        result.push_back({k * step, tick_text(k * step, step)});
    return result;
}

/// Powers of ten, every `each`, with the mantissas between them if wanted.
std::vector<Tick> logarithmic_ticks(Range range, int each, const std::vector<double>& mantissas) {
    const double inside = 1e-9;
    const int first = static_cast<int>(std::floor(std::log10(range.from) - inside));
    const int last = static_cast<int>(std::floor(std::log10(range.to) + inside));
    const bool plain = first >= -4 && last <= 4;
    std::vector<Tick> result;
    for (int e = first; e <= last; ++e) {
        if (((e % each) + each) % each != 0) continue;
        for (const double m : mantissas) {
            const double value = m * std::pow(10, e);
            if (value < range.from * (1 - inside) || value > range.to * (1 + inside)) continue;
            result.push_back({value, plain ? decimal(value, std::max(0, -e)) : power_of_ten(m, e)});
        }
    }
    return result;
}

/// True if labels of these ticks stay apart.
bool fits(const std::vector<Tick>& list, const Ruler& ruler, bool horizontal) {
    for (std::size_t i = 1; i < list.size(); ++i) {
        const double gap = std::abs(ruler(list[i].value) - ruler(list[i - 1].value));
        const double need = horizontal ? 14 + (width_of_markup(list[i].markup, tick_size) +
                                               width_of_markup(list[i - 1].markup, tick_size)) /
                                                  2
                            : ruler.scale == Scale::logarithmic ? 28
                                                                : 36;
        if (gap < need) return false;
    }
    return true;
}

}  // namespace

bool can_show(Scale scale, double value) {
    return std::abs(value) <= 1e300 &&
           (scale == Scale::linear || value >= 1e-300);  // false for what is not a number
}

bool Ruler::takes(double value) const {
    return can_show(scale, value);
}

bool Ruler::shows(double value) const {
    if (!takes(value)) return false;
    const double place = (*this)(value), some = 1e-6;
    return place >= std::min(low, high) - some && place <= std::max(low, high) + some;
}

double Ruler::operator()(double value) const {
    // halves keep the difference of two huge numbers finite
    const double part =
        scale == Scale::linear
            ? (value / 2 - range.from / 2) / (range.to / 2 - range.from / 2)
            : (std::log(value) - std::log(range.from)) / (std::log(range.to) - std::log(range.from));
    return low + std::clamp(part, -1e4, 1e4) * (high - low);
}

Range range_of_x(const Chart& chart) {
    Extent extent;
    bool marks = false;
    for (const Series& series : chart.series) {
        for (const double x : series.x) extent.take(x, chart.x.scale);
        marks = marks || series.draw == Draw::marks;
    }
    for (const Region& region : chart.regions)
        extent.take(region.left, chart.x.scale), extent.take(region.right, chart.x.scale);
    for (const Bar& bar : chart.bars)
        extent.take(bar.value, chart.x.scale), extent.take(bar.floor, chart.x.scale);
    for (const Level& level : chart.levels_x) extent.take(level.value, chart.x.scale);
    if (!chart.bars.empty() && chart.x.scale == Scale::linear) extent.take(0, Scale::linear);
    // a region's grid fills the plane to its border
    if (!chart.regions.empty()) return ends(chart, chart.x, extent.least, extent.most);
    return finished(chart, chart.x, extent,
                    chart.x.scale == Scale::logarithmic || marks || !chart.bars.empty());
}

Range range_of_y(const Chart& chart) {
    Extent extent;
    for (const Series& series : chart.series)
        for (const double y : series.y) extent.take(y, chart.y.scale);
    for (const Region& region : chart.regions)
        extent.take(region.bottom, chart.y.scale), extent.take(region.top, chart.y.scale);
    for (const Level& level : chart.levels_y) extent.take(level.value, chart.y.scale);
    if (chart.tolerance) extent.take(chart.tolerance->value, chart.y.scale);
    if (!chart.regions.empty()) return ends(chart, chart.y, extent.least, extent.most);
    return finished(chart, chart.y, extent, true);
}

std::vector<Tick> ticks(Scale scale, Range range, double along, bool horizontal) {
    const Ruler ruler{scale, range, 0, along};
    if (scale == Scale::logarithmic) {
        for (int each = 1; each < 400; ++each) {
            auto list = logarithmic_ticks(range, each, {1});
            if (list.size() < 3 && each == 1) {
                if (auto finer = logarithmic_ticks(range, 1, {1, 2, 5});
                    finer.size() >= 2 && fits(finer, ruler, horizontal))
                    return finer;
                if (list.size() < 2) break;
            }
            if (fits(list, ruler, horizontal)) return list;
        }
    }
    std::vector<Tick> list;
    for (double step = round_step(range.to / 12 - range.from / 12);; step = round_step(step * 1.5)) {
        list = linear_ticks(range, step);
        if (list.size() <= 2 || fits(list, ruler, horizontal)) return list;
    }
}

std::string draw_text(const std::string& css_class, double x, double y, std::string_view text,
                      const char* anchor) {
    const std::string side =
        std::string_view(anchor) == "start" ? "" : std::string(" text-anchor='") + anchor + "'";
    return "<text class='" + css_class + "' x='" + unit(x) + "' y='" + unit(y) + "'" + side + ">" +
           escaped(text) + "</text>\n";
}

bool is_plane(const Chart& chart) {
    return chart.equal_aspect || !chart.regions.empty();
}

std::string draw_x_name(const Chart& chart, const Box& plot, double width, double& bottom) {
    std::string out;
    double y = plot.bottom + 22;
    for (const std::string& line : wrapped(chart.x.name, text_size, width - 32)) {
        const double half = text_width(line, text_size) / 2;
        out += draw_text("name", std::clamp((plot.left + plot.right) / 2, 16 + half, width - 16 - half),
                         y += 21, line, "middle");
    }
    bottom = y + 14;
    return out;
}

std::string draw_grid(const Chart& chart, const Frame& frame) {
    const Box& plot = frame.plot;
    const auto line = [](double x1, double y1, double x2, double y2, const char* css_class) {
        return std::string("<line class='") + css_class + "' x1='" + unit(x1) + "' y1='" + unit(y1) +
               "' x2='" + unit(x2) + "' y2='" + unit(y2) + "'/>\n";
    };
    const auto axis_or_grid = [](const Ruler& ruler, double value) {
        return ruler.scale == Scale::linear && std::abs(value) < 1e-9 * (ruler.range.to - ruler.range.from)
                   ? "axis"
                   : "grid";
    };
    std::string out, zero;
    for (const Tick& tick : ticks(chart.x.scale, frame.x.range, plot.width(), true)) {
        const double x = frame.x(tick.value);
        const bool axis = chart.equal_aspect && std::string_view(axis_or_grid(frame.x, tick.value)) == "axis";
        (axis ? zero : out) += line(x, plot.top, x, plot.bottom, axis ? "axis" : "grid");
        out += "<text class='tick' x='" + unit(x) + "' y='" + unit(plot.bottom + 20) +
               "' text-anchor='middle'>" + tick.markup + "</text>\n";
    }
    if (chart.bars.empty())
        for (const Tick& tick : ticks(chart.y.scale, frame.y.range, plot.height(), false)) {
            const double y = frame.y(tick.value);
            const char* css_class = axis_or_grid(frame.y, tick.value);
            (*css_class == 'a' ? zero : out) += line(plot.left, y, plot.right, y, css_class);
            out += "<text class='tick' x='" + unit(plot.left - 8) + "' y='" + unit(y + 5) +
                   "' text-anchor='end'>" + tick.markup + "</text>\n";
        }
    return out + zero;
}

}  // namespace nutshell::chart::parts
