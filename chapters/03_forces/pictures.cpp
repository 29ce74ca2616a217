// The pictures of chapter 3 that show one body.
#include <nutshell/picture/picture.hpp>
#include "entries.hpp"
#include "program.hpp"

namespace nutshell {

namespace pic = picture;

namespace {

using Path = std::vector<Vector3>;

/// Height against time, as a pen on a strip of paper draws it: `stretch` metres to the right for
/// each second.
template <class Method>
Path strip(const MassOnSpring& scene, const Method& method, double dt, int steps,
           double stretch) {
    Path points;
    auto step = method.start(scene);
    PointMass s = scene.start;
    for (int n = 0; n <= steps; ++n) {
        points.push_back({stretch * n * dt, s.position.x(), 0});
        s = step(s, scene, n * dt, dt);
    }
    return points;
}

Path exact_strip(const MassOnSpring& scene, double duration, int pieces, double stretch) {
    Path points;
    for (int n = 0; n <= pieces; ++n)
        points.push_back({stretch * duration * n / pieces,
                          scene.exact(duration * n / pieces).position.x(), 0});
    return points;
}

void limit_picture(lab::Report& report) {
    const MassOnSpring scene;
    const double limit = 2 / scene.omega();
    const int steps = 8;
    const auto far = [&](double part) {
        return std::abs(strip(scene, methods::verlet, part * limit, steps, 1).back().y());
    };
    double largest = 0;
    for (const Vector3& p : strip(scene, methods::verlet, 1.01 * limit, steps, 1))
        largest = std::max(largest, std::abs(p.y()));
    report.number("picture.limit.largest", largest, "m");
    const pic::Note note{
        report.command(),
        "mass on a spring",
        "Verlet",
        "0.99 and 1.01 times 2/omega",
        {{"stretch after 8 steps at 0.99", far(0.99), "m"}, {"at 1.01", far(1.01), "m"}}};
    pic::save(report.path("limit.png"), note, [&]() -> pic::Sheet {
        const pic::Size half{640, 500};
        const auto drawing_of = [&](double part) {
            pic::Drawing drawing;
            drawing.no_ground();
            const Path points = strip(scene, methods::verlet, part * limit, steps, 4);
            drawing.add(pic::Trail{.points = points,
                                   .colour = pic::palette::symplectic,
                                   .width = 2.5,
                                   .shadow = false});
            for (const Vector3& p : points)
                drawing.add(
                    pic::Ball{.centre = p, .radius = 0.22, .colour = pic::palette::symplectic});
            drawing.add(pic::Trail{.points = {{0, 1, 0}, {4 * limit * steps, 1, 0}},
                                   .colour = pic::palette::ink,
                                   .dashed = true,
                                   .width = 2,
                                   .shadow = false});
            drawing.add(pic::Trail{.points = {{0, -1, 0}, {4 * limit * steps, -1, 0}},
                                   .colour = pic::palette::ink,
                                   .dashed = true,
                                   .width = 2,
                                   .shadow = false});
            return drawing;
        };
        pic::Drawing left = drawing_of(0.99), right = drawing_of(1.01);
        left.title("0.99 of the limit"), right.title("1.01 of the limit");
        const pic::Camera camera = pic::fit(right, {0, 0.05, 1}, half);
        return {{{left, camera, half}, {right, camera, half}}};
    });
}

void damped_picture(lab::Report& report) {
    const MassOnSpring scene = MassOnSpring::with_damping(0.1);
    const double dt = 1.0 / 8;
    const int steps = 24;
    const double stretch = 1.6;
    double naive_off = 0, good_off = 0;
    const Path naive = strip(scene, methods::verlet, dt, steps, stretch),
               good = strip(scene, methods::exponential_verlet, dt, steps, stretch);
    const Path exact = exact_strip(scene, dt * steps, steps, stretch);
    for (std::size_t i = 0; i < exact.size(); ++i)
        naive_off = std::max(naive_off, (naive[i] - exact[i]).norm()),
        good_off = std::max(good_off, (good[i] - exact[i]).norm());
    report.number("picture.damped.naive", naive_off, "m");
    report.number("picture.damped.exponential", good_off, "m");
    const pic::Note note{report.command(),
                         "damped spring, ratio 0.1",
                         "Verlet with drag in the kick; exponential Verlet",
                         "1/8 s",
                         {{"largest error, drag in the kick", naive_off, "m"},
                          {"exponential half-kicks", good_off, "m"}}};
    pic::save(report.path("damped_spring.png"), note, [&]() -> pic::Sheet {
        const pic::Size half{640, 340};
        const auto drawing_of = [&](const Path& points, pic::Colour colour) {
            pic::Drawing drawing;
            drawing.no_ground();
            pic::add(drawing,
                     pic::Stroboscope{.computed = points,
                                      .exact = exact,
                                      .exact_path = exact_strip(scene, dt * steps, 300, stretch),
                                      .radius = 0.07,
                                      .colour = colour});
            return drawing;
        };
        pic::Drawing left = drawing_of(naive, pic::palette::symplectic),
                     right = drawing_of(good, pic::palette::exponential);
        const pic::Camera camera = pic::fit(left, {0, 0.05, 1}, half);
        left.title("drag in the kick"), right.title("exponential half-kicks");
        return {{{left, camera, half}, {right, camera, half}}};
    });
}

void throws_picture(lab::Report& report) {
    ThrowInAir none, honey, air;
    none.air = 0;
    honey.air = 0, honey.drag = air.air * air.start.velocity.norm();
    const pic::Note note{
        report.command(),
        "throw with three models of drag",
        "exact",
        "0.25 s between images",
        {{"no drag, off at 2.5 s", distance(none.exact(2.5), air.exact(2.5)), "m"},
         {"linear drag, off at 2.5 s", distance(honey.exact(2.5), air.exact(2.5)), "m"}}};
    pic::save(report.path("throws.png"), note, [&]() -> pic::Sheet {
        pic::Drawing drawing;
        drawing.ground({.height = -0.5, .spacing = 5});
        const auto add = [&](const ThrowInAir& scene, const char* words, pic::Colour colour) {
            Path path;
            for (int n = 0; n <= 100 && (n < 50 || scene.exact(0.03 * n).position.y() > 0); ++n)
                path.push_back(scene.exact(0.03 * n).position);
            drawing.add(pic::Trail{.points = path, .colour = colour, .width = 3});
            for (int n = 0; n <= 12; ++n)
                if (const Vector3 p = scene.exact(0.25 * n).position; p.y() >= 0)
                    drawing.add(pic::Ball{
                        .centre = p, .radius = 0.3, .colour = colour, .contact_shadow = true});
            drawing.add(pic::Label{.at = path.back() + Vector3(0, 0.6, 0), .text = words});
        };
        add(none, "no drag", pic::palette::steel);
        add(honey, "linear", pic::palette::gold);
        add(air, "quadratic", pic::palette::body);
        drawing.title("One throw, three models of drag")
            .caption("a ball of 1 kg, radius 10 cm, at 18 m/s; an image every 0.25 s");
        return pic::Shot{drawing, pic::fit(drawing, {0.12, 0.18, 1})};
    });
}

void clock_picture(lab::Report& report) {
    const int steps = 40;
    const Planet scene;
    Path by_time, by_clock, ellipse;
    lab::run(scene, methods::verlet, steps,
             [&](const PointMass& p, double) { by_time.push_back(p.position); });
    TimedPlanet planet{scene.start};
    const LogHamiltonian leapfrog(scene.gm, scene.start);
    for (int n = 0; n < steps; ++n) {
        by_clock.push_back(planet.body.position);
        planet = leapfrog(planet, scene, 0.0, 2 * pi / steps);
    }
    for (int n = 0; n <= 200; ++n) ellipse.push_back(scene.exact(2 * pi * n / 200).position);
    const pic::Note note{
        report.command(),
        "planet, e = 0.6, one orbit",
        "Verlet; logarithmic leapfrog",
        "1/40 orbit; 1/40 orbit of its own clock",
        {{"Verlet, error at the end",
          scene.error(lab::run(scene, methods::verlet, steps), scene.duration), "a"},
         {"logarithmic leapfrog, error at its end", scene.error(planet.body, planet.time), "a"}}};
    report.number("picture.clock.verlet",
                  scene.error(lab::run(scene, methods::verlet, steps), scene.duration), "a");
    report.number("picture.clock.leapfrog", scene.error(planet.body, planet.time), "a");
    pic::save(report.path("clock.png"), note, [&]() -> pic::Sheet {
        const pic::Size half{640, 520};
        const auto drawing_of = [&](const Path& points) {
            pic::Drawing drawing;
            drawing.ground(
                {.height = -0.06, .normal = Vector3::UnitZ(), .spacing = 0.5, .unit = "a"});
            drawing.add(pic::Trail{.points = ellipse,
                                   .colour = pic::palette::ink,
                                   .dashed = true,
                                   .width = 3,
                                   .shadow = false});
            drawing.add(pic::Ball{.centre = {0, 0, 0},
                                  .radius = 0.08,
                                  .colour = pic::palette::gold,
                                  .shines = true});
            for (const Vector3& p : points)
                drawing.add(
                    pic::Ball{.centre = p, .radius = 0.04, .colour = pic::palette::symplectic});
            return drawing;
        };
        pic::Drawing left = drawing_of(by_time), right = drawing_of(by_clock);
        left.title("Verlet, equal times"), right.title("logarithmic leapfrog");
        const pic::Fit how{.margin = 0.06, .up = Vector3::UnitY()};
        const pic::Camera camera = pic::fit(left, {0, 0, 1}, half, how);
        return {{{left, camera, half}, {right, pic::fit(right, {0, 0, 1}, half, how), half}}};
    });
}

}  // namespace

void pictures(lab::Report& report) {
    limit_picture(report);
    damped_picture(report);
    throws_picture(report);
    clock_picture(report);
}

}  // namespace nutshell
