// The picture of the second half's question, and its diagrams.
#include <nutshell/chart/diagram.hpp>
#include <nutshell/picture/picture.hpp>
#include "program.hpp"
#include "top_drawings.hpp"

namespace nutshell {

namespace {

/// The handle as it is let go, seen from the front: what turns, about which axis.
void question(lab::Report& report) {
    const FreeBody scene = flip();
    const pic::Note note{report.command(),
                         "the handle of the question",
                         "none yet",
                         "1/60 s",
                         {{"spin about the stem", 2, "rad/s"}}};
    pic::save(report.path("tops_question.png"), note, [&]() -> pic::Sheet {
        pic::Drawing drawing;
        drawing.no_ground();
        const Quaternion q = exponential({0, -0.35, 0});
        add_handle(drawing, q, {0, 0, 0}, pic::palette::body);
        drawing.add(pic::Arrow{.from = {0, 0.75, 0},
                               .vector = {0, 0.6, 0},
                               .colour = pic::palette::angular_velocity,
                               .label = "ω, nearly along the stem"});
        std::vector<Vector3> round;
        for (int i = 0; i <= 48; ++i) {
            const double a = -0.3 * pi + 1.6 * pi * i / 48;
            round.push_back({0.35 * std::sin(a), 1.0, 0.35 * std::cos(a)});
        }
        drawing.add(
            pic::Trail{.points = round, .colour = pic::palette::angular_velocity, .width = 4});
        pic::Drawing room;
        room.add(pic::Ball{.centre = {0, 0.5, 0}, .radius = 1.08});
        return pic::Shot{
            drawing, pic::fit(room, {0.35, 0.3, 1}, {800, 420}, {.margin = 0.02}), {800, 420}};
    });
}

/// Two instants of a body whose L stands still: seen from the world, and seen from the body.
void seen_from_both(lab::Report& report) {
    chart::Diagrams both;
    both.title = "One motion, two points of view";
    both.subtitle = "The box turns by θ. In the world L stays; in the box it turns back by θ.";
    const double angle = 0.5, tilt = 1.2;
    for (const bool in_world : {true, false}) {
        chart::Diagram d;
        d.title = in_world ? "seen from the world" : "seen from the body";
        const double now = in_world ? angle : 0;
        d.box({0, 0}, 2.4, 1.2, 0);
        if (in_world) d.as_ghost(), d.box({0, 0}, 2.4, 1.2, now);
        d.axes({0, 0}, now, 0.95, "x", "y");
        const auto arrow = [&](double direction, const char* name) {
            d.arrow({0, 0}, {2.1 * std::cos(direction), 2.1 * std::sin(direction)},
                    chart::Quantity::angular_momentum, name);
        };
        if (in_world) {
            arrow(tilt, "L, now and before");
            d.angle({0, 0}, 1.45, 0, angle, "θ");
        } else {
            arrow(tilt, "M before");
            arrow(tilt - angle, "M now");
            d.angle({0, 0}, 1.45, tilt - angle, tilt, "θ");
        }
        both.panels.push_back(d);
    }
    chart::write_svg(both, report.path("two_views.svg"));
}

/// A heavy top from the side and from above, with the numbers of scene S8.
void torque_of_a_top(lab::Report& report) {
    const Top top = standard_top();
    const double lean = pi / 6, l = 0.5, L = 3, torque = top.weight * std::sin(lean);
    chart::Diagrams both;
    both.title = "The weight pulls L round, not down";
    both.subtitle = "The top leans by 30°. Forces 0.05 m for a newton, L 0.3 m for a kg m²/s.";
    chart::Diagram side;
    side.title = "from the side";
    const chart::Place c{l * std::sin(lean), l * std::cos(lean)};
    const chart::Place end{1.35 * c.x, 1.35 * c.y};
    side.rod({0, 0}, end);
    side.box(c, 0.894, 0.346, -lean);
    side.wall({0.3, -0.02}, {-0.3, -0.02});
    side.centre(c);
    side.dashed({{0, 0}, {c.x, 0}, c});
    side.dimension({0, -0.16}, {c.x, -0.16}, "l sin θ = 0.25 m");
    side.arrow(c, {0, -0.05 * top.weight / l}, chart::Quantity::force,
               "m g = " + lab::rounded(top.weight / l) + " N");
    side.arrow({0, 0}, {0.3 * L * std::sin(lean), 0.3 * L * std::cos(lean)},
               chart::Quantity::angular_momentum, "L");
    side.angle({0, 0}, 0.3, pi / 2 - lean, pi / 2, "θ");
    side.note({-0.62, 0.35}, "τ points away from you");
    chart::Diagram above;
    above.title = "from above";
    const double flat = 0.3 * L * std::sin(lean);
    std::vector<chart::Place> circle;
    for (int i = 0; i <= 64; ++i)
        circle.push_back({flat * std::cos(2 * pi * i / 64), flat * std::sin(2 * pi * i / 64)});
    above.path(circle);
    above.arrow({0, 0}, {flat, 0}, chart::Quantity::angular_momentum, "L sin θ");
    above.arrow({flat, 0}, {0, 0.12 * torque}, chart::Quantity::torque,
                "τ = m g l sin θ = 2.45 N m");
    above.arc({0, 0}, 0.2, 0, 1.2, chart::Quantity::angular_velocity, "Ω");
    both.panels = {side, above};
    chart::write_svg(both, report.path("top_torque.svg"));
    report.number("diagram.torque", torque, "N m");
}

}  // namespace

void top_pictures(lab::Report& report) {
    question(report);
    seen_from_both(report);
    torque_of_a_top(report);
}

}  // namespace nutshell
