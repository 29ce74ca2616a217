// doctor_picture [--out DIR]: draws DIR/picture.png and says in one line what drew it.
// DIR is out/doctor unless given.
#include <iostream>

#include "nutshell/picture/picture.hpp"

int main(int argc, char** argv) {
    namespace pic = nutshell::picture;
    if (argc != 1 && (argc != 3 || std::string(argv[1]) != "--out")) {
        std::cerr << "usage: doctor_picture [--out DIR]\n";
        return 2;
    }
    const std::filesystem::path folder = argc == 3 ? argv[2] : "out/doctor";
    pic::Drawing drawing;
    drawing.title("Pictures work").caption("drawn by doctor_picture");
    drawing.add(pic::Ball{.centre = {-1.1, 0.5, 0}, .radius = 0.5, .colour = pic::palette::body});
    drawing.add(pic::Box{.pose = Eigen::Isometry3d(Eigen::Translation3d(0.5, 0.4, 0) *
                                                   Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY())),
                         .half_extents = {0.4, 0.4, 0.4}});
    drawing.add(pic::Arrow{.from = {-1.1, 0.5, 0}, .vector = {0.9, 0.9, 0}, .label = "v"});
    try {
        const pic::Image image = pic::render(drawing, pic::fit(drawing, {0.3, 0.5, 1}));
        pic::save(image, folder / "picture.png",
                  {.command = "doctor_picture --out " + folder.string(), .scene = "test picture"});
    } catch (const std::exception& problem) {
        std::cerr << "doctor_picture: " << problem.what() << "\n";
        return 1;
    }
    std::cout << pic::backend() << "; wrote " << (folder / "picture.png").string() << "\n";
}
