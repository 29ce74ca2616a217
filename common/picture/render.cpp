#include "nutshell/picture/render.hpp"

#include <mutex>
#include <stdexcept>

#include "studio.hpp"
#include "words.hpp"

namespace nutshell::picture {

namespace {

std::mutex& studio_door() {
    static std::mutex door;
    return door;
}

/// The one studio, for whoever holds the lock.
Studio& the_studio(const std::lock_guard<std::mutex>&) {
    static Studio studio;
    return studio;
}

}  // namespace

Image render_bare(const Drawing& drawing, const Camera& camera, Size size, const Quality& quality) {
    const int most = 4096;
    if (size.width < 1 || size.height < 1 || size.width > most || size.height > most) {
        throw std::invalid_argument("picture: a size must be 1 to 4096 pixels each way, not " +
                                    std::to_string(size.width) + " x " + std::to_string(size.height));
    }
    if (quality.samples < 1 || quality.samples > 4 || quality.shadow_map < 16 || quality.shadow_map > 8192) {
        throw std::invalid_argument(
            "picture: quality must be 1 to 4 samples and a shadow map of 16 to 8192 texels");
    }
    check(camera);
    const std::lock_guard<std::mutex> lock(studio_door());
    the_studio(lock).context.use();
    return paint(the_studio(lock), drawing, camera, size, quality);
}

Image render(const Drawing& drawing, const Camera& camera, Size size, const Quality& quality) {
    Image image = render_bare(drawing, camera, size, quality);
    write_words(image, place_words(drawing, camera, size), drawing.theme());
    return image;
}

bool available() {
    try {
        const std::lock_guard<std::mutex> lock(studio_door());
        the_studio(lock);
        return true;
    } catch (const std::exception&) {
        return false;
    }
}

std::string backend() {
    try {
        const std::lock_guard<std::mutex> lock(studio_door());
        the_studio(lock).context.use();
        auto name = [](GLenum what) { return std::string(reinterpret_cast<const char*>(glGetString(what))); };
        return Context::name() + ": " + name(GL_RENDERER) + ", OpenGL " + name(GL_VERSION);
    } catch (const std::exception& problem) {
        return problem.what();
    }
}

}  // namespace nutshell::picture
