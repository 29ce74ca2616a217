// Stands in for all drawing where a package was missing when this was configured: the course goes on without
// pictures.
#include "nutshell/picture/render.hpp"

#include "nutshell/picture/sheet.hpp"
#include "png.hpp"

namespace nutshell::picture {

namespace {

std::string reason() {
    return "this build cannot draw: missing " PICTURE_MISSING;
}

}  // namespace

Image render(const Drawing&, const Camera&, Size, const Quality&) {
    throw NoGraphics(reason());
}
Image render_bare(const Drawing&, const Camera&, Size, const Quality&) {
    throw NoGraphics(reason());
}
Printed print(const Sheet&, const std::string&) {
    throw NoGraphics(reason());
}
Image side_by_side(const Image&, const Image&, const std::string&, const std::string&) {
    throw NoGraphics(reason());
}
Image filmstrip(const std::vector<Image>&, const std::vector<std::string>&, int) {
    throw NoGraphics(reason());
}
std::string png(const Image&) {
    throw NoGraphics(reason());
}
bool available() {
    return false;
}
std::string backend() {
    return reason();
}

}  // namespace nutshell::picture
