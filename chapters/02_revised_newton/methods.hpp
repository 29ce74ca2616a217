// How this chapter's parts report the least that meets a scene's need.
#pragma once
#include <nutshell/lab/work_chart.hpp>
#include <nutshell/newton_methods.hpp>

namespace nutshell {

/// Prints the ways to meet the scene's need and keeps their numbers as SCENE.METHOD.steps and so
/// on.
inline void report_ways(lab::Report& report, const std::string& scene, const Need& need,
                        const std::vector<lab::Choice>& ways) {
    const std::string needs =
        "Needs " + need.reason + " (" + lab::rounded(need.tolerance) + " " + need.unit + "). ";
    report.say(needs +
               (ways.empty()
                    ? "No method gives it, however small the step: look for a wrong formula."
                    : "The least that gives it:"));
    if (!ways.empty()) report.print(lab::ways_table(ways, need));
    report.number(scene + ".need", need.tolerance, need.unit);
    for (const auto& way : ways) {
        const std::string key = scene + "." + key_of(way.method);
        report.number(key + ".steps", static_cast<double>(way.run.steps));
        report.number(key + ".step", way.run.dt, "s");
        report.number(key + ".evaluations", static_cast<double>(way.run.evaluations));
        report.number(key + ".error", way.run.max_error, need.unit);
    }
}

}  // namespace nutshell
