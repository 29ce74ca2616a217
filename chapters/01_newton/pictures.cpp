// The pictures of chapter 1, and the book's cover.
#include <nutshell/game_loop.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/live/stills.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/newton_scenes.hpp>
#include <nutshell/picture/picture.hpp>
#include "frames.hpp"
#include "program.hpp"

namespace nutshell {

namespace pic = picture;

namespace {

using Path = std::vector<Vector3>;

/// Positions after every `every`-th step.
template <class Scene, class Method>
Path path(const Scene& scene, const Method& method, long steps, long every = 1) {
    Path points;
    long n = 0;
    lab::run(scene, method, steps, [&](const PointMass& body, double) {
        if (n++ % every == 0) points.push_back(body.position);
    });
    return points;
}

template <class Scene>
Path exact_path(const Scene& scene, long pieces) {
    Path points;
    for (long n = 0; n <= pieces; ++n)
        points.push_back(
            scene.exact(scene.duration * static_cast<double>(n) / static_cast<double>(pieces))
                .position);
    return points;
}

void straight_line_picture(lab::Report& report) {
    const StraightLine scene;
    const pic::Note note{
        report.command(),
        "straight line",
        "Verlet",
        "0.5 s",
        {{"largest error", lab::measure(scene, methods::verlet, 8).max_error, "m"}}};
    pic::save(report.path("straight_line.png"), note, [&]() -> pic::Sheet {
        pic::Drawing drawing;
        pic::add(drawing, pic::Stroboscope{.computed = path(scene, methods::verlet, 8),
                                           .exact = {},
                                           .exact_path = {},
                                           .radius = 0.22});
        drawing.add(pic::Arrow{.from = scene.start.position + Vector3(0, 0.4, 0),
                               .vector = scene.start.velocity * 0.8,
                               .label = "v"});
        drawing.title("No force: the same distance in the same time")
            .caption("an image every 0.5 s");
        return pic::Shot{drawing, pic::fit(drawing, {0.2, 0.35, 1})};
    });
}

void throw_picture(lab::Report& report) {
    const ThrownBall scene;
    const long steps = 12;
    const double dt = scene.duration / steps;
    const pic::Note note{
        report.command(),
        "thrown ball",
        "Euler",
        lab::rounded(dt) + " s",
        {{"height above the exact path at the end",
          (lab::run(scene, methods::euler, steps).position - scene.exact(scene.duration).position)
              .y(),
          "m"}}};
    pic::save(report.path("throw.png"), note, [&]() -> pic::Sheet {
        pic::Drawing drawing;
        pic::add(drawing, pic::Stroboscope{.computed = path(scene, methods::euler, steps),
                                           .exact = exact_path(scene, steps),
                                           .exact_path = exact_path(scene, 100),
                                           .radius = 0.45,
                                           .colour = pic::palette::explicit_euler});
        drawing.ground({.height = -0.45, .spacing = 5});
        drawing.title("Euler's ball flies too high")
            .caption("solid: Euler, one step every 0.25 s.  ghost: exact");
        return pic::Shot{drawing, pic::fit(drawing, {0.12, 0.18, 1})};
    });
}

/// The last part of the throw on five machines: with a step that follows the frame, or with fixed
/// steps and drawing between them.
pic::Drawing landings(bool fixed_step) {
    const ThrownBall scene;
    const double from = 2.85;  // [s]
    pic::Drawing drawing;
    drawing.ground({.height = -1.1, .spacing = 1});
    Path exact;
    for (double t = from; t <= scene.duration; t += 0.005)
        exact.push_back(scene.exact(t).position);
    drawing.add(pic::Trail{.points = exact,
                           .colour = pic::palette::ink,
                           .dashed = true,
                           .width = 3,
                           .shadow = false});
    for (const Machine& machine : machines()) {
        Path points;
        play(machine, [&](const Shown& shown) {
            if (shown.time >= from) points.push_back(fixed_step ? shown.fixed : shown.following);
        });
        drawing.add(pic::Trail{.points = points, .colour = pic::palette::symplectic, .width = 3});
        drawing.add(pic::Ball{
            .centre = points.back(), .radius = 0.06, .colour = pic::palette::symplectic});
        const double side =
            machine.ragged > 0 ? -0.42 : 0.12;  // beside its ball, off the neighbour's
        if (!fixed_step)
            drawing.add(
                pic::Label{.at = points.back() + Vector3(side, 0, 0), .text = machine.label});
    }
    if (fixed_step)
        drawing.add(pic::Label{.at = scene.exact(scene.duration).position + Vector3(0.12, 0, 0),
                               .text = "all five"});
    return drawing;
}

void game_loop_picture(lab::Report& report) {
    const pic::Note note{report.command(),
                         "the end of a throw, on five machines",
                         "semi-implicit Euler",
                         "the frame's, or fixed 1/120 s",
                         {}};
    pic::save(report.path("game_loop.png"), note, [&]() -> pic::Sheet {
        const pic::Size half{640, 560};
        pic::Drawing left = landings(false), right = landings(true);
        const pic::Camera camera = pic::fit(left, {0.1, 0.12, 1}, half);
        left.title("step follows the frame"), right.title("fixed step, drawn between");
        return {{{left, camera, half}, {right, camera, half}}};
    });
}

void cover(lab::Report& report) {
    const long steps_an_orbit = 80;
    const double orbits_drawn = 26;
    const Planet scene = Planet::for_orbits(orbits_drawn);
    const pic::Note note{report.command(), "planet, e = 0.6", "Verlet", "1/80 orbit", {}};
    pic::save(report.path("cover.png"), note, [&]() -> pic::Sheet {
        const Path points =
            path(scene, methods::verlet, static_cast<long>(orbits_drawn) * steps_an_orbit);
        pic::Drawing drawing;
        drawing.ground({.height = -0.3, .normal = Vector3::UnitZ(), .spacing = 0.5, .unit = "a"});
        drawing.add(pic::Trail{.points = points,
                               .colour = pic::palette::symplectic,
                               .width = 2,
                               .opacity_at_start = 0.25});
        drawing.add(pic::Ball{
            .centre = {0, 0, 0}, .radius = 0.13, .colour = pic::palette::gold, .shines = true});
        const long last_orbit = static_cast<long>(points.size()) - steps_an_orbit;
        for (long n = last_orbit; n < static_cast<long>(points.size()); n += 4)
            drawing.add(pic::Ball{.centre = points[static_cast<std::size_t>(n)],
                                  .radius = 0.05,
                                  .colour = pic::palette::body});
        return pic::Shot{drawing,
                         pic::fit(drawing, {-0.4, -1.3, 0.8}, {1200, 560},
                                  {.margin = 0.03, .up = Vector3::UnitZ()}),
                         {1200, 560}};
    });
}

}  // namespace

void pictures(lab::Report& report) {
    straight_line_picture(report);
    throw_picture(report);
    live::draw_stills(report);
    game_loop_picture(report);
    cover(report);
}

}  // namespace nutshell
