// A cloth hung up by two corners, and what one per cent of the step decides.
#include <nutshell/chain_scenes.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/picture/picture.hpp>
#include <nutshell/sentence.hpp>
#include <nutshell/spring_limits.hpp>
#include "scale.hpp"

namespace nutshell {

namespace pic = picture;

namespace {

/// The cloth as two meshes: stripes of three springs' width, so that the eye sees how it drapes.
pic::Mesh stripes(const SpringNet& net, const Particles& all, const Vector3& lift, int which,
                  const pic::Colour& colour) {
    pic::Mesh mesh;
    mesh.colour = colour, mesh.smooth = true;
    for (std::size_t i = 0; i < all.size(); ++i) mesh.points.push_back(all.position[i] + lift);
    const int columns = static_cast<int>(net.springs.columns),
              rows = static_cast<int>(net.springs.rows);
    for (int r = 0; r + 1 < rows; ++r)
        for (int c = 0; c + 1 < columns; ++c) {
            if (c / 3 % 2 != which) continue;
            const int a = r * columns + c, b = a + 1, d = a + columns, e = d + 1;
            mesh.triangles.push_back({a, d, b});
            mesh.triangles.push_back({b, d, e});
        }
    return mesh;
}

pic::Shot draw_cloth(const SpringNet& net, const Particles& all, pic::Size size,
                     const std::string& title, const std::string& caption) {
    const Vector3 lift(0, 2, 0);
    pic::Drawing drawing;
    drawing.add(stripes(net, all, lift, 0, pic::palette::body));
    drawing.add(
        stripes(net, all, lift, 1, pic::mix(pic::palette::body, pic::palette::paper, 0.55F)));
    for (const std::size_t i : net.held) {
        const Vector3 corner = net.start.position[i] + lift;
        drawing.add(pic::Rod{.from = {corner.x(), 0, corner.z()}, .to = corner, .radius = 0.02});
        drawing.add(pic::Ball{.centre = corner, .radius = 0.04, .colour = pic::palette::steel});
    }
    if (!title.empty()) drawing.title(title);
    if (!caption.empty()) drawing.caption(caption);
    const pic::Camera camera{
        .eye = {1.9, 1.7, 4.3}, .target = {0.56, 1.05, 0}, .field_of_view = 0.55};
    return {drawing, camera, size};
}

double farthest(const Particles& a, const Particles& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, (a.position[i] - b.position[i]).norm());
    return most;
}

}  // namespace

void hanging_cloth(lab::Report& report) {
    report.heading("A cloth hung up by two corners");
    constexpr std::size_t n = 24;
    constexpr double side = 1.5, mass = 0.5, stiffness = 60, drag = 2e-3,
                     settle_dt = 1e-3;  // [m], [kg], [N/m], [kg/s], [s]
    constexpr double narrower = 0.75;   // the held corners' distance over the cloth's side
    const std::string size = std::to_string(n) + " x " + std::to_string(n) + " particles";
    SpringNet net = cloth(n, side, mass, stiffness, Weave::with_shear_and_bend);
    net.held = {0, n - 1}, net.drag = drag, net.duration = 60;
    for (std::size_t i = 0; i < n * n;
         ++i) {  // the corners come closer, and the cloth between them bulges
        const double across = static_cast<double>(i % n) / (n - 1);
        net.start.position.x[i] *= narrower;
        net.start.position.z[i] += 0.3 * std::sin(pi * across) + 0.03 * std::sin(3 * pi * across);
    }
    net.start =
        lab::run(net, methods::semi_implicit_euler, std::lround(net.duration / settle_dt));
    double speed = 0;
    for (std::size_t i = 0; i < net.start.size(); ++i)
        speed = std::max(speed, net.start.velocity[i].norm());
    pic::save(report.path("cloth.png"),
              {report.command(),
               "cloth, " + size + ", " + lab::rounded(side) + " m, " + lab::rounded(mass) +
                   " kg, held at two corners",
               methods::semi_implicit_euler.name,
               lab::rounded(settle_dt, "%g s"),
               {{"fastest particle", speed, "m/s"}}},
              [&]() -> pic::Sheet {
                  return draw_cloth(
                      net, net.start, {}, "A cloth hung up by two corners",
                      size + ", springs to the next, across, and to the next but one; at rest");
              });

    net.drag = 0;
    const double mode = 2 / fastest_mode(net, net.start, 4000).frequency;
    const auto strays = [&](double dt, long steps) {
        Particles all = net.start;
        auto verlet_step = methods::verlet.start(net);
        long step = 0;
        for (; step < steps && farthest(all, net.start) < 2 * side / n; ++step)
            all = verlet_step(std::move(all), net, double(step) * dt, dt);
        return std::pair(all, step);
    };
    Particles above,
        below;  // at 1.01 of the limit until a particle strays, and at 0.99 for as many steps
    long steps = 0, same = 0;
    std::tie(above, steps) = strays(1.01 * mode, 100'000);
    std::tie(below, same) = strays(0.99 * mode, steps);
    report.number("cloth.limit", mode, "s");
    report.number("cloth.steps", double(steps));
    report.number("cloth.strays_at_0.99", farthest(below, net.start), "m");
    report.number("cloth.strays_at_1.01", farthest(above, net.start), "m");
    report.say(sentence("{} at 0.99 of its limit strays ", methods::verlet) +
               lab::rounded(farthest(below, net.start)) + " m in " + std::to_string(same) +
               " steps, at 1.01 " + lab::rounded(farthest(above, net.start)) + " m in " +
               std::to_string(steps));
}

}  // namespace nutshell
