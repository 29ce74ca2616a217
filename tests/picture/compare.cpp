#include "compare.hpp"

#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
#include <unistd.h>

#include <cmath>

using nutshell::picture::Image;

double difference(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height) return 255;
    const int square = 4;
    double sum = 0;
    int count = 0;
    for (int y = 0; y + square <= a.height; y += square) {
        for (int x = 0; x + square <= a.width; x += square) {
            for (int c = 0; c < 3; ++c, ++count) {
                int excess = 0;
                for (int j = 0; j < square; ++j) {
                    for (int i = 0; i < square; ++i)
                        excess += a.pixel(x + i, y + j)[c] - b.pixel(x + i, y + j)[c];
                }
                sum += std::abs(excess) / double(square * square);
            }
        }
    }
    return sum / count;
}

Image read_png(const std::filesystem::path& file) {
    Image image;
    int channels = 0;
    unsigned char* bytes = stbi_load(file.string().c_str(), &image.width, &image.height, &channels, 3);
    if (!bytes) throw std::runtime_error("cannot read " + file.string());
    image.rgb.assign(bytes, bytes + 3 * std::size_t(image.width) * std::size_t(image.height));
    stbi_image_free(bytes);
    return image;
}

std::filesystem::path own_path(const std::string& name) {
    return std::filesystem::temp_directory_path() / ("nutshell_" + std::to_string(getpid()) + "_" + name);
}

double grey(const Image& image, double x, double y) {
    const std::uint8_t* p = image.pixel(int(std::floor(x)), int(std::floor(y)));
    return (0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]) / 255;
}
