// What is drawn stands where the world says, in its colour, in the sun's light.
#include <cmath>

#include "check.hpp"
#include "compare.hpp"
#include "nutshell/picture/picture.hpp"

namespace pic = nutshell::picture;
using Eigen::Vector3d;

namespace {

constexpr pic::Size size{400, 240};

/// Pixels in which two pictures differ by at least so many levels: their number and middle.
struct Spot {
    double count = 0, x = 0, y = 0;
};

Spot changed(const pic::Image& a, const pic::Image& b, int least) {
    Spot spot;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            int most = 0;
            for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]));
            if (most < least) continue;
            ++spot.count;
            spot.x += x + 0.5;
            spot.y += y + 0.5;
        }
    }
    spot.x /= spot.count;
    spot.y /= spot.count;
    return spot;
}

pic::Drawing empty() {
    pic::Drawing d;
    return d.no_ground();
}

}  // namespace

TEST_CASE("a point of the world is projected onto the right pixel") {
    // 10 m away, tan(half the field of view) = 1/2: half the picture's height is 5 m.
    const pic::Camera camera{.eye = {0, 0, 10}, .target = {0, 0, 0}, .field_of_view = 2 * std::atan(0.5)};
    const Vector3d p = pic::project(camera, {960, 540}, {1, 2, 0});
    CHECK(p.x() == Approx(480 + 54));
    CHECK(p.y() == Approx(270 - 108));
    CHECK(p.z() == Approx(10));
    CHECK(pic::project(camera, {960, 540}, {0, 0, 11}).z() == Approx(-1));
}

TEST_CASE("a ball is drawn where it is projected, as large as it must be") {
    const pic::Camera camera{.eye = {1, 2, 10}, .target = {0.3, 0.1, 0}};
    const double radius = 0.35, pixels = size.height / 2.0 / std::tan(camera.field_of_view / 2);
    for (const Vector3d& centre : {Vector3d(0.3, 0.1, 0), Vector3d(-1, 0.8, 0.5), Vector3d(1.6, -0.7, -1)}) {
        pic::Drawing d = empty();
        d.add(pic::Ball{.centre = centre, .radius = radius});
        const Spot spot = changed(pic::render(d, camera, size), pic::render(empty(), camera, size),
                                  100);  // half of what the ball darkens
        const Vector3d p = pic::project(camera, size, centre);
        CHECK(std::abs(spot.x - p.x()) < 0.6);
        CHECK(std::abs(spot.y - p.y()) < 0.6);
        const double r = pixels * radius / std::sqrt((camera.eye - centre).squaredNorm() - radius * radius);
        CHECK(std::sqrt(spot.count / 3.14159265) == Approx(r).margin(0.3));
    }
}

TEST_CASE("a lit ball has its colour") {
    const pic::Camera camera{.eye = {0, 0, 5}, .target = {0, 0, 0}};
    for (const pic::Colour& colour :
         {pic::palette::explicit_euler, pic::palette::symplectic, pic::palette::runge_kutta,
          pic::palette::implicit, pic::palette::exponential, pic::palette::body, pic::palette::gold}) {
        pic::Drawing d = empty();
        d.add(pic::Ball{.centre = {0, 0, 0}, .radius = 0.5, .colour = colour}).sun({-1, 1, 1});
        const pic::Image image = pic::render(d, camera, size);
        const std::uint8_t* p = image.pixel(200, 120);
        const float most = std::max({colour.red, colour.green, colour.blue});
        const float seen = float(std::max({p[0], p[1], p[2]}));
        CHECK(float(p[0]) / seen == Approx(colour.red / most).margin(0.08));
        CHECK(float(p[1]) / seen == Approx(colour.green / most).margin(0.08));
        CHECK(float(p[2]) / seen == Approx(colour.blue / most).margin(0.08));
        CHECK(seen / 255 == Approx(most).margin(0.12));
        CHECK(grey(image, 184, 104) > 1.2 * grey(image, 216, 136));  // the side of the sun, the other side
    }
}

TEST_CASE("a shadow falls where the sun says") {
    const pic::Camera camera{.eye = {0, 4, 6}, .target = {0, 0, 0}};
    const Vector3d sun(1, 2, 0.5), centre(0, 1, 0);
    pic::Drawing d, elsewhere;
    d.add(pic::Ball{.centre = centre, .radius = 0.2}).sun(sun);
    elsewhere.add(pic::Ball{.centre = centre, .radius = 0.2}).sun({-4, 1, -4});
    const pic::Image image = pic::render(d, camera, size), bare = pic::render(elsewhere, camera, size);
    auto ratio = [&](const Vector3d& on_ground) {
        const Vector3d p = pic::project(camera, size, on_ground);
        return grey(image, p.x(), p.y()) / grey(bare, p.x(), p.y());
    };
    const Vector3d foot = centre - sun / sun.y();
    CHECK(ratio(foot) < 0.8);
    for (const Vector3d& side :
         {Vector3d(0.4, 0, 0), Vector3d(-0.4, 0, 0), Vector3d(0, 0, 0.4), Vector3d(0, 0, -0.4)}) {
        CHECK(ratio(foot + side) > 0.97);
    }
    CHECK(ratio({-foot.x(), 0, -foot.z()}) > 0.97);
}

TEST_CASE("a thing shades another one") {
    const pic::Camera camera{.eye = {0, 6, 6}, .target = {0, 0, 0}};
    pic::Drawing alone, shaded;
    const pic::Box table{.half_extents = {1, 0.2, 1}};
    alone.add(table).sun({0, 1, 0});
    shaded.add(table).sun({0, 1, 0}).add(pic::Ball{.centre = {0.5, 2, 0}, .radius = 0.2});
    const Vector3d p = pic::project(camera, size, {0.5, 0.2, 0});
    const pic::Image a = pic::render(alone, camera, size), b = pic::render(shaded, camera, size);
    CHECK(grey(b, p.x(), p.y()) < 0.8 * grey(a, p.x(), p.y()));
    const Vector3d q = pic::project(camera, size, {-0.5, 0.2, 0});
    CHECK(grey(b, q.x(), q.y()) == Approx(grey(a, q.x(), q.y())).margin(0.02));
}

TEST_CASE("a ghost is translucent, leaves no shadow, and hides nothing behind its own far side") {
    const pic::Camera camera{.eye = {0, 0, 5}, .target = {0, 0, 0}};
    pic::Drawing none = empty(), ghost = empty(), solid = empty();
    for (pic::Drawing* d : {&none, &ghost, &solid})
        d->add(
             pic::Box{.pose = Eigen::Isometry3d(Eigen::Translation3d(0, 0, -1)), .half_extents = {1, 1, 0.1}})
            .sun({0, 0, 1});
    ghost.add(pic::Ball{
        .centre = {0, 0, 0}, .radius = 0.5, .colour = pic::palette::exact, .look = pic::Look::ghost});
    solid.add(pic::Ball{.centre = {0, 0, 0}, .radius = 0.5, .colour = pic::palette::exact});
    const pic::Image a = pic::render(none, camera, size), b = pic::render(ghost, camera, size),
                     c = pic::render(solid, camera, size);
    CHECK(grey(b, 200, 120) < grey(a, 200, 120) - 0.05);
    CHECK(grey(b, 200, 120) > grey(c, 200, 120) + 0.1);
    const Vector3d rim = pic::project(camera, size, {0.46, 0, 0});
    CHECK(grey(b, rim.x(), rim.y()) < grey(b, 200, 120));  // seen more clearly at its rim
    pic::Drawing on_ground, bare;
    on_ground.add(pic::Ball{.centre = {0, 1, 0}, .radius = 0.2, .look = pic::Look::ghost}).sun({1, 1, 0});
    const pic::Camera above{.eye = {0, 4, 6}, .target = {0, 0, 0}};
    const Vector3d foot = pic::project(above, size, {-1, 0, 0});
    CHECK(grey(pic::render(on_ground, above, size), foot.x(), foot.y()) ==
          Approx(grey(pic::render(bare, above, size), foot.x(), foot.y())).margin(0.02));
}

TEST_CASE("what is in front hides what is behind, whatever the order of adding") {
    const pic::Camera camera{.eye = {0, 0, 5}, .target = {0, 0, 0}};
    const pic::Ball front{.centre = {0, 0, 1}, .radius = 0.3, .colour = pic::palette::gold};
    const pic::Ball back{.centre = {0, 0, -1}, .radius = 0.5, .colour = pic::palette::body};
    pic::Drawing a = empty(), b = empty();
    a.add(front).add(back);
    b.add(back).add(front);
    const pic::Image image = pic::render(a, camera, size);
    CHECK(image.rgb == pic::render(b, camera, size).rgb);
    CHECK(image.pixel(200, 120)[0] > image.pixel(200, 120)[2]);  // gold
}

TEST_CASE("trails: width in pixels, dashes, fading, and cut behind the eye") {
    const pic::Camera camera{.eye = {0, 0, 5}, .target = {0, 0, 0}};
    auto ink = [&](const pic::Trail& trail) {
        pic::Drawing d = empty();
        d.add(trail);
        const pic::Image a = pic::render(d, camera, {960, 240}), b = pic::render(empty(), camera, {960, 240});
        double sum = 0;
        for (std::size_t i = 0; i < a.rgb.size(); i += 3) sum += 1 - double(a.rgb[i]) / b.rgb[i];
        return sum;  // pixels that the black trail covers
    };
    const pic::Trail solid{.points = {{-1, 0, 0}, {1, 0, 0}}, .colour = {0, 0, 0}, .width = 6};
    const double length = 2 * 120 / std::tan(0.25) / 5;
    CHECK(ink(solid) == Approx(6 * length).epsilon(0.04));
    pic::Trail dashed = solid, faded = solid;
    dashed.dashed = true;
    faded.opacity_at_start = 0;
    CHECK(ink(dashed) == Approx(3.6 / 6.2 * 6 * length).epsilon(0.08));
    CHECK(ink(faded) == Approx(0.5 * 6 * length).epsilon(0.06));
    pic::Trail behind = solid;
    behind.points = {{0, -0.2, 0}, {0, -0.2, 20}};  // passes below the eye
    const double seen = ink(behind);
    CHECK(seen > 100);
    CHECK(seen < 6 * 240);
}

TEST_CASE("a fitted camera holds the whole drawing and no more, words apart") {
    pic::Drawing d;
    d.add(pic::Ball{.centre = {-3, 0.5, 1}, .radius = 0.5})
        .add(pic::Ball{.centre = {4, 2.5, -1}, .radius = 0.3});
    d.add(pic::Trail{.points = {{0, 0, 0}, {1, 4, 2}}}).no_ground();
    for (const Vector3d& from : {Vector3d(0, 0, 1), Vector3d(0.5, 0.5, 1), Vector3d(-3, 1, 0.2)}) {
        const pic::Camera camera = pic::fit(d, from, size, {.margin = 0.1});
        CHECK((camera.eye - camera.target).normalized().dot(from.normalized()) == Approx(1));
        double room = 1;  // share of the picture between the drawing and the nearest edge
        for (const pic::Extent& e : d.extents()) {
            const double r = e.radius;
            for (int axis = 0; axis < 3; ++axis) {
                for (double sign : {-1.0, 1.0}) {
                    const Vector3d p = pic::project(camera, size, e.centre + sign * r * Vector3d::Unit(axis));
                    REQUIRE(p.z() > 0);
                    room = std::min({room, p.x() / size.width, 1 - p.x() / size.width, p.y() / size.height,
                                     1 - p.y() / size.height});
                }
            }
        }
        CHECK(room > 0.0999);
        CHECK(room < 0.115);
    }
    pic::Drawing titled = d;
    titled.title("a title");
    const double top = pic::project(pic::fit(d, {0, 0, 1}, size), size, {1, 4, 2}).y();
    CHECK(pic::project(pic::fit(titled, {0, 0, 1}, size), size, {1, 4, 2}).y() > top);
}

TEST_CASE("a drawing looks the same in centimetres, in kilometres, and far from the origin") {
    auto draw = [](double unit, const Vector3d& shift) {
        pic::Drawing d;
        d.add(pic::Ball{.centre = Vector3d(0, 0.5, 0) * unit + shift, .radius = 0.5 * unit});
        d.add(
            pic::Box{.pose = Eigen::Isometry3d(Eigen::Translation3d(Vector3d(1.2, 0.3, 0.4) * unit + shift)),
                     .half_extents = Vector3d(0.3, 0.3, 0.3) * unit});
        d.add(pic::Trail{.points = {Vector3d(-1, 0, 1) * unit + shift, Vector3d(1, 1, 1) * unit + shift}});
        d.ground({.spacing = 0.5 * unit, .unit = "?"});
        pic::Image image = pic::render(d, pic::fit(d, {0.3, 0.4, 1}, size), size);
        image.rgb.resize(3 * 400 * 200);  // without the words on the grid's spacing
        image.height = 200;
        return image;
    };
    const pic::Image metres = draw(1, Vector3d::Zero());
    CHECK(difference(metres, draw(0.01, Vector3d::Zero())) < 0.02);
    CHECK(difference(metres, draw(5000, Vector3d::Zero())) < 0.02);
    CHECK(difference(metres, draw(1, Vector3d(5e6, 0, -2e6))) < 0.02);
}
