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

/// What a study says in words: `scene` for the subtitles ("Planet, three orbits."), `behind` as the title of
/// the error against the cost, the slopes of its guides, and a title of its own for the lead chart where the
/// finding will not do.
struct StudyWords {
    std::string key, scene, behind;
    std::vector<double> guides;
    std::string lead = {};
    std::string work = "evaluations of the force";  ///< what the first cost counts
};

/// Writes KEY_need.svg (what the need costs), KEY.svg (error against cost) and KEY.csv (all runs).
void draw_study(Report& report, const StudyWords& words, const std::vector<Curve>& curves,
                const std::vector<Least>& all, const Need& need);

}  // namespace nutshell::lab
