// picture_gallery DIR: pictures typical of the course, to be looked at; prints the processor time each one
// takes.
#include <cmath>
#include <ctime>
#include <functional>
#include <iostream>
#include <numbers>

#include "nutshell/picture/picture.hpp"

namespace pic = nutshell::picture;
using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

namespace {

pic::Drawing thrown(double dt, const pic::Colour& colour, const std::string& title) {
    const Vector3d g(0, -9.81, 0);
    Vector3d x(0, 0, 0), v(10, 15, 0);
    Points computed, exact, path;
    for (double t = 0; t < 2.9; t += dt) {
        computed.push_back(x);
        exact.push_back(Vector3d(10 * t, 15 * t - 4.905 * t * t, 0));
        x += v * dt;
        v += g * dt;
    }
    for (int i = 0; i <= 100; ++i) {
        const double t = 3.058 * i / 100;
        path.push_back(Vector3d(10 * t, 15 * t - 4.905 * t * t, 0));
    }
    pic::Drawing drawing;
    pic::add(drawing,
             {.computed = computed, .exact = exact, .exact_path = path, .radius = 0.45, .colour = colour});
    drawing.ground({.height = -0.45});
    drawing.title(title).caption("dt = " + std::to_string(dt).substr(0, 4) +
                                 " s; ghost and dashed line: exact");
    drawing.add(pic::Arrow{.from = computed[0], .vector = Vector3d(10, 15, 0) * 0.25, .label = "v"});
    return drawing;
}

pic::Image throw_picture() {
    const pic::Drawing d = thrown(0.2, pic::palette::explicit_euler, "Euler throws too far");
    return pic::render(d, pic::fit(d, {0.15, 0.22, 1}));
}

pic::Image two_up() {
    const pic::Size half{477, 540};
    auto one = [&](double dt, const pic::Colour& c) {
        pic::Drawing d = thrown(dt, c, "");
        d.caption("");
        return pic::render(d, pic::fit(d, {0.5, 0.35, 1}, half), half);
    };
    return pic::side_by_side(one(0.1, pic::palette::symplectic), one(0.3, pic::palette::explicit_euler),
                             "0.99 of the limit", "1.01 of the limit");
}

pic::Image orbit() {
    Points path, exact;
    Vector3d x(0.4, 0, 0), v(0, 2, 0);
    const double dt = 2 * std::numbers::pi / 300;
    auto gravity = [](const Vector3d& p) -> Vector3d { return -p / std::pow(p.norm(), 3); };
    for (int i = 0; i < 300 * 20; ++i) {
        path.push_back(x);
        v += gravity(x) * dt;
        x += v * dt;
    }
    for (int i = 0; i <= 200; ++i) {
        const double e = 2 * std::numbers::pi * i / 200;
        exact.push_back({std::cos(e) - 0.6, 0.8 * std::sin(e), 0});
    }
    pic::Drawing d;
    d.ground({.height = -0.06, .normal = {0, 0, 1}, .unit = "AU"});
    d.add(pic::Trail{.points = path,
                     .colour = pic::palette::symplectic,
                     .width = 2.2,
                     .opacity = 0.9,
                     .opacity_at_start = 0.25});
    d.add(pic::Trail{.points = exact, .colour = pic::palette::exact, .dashed = true, .width = 3.5});
    d.add(pic::Ball{.centre = {0, 0, 0}, .radius = 0.09, .colour = pic::palette::star, .shines = true});
    d.add(pic::Ball{.centre = x, .radius = 0.055, .colour = pic::palette::symplectic});
    d.add(pic::Label{.at = {0, 0, 0.09}, .text = "star"});
    d.add(pic::Label{.at = x, .text = "planet after 20 turns"});
    d.title("The ellipse turns, its size stays")
        .caption("semi-implicit Euler, 300 steps a turn; dashed: exact");
    return pic::render(d, pic::fit(d, {0, -0.75, 1}, {}, {.up = {0, 0, 1}}));
}

pic::Image chain() {
    pic::Drawing d;
    Points at;
    const int n = 16;
    for (int i = 0; i <= n; ++i) {
        const double x = -1.5 + 3.0 * i / n;
        at.push_back({x, 0.9 * std::cosh(x / 0.9) - 0.2, 0});
    }
    for (int i = 0; i < n; ++i) {
        d.add(pic::Rod{.from = at[std::size_t(i)], .to = at[std::size_t(i) + 1], .radius = 0.018});
    }
    for (const Vector3d& p : at) d.add(pic::Ball{.centre = p, .radius = 0.06, .colour = pic::palette::body});
    for (std::size_t i : {std::size_t(0), std::size_t(n)}) {
        const Vector3d top(at[i].x(), at[i].y() / 2, 0);
        d.add(pic::Box{.pose = Eigen::Isometry3d(Eigen::Translation3d(top)),
                       .half_extents = {0.05, at[i].y() / 2, 0.05},
                       .colour = pic::palette::steel});
    }
    d.add(
        pic::Arrow{.from = at[n / 2], .vector = {0, -0.5, 0}, .colour = pic::palette::force, .label = "mg"});
    d.title("A chain at rest hangs as a catenary");
    return pic::render(d, pic::fit(d, {0.5, 0.35, 1}));
}

pic::Image cloth() {
    pic::Mesh cloth;
    const int n = 24;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const double u = double(i) / (n - 1), w = double(j) / (n - 1);
            const double sag = 0.5 * std::sin(std::numbers::pi * u) * (0.4 + w * 0.6),
                         fold = 0.06 * std::sin(14 * u) * w;
            cloth.points.push_back({2 * u - 1, 2.1 - 1.6 * w * w - sag * (0.5 + 0.5 * w), 1.3 * w + fold});
        }
    }
    auto id = [](int i, int j) { return 24 * i + j; };
    for (int i = 0; i + 1 < n; ++i) {
        for (int j = 0; j + 1 < n; ++j) {
            cloth.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
            cloth.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
        }
    }
    cloth.smooth = true;
    cloth.colour = pic::palette::runge_kutta;
    pic::Drawing d;
    for (double x : {-1.0, 1.0}) {
        d.add(pic::Ball{.centre = {x, 2.1, 0}, .radius = 0.06, .colour = pic::palette::gold});
        d.add(pic::Rod{.from = {x, 0, 0}, .to = {x, 2.1, 0}, .radius = 0.025});
    }
    d.add(cloth);
    d.title("A cloth of 24 x 24 masses").caption("implicit Euler, dt = 1/60 s");
    return pic::render(d, pic::fit(d, {0.7, 0.4, 1}));
}

pic::Image box_with_arrows() {
    pic::Drawing d;
    const Eigen::Isometry3d pose =
        Eigen::Translation3d(0, 1.1, 0) * Eigen::AngleAxisd(0.6, Vector3d(0.3, 1, 0.5).normalized());
    d.add(pic::Box{.pose = pose, .half_extents = {0.7, 0.2, 0.4}});
    d.add(pic::Axes{.pose = pose, .length = 1.1});
    d.add(pic::Arrow{.from = pose.translation(),
                     .vector = {0.5, 1.1, 0.1},
                     .colour = pic::palette::angular_momentum,
                     .label = "L"});
    d.add(pic::Arrow{.from = pose.translation(),
                     .vector = {-0.2, 1.2, 0.1},
                     .colour = pic::palette::angular_velocity,
                     .label = "ω"});
    d.add(pic::Arrow{.from = pose * Vector3d(0.7, -0.2, 0.4),
                     .vector = {0.6, -0.3, 0.4},
                     .colour = pic::palette::force,
                     .label = "F"});
    d.title("L and ω point in different directions");
    return pic::render(d, pic::fit(d, {0.6, 0.4, 1}));
}

pic::Image spring() {
    pic::Drawing d;
    auto one = [&](double z, double length, const pic::Colour& c, pic::Look look) {
        d.add(pic::Box{.pose = Eigen::Isometry3d(Eigen::Translation3d(-0.1, 0.3, z)),
                       .half_extents = {0.1, 0.3, 0.25},
                       .colour = pic::palette::steel});
        d.add(pic::Tube{
            .points = pic::coil({0, 0.2, z}, {length, 0.2, z}, 0.09, 9), .radius = 0.016, .look = look});
        d.add(pic::Box{.pose = Eigen::Isometry3d(Eigen::Translation3d(length + 0.2, 0.2, z)),
                       .half_extents = {0.2, 0.2, 0.2},
                       .colour = c,
                       .look = look});
    };
    one(0, 1.3, pic::palette::symplectic, pic::Look::solid);
    one(-0.9, 1.0, pic::palette::exact, pic::Look::ghost);
    d.add(pic::Arrow{
        .from = {1.5, 0.5, 0}, .vector = {-0.6, 0, 0}, .colour = pic::palette::force, .label = "−k x"});
    d.title("A spring pulls back");
    return pic::render(d, pic::fit(d, {0.3, 0.6, 1}));
}

pic::Image pile() {
    pic::Drawing d;
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 10; ++j)
            for (int k = 0; k < 10; ++k)
                d.add(pic::Ball{.centre = Vector3d(i + 0.05 * std::sin(7 * j + k), j + 0.6,
                                                   k + 0.05 * std::cos(i + 5 * j)) *
                                          0.2,
                                .radius = 0.1,
                                .colour = pic::mix(pic::palette::body, pic::palette::gold, float(j) / 9)});
    d.title("A thousand spheres");
    return pic::render(d, pic::fit(d, {0.7, 0.6, 1}));
}

pic::Image film() {
    std::vector<pic::Image> frames;
    std::vector<std::string> words;
    for (int i = 0; i < 4; ++i) {
        pic::Drawing d;
        const double angle = 1.2 - 0.5 * i;
        const Vector3d bob(1.5 * std::sin(angle), 2 - 1.5 * std::cos(angle), 0);
        d.add(pic::Rod{.from = {0, 2, 0}, .to = bob, .radius = 0.02});
        d.add(pic::Ball{.centre = bob, .radius = 0.15, .colour = pic::palette::gold});
        d.add(pic::Ball{.centre = {0, 2, 0}, .radius = 0.05, .colour = pic::palette::steel});
        frames.push_back(pic::render(d, {{0, 1.6, 7}, {0, 1.1, 0}, 0.55}, {236, 300}));
        words.push_back("t = " + std::to_string(i) + " s");
    }
    return pic::filmstrip(frames, words);
}

pic::Image metres(double unit) {
    pic::Drawing d;
    d.add(pic::Ball{.centre = Vector3d(0, 0.5, 0) * unit, .radius = 0.5 * unit});
    d.add(pic::Trail{
        .points = {Vector3d(-2, 0.5, 0) * unit, Vector3d(0, 1.6, 0.3) * unit, Vector3d(2, 0, 0) * unit},
        .colour = pic::palette::runge_kutta});
    d.title("The same at any size");
    return pic::render(d, pic::fit(d, {0.2, 0.25, 1}));
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "out/gallery";
    const std::pair<const char*, std::function<pic::Image()>> all[] = {
        {"throw", throw_picture},
        {"two_up", two_up},
        {"orbit", orbit},
        {"chain", chain},
        {"cloth", cloth},
        {"box", box_with_arrows},
        {"spring", spring},
        {"pile", pile},
        {"film", film},
        {"small", [] { return metres(0.02); }},
        {"large", [] { return metres(2000); }},
    };
    for (const auto& [name, draw] : all) {
        const std::clock_t start = std::clock();
        const bool drawn =
            pic::save(folder / (std::string(name) + ".png"), {.command = "picture_gallery"}, draw);
        std::cout << name << ": " << double(std::clock() - start) / CLOCKS_PER_SEC << " s"
                  << (drawn ? "" : ", not drawn") << "\n";
    }
}
