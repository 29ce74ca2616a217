// Words, joined pictures, files and refusals.
#include <fstream>
#include <iterator>
#include <limits>

#include "check.hpp"
#include "compare.hpp"
#include "nutshell/picture/picture.hpp"

namespace pic = nutshell::picture;
namespace fs = std::filesystem;
using Eigen::Vector3d;

namespace {

constexpr pic::Size size{480, 270};
const pic::Camera camera{.eye = {0, 1, 6}, .target = {0, 1, 0}};

/// The rectangle of pixels with ink on them, in a region.
struct Ink {
    int count = 0, left = 10000, right = -1, top = 10000, bottom = -1;
};

Ink ink(const pic::Image& image, double darker_than = 0.35) {
    Ink out;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (grey(image, x, y) > darker_than) continue;
            ++out.count;
            out.left = std::min(out.left, x);
            out.right = std::max(out.right, x);
            out.top = std::min(out.top, y);
            out.bottom = std::max(out.bottom, y);
        }
    }
    return out;
}

pic::Drawing with_label(const Vector3d& at, const std::string& text) {
    pic::Drawing d;
    d.no_ground().add(pic::Label{.at = at, .text = text});
    return d;
}

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("a label draws ink beside its point, and stays inside the picture") {
    pic::Drawing blank;
    CHECK(ink(pic::render(blank.no_ground(), camera, size)).count == 0);
    const Ink middle = ink(pic::render(with_label({0, 1, 0}, "ω = 3 rad/s"), camera, size));
    CHECK(middle.count > 100);
    CHECK(middle.left > 240);
    CHECK(middle.left < 265);
    CHECK(middle.bottom < 135);
    for (const Vector3d& corner : {Vector3d(2.6, 2.4, 0), Vector3d(-2.6, -0.4, 0), Vector3d(2.6, -0.4, 0)}) {
        const Ink edge = ink(pic::render(with_label(corner, "ω = 3 rad/s"), camera, size));
        CHECK(edge.count > 0.8 * middle.count);
        CHECK(edge.left >= 2);
        CHECK(edge.right < size.width - 2);
        CHECK(edge.top >= 2);
        CHECK(edge.bottom < size.height - 2);
    }
}

TEST_CASE("labels of one point keep off each other") {
    const int one = ink(pic::render(with_label({0, 1, 0}, "label"), camera, size)).count;
    pic::Drawing four;
    four.no_ground();
    for (int i = 0; i < 4; ++i) four.add(pic::Label{.at = {0, 1, 0}, .text = "label"});
    CHECK(ink(pic::render(four, camera, size)).count == Approx(4 * one).epsilon(0.08));
}

TEST_CASE("title, caption and the grid's spacing stand in their corners") {
    pic::Drawing d;
    d.title("A title").caption("a caption");
    const pic::Image image = pic::render(d, camera, size);
    auto inked = [&](int left, int top) {
        int count = 0;
        for (int y = top; y < top + 60; ++y) {
            for (int x = left; x < left + 150; ++x) count += grey(image, x, y) < 0.55;
        }
        return count;
    };
    CHECK(inked(0, 0) > 100);
    CHECK(inked(0, 210) > 60);
    CHECK(inked(330, 210) > 60);
    CHECK(inked(330, 0) == 0);
}

TEST_CASE("joined pictures stand side by side, with their words") {
    auto plain = [](std::uint8_t level) {
        return pic::Image{100, 80, std::vector<std::uint8_t>(3 * 100 * 80, level)};
    };
    const pic::Image two = pic::side_by_side(plain(200), plain(120), "0.99", "1.01");
    CHECK(two.width == 206);
    CHECK(two.height == 80);
    CHECK(int(two.pixel(90, 70)[0]) == 200);
    CHECK(int(two.pixel(103, 70)[0]) == 255);
    CHECK(int(two.pixel(110, 70)[0]) == 120);
    CHECK(ink(two, 0.3).count > 40);
    const pic::Image film = pic::filmstrip({plain(200), plain(200), plain(200), plain(120), plain(120)},
                                           {"1", "2", "3", "4", "5"}, 3);
    CHECK(film.width == 3 * 100 + 2 * 6);
    CHECK(film.height == 2 * 80 + 6);
    CHECK(int(film.pixel(50, 150)[0]) == 120);
    CHECK_THROWS_WITH(pic::side_by_side(plain(1), pic::render(pic::Drawing{}, camera, {50, 80}), "", ""),
                      ContainsSubstring("differ in size"));
    CHECK_THROWS_WITH(pic::filmstrip({}, {}), ContainsSubstring("at least one"));
    CHECK_THROWS_WITH(pic::filmstrip({plain(1)}, {}), ContainsSubstring("0 words"));
}

TEST_CASE("a saved picture reads back, and its note says how it was made") {
    const fs::path folder = own_path("picture_test");
    fs::remove_all(folder);
    const pic::Image image = pic::render(with_label({0, 1, 0}, "here"), camera, size);
    const pic::Note note{
        "the_program --out here", "throw", "Euler", "0.1 s", {{"error", 0.1, "m"}, {"steps", 30, ""}}};
    pic::save(image, folder / "a.png", note);
    const pic::Image back = read_png(folder / "a.png");
    CHECK(back.width == size.width);
    CHECK(back.rgb == image.rgb);
    CHECK(text_of(folder / "a.txt") ==
          "drawn: 480 x 270\ncommand: the_program --out here\nscene: throw\nmethod: Euler\ndt: 0.1 s\n"
          "error = 0.10000000000000001 m\nsteps = 30\n");
    CHECK(std::distance(fs::directory_iterator(folder), {}) == 2);  // nothing half written is left

    SECTION("where nothing can be drawn the note says why, and no old picture stays") {
        const bool drawn = pic::save(folder / "a.png", note,
                                     []() -> pic::Image { throw pic::NoGraphics("no OpenGL here"); });
        CHECK_FALSE(drawn);
        CHECK_FALSE(fs::exists(folder / "a.png"));
        CHECK_THAT(text_of(folder / "a.txt"), ContainsSubstring("not drawn: no OpenGL here\n"));
    }
    SECTION("a folder that is a file is named") {
        CHECK_THROWS_WITH(pic::save(image, folder / "a.txt" / "b.png", note),
                          ContainsSubstring((folder / "a.txt").string()));
        CHECK_THROWS_WITH(pic::save(image, "/proc/none/b.png", note), ContainsSubstring("/proc/none"));
    }
    fs::remove_all(folder);
}

TEST_CASE("a picture of the book: for light pages and dark, with its words as text") {
    const fs::path folder = own_path("sheet_test");
    fs::remove_all(folder);
    pic::Drawing drawing = with_label({0, 1, 0}, "ω < 3 rad/s");
    drawing.title("A title");
    pic::save(folder / "a.png", {}, [&] {
        return pic::Sheet{{{drawing, camera, size}, {drawing, camera, size}}};
    });
    const pic::Image both = read_png(folder / "a.png");
    CHECK(both.width == 2 * size.width + 6);
    const pic::Image light = read_png(folder / "a.1.jpg"), dark = read_png(folder / "a.2.dark.jpg");
    CHECK(ink(light, 0.3).count == 0);  // no letters drawn in
    const auto bare = pic::render_bare(drawing, camera, size);
    CHECK(difference(light, bare) < 1);  // of 255: what JPEG takes
    CHECK(grey(dark, 240, 135) < 0.25);
    const std::string page = text_of(folder / "a.page.html");
    CHECK_THAT(page, ContainsSubstring("ω &lt; 3 rad/s"));
    CHECK_THAT(page, ContainsSubstring("srcset=\"a.2.dark.jpg\""));
    CHECK_THAT(page, ContainsSubstring("words narrow"));
    CHECK(pic::save(folder / "a.png", {}, []() -> pic::Sheet { throw pic::NoGraphics("none"); }) == false);
    CHECK_FALSE(fs::exists(folder / "a.page.html"));
    fs::remove_all(folder);
}

TEST_CASE("a body with marks shows how it is turned") {
    const pic::Camera front{.eye = {0, 0, 6}, .target = {0, 0, 0}};
    const auto seen = [&](const auto& thing) {
        pic::Drawing d;
        return pic::render(d.no_ground().add(thing), front, size);
    };
    const auto turned = [](double angle, const Vector3d& axis) {
        return Eigen::Isometry3d(Eigen::AngleAxisd(angle, axis));
    };
    const double quarter = std::acos(0.0);
    const auto box = [&](const Eigen::Isometry3d& pose, bool marked) {
        return seen(pic::Box{.pose = pose, .marked = marked});
    };
    // a cube looks the same after each quarter turn, a marked one does not
    for (const Vector3d& axis : {Vector3d::UnitX().eval(), Vector3d::UnitY().eval()}) {
        CHECK(difference(box(turned(0, axis), false), box(turned(quarter, axis), false)) < 0.01);
        CHECK(difference(box(turned(0, axis), true), box(turned(quarter, axis), true)) > 1);
        CHECK(difference(box(turned(0, axis), true), box(turned(2 * quarter, axis), true)) > 0.3);
    }
    const auto ball = [&](double angle) {
        return seen(pic::Ball{
            .radius = 1, .orientation = Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vector3d::UnitZ()))});
    };
    CHECK(difference(ball(0), ball(quarter)) > 5);
    CHECK(difference(ball(0), ball(2 * quarter)) < 0.05);
}

TEST_CASE("the images of a stroboscope leave no second path on the ground") {
    const auto shadows = [](bool contact) {
        pic::Drawing d, bare;
        for (int i = 0; i < 5; ++i)
            d.add(pic::Ball{.centre = {0.8 * i - 1.6, 1.5, 0}, .radius = 0.1, .contact_shadow = contact});
        d.stage({{0, 1, 0}, 2}), bare.stage({{0, 1, 0}, 2});
        const auto image = pic::render(d, camera, size), empty = pic::render(bare, camera, size);
        int darker = 0;
        for (int y = size.height / 2; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) darker += grey(image, x, y) < grey(empty, x, y) - 0.05;
        return darker;
    };
    CHECK(shadows(false) > 100);
    CHECK(shadows(true) == 0);
}

TEST_CASE("bad arguments of pictures are named") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    pic::Drawing d;
    CHECK_THROWS_WITH(d.add(pic::Ball{.centre = {0, nan, 0}}),
                      ContainsSubstring("Ball::centre is not finite"));
    CHECK_THROWS_WITH(d.add(pic::Ball{.radius = 0}), ContainsSubstring("Ball::radius must be positive"));
    CHECK_THROWS_WITH(d.add(pic::Ball{.orientation = Eigen::Quaterniond(2, 0, 0, 0)}),
                      ContainsSubstring("Ball::orientation is no rotation"));
    CHECK_THROWS_WITH(d.add(pic::Box{.half_extents = {1, -1, 1}}), ContainsSubstring("Box::half_extents"));
    CHECK_THROWS_WITH(d.add(pic::Rod{.to = {nan, 0, 0}}), ContainsSubstring("Rod::to"));
    CHECK_THROWS_WITH(d.add(pic::Tube{.points = {{0, 0, 0}}}), ContainsSubstring("at least two points"));
    CHECK_THROWS_WITH(d.add(pic::Trail{.points = {{0, 0, 0}, {0, nan, 0}}}), ContainsSubstring("number 1"));
    CHECK_THROWS_WITH(d.add(pic::Mesh{.points = {{0, 0, 0}}, .triangles = {{0, 0, 1}}}),
                      ContainsSubstring("index 1 but there are 1"));
    CHECK_THROWS_WITH(d.add(pic::Arrow{.vector = {0, nan, 0}}), ContainsSubstring("Arrow::vector"));
    CHECK_THROWS_WITH(d.ground({.normal = {0, 0, 0}}), ContainsSubstring("Ground::normal"));
    CHECK_THROWS_WITH(pic::fit(d, {0, 0, 1}), ContainsSubstring("something in it"));
    d.add(pic::Ball{});
    CHECK_THROWS_WITH(pic::fit(d, {0, 0, 0}), ContainsSubstring("not zero"));
    CHECK_THROWS_WITH(pic::fit(d, {0, 1, 0}), ContainsSubstring("along its up"));
    CHECK_THROWS_WITH(pic::render(d, camera, {0, 100}), ContainsSubstring("0 x 100"));
    CHECK_THROWS_WITH(pic::render(d, camera, {100, 5000}), ContainsSubstring("1 to 4096"));
    CHECK_THROWS_WITH(pic::render(d, {.eye = {1, 1, 1}, .target = {1, 1, 1}}),
                      ContainsSubstring("eye at its target"));
    CHECK_THROWS_WITH(pic::render(d, {.eye = {nan, 1, 1}}), ContainsSubstring("not finite"));
    CHECK_THROWS_WITH(pic::render(d, camera, {10, 10}, {.samples = 9}), ContainsSubstring("1 to 4 samples"));
    CHECK_THROWS_WITH(pic::hex("#12345"), ContainsSubstring("'#12345'"));
    CHECK_THROWS_AS(pic::hex("#12345g"), std::invalid_argument);
    const pic::Image image{2, 2, std::vector<std::uint8_t>(12)};
    CHECK_THROWS_WITH(pic::save(image, "a.jpg", {}), ContainsSubstring("must end in .png"));
    CHECK_THROWS_WITH(pic::save(pic::Image{}, "a.png", {}), ContainsSubstring("empty"));
}

TEST_CASE("things of no extent do no harm") {
    pic::Drawing d;
    d.add(pic::Arrow{.vector = {0, 0, 0}, .label = "no force"})
        .add(pic::Rod{.from = {1, 1, 1}, .to = {1, 1, 1}});
    d.add(pic::Tube{.points = {{0, 0, 0}, {0, 0, 0}}})
        .add(pic::Trail{.points = {{0, 0, 0}, {0, 0, 0}}})
        .add(pic::Label{.at = {0, 0, 100}, .text = "behind"});
    CHECK(pic::render(d, camera, {1, 1}).rgb.size() == 3);
    pic::Drawing point;
    point.add(pic::Label{.at = {5, 0, 0}, .text = "alone"});
    const pic::Camera alone = pic::fit(point, {0, 0, 3});
    CHECK((alone.eye - Vector3d(5, 0, 0)).norm() == Approx(3));
}

TEST_CASE("colours of methods can be told from the ground on a grey screen, and are written as on the web") {
    auto light = [](const pic::Colour& c) {
        auto linear = [](float x) { return x <= 0.04045F ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); };
        return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
    };
    for (const pic::Colour& c :
         {pic::palette::explicit_euler, pic::palette::symplectic, pic::palette::runge_kutta,
          pic::palette::implicit, pic::palette::exponential, pic::palette::exact}) {
        CHECK((light(pic::palette::ground) + 0.05) / (light(c) + 0.05) > 3);  // as for large marks on the web
    }
    const pic::Colour vermilion = pic::hex("#D55E00");
    CHECK(vermilion.red == Approx(0xD5 / 255.0));
    CHECK(vermilion.green == Approx(0x5E / 255.0));
    CHECK(vermilion.blue == 0);
    CHECK(pic::web(pic::palette::ink, pic::Theme::light) == "#1d2126");
    CHECK(pic::web(pic::palette::ink, pic::Theme::dark) == "#eceff3");
    CHECK(pic::hex("0072b2") == pic::hex("#0072B2"));
}
