// The pictures of chapter 2.
#include <nutshell/lab/run.hpp>
#include <nutshell/live/stills.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/picture/picture.hpp>
#include <nutshell/revised_newton_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace pic = picture;

namespace {

const pic::Colour water{0.337F, 0.706F, 0.914F}, stone = pic::palette::steel;

/// A drop's radius on the picture: true in proportion, far too large to be true.
double drop_radius(double mass, double full_mass) {
    return 1.3 * std::cbrt(mass / full_mass);
}

void raindrop_picture(lab::Report& report) {
    const Raindrop drop;
    const double dt = 0.1;
    const auto drops = lab::states_of(drop, methods::verlet, lab::steps_of(drop.duration, dt), 4);
    const double full = drops.back().mass;
    const auto note =
        pic::note_of(report.command(), drop, methods::verlet, dt,
                     {{"speed down at the end", -velocity(drops.back()).y(), "m/s"},
                      {"speed sideways at the end", velocity(drops.back()).x(), "m/s"},
                      {"position, off by", drop.error(drops.back(), drop.duration), "m"}});
    pic::save(report.path("raindrop.png"), note, [&]() -> pic::Sheet {
        pic::Drawing drawing;
        drawing.ground({.height = 0, .spacing = 5});
        for (int i = 0; i < 240;
             ++i) {  // the cloud: droplets on a low-discrepancy lattice, at rest
            const double a = std::fmod(0.7548776662466927 * i, 1),
                         b = std::fmod(0.5698402909980532 * i, 1);
            drawing.add(pic::Ball{.centre = {-5 + 17 * a, 3 + 52 * b, -2},
                                  .radius = 0.2,
                                  .colour = water,
                                  .look = pic::Look::ghost});
        }
        std::vector<Vector3> parabola;
        for (int i = 0; i <= 60; ++i) {
            const double t = 3.2 * i / 60;
            parabola.push_back(drop.start.position + velocity(drop.start) * t +
                               gravity * t * t / 2);
        }
        drawing.add(pic::Trail{
            .points = parabola, .colour = stone, .dashed = true, .width = 2.5, .shadow = false});
        for (const double t : {0.4, 0.8, 1.2, 1.6, 2.0, 2.4, 2.8}) {
            const Vector3 ghost =
                drop.start.position + velocity(drop.start) * t + gravity * t * t / 2;
            drawing.add(pic::Trail{.points = {drop.exact(t).position, ghost},
                                   .colour = stone,
                                   .width = 1.5,
                                   .shadow = false});
            drawing.add(pic::Ball{.centre = ghost,
                                  .radius = drop_radius(drop.m0, full),
                                  .colour = stone,
                                  .look = pic::Look::ghost});
        }
        std::vector<Vector3> path;
        for (const auto& state : drops) path.push_back(state.position);
        drawing.add(pic::Trail{.points = path, .colour = pic::palette::symplectic, .width = 2.5});
        for (const auto& state : drops)
            drawing.add(pic::Ball{.centre = state.position,
                                  .radius = drop_radius(state.mass, full),
                                  .colour = pic::palette::symplectic,
                                  .contact_shadow = true});
        drawing.add(pic::Label{.at = drops.back().position + Vector3(3.2, 0, 0),
                               .text = lab::rounded(1e6 * full, "%.0f mg")});
        drawing.add(pic::Label{.at = drops.front().position + Vector3(-3, 1, 0),
                               .text = lab::rounded(1e6 * drop.m0, "%.0f mg")});
        drawing.add(pic::Label{.at = parabola[42] + Vector3(3.6, 0, 0), .text = "no cloud"});
        drawing.title("Rain is slower than a stone")
            .caption("an image every 0.4 s; lines join the same instants");
        const pic::Size size{620, 800};
        return pic::Shot{drawing, pic::fit(drawing, {0.1, 0.12, 1}, size, {.margin = 0.05}),
                         size};
    });
}

}  // namespace

void pictures(lab::Report& report) {
    raindrop_picture(report);
    live::draw_stills(report);
}

}  // namespace nutshell
