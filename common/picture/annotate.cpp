#include <cmath>

#include "grid.hpp"
#include "pieces.hpp"
#include "words.hpp"

namespace nutshell::picture {

using Eigen::Vector3d;

namespace {

/// What labels had better not cover: balls and trails.
std::vector<Taken> covered(const Drawing& drawing, const Camera& camera, Size size) {
    std::vector<Taken> all;
    const double scale =
        size.height / 2.0 / std::tan(camera.field_of_view / 2);  // pixels of a metre one metre away
    for (const Ball& ball : drawing.balls()) {
        const Vector3d p = project(camera, size, ball.centre);
        if (p.z() <= 0) continue;
        const double r = 0.9 * ball.radius * scale / p.z();
        all.push_back({p.x() - r, p.y() - r, p.x() + r, p.y() + r});
    }
    const double step = 6;  // between two points of a trail that count [pixels]
    for (const Trail& trail : drawing.trails()) {
        Vector3d last = Vector3d::Constant(-1e9);
        for (const Vector3d& point : trail.points) {
            const Vector3d p = project(camera, size, point);
            if (p.z() <= 0 || (p - last).head<2>().norm() < step) continue;
            all.push_back({p.x() - step / 2, p.y() - step / 2, p.x() + step / 2, p.y() + step / 2});
            last = p;
        }
    }
    return all;
}

}  // namespace

void write_words(Image& image, const Drawing& drawing, const Camera& camera, Size size) {
    const double scale = std::max(0.75, size.width / 960.0);  // half pictures keep their letters readable
    const double title_height = 27 * scale, caption_height = 19 * scale, label_height = 22 * scale,
                 edge = 20 * scale;
    const Colour quiet = mix(palette::ink, palette::paper, 0.25F);
    std::vector<Taken> taken;
    auto write = [&](double x, double baseline, const std::string& text, double height, Weight weight,
                     const Colour& ink) {
        draw_text(image, x, baseline, text, height, weight, ink);
        taken.push_back(
            {x - 4, baseline - height, x + text_width(text, height, weight) + 4, baseline + 0.3 * height, 5});
    };
    if (!drawing.title().empty()) {
        write(edge, edge + 0.8 * title_height, drawing.title(), title_height, Weight::bold, palette::ink);
    }
    if (!drawing.caption().empty()) {
        write(edge, size.height - edge, drawing.caption(), caption_height, Weight::regular, quiet);
    }
    if (drawing.ground().visible) {
        const double spacing = grid_spacing(drawing.ground(), frame_of(drawing, camera).unit);
        const std::string words = "grid " + written_length(spacing, drawing.ground().unit);
        const double width = text_width(words, caption_height, Weight::regular);
        write(size.width - edge - width, size.height - edge, words, caption_height, Weight::regular, quiet);
    }
    for (const Taken& thing : covered(drawing, camera, size)) taken.push_back(thing);
    std::vector<AnchoredWords> anchored;
    auto anchor = [&](const Vector3d& at, double dx, double dy, const std::string& text, const Colour& ink) {
        const Vector3d p = project(camera, size, at);
        if (!text.empty() && p.z() > 0)
            anchored.push_back({p.x(), p.y(), dx, dy, text, mix(ink, palette::ink, 0.25F)});
    };
    for (const Arrow& arrow : drawing.arrows()) {
        const Vector3d foot = project(camera, size, arrow.from),
                       tip = project(camera, size, arrow.from + arrow.vector);
        anchor(arrow.from + arrow.vector, tip.x() - foot.x(), tip.y() - foot.y(), arrow.label, arrow.colour);
    }
    for (const Label& label : drawing.labels()) anchor(label.at, 1, -1, label.text, label.colour);
    draw_anchored(image, anchored, label_height, std::move(taken));
}

}  // namespace nutshell::picture
