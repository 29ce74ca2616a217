#include <nutshell/lab/need_chart.hpp>

#include <algorithm>
#include <cmath>
#include <nutshell/lab/work_chart.hpp>
#include <nutshell/require.hpp>
#include <nutshell/sentence.hpp>
#include <set>

namespace nutshell::lab {
namespace {

constexpr std::size_t most_coloured = 5;
constexpr double highest_shown = 300, lowest_shown = 1.0 / 3000;  // errors, in tolerances

bool timed(const std::vector<Least>& all) {
    return std::all_of(all.begin(), all.end(), [](const Least& least) {
        return !least.met || std::isfinite(least.run.seconds_per_second);
    });
}

std::string thin_spaced(long count) {
    std::string digits = std::to_string(count);
    for (std::size_t i = digits.size(); count >= 10'000 && i > 3; i -= 3) digits.insert(i - 3, "\u2009");
    return digits;
}

/// Three digits, and a power of ten as one writes it: 1e-05 is 10⁻⁵.
std::string written(double value) {
    const std::string text = rounded(value);
    const std::size_t e = text.find('e');
    if (e == std::string::npos) return text;
    static constexpr const char* digits[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                             "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    const int exponent = std::stoi(text.substr(e + 1));
    std::string power = exponent < 0 ? "10\u207b" : "10";
    for (const char c : std::to_string(std::abs(exponent))) power += digits[c - '0'];
    const std::string mantissa = text.substr(0, e);
    return mantissa == "1" ? power : mantissa + " \u00d7 " + power;
}

std::string who_needs_least(const std::vector<Least>& all) {
    require(!all.empty() && all.front().met, "finding: no method meets the need: there is no least");
    const Least& fewest = all.front();
    if (!timed(all)) return fewest.name + " needs least work";
    const Least* fastest = &fewest;
    for (const Least& least : all)
        if (least.met && least.run.seconds_per_second < fastest->run.seconds_per_second) fastest = &least;
    if (fastest == &fewest) return fewest.name + " needs least work and least time";
    return fewest.name + " asks for the force least, " + fastest->name + " is fastest";
}

}  // namespace

std::string finding(const std::vector<Least>& all) {
    return capital(who_needs_least(all));
}

chart::Ranking need_chart(const std::vector<Least>& all, const Need& need, const std::string& words,
                          const std::string& title) {
    chart::Ranking ranking;
    ranking.title = title.empty() ? finding(all) : title;
    ranking.subtitle = words + " Each with the largest step that keeps it within " + written(need.tolerance) +
                       " " + need.unit + ": " + need.reason + ".";
    const bool with_time = timed(all);
    ranking.columns = {"evaluations of the force"};
    if (with_time) ranking.columns.push_back("processor time for a simulated second [\u00b5s]");
    for (const Least& least : all) {
        chart::Ranking::Row row{least.name, least.look};
        if (least.met) {
            row.values = {static_cast<double>(least.run.evaluations)};
            if (with_time) row.values.push_back(1e6 * least.run.seconds_per_second);
            row.note = "dt = " + rounded(least.run.dt) + " s, " + std::to_string(least.run.steps) + " steps";
        } else {
            row.instead =
                "does not get there" + (std::isfinite(least.run.max_error)
                                            ? ": with " + thin_spaced(least.run.steps) + " steps still " +
                                                  written(least.run.max_error) + " " + need.unit + " off"
                                            : " within " + thin_spaced(least.run.steps) + " steps");
        }
        ranking.rows.push_back(std::move(row));
    }
    return ranking;
}

chart::Figure work_figure(const std::vector<Curve>& curves, const std::vector<Least>& all, const Need& need,
                          const std::string& title, const std::string& words,
                          const std::vector<double>& guides) {
    std::set<std::string> coloured;
    std::set<Family> families;
    for (const Least& least : all)
        if (coloured.size() < most_coloured && families.insert(least.look.family).second)
            coloured.insert(least.name);
    for (const Least& least : all)  // room left: the next best
        if (coloured.size() < most_coloured) coloured.insert(least.name);
    const double top = highest_shown * need.tolerance, bottom = lowest_shown * need.tolerance;
    chart::Figure figure{title, words, {}};
    for (const Cost cost : {Cost::evaluations, Cost::time}) {
        chart::Chart panel = work_precision_chart(curves, need, cost);
        panel.cut = true, panel.guides = guides, panel.height = 460;
        panel.y.from = bottom, panel.y.to = top;
        double least = INFINITY, most = 0;
        for (chart::Series& series : panel.series) {
            series.quiet = coloured.count(series.name) == 0;
            for (std::size_t i = 0; i < series.x.size(); ++i)
                if (series.x[i] > 0 && series.y[i] >= bottom && series.y[i] <= top)
                    least = std::min(least, series.x[i]), most = std::max(most, series.x[i]);
        }
        if (!(most > 0)) continue;  // not timed
        std::erase_if(panel.series,
                      [&](const chart::Series& series) {  // with a cost of nothing, or all beyond
                          for (std::size_t i = 0; i < series.x.size(); ++i)
                              if (series.x[i] > 0 && series.y[i] <= top) return false;
                          return true;
                      });
        for (chart::Series& series : panel.series)
            if (!series.quiet &&
                std::all_of(series.y.begin(), series.y.end(), [&](double y) { return y < bottom; }))
                series.name += ", below the chart";
        panel.x.from = least / 1.5, panel.x.to = most * 1.5;
        figure.panels.push_back(std::move(panel));
    }
    if (figure.panels.size() == 1) figure.width = 640;
    return figure;
}

void report_least(Report& report, const std::string& key, const std::vector<Least>& all, const Need& need) {
    const bool any = std::any_of(all.begin(), all.end(), [](const Least& least) { return least.met; });
    report.say("Needs " + need.reason + " (" + rounded(need.tolerance) + " " + need.unit + "). " +
               (any ? "The least that gives it:"
                    : "No method gives it, however small the step: look for a wrong formula."));
    if (any) report.print(least_table(all, need));
    const std::string chart = key + "_need.svg";
    report.number(key + ".need", need.tolerance, need.unit, chart);
    for (const Least& least : all) {
        if (!least.met) continue;
        const std::string name = key + "." + key_of(least.name);
        report.number(name + ".steps", static_cast<double>(least.run.steps), "", chart);
        report.number(name + ".step", least.run.dt, "s", chart);
        report.number(name + ".evaluations", static_cast<double>(least.run.evaluations), "", chart);
    }
}

void draw_study(Report& report, const Plan& plan, const std::vector<Curve>& curves,
                const std::vector<Least>& all, const Need& need) {
    require(
        std::any_of(curves.begin(), curves.end(), [](const Curve& curve) { return !curve.runs.empty(); }),
        "the study " + plan.key + ": its plan needs `steps`, how many each run makes (such as 10, 20, 40)");
    report.data(plan.key + ".csv", work_precision_data(curves));
    chart::Figure behind =
        work_figure(curves, all, need, plan.behind, plan.scene + " Down and left is better.", plan.guides);
    if (behind.panels.empty()) {
        report.say("Not drawn: no run comes within " + rounded(highest_shown) +
                   " times what is needed. Look for a wrong formula.");
        return;
    }
    chart::Ranking lead = need_chart(all, need, plan.scene, plan.lead);
    lead.columns.front() = behind.panels.front().x.name = plan.work;
    chart::write_svg(lead, report.path(plan.key + "_need.svg"));
    chart::write_svg(behind, report.path(plan.key + ".svg"));
}

}  // namespace nutshell::lab
