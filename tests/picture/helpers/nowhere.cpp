// Built without graphics: a program that draws must go on, leave a note with the reason, and no picture.
#include <unistd.h>

#include <fstream>
#include <iostream>
#include <iterator>

#include "nutshell/picture/picture.hpp"

int main() {
    namespace pic = nutshell::picture;
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("nutshell_nowhere_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "a.png") << "of an earlier run";
    pic::Drawing drawing;
    drawing.add(pic::Ball{});
    const bool drawn = pic::save(folder / "a.png", {.command = "this"}, [&] {
        return pic::render(drawing, pic::fit(drawing, {0, 0, 1}));
    });
    std::ifstream in(folder / "a.txt");
    const std::string note(std::istreambuf_iterator<char>(in), {});
    const bool picture_left = std::filesystem::exists(folder / "a.png");
    std::filesystem::remove_all(folder);
    const bool good = !drawn && !picture_left && !pic::available() &&
                      note == "not drawn: this build cannot draw: missing a package\ncommand: this\n";
    if (!good) std::cout << "drawn " << drawn << ", picture left " << picture_left << ", note:\n" << note;
    return good ? 0 : 1;
}
