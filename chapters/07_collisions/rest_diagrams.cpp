// Diagrams of the second half, drawn from what the engine's own functions find.
#include <nutshell/box_contacts.hpp>
#include <nutshell/chart/diagram.hpp>
#include <nutshell/rotations.hpp>
#include "program.hpp"

namespace nutshell {

void rest_diagrams(lab::Report& report) {
    // two boxes that do not touch, seen along z
    const Vector3 half_a(0.6, 0.4, 0.5), half_b(0.4, 0.4, 0.5), place_a(0, 0, 0),
        place_b(1.25, 0.45, 0);
    const double angle = 0.5;
    const BoxPair pair{half_a, half_b, place_a, place_b, Matrix3::Identity(), rotation_z(angle)};
    const Apart apart = farthest_apart(pair, 1e-3);
    const Vector3 n = apart.normal;
    chart::Diagram side;
    side.title = "Is there a plane between them?";
    side.box({place_a.x(), place_a.y()}, 2 * half_a.x(), 2 * half_a.y(), 0, "A");
    side.box({place_b.x(), place_b.y()}, 2 * half_b.x(), 2 * half_b.y(), angle, "B");
    double reach_a = 0;
    for (int i = 0; i < 3; ++i) reach_a += half_a[i] * std::abs(n[i]);
    const Vector3 middle = (reach_a + apart.gap / 2) * n, along = n.cross(Vector3::UnitZ());
    const Vector3 low = middle - 0.8 * along, high = middle + 0.8 * along;
    side.dashed({{low.x(), low.y()}, {high.x(), high.y()}});
    const Vector3 foot = reach_a * n - 0.3 * along;
    side.arrow({foot.x(), foot.y()}, {0.5 * n.x(), 0.5 * n.y()}, chart::Quantity::plain, "n");

    // two faces, from above
    const Vector3 half(0.6, 0.5, 0);
    const Matrix3 turn = rotation_z(0.6);
    const Vector3 centre(0.35, 0.2, 0), u = turn * Vector3(0.55, 0, 0),
                                        v = turn * Vector3(0, 0.45, 0);
    Polygon face;
    face.add(centre - u - v, 5), face.add(centre + u - v, 10), face.add(centre + u + v, 15),
        face.add(centre - u + v, 20);
    const auto outline = [](const Polygon& polygon) {
        std::vector<chart::Place> corners;
        for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.size); ++i)
            corners.push_back({polygon.corner[i].x(), polygon.corner[i].y()});
        return corners;
    };
    chart::Diagram top;
    top.title = "Where do they touch?";
    top.box({0, 0}, 2 * half.x(), 2 * half.y(), 0, "A");
    top.polygon(outline(face)).as_ghost();
    Polygon left = clipped(face, 0, 1, half.x(), 1);
    left = clipped(left, 0, -1, half.x(), 2);
    left = clipped(left, 1, 1, half.y(), 3);
    left = clipped(left, 1, -1, half.y(), 4);
    top.polygon(outline(left));
    for (const chart::Place& at : outline(left)) top.dots.push_back({at, false});
    top.note({centre.x() + 0.45, centre.y() + 0.55}, "B");
    report.number("manifold.corners", left.size);

    chart::Diagrams both;
    both.title = "A plane between two boxes, or the corners of a cut face";
    both.panels = {side, top};
    chart::write_svg(both, report.path("manifold.svg"));
}

}  // namespace nutshell
