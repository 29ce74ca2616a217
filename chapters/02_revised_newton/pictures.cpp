// The pictures of chapter 2.
#include <nutshell/lab/run.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/picture/picture.hpp>
#include <nutshell/revised_newton_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace pic = picture;

namespace {

const pic::Colour sand = pic::palette::gold, water{0.337F, 0.706F, 0.914F},
                  stone = pic::palette::steel;

/// States after every `every`-th step.
template <class Scene, class Method>
auto states(const Scene& scene, const Method& method, long steps, long every) {
    std::vector<decltype(scene.start)> kept;
    long n = 0;
    lab::run(scene, method, steps, [&](const auto& state, double) {
        if (n++ % every == 0) kept.push_back(state);
    });
    return kept;
}

pic::Box box(const Vector3& centre, const Vector3& half, pic::Colour colour) {
    pic::Box thing{.half_extents = half, .colour = colour};
    thing.pose.translation() = centre;
    return thing;
}

/// A cart on its lane: as much of its load as its mass says.
void add_cart(pic::Drawing& drawing, const Particle& cart, double lane, double full_mass) {
    const double x = cart.position.x(), load = 2.4 * cart.mass / full_mass;  // half height [m]
    drawing.add(box({x, 3.1, lane}, {5.4, 0.3, 2.6}, stone));
    drawing.add(box({x, 3.4 + load, lane}, {4.8, load, 2.3}, sand));
    for (const double wheel : {-3.4, 3.4})
        drawing.add(pic::Ball{
            .centre = {x + wheel, 1.4, lane + 1.6}, .radius = 1.4, .colour = pic::palette::ink});
}

void cart_picture(lab::Report& report) {
    const LeakyCart truth, printed = LeakyCart::as_printed();
    const long steps = 100, every = 20;
    const auto told = states(printed, methods::euler, steps, every),
               is = states(truth, methods::euler, steps, every);
    const pic::Note note{
        report.command(),
        "leaky cart",
        "Euler",
        "0.1 s",
        {{"final speed, K = m v with K constant", velocity(told.back()).x(), "m/s"},
         {"final speed, momentum books", velocity(is.back()).x(), "m/s"}}};
    pic::save(report.path("cart.png"), note, [&]() -> pic::Sheet {
        pic::Drawing drawing;
        const double back = -62, front = 0;
        drawing.ground({.height = 0, .spacing = 10});
        // what the formula claims: each grain stays where it fell out
        lab::run(printed, methods::euler, steps,
                 [&, n = 0](const Particle& cart, double) mutable {
                     if (n++ % 2 == 1)
                         drawing.add(pic::Ball{.centre = {cart.position.x(), 0.7, back + 3},
                                               .radius = 0.7,
                                               .colour = sand});
                 });
        for (const Particle& cart : told) add_cart(drawing, cart, back, truth.start.mass);
        // what happens: each grain slides along below the cart
        for (std::size_t i = 0; i < is.size(); ++i) {
            add_cart(drawing, is[i], front, truth.start.mass);
            for (std::size_t grain = 0; grain < 2 * i; ++grain)
                drawing.add(pic::Ball{
                    .centre = {is[i].position.x() +
                                   (static_cast<double>(grain) - static_cast<double>(i) + 0.5) *
                                       1.1,
                               0.7, front + 3},
                    .radius = 0.7,
                    .colour = sand});
        }
        const auto label = [&](const Particle& cart, double lane, const std::string& text) {
            drawing.add(pic::Label{.at = {cart.position.x(), 12.5, lane}, .text = text});
        };
        drawing.add(
            pic::Label{.at = {24, 15, back}, .text = "computed with K = m v, K constant"});
        label(told.back(), back, lab::rounded(velocity(told.back()).x(), "%.0f m/s"));
        drawing.add(pic::Label{.at = {2, 15, front}, .text = "the truth"});
        label(is.back(), front, lab::rounded(velocity(is.back()).x(), "%.0f m/s"));
        drawing.title("The cart that speeds up by itself")
            .caption("an image every 2 s; carts drawn large");
        const pic::Size size{960, 450};
        return pic::Shot{
            drawing,
            pic::fit(drawing, {0, 0.55, 1}, size, {.margin = 0.04, .field_of_view = 0.06}), size};
    });
}

/// A drop's radius on the picture: true in proportion, far too large to be true.
double drop_radius(double mass, double full_mass) {
    return 1.3 * std::cbrt(mass / full_mass);
}

void raindrop_picture(lab::Report& report) {
    const Raindrop drop;
    const auto drops = states(drop, methods::verlet, 40, 4);
    const double full = drops.back().mass;
    const pic::Note note{report.command(),
                         "raindrop",
                         "Verlet",
                         "0.1 s",
                         {{"speed down at the end", -velocity(drops.back()).y(), "m/s"},
                          {"speed sideways at the end", velocity(drops.back()).x(), "m/s"},
                          {"position, off by", drop.error(drops.back(), drop.duration), "m"}}};
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

void rocket_picture(lab::Report& report) {
    const Launch scene = Rocket::with_midway(Launch{});
    const RocketBooks books{scene};
    const long steps = 60, every = 12;
    const auto all = states(books, methods::verlet, steps, every);
    const RocketAndExhaust& end = all.back();
    const pic::Note note{
        report.command(),
        "launch",
        "Verlet, midway parcels",
        "0.025 s",
        {{"height at burnout", end.rocket.position.y(), "m"},
         {"position, off by", scene.error(end.rocket, scene.duration), "m"},
         {"momentum of rocket and exhaust, off by",
          (total_momentum(end) - books.exact_momentum(scene.duration)).norm(), "kg m/s"}}};
    pic::save(report.path("rocket.png"), note, [&]() -> pic::Sheet {
        pic::Drawing drawing;
        drawing.ground({.height = 0, .spacing = 5});
        const Vector3 axis = -scene.start.flow.velocity.normalized();
        for (const RocketAndExhaust& instant : all) {
            const Particle& rocket = instant.rocket;
            const Vector3 tail = rocket.position + Vector3(0, 0.4, 0);
            const double full = 2.2 * rocket.mass / scene.start.mass;
            drawing.add(pic::Rod{
                .from = tail, .to = tail + full * axis, .radius = 0.42, .colour = water});
            drawing.add(pic::Rod{.from = tail + full * axis,
                                 .to = tail + 2.4 * axis,
                                 .radius = 0.38,
                                 .colour = stone});
            drawing.add(pic::Ball{.centre = tail + 2.4 * axis, .radius = 0.38, .colour = stone});
        }
        for (const Particle& parcel : end.exhaust)
            if (parcel.position.y() > 0)
                drawing.add(
                    pic::Ball{.centre = parcel.position, .radius = 0.22, .colour = water});
        drawing.title("It climbs on what it throws down")
            .caption("an image every 0.3 s; drops: the water in the air at the last");
        const pic::Size size{620, 760};
        return pic::Shot{drawing, pic::fit(drawing, {0.15, 0.15, 1}, size, {.margin = 0.06}),
                         size};
    });
}

}  // namespace

void pictures(lab::Report& report) {
    cart_picture(report);
    raindrop_picture(report);
    rocket_picture(report);
}

}  // namespace nutshell
