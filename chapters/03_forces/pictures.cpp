// The pictures of chapter 3 that show one body.
#include <nutshell/live/stills.hpp>
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

/// What the captions of the spring's and the planet's moving figures say.
void numbers_of_captions(lab::Report& report) {
    const MassOnSpring spring;
    const double limit = 2 / spring.omega();
    double largest = 0;
    for (const Vector3& p : strip(spring, methods::verlet, 1.01 * limit, 8, 1))
        largest = std::max(largest, std::abs(p.y()));
    report.number("picture.limit.largest", largest, "m");

    const MassOnSpring damped = MassOnSpring::with_damping(0.1);
    const double dt = 1.0 / 8;
    const int steps = 24;
    const auto off = [&](const auto& method) {
        double most = 0;
        const Path computed = strip(damped, method, dt, steps, 1);
        for (std::size_t i = 0; i < computed.size(); ++i)
            most =
                std::max(most, std::abs(computed[i].y() -
                                        damped.exact(dt * static_cast<double>(i)).position.x()));
        return most;
    };
    report.number("picture.damped." + methods::verlet.key(), off(methods::verlet), "m");
    report.number("picture.damped.exponential", off(methods::exponential_verlet), "m");
}

void throws_picture(lab::Report& report) {
    ThrowInAir none, linear, air;
    none.air = 0;
    linear.air = 0, linear.drag = air.air * air.start.velocity.norm();
    const double between = 0.25;  // [s]
    const pic::Note note{
        report.command(),
        "throw with three models of drag",
        "exact",
        lab::rounded(between) + " s between images",
        {{"no drag, off at 2.5 s", distance(none.exact(2.5), air.exact(2.5)), "m"},
         {"linear drag, off at 2.5 s", distance(linear.exact(2.5), air.exact(2.5)), "m"}}};
    pic::save(report.path("throws.png"), note, [&]() -> pic::Sheet {
        pic::Drawing drawing;
        drawing.ground({.height = -0.5, .spacing = 5});
        const auto add = [&](const ThrowInAir& scene, pic::Colour colour, const char* words,
                             double on, const Vector3& beside) {  // its name, where it is alone
            Path path;
            for (int n = 0; n <= 100 && (n < 50 || scene.exact(0.03 * n).position.y() > 0); ++n)
                path.push_back(scene.exact(0.03 * n).position);
            drawing.add(pic::Trail{.points = path, .colour = colour, .width = 3});
            for (int n = 0; n <= 12; ++n)
                if (const Vector3 p = scene.exact(between * n).position; p.y() >= 0)
                    drawing.add(pic::Ball{
                        .centre = p, .radius = 0.3, .colour = colour, .contact_shadow = true});
            const auto there =
                static_cast<std::size_t>(on * static_cast<double>(path.size() - 1));
            drawing.add(pic::Label{.at = path[there] + beside, .text = words, .colour = colour});
        };
        add(none, pic::palette::steel, "no drag", 0.65, {2.5, 0.8, 0});
        add(linear, pic::palette::gold, "linear", 0.85, {-3, -0.5, 0});
        add(air, pic::palette::body, "quadratic", 1, {0.5, -2, 0});
        drawing.title("One throw, three models of drag")
            .caption("a ball of " + lab::rounded(air.start.mass) + " kg at " +
                     lab::rounded(air.start.velocity.norm(), "%.0f") + " m/s; an image every " +
                     lab::rounded(between) + " s");
        return pic::Shot{drawing, pic::fit(drawing, {0.12, 0.18, 1})};
    });
}

}  // namespace

void pictures(lab::Report& report) {
    numbers_of_captions(report);
    throws_picture(report);
    live::draw_stills(report);
}

}  // namespace nutshell
