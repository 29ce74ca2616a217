// What a chart must fulfil before it is drawn, and what is said when it does not.
#include <cmath>
#include <stdexcept>

#include "chart_parts.hpp"

namespace nutshell::chart::parts {
namespace {

std::string number_of(std::size_t n) {
    return std::to_string(n);
}

void check_axis(const Chart& chart, const Axis& axis, const char* which) {
    const auto refuse_axis = [&](const std::string& what) {
        refuse(chart, std::string("axis ") + which + " " + what);
    };
    for (const double end : {axis.from, axis.to}) {
        if (std::isinf(end)) refuse_axis("ends at infinity; give a finite end, or leave it automatic");
        if (axis.scale == Scale::logarithmic && end <= 0)
            refuse_axis("is logarithmic and ends at " + spoken(end) + "; give an end above zero");
        if (!std::isnan(end) && !can_show(axis.scale, end))
            refuse_axis("ends at " + spoken(end) + ", beyond 1e300 or below 1e-300");
    }
    if (axis.from >= axis.to)
        refuse_axis("goes from " + spoken(axis.from) + " to " + spoken(axis.to) + "; give from < to");
}

void check_level(const Chart& chart, const Axis& axis, double value, const std::string& what) {
    if (!can_show(axis.scale, value))
        refuse(chart,
               what + " is " + spoken(value) + ", which axis \"" + axis.name +
                   "\" cannot show; give a finite value within 1e300, above zero on a logarithmic axis");
}

void check_region(const Chart& chart, const Region& region) {
    const std::string name = "region \"" + region.name + "\" ";
    if (region.columns < 2 || region.rows < 2) refuse(chart, name + "needs a grid of at least 2 by 2");
    const auto wanted = static_cast<std::size_t>(region.columns) * static_cast<std::size_t>(region.rows);
    if (region.values.size() != wanted)
        refuse(chart, name + "has " + number_of(region.values.size()) + " values for a grid of " +
                          number_of(wanted));
    if (!(region.left < region.right && region.bottom < region.top) ||
        !std::isfinite(region.right - region.left) || !std::isfinite(region.top - region.bottom))
        refuse(chart, name + "needs finite left < right and bottom < top");
}

}  // namespace

void check(const Chart& chart) {
    if (chart.title.empty()) refuse(chart, "has no title; give it the question or the finding");
    if (chart.width < 200 || chart.height < 150) refuse(chart, "is too small; give at least 200 by 150");
    check_axis(chart, chart.x, "x"), check_axis(chart, chart.y, "y");
    if (chart.series.empty() && chart.regions.empty() && chart.bars.empty())
        refuse(chart, "has nothing to draw; give it series, regions or bars");
    if (!chart.bars.empty() && !(chart.series.empty() && chart.regions.empty()))
        refuse(chart, "has bars and something else; draw two charts");
    if (is_plane(chart) && (chart.x.scale == Scale::logarithmic || chart.y.scale == Scale::logarithmic))
        refuse(chart, "shows a plane (regions or equal_aspect) on a logarithmic axis; make both axes linear");
    if (!chart.guides.empty() && (chart.x.scale != Scale::logarithmic || chart.y.scale != Scale::logarithmic))
        refuse(chart,
               "has slope guides but not two logarithmic axes; make both logarithmic or drop the guides");
    for (const Series& s : chart.series) {
        const std::string name = "series \"" + s.name + "\" has ";
        if (s.x.size() != s.y.size())
            refuse(chart, name + number_of(s.x.size()) + " values of x and " + number_of(s.y.size()) +
                              " of y; give as many of each");
        if (s.x.empty()) refuse(chart, name + "no points; give it data or leave it out");
        if (!s.notes.empty() && s.notes.size() != s.x.size())
            refuse(chart, name + number_of(s.notes.size()) + " notes for " + number_of(s.x.size()) +
                              " points; give one each or none");
    }
    for (const Region& region : chart.regions) check_region(chart, region);
    for (const Bar& bar : chart.bars) {
        check_level(chart, chart.x, bar.value, "bar \"" + bar.name + "\"");
        if (!std::isnan(bar.floor))
            check_level(chart, chart.x, bar.floor, "the floor of bar \"" + bar.name + "\"");
    }
    for (const double slope : chart.guides)
        if (!std::isfinite(slope)) refuse(chart, "has a slope guide that is not finite");
    for (const Level& level : chart.levels_x)
        check_level(chart, chart.x, level.value, "level \"" + level.reason + "\"");
    for (const Level& level : chart.levels_y)
        check_level(chart, chart.y, level.value, "level \"" + level.reason + "\"");
    if (chart.tolerance) check_level(chart, chart.y, chart.tolerance->value, "the tolerance");
    for (const Ring& ring : chart.rings) {
        check_level(chart, chart.x, ring.x, "ring \"" + ring.text + "\"");
        check_level(chart, chart.y, ring.y, "ring \"" + ring.text + "\"");
    }
}

void check(const Ranking& ranking) {
    const std::string& name = ranking.name.empty() ? ranking.title : ranking.name;
    if (ranking.title.empty()) refuse(name, "has no title; give it the question or the finding");
    if (ranking.columns.empty() || ranking.rows.empty())
        refuse(name, "has nothing to rank; give it columns and rows");
    for (const Ranking::Row& row : ranking.rows) {
        if (row.values.empty() != !row.instead.empty() ||
            (!row.values.empty() && row.values.size() != ranking.columns.size()))
            refuse(name, "row \"" + row.name + "\" has " + number_of(row.values.size()) + " values for " +
                             number_of(ranking.columns.size()) +
                             " columns; give one each, or none and the words that stand instead");
        for (const double value : row.values)
            if (value != 0 && !can_show(Scale::logarithmic, value))
                refuse(name, "row \"" + row.name + "\" has the value " + spoken(value) +
                                 "; a cost is finite and not negative");
    }
}

void refuse(const std::string& name, const std::string& what) {
    throw std::invalid_argument("chart \"" + name + "\": " + what);
}

void refuse(const Chart& chart, const std::string& what) {
    refuse(chart.name.empty() ? chart.title : chart.name, what);
}

}  // namespace nutshell::chart::parts
