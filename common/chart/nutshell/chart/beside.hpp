// A second run's charts beside those of a first: what a learner's code draws, with the reference as a ghost.
#pragma once
#include <filesystem>
#include <string>

namespace nutshell::chart {

/// From now on write_svg keeps the points of every chart and figure in this folder too, as NAME.points.
void keep_points(const std::filesystem::path& folder);

/// From now on every chart that write_svg writes is compared with the points that `folder` keeps of it. A
/// curve that differs is called "NAME, yours", with the kept one behind it as a pale ghost, cut to the axes
/// of the chart; the subtitle says `whose` ("your 2.4").
void draw_beside(const std::filesystem::path& folder, const std::string& whose);

}  // namespace nutshell::chart
