#pragma once
#include <string>

#include "nutshell/picture/image.hpp"

namespace nutshell::picture {

/// The image as the bytes of a PNG file.
std::string png(const Image& image);

/// As the bytes of a JPEG file: a sixth of a PNG's weight where there is soft light, no difference to the
/// eye.
std::string jpeg(const Image& image);

}  // namespace nutshell::picture
