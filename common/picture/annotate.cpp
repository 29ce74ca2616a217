#include <cmath>

#include "grid.hpp"
#include "pieces.hpp"
#include "words.hpp"

namespace nutshell::picture {

using Eigen::Vector3d;

namespace {

/// Sizes of letters [pixels].
struct Letters {
    double title, caption, label, edge;
};

/// Half pictures keep their letters readable; on a phone they are as large as its text.
Letters letters_for(int width) {
    if (width < 480) return {16, 13, 14, 9};
    const double scale = std::max(0.75, width / 960.0);
    return {27 * scale, 19 * scale, 22 * scale, 20 * scale};
}

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

std::vector<Line> place_words(const Drawing& drawing, const Camera& camera, Size size) {
    const Letters letters = letters_for(size.width);
    const Colour quiet = mix(palette::ink, palette::paper, 0.25F);
    std::vector<Line> lines;
    auto write = [&](Line::Part part, const std::string& text, double height, Weight weight,
                     const Colour& ink) {
        const bool right = part == Line::Part::grid;
        const double width = text_width(text, height, weight), edge = letters.edge;
        const double left = right ? size.width - edge - width : edge;
        const double baseline = part == Line::Part::title ? edge + 0.8 * height : size.height - edge;
        lines.push_back({part, text, left, left + width, baseline, height, weight, ink, right});
    };
    using Part = Line::Part;
    if (!drawing.title().empty()) {
        write(Part::title, drawing.title(), letters.title, Weight::bold, palette::ink);
    }
    if (!drawing.caption().empty()) {
        write(Part::caption, drawing.caption(), letters.caption, Weight::regular, quiet);
    }
    if (drawing.ground().visible) {
        const double spacing = grid_spacing(drawing.ground(), frame_of(drawing, camera).unit);
        const std::string words = "grid " + written_length(spacing, drawing.ground().unit);
        write(Part::grid, words, letters.caption, Weight::regular, quiet);
    }
    std::vector<Taken> taken;
    for (const Line& line : lines) {
        taken.push_back({line.left - 4, line.baseline - line.height, line.right + 4,
                         line.baseline + 0.3 * line.height, 5});
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
    for (Line& line : place_anchored(size, anchored, letters.label, std::move(taken))) {
        lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace nutshell::picture
