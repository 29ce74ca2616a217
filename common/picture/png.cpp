#include "png.hpp"

#include <stb_image_write.h>

namespace nutshell::picture {

std::string png(const Image& image) {
    std::string bytes;
    auto collect = [](void* to, void* data, int size) {
        static_cast<std::string*>(to)->append(static_cast<const char*>(data), std::size_t(size));
    };
    if (!stbi_write_png_to_func(collect, &bytes, image.width, image.height, 3, image.rgb.data(),
                                3 * image.width)) {
        throw std::runtime_error("picture: the PNG writer failed");
    }
    return bytes;
}

}  // namespace nutshell::picture
