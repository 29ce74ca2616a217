#include <nutshell/lab/work_chart.hpp>

namespace nutshell::lab {

chart::Chart work_precision_chart(const std::vector<Curve>& curves, const Need& need, Cost cost) {
    chart::Chart chart;
    chart.x = {
        cost == Cost::evaluations ? "evaluations of the force" : "processor time per simulated second [s]",
        chart::Scale::logarithmic};
    chart.y = {"largest error [" + need.unit + "]", chart::Scale::logarithmic};
    chart.tolerance = chart::Level{need.tolerance, need.reason};
    chart.ring_cheapest = true;
    for (const auto& curve : curves) {
        chart::Series series{curve.name};
        series.look = curve.look;
        for (const auto& run : curve.runs) {
            series.x.push_back(cost == Cost::evaluations ? static_cast<double>(run.evaluations)
                                                         : run.seconds_per_second);
            series.y.push_back(run.max_error);
            series.notes.push_back("dt = " + rounded(run.dt) + " s, " + std::to_string(run.steps) + " steps");
        }
        chart.series.push_back(std::move(series));
    }
    return chart;
}

Table work_precision_data(const std::vector<Curve>& curves) {
    Table table{{"method", "steps", "dt", "evaluations", "max_error", "final_error", "seconds_per_second"},
                {}};
    for (const auto& curve : curves)
        for (const auto& run : curve.runs)
            table.add({curve.name, run.steps, run.dt, run.evaluations, run.max_error, run.final_error,
                       run.seconds_per_second});
    return table;
}

Table least_table(const std::vector<Least>& all, const Need& need) {
    Table table{
        {"method", "steps", "dt [s]", "evaluations", "error [" + need.unit + "]", "µs per simulated s"}, {}};
    for (const auto& [name, look, run, met] : all)
        if (met)
            table.add(
                {name, run.steps, run.dt, run.evaluations, run.max_error, 1e6 * run.seconds_per_second});
    return table;
}

}  // namespace nutshell::lab
