// The pictures of the second half that do not move: the question, a filmstrip of cubes.
#include <fstream>
#include <nutshell/picture/picture.hpp>
#include "piles_drawings.hpp"
#include "program.hpp"

namespace nutshell {

namespace {

void film(lab::Report& report, const std::string& file, const Pile& pile, int in_a_layer) {
    const std::array instants{0.0, 0.5, 1.0, 3.0};
    const pic::Note note{report.command(),
                         file,
                         "our engine",
                         "1/60 s",
                         {{"bodies", static_cast<double>(pile.start().bodies.size()), ""}}};
    pic::save(report.path(file + ".png"), note, [&]() -> pic::Sheet {
        pic::Sheet sheet;
        sheet.columns = 2;
        World world = pile.start();
        Engine engine(pile.switches);
        int steps = 0;
        for (const double at : instants) {
            for (; steps < std::lround(60 * at); ++steps) engine.step(world, 1 / 60.0);
            pic::Drawing drawing;
            const double half = pile.half_width();
            drawing.stage({{0, 1.2, 0}, 1.6 * half + 0.6});
            drawing.ground({.height = 0, .spacing = 0.5});
            add_room(drawing, half, 0.9);
            for (std::size_t i = 0; i < world.bodies.size(); ++i)
                add_body(drawing, world, i,
                         layer_colour(i / static_cast<std::size_t>(in_a_layer), 10));
            drawing.title(lab::rounded(at) + " s");
            pic::Drawing room;
            room.add(pic::Box{.pose = Eigen::Isometry3d(Eigen::Translation3d(0, 1.2, 0)),
                              .half_extents = {half, 1.2, half}});
            const pic::Size size{480, 480};
            sheet.shots.push_back(
                {drawing, pic::fit(room, {0.5, 0.35, 1}, size, {.margin = 0.03}), size});
        }
        return sheet;
    });
}

/// How many lines the engine has, if the sources are where `./course run` starts.
void count_lines(lab::Report& report) {
    double lines = 0;
    for (const char* name : {"shapes", "hull", "contacts", "box_contacts", "hull_contacts",
                             "contact_solver", "contact_memory", "grid", "sleep", "engine"}) {
        std::ifstream file(std::string("chapters/07_collisions/nutshell/") + name + ".hpp");
        for (std::string line; std::getline(file, line);) ++lines;
    }
    if (lines > 0) report.number("engine.lines", lines);
}

}  // namespace

void rest_pictures(lab::Report& report) {
    count_lines(report);
    // The comparison with Bullet is a program of its own (tests/peers), run after this one where
    // Bullet is installed. Until then a note stands where its charts will be.
    for (const std::string name : {"bullet_stack", "bullet_pile"}) {
        std::filesystem::path file = report.path(name + ".txt");
        write_file(file, "command: " + report.command() +
                             "\nnot drawn: the comparison with Bullet was not made in this run. "
                             "It needs Bullet (Debian: libbullet-dev)\n");
        std::filesystem::remove(file.replace_extension(".svg"));
    }
    const pic::Note note{report.command(), "the stack of the question", "none yet", "1/60 s", {}};
    pic::save(report.path("stack_question.png"), note, [&]() -> pic::Sheet {
        const World world = Stack{}.start();
        pic::Drawing drawing;
        drawing.ground({.height = 0, .spacing = 1});
        for (std::size_t i = 0; i < world.bodies.size(); ++i)
            add_body(drawing, world, i, layer_colour(i, 10));
        const pic::Size size{480, 600};
        return pic::Shot{drawing, pic::fit(drawing, {0.5, 0.22, 1}, size, {.margin = 0.05}),
                         size};
    });
    Pile cubes;
    cubes.cubes = true, cubes.wide = 6;
    film(report, "pile_cubes", cubes, 36);
}

}  // namespace nutshell
