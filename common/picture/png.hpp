#pragma once
#include <string>

#include "nutshell/picture/image.hpp"

namespace nutshell::picture {

/// The image as the bytes of a PNG file.
std::string png(const Image& image);

}  // namespace nutshell::picture
