#include "png.hpp"

#include <stb_image_write.h>

namespace nutshell::picture {

namespace {

void collect(void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), std::size_t(size));
}

}  // namespace

std::string jpeg(const Image& image) {
    const int quality = 91;  // above 90 stb keeps colours as fine as light
    std::string bytes;
    if (!stbi_write_jpg_to_func(collect, &bytes, image.width, image.height, 3, image.rgb.data(), quality)) {
        throw std::runtime_error("picture: the JPEG writer failed");
    }
    return bytes;
}

std::string png(const Image& image) {
    std::string bytes;
    if (!stbi_write_png_to_func(collect, &bytes, image.width, image.height, 3, image.rgb.data(),
                                3 * image.width)) {
        throw std::runtime_error("picture: the PNG writer failed");
    }
    return bytes;
}

}  // namespace nutshell::picture
