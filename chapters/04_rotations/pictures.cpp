// The pictures of chapter 4.
#include <nutshell/live/stills.hpp>
#include <nutshell/picture/picture.hpp>
#include "drawings.hpp"
#include "printed.hpp"
#include "program.hpp"

namespace nutshell {

namespace {

constexpr double degrees = 180 / pi;
const Vector3 y_axis = Vector3::UnitY(), z_axis = Vector3::UnitZ();

/// The book of the question, and the two axes it is to be turned about.
void question_picture(lab::Report& report) {
    const pic::Note note{report.command(), "the book of the question", "none yet", "", {}};
    pic::save(report.path("question.png"), note, [&]() -> pic::Sheet {
        pic::Drawing drawing;
        drawing.no_ground();
        drawing.add(book(four_vector({0, 0, 0}, 1), {0, 0, 0}, pic::palette::body));
        const auto axis = [&](const Vector3& along, const char* name, pic::Colour colour) {
            drawing.add(pic::Arrow{
                .from = -0.9 * along, .vector = 2.1 * along, .colour = colour, .label = name});
        };
        axis(Vector3::UnitX(), "x", pic::palette::angular_velocity);
        axis(z_axis, "z", pic::palette::angular_velocity);
        axis(y_axis, "y", pic::palette::steel);
        const auto turn = [&](const Vector3& along, const char* name, double name_at) {
            const Vector3 from = along.cross(Vector3(0.3, 0.8, 1)), middle = 0.95 * along;
            const auto ring = arc(middle, along, from, 0.3, 0, 1.5 * pi);
            drawing.add(
                pic::Trail{.points = ring, .colour = pic::palette::angular_velocity, .width = 4});
            drawing.add(
                pic::Arrow{.from = ring.back(),
                           .vector = 0.16 * along.cross(ring.back() - middle).normalized(),
                           .colour = pic::palette::angular_velocity});
            drawing.add(pic::Label{middle + turned(1.5 * (ring[0] - middle), along, name_at),
                                   name, pic::palette::angular_velocity});
        };
        turn(Vector3::UnitX(), "1st", pi);
        turn(z_axis, "2nd", pi / 2);
        return pic::Shot{
            drawing, pic::fit(drawing, {0.45, 0.4, 1}, {800, 420}, {.margin = 0.04}), {800, 420}};
    });
}

void along_and_across_picture(lab::Report& report) {
    const Vector3 n = y_axis, p = Vector3(1.0, 1.1, 0.35);
    const double angle = 1.1;
    const Vector3 along = n * n.dot(p), across = p - along, image = turned(p, n, angle);
    const pic::Note note{report.command(),
                         "a turn about an axis",
                         "Rodrigues' formula",
                         "",
                         {{"angle", angle * degrees, "degrees"}}};
    pic::save(report.path("along_and_across.png"), note, [&]() -> pic::Sheet {
        pic::Drawing drawing;
        drawing.ground({.height = 0, .spacing = 0.5});
        drawing.add(pic::Trail{.points = arc(along, n, across, across.norm(), 0, 2 * pi),
                               .colour = pic::palette::steel,
                               .dashed = true,
                               .width = 3});
        drawing.add(pic::Trail{.points = arc(along, n, across, 0.5 * across.norm(), 0, angle),
                               .colour = pic::palette::angular_velocity,
                               .width = 4});
        const auto arrow = [&](const Vector3& from, const Vector3& to, pic::Colour colour,
                               const char* name) {
            drawing.add(
                pic::Arrow{.from = from, .vector = to - from, .colour = colour, .label = name});
        };
        arrow({0, 0, 0}, 1.75 * n, pic::palette::angular_velocity, "n");
        arrow({0, 0, 0}, p, pic::palette::ink, "p");
        arrow({0, 0, 0}, image, pic::palette::body, "p'");
        arrow(along, p, pic::palette::ink, "");
        arrow(along, along + n.cross(p), pic::palette::steel, "n × p");
        arrow(along, image, pic::palette::body, "");
        drawing.add(pic::Label{along + turned(0.62 * across, n, angle / 2), "θ",
                               pic::palette::angular_velocity});
        drawing.add(pic::Label{0.45 * along + Vector3(-0.3, 0, 0), "along", pic::palette::ink});
        drawing.add(pic::Label{along + 0.3 * across + Vector3(-0.02, -0.13, 0), "across",
                               pic::palette::ink});
        return pic::Shot{drawing, pic::fit(drawing, {0.45, 0.42, 1})};
    });
}

void printed_picture(lab::Report& report) {
    const Vector3 n = direction_of({1, 2, 3});
    const double angle = pi / 3;
    const Matrix3 right = rotation_about(n, angle), wrong26 = printed::rotation_about(n, angle),
                  wrong28 = printed::rotation_matrix(quaternion_about(n, angle));
    const pic::Note note{report.command(),
                         "a cube turned by 60 degrees about (1, 2, 3)",
                         "(26*), (26) and (28) as printed",
                         "",
                         {{"volume by (26) as printed", wrong26.determinant(), ""},
                          {"volume by (28) as printed", wrong28.determinant(), ""}}};
    pic::save(report.path("printed.png"), note, [&]() -> pic::Sheet {
        const pic::Size third{400, 400};
        const auto shot = [&](const Matrix3& map, const char* title, pic::Colour colour) {
            pic::Drawing drawing;
            drawing.stage({{0, 0, 0}, 1.05}).no_ground();
            if (map != right)
                add_cube(drawing, right, {0, 0, 0}, pic::palette::steel, pic::Look::ghost);
            add_cube(drawing, map, {0, 0, 0}, colour);
            drawing.title(title);
            return pic::Shot{drawing, pic::fit(drawing, {0.5, 0.6, 1}, third), third};
        };
        return {{shot(right, "(26*), a turn", pic::palette::body),
                 shot(wrong26, "(26) as printed", pic::palette::explicit_euler),
                 shot(wrong28, "(28) as printed", pic::palette::explicit_euler)}};
    });
}

}  // namespace

void pictures(lab::Report& report) {
    live::draw_stills(report);
    question_picture(report);
    along_and_across_picture(report);
    printed_picture(report);
}

}  // namespace nutshell
