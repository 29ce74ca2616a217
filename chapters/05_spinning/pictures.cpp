// The picture of chapter 5's question, and the stills of its moving figures.
#include <nutshell/live/stills.hpp>
#include <nutshell/picture/picture.hpp>
#include "drawings.hpp"
#include "program.hpp"

namespace nutshell {

void pictures(lab::Report& report) {
    live::draw_stills(report);
    const SpinningWheel wheel = SpinningWheel::s6_fast();
    const pic::Note note{report.command(),
                         "the wheel of the question",
                         "none yet",
                         "1/60 s",
                         {{"turns a second", 20, ""}}};
    pic::save(report.path("question.png"), note, [&]() -> pic::Sheet {
        // its axle lies along the axis of the spin
        const Vector3 n = direction_of(wheel.axis);
        const Quaternion pose(Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), n));
        pic::Drawing drawing;
        drawing.no_ground();
        add_wheel(drawing, pose, {0, 0, 0}, 1, 8, pic::palette::body, true);
        drawing.add(pic::Rod{.from = -0.6 * n, .to = 0.6 * n, .radius = 0.05});
        drawing.add(pic::Arrow{.from = 0.6 * n,
                               .vector = 0.8 * n,
                               .colour = pic::palette::angular_velocity,
                               .label = "ω, 20 turns a second"});
        return pic::Shot{
            drawing, pic::fit(drawing, {1.2, 0.1, 1}, {800, 420}, {.margin = 0.05}), {800, 420}};
    });
}

}  // namespace nutshell
