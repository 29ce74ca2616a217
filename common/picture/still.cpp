// A picture that stands still: drawn with several samples a pixel, read back and averaged.
#include <stdexcept>

#include "studio.hpp"

namespace nutshell::picture {

namespace {

Image average(const std::vector<unsigned char>& samples, Size size, int n) {
    const int half = n * n / 2;
    Image image{size.width, size.height, {}};
    image.rgb.resize(3 * std::size_t(size.width) * std::size_t(size.height));
    const std::size_t row = 3 * std::size_t(size.width) * std::size_t(n);
    std::size_t out = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                int sum = half;
                for (int j = 0; j < n; ++j) {
                    const std::size_t first = row * std::size_t(y * n + j) + 3 * std::size_t(x * n) + c;
                    for (int i = 0; i < n; ++i) sum += samples[first + 3 * std::size_t(i)];
                }
                image.rgb[out++] = std::uint8_t(sum / (n * n));
            }
        }
    }
    return image;
}

}  // namespace

Image paint(Studio& studio, const Drawing& drawing, const Camera& camera, Size size, const Quality& quality) {
    const gl::Canvas canvas(size.width * quality.samples, size.height * quality.samples);
    draw(studio, drawing, camera, size, quality, [&] { canvas.use(); });
    const std::vector<unsigned char> samples = canvas.pixels();
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
        throw std::runtime_error("picture: OpenGL error " + std::to_string(error));
    }
    return average(samples, size, quality.samples);
}

}  // namespace nutshell::picture
