// The picture of chapter 6's question, and the stills of its moving figures, those of both
// halves.
#include <nutshell/live/stills.hpp>
#include <nutshell/pendulum_scenes.hpp>
#include <nutshell/picture/picture.hpp>
#include "lever_drawings.hpp"
#include "program.hpp"

namespace nutshell {

namespace {

/// Both pendulums held level, before they are let go.
void question(lab::Report& report) {
    const Pendulum bob = rod_pendulum(pi / 2), rod = compound_pendulum(pi / 2);
    const pic::Note note{report.command(),
                         "a bob on a thin rod and a heavy rod, held level",
                         "none yet",
                         "none",
                         {{"bob [kg]", bob.mass, "kg"}, {"rod [kg]", rod.mass, "kg"}}};
    pic::save(report.path("question.png"), note, [&]() -> pic::Sheet {
        const Vector3 left(0, 0, 0), right(1.6, 0, 0);
        pic::Drawing drawing;
        drawing.no_ground();
        for (const Vector3& nail : {left, right}) {
            add_nail(drawing, nail);
            drawing.add(pic::Trail{.points = {nail, nail + Vector3(0, -1.1, 0)},
                                   .colour = pic::palette::ink,
                                   .dashed = true,
                                   .width = 2});
        }
        add_bob(drawing, left, bob.start.orientation, 1, pic::palette::body);
        add_heavy_rod(drawing, right, rod.start.orientation, 1, pic::palette::gold);
        drawing.add(pic::Label{.at = {0.5, 0.14, 0}, .text = "bob, 1 kg"});
        drawing.add(pic::Label{.at = {2.1, 0.14, 0}, .text = "rod, 1 kg"});
        return pic::Shot{
            drawing, pic::fit(drawing, {0.1, 0.1, 1}, {840, 400}, {.margin = 0.05}), {840, 400}};
    });
}

}  // namespace

void pictures(lab::Report& report) {
    question(report);
    live::draw_stills(report);
}

}  // namespace nutshell
