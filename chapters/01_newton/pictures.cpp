// The pictures of chapter 1, and the book's cover.
#include <nutshell/lab/run.hpp>
#include <nutshell/live/stills.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/newton_scenes.hpp>
#include <nutshell/picture/picture.hpp>
#include "program.hpp"

namespace nutshell {

namespace pic = picture;

namespace {

using Path = std::vector<Vector3>;

template <class Scene, class Method>
Path path(const Scene& scene, const Method& method, long steps) {
    Path points;
    for (const PointMass& body : lab::states_of(scene, method, steps))
        points.push_back(body.position);
    return points;
}

void straight_line_picture(lab::Report& report) {
    const StraightLine scene;
    const double dt = 0.5;
    const long steps = lab::steps_of(scene.duration, dt);
    const auto note = pic::note_of(
        report.command(), scene, methods::verlet, dt,
        {{"largest error", lab::measure(scene, methods::verlet, steps).max_error, "m"}});
    pic::save(report.path("straight_line.png"), note, [&]() -> pic::Sheet {
        pic::Drawing drawing;
        pic::add(drawing, pic::Stroboscope{.computed = path(scene, methods::verlet, steps),
                                           .exact = {},
                                           .exact_path = {},
                                           .radius = 0.22});
        drawing.add(pic::Arrow{.from = scene.start.position + Vector3(0, 0.4, 0),
                               .vector = scene.start.velocity * 0.8,
                               .label = "v"});
        drawing.title("No force: the same distance in the same time")
            .caption("an image every " + lab::rounded(dt) + " s");
        return pic::Shot{drawing, pic::fit(drawing, {0.2, 0.35, 1})};
    });
}

void cover(lab::Report& report) {
    const long steps_an_orbit = 80;
    const double orbits_drawn = 26;
    const Planet scene = Planet::for_orbits(orbits_drawn);
    const auto note =
        pic::note_of(report.command(), scene, methods::verlet, 2 * pi / steps_an_orbit);
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
    live::draw_stills(report);
    cover(report);
}

}  // namespace nutshell
