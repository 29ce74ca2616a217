// What comes out of a study: what its need costs (the lead chart), behind it the error against the cost, and
// the numbers.
#pragma once
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/output.hpp>
#include <nutshell/lab/study.hpp>

namespace nutshell::lab {

/// Who needs least, in a sentence that agrees with the data: "Verlet needs least work and least time".
/// @throws std::invalid_argument if no method meets the need
std::string finding(const std::vector<Least>& all);

/// What the need costs: the methods ranked by force evaluations, their processor time beside it where it was
/// measured. The title is the finding unless one is given; `words` say which scene and how long.
chart::Ranking need_chart(const std::vector<Least>& all, const Need& need, const std::string& words,
                          const std::string& title = {});

/// Error against cost: a panel for evaluations and, where they were timed, one for processor time. The best
/// method of each family is drawn in its colour, then the next best, five in all, the others thin and grey;
/// the range is what the need asks, from 300 times its tolerance to a 3000th of it.
chart::Figure work_figure(const std::vector<Curve>& curves, const std::vector<Least>& all, const Need& need,
                          const std::string& title, const std::string& words,
                          const std::vector<double>& guides);

/// Prints what the need takes, and keeps it: KEY.need, and KEY.METHOD.steps, .step, .evaluations.
void report_least(Report& report, const std::string& key, const std::vector<Least>& all, const Need& need);

/// Prints the observed order of each method with these numbers of steps, and keeps it: KEY.METHOD.order. Not
/// of those whose last error is below `round_off`, which has none.
template <class Scene>
void report_orders(Report& report, const std::string& key, const Scene& scene,
                   const std::vector<Entry<Scene>>& methods, const std::vector<long>& steps,
                   double round_off = 0) {
    Table table{{"method", {"order", "%.2f"}}, {}};
    for (const auto& method : methods) {
        if (method.measure(scene, steps.back()).max_error < round_off) continue;
        const double order = order_of(scene, method, steps);
        table.add({method.name, order});
        report.number(key + "." + key_of(method.name) + ".order", order, "", "printed");
    }
    report.print(table);
}

using StudyWords = Plan;

/// Writes KEY_need.svg (what the need costs), KEY.svg (error against cost) and KEY.csv (all runs).
/// @throws std::invalid_argument if no curve has a run
void draw_study(Report& report, const Plan& plan, const std::vector<Curve>& curves,
                const std::vector<Least>& all, const Need& need);

/// A whole study: table and numbers as report_least, charts and data as draw_study. Scene, methods and need
/// in; table, data, charts and numbers out.
template <class Scene, class Methods>
Study study(Report& report, const Scene& scene, const Methods& methods, const Plan& plan) {
    Study all = measured(scene, methods, plan);
    report_least(report, plan.key, all.least, scene.need);
    draw_study(report, plan, all.curves, all.least, scene.need);
    return all;
}

}  // namespace nutshell::lab
