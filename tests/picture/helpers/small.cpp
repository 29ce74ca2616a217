// picture_small FILE.png: draws the small scene, twice; prints what drew it.
#include <iostream>

#include "../small_scene.hpp"

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const nutshell::picture::Image image = small_scene::image(), again = small_scene::image();
    nutshell::picture::save(image, argv[1], {});
    std::cout << nutshell::picture::backend() << "\n";
    return image.rgb == again.rgb ? 0 : 1;
}
