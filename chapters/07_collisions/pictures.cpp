// The picture of chapter 7's question, and the stills of its moving figures.
#include <nutshell/bouncing_ball.hpp>
#include <nutshell/live/stills.hpp>
#include <nutshell/picture/picture.hpp>
#include "drawings.hpp"
#include "program.hpp"

namespace nutshell {

void pictures(lab::Report& report) {
    live::draw_stills(report);
    const BouncingBall scene;
    const pic::Note note{report.command(),
                         "the bouncing ball of the question",
                         "exact",
                         "3/40 s",
                         {{"restitution", scene.restitution, ""}}};
    pic::save(report.path("question.png"), note, [&]() -> pic::Sheet {
        pic::Drawing drawing;
        drawing.ground({.height = 0, .spacing = 0.5});
        pic::Trail path{.points = {}, .colour = pic::palette::body, .width = 3};
        for (int i = 0; i <= 360; ++i) {
            const double t = i / 120.0;
            const Vector3 at(t, scene.exact(t).position.y(), 0);
            path.points.push_back(at);
            if (i % 9 == 0)
                drawing.add(pic::Ball{.centre = at,
                                      .radius = scene.ball.radius,
                                      .colour = pic::palette::body,
                                      .contact_shadow = true});
        }
        drawing.add(path);
        return pic::Shot{
            drawing, pic::fit(drawing, {0, 0.12, 1}, {960, 400}, {.margin = 0.04}), {960, 400}};
    });
}

}  // namespace nutshell
