// How pictures are compared in tests.
#pragma once
#include <filesystem>
#include <string>

#include "nutshell/picture/image.hpp"

/// Mean absolute difference of the two, each averaged over squares of 4 x 4 pixels [levels of 255].
/// Averaging makes a line that moved by half a pixel small and a thing that moved by a few pixels large.
double difference(const nutshell::picture::Image& a, const nutshell::picture::Image& b);

nutshell::picture::Image read_png(const std::filesystem::path& file);

/// A name of this process alone in the temporary folder: tests run beside each other.
std::filesystem::path own_path(const std::string& name);

/// Lightness of a pixel as a grey screen shows it, 0 to 1.
double grey(const nutshell::picture::Image& image, double x, double y);
