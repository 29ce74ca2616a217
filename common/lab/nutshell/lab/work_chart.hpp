// From a study to its chart and its table, the same in every chapter.
#pragma once
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/output.hpp>
#include <nutshell/lab/study.hpp>

namespace nutshell::lab {

enum class Cost { evaluations, time };

/// A work-precision chart: largest error against cost, with the scene's need as tolerance line and the
/// cheapest way to meet it ringed. Title, subtitle and guides are the caller's to set.
chart::Chart work_precision_chart(const std::vector<Curve>& curves, const Need& need, Cost cost);

/// The same study as data: method, steps, dt, evaluations, max_error, final_error, seconds_per_second.
Table work_precision_data(const std::vector<Curve>& curves);

/// What it takes to meet the need, cheapest first: method, steps, dt, evaluations, error, time.
Table least_table(const std::vector<Least>& all, const Need& need);

}  // namespace nutshell::lab
