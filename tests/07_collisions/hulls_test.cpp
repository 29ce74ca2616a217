// Contacts of convex pieces: against boxes, and against brute force.
#include <nutshell/rest_scenes.hpp>
#include <set>
#include "pieces.hpp"

using namespace nutshell;

namespace {

/// The gap of two convex sets by brute force: all planes through three differences of corners that have
/// every other difference on one side, and of these the one farthest from the origin. Knows no faces, no
/// edges.
double gap_by_force(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
    std::vector<Vector3> d;
    for (const Vector3& p : a)
        for (const Vector3& q : b) d.push_back(q - p);
    double gap = -immovable;
    for (std::size_t i = 0; i < d.size(); ++i)
        for (std::size_t j = i + 1; j < d.size(); ++j)
            for (std::size_t k = j + 1; k < d.size(); ++k) {
                const Vector3 across = (d[j] - d[i]).cross(d[k] - d[i]);
                if (across.norm() < 1e-7) continue;
                const Vector3 n = across.normalized();
                double low = 0, high = 0;
                for (const Vector3& p : d) {
                    low = std::min(low, n.dot(p - d[i])), high = std::max(high, n.dot(p - d[i]));
                    if (low < -1e-12 && high > 1e-12) break;
                }
                if (low >= -1e-12) gap = std::max(gap, n.dot(d[i]));
                if (high <= 1e-12) gap = std::max(gap, -n.dot(d[i]));
            }
    return gap;
}

/// How far a point is outside of a hull, at least [m]; negative inside.
double outside(const Hull& hull, const Body& body, const Vector3& point) {
    const Vector3 own = rotate(inverse(body.orientation), point - body.position);
    double most = -immovable;
    for (std::size_t f = 0; f < hull.form->faces.size(); ++f)
        most = std::max(most, hull.form->normals[f].dot(own - hull.form->corners[hull.form->faces[f][0]]));
    return most;
}

/// The point of a hull nearest to another: Dykstra's projections on the half spaces of its faces.
Vector3 nearest_by_projections(const Polyhedron& form, const Vector3& point) {
    std::vector<Vector3> taken(form.faces.size(), Vector3::Zero());
    Vector3 x = point;
    for (int round = 0; round < 20000; ++round) {
        const Vector3 before = x;
        for (std::size_t f = 0; f < form.faces.size(); ++f) {
            const Vector3 y = x + taken[f];
            const double above = form.normals[f].dot(y - form.corners[form.faces[f][0]]);
            x = y - std::max(above, 0.0) * form.normals[f], taken[f] = y - x;
        }
        if ((x - before).norm() < 1e-15) break;
    }
    return x;
}

}  // namespace

TEST_CASE("Boxes as hulls have the contacts of boxes: gap, normal, points") {
    // Round-off: sums of a few products of numbers around 1. Where two directions are equally good but
    // for the slack, the two codes may take different ones: then their gaps differ by no more than the
    // slack allows.
    Chance chance(41);
    int alike = 0, others = 0, clamped = 0, edges = 0;
    for (int i = 0; i < 5000; ++i) {
        const Box s{{chance(0.2, 1), chance(0.2, 1), chance(0.2, 1)}},
            t{{chance(0.2, 1), chance(0.2, 1), chance(0.2, 1)}};
        const Body a = turned_body(chance, {0, 0, 0}), b = turned_body(chance, chance.vector(1));
        const Hull hull_s = box_hull(s.half), hull_t = box_hull(t.half);
        const BoxPair pair{s.half,
                           t.half,
                           a.position,
                           b.position,
                           rotation_matrix(a.orientation),
                           rotation_matrix(b.orientation)};
        const Apart of_boxes = farthest_apart(pair, 0);
        const HullsApart of_hulls = farthest_apart(placed(hull_s, a), placed(hull_t, b), 0);
        CHECK(of_hulls.gap == near(of_boxes.gap, 1e-13));
        CHECK((of_hulls.normal - of_boxes.normal).norm() < 1e-12);

        std::vector<Contact> boxes, hulls, mixed;
        find_contacts(s, a, t, b, 0.05, boxes);
        find_contacts(hull_s, a, hull_t, b, 0.05, hulls);
        find_contacts(i % 2 ? Shape{s} : Shape{hull_s}, a, i % 2 ? Shape{hull_t} : Shape{t}, b, 0.05, mixed);
        REQUIRE(mixed.size() == hulls.size());
        for (std::size_t k = 0; k < mixed.size(); ++k) {
            CHECK((mixed[k].point - hulls[k].point).norm() < 1e-13);
            CHECK(mixed[k].feature == hulls[k].feature);
        }
        if (boxes.empty() || hulls.empty()) {
            CHECK(boxes.size() == hulls.size());
            continue;
        }
        if ((boxes[0].normal - hulls[0].normal).norm() > 1e-9) {
            ++others;
            const double slack = 0.01 * std::min(s.half.minCoeff(), t.half.minCoeff());
            const auto gap = [&](const Vector3& n) {
                return gap_along(n, placed(hull_s, a), placed(hull_t, b));
            };
            CHECK(gap(boxes[0].normal) == near(gap(hulls[0].normal), 2 * slack));
            continue;
        }
        // Of more than four corners boxes take the lowest always, hulls if it is lower by the slack.
        REQUIRE((boxes.size() == hulls.size() || boxes.size() == hulls.size() + 1));
        for (const Contact& hull : hulls) {
            double best = immovable;
            for (const Contact& box : boxes)
                best = std::min(best,
                                (box.point - hull.point).norm() + std::abs(box.separation - hull.separation));
            if (hull.feature < 0) ++edges;
            if (hull.feature < 0 && best > 1e-12)
                ++clamped;  // the box's edges go on beyond their ends, the hull's do not
            else
                CHECK(best < 1e-12);
        }
        ++alike;
    }
    CHECK(alike > 3000);
    CHECK(edges > 500);
    CHECK(others < alike / 50);
    CHECK(clamped < edges / 50);
}

TEST_CASE("Tetrahedra and prisms: the gap, or the least way out, is that of brute force over all corners") {
    Chance chance(42);
    int apart = 0, faces = 0, edges = 0;
    for (int i = 0; i < 200; ++i) {
        const bool both = i % 2;  // two tetrahedra, or one and a prism
        const Hull s = piece_of(tetrahedron(chance, 1), 1000).hull,
                   t = piece_of(both ? tetrahedron(chance, 1) : prism(3, 0.8, 1), 1000).hull;
        const Body a = turned_body(chance, {0, 0, 0}), b = turned_body(chance, chance.vector(1));
        const PlacedHull of_a = placed(s, a), of_b = placed(t, b);
        const HullsApart found = farthest_apart(of_a, of_b, 0);
        // Apart, a direction across two edges may show more of the gap than the brute planes do, never
        // less.
        const double gap = gap_by_force(of_a.corners, of_b.corners);
        if (gap < 0)
            CHECK(found.gap == near(gap, 1e-11));
        else
            CHECK(found.gap >= gap - 1e-11);
        CHECK(found.gap == near(gap_along(found.normal, of_a, of_b), 1e-14));
        CHECK(found.normal.norm() == near(1, 1e-12));
        ++(found.gap > 0 ? apart : found.edges ? edges : faces);
    }
    CHECK(apart > 20);
    CHECK(faces > 20);
    CHECK(edges > 20);
}

TEST_CASE("Contacts of convex pieces lie on both, each with a name of its own, the same when they shake") {
    Chance chance(43);
    int several = 0, kept = 0, lost = 0;
    for (int i = 0; i < 2000; ++i) {
        const Piece s = any_piece(chance, 0.6), t = any_piece(chance, 0.6);
        const Body a = turned_body(chance, {0, 0, 0}), b = turned_body(chance, chance.vector(0.8));
        std::vector<Contact> found;
        find_contacts(s.hull, a, t.hull, b, 0.05, found);
        REQUIRE(found.size() <= 5);
        several += found.size() > 2;
        std::set<int> names;
        for (const Contact& c : found) {
            const Vector3 half = c.separation / 2 * c.normal;
            // Within the hundredth of a face that contacts may hang over; clamped edges may be off by a
            // gap.
            if (c.feature >= 0) {
                CHECK(outside(s.hull, a, c.point - half) < 0.02);
                CHECK(outside(t.hull, b, c.point + half) < 0.02);
            }
            names.insert(c.feature);
        }
        CHECK(names.size() == found.size());
        Body shaken = b;  // by far less than the slack
        shaken.position += 1e-6 * chance.direction();
        std::vector<Contact> again;
        find_contacts(s.hull, a, t.hull, shaken, 0.05, again);
        for (const Contact& c : again) ++(names.count(c.feature) ? kept : lost);
    }
    CHECK(several > 300);
    CHECK(lost * 200 < kept);  // one in two hundred: where an edge just meets a corner
}

TEST_CASE("A sphere touches a hull where projections on its faces end, and a plane at its corners") {
    Chance chance(44);
    int outside_ones = 0;
    for (int i = 0; i < 1000; ++i) {
        const Hull hull = any_piece(chance, 0.8).hull;
        const Sphere ball{chance(0.05, 0.3)};
        const Body a = turned_body(chance, chance.vector(1)), b = turned_body(chance, chance.vector(1.5));
        std::vector<Contact> found, swapped;
        find_contacts(hull, a, ball, b, 0.3, found);
        find_contacts(ball, b, hull, a, 0.3, swapped);
        REQUIRE(found.size() == swapped.size());
        const Vector3 own = rotate(inverse(a.orientation), b.position - a.position);
        const double inside = outside(hull, a, b.position);
        if (inside > 1e-6) {
            const double distance = (own - nearest_by_projections(*hull.form, own)).norm();
            if (std::abs(distance - ball.radius - 0.3) > 1e-6)
                REQUIRE(found.size() == (distance - ball.radius < 0.3 ? 1 : 0));
            if (found.empty()) continue;
            ++outside_ones;
            CHECK(found[0].separation == near(distance - ball.radius, 1e-9));
        } else {
            REQUIRE(found.size() == 1);
            CHECK(found[0].separation == near(inside - ball.radius, 1e-12));
        }
        CHECK(found[0].normal == -swapped[0].normal);
        CHECK(found[0].normal.norm() == near(1, 1e-12));
        const Vector3 to_ball = b.position - (ball.radius + found[0].separation / 2) * found[0].normal;
        CHECK((found[0].point - to_ball).norm() < 1e-12);

        const Plane plane{chance.direction(), chance(-0.5, 0.5)};
        std::vector<Contact> on_plane;
        find_contacts(plane, Shape{hull}, a, immovable, on_plane);
        REQUIRE(on_plane.size() == hull.form->corners.size());
        for (std::size_t k = 0; k < on_plane.size(); ++k) {
            const Vector3 corner = point_of(a, hull.form->corners[k]);
            CHECK(on_plane[k].separation == near(distance_to(plane, corner), 1e-14));
            CHECK((on_plane[k].point - corner + on_plane[k].separation / 2 * plane.normal).norm() < 1e-14);
        }
    }
    CHECK(outside_ones > 100);
}

TEST_CASE(
    "Hulls in one place, face on face, edge on face, edge along edge: finite, and as many points as needed") {
    const Hull cube = box_hull({0.5, 0.5, 0.5});
    const Piece wedge = piece_of(prism_mesh({{-0.5, 0}, {0.5, 0}, {0, 0.8}}, 1), 1000);
    Body a, b;
    for (const Vector3& place : {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(1, 1, 0), Vector3(1, 1, 1)}) {
        b.position = place;
        for (const Hull& other : {cube, wedge.hull}) {
            std::vector<Contact> found;
            find_contacts(cube, a, other, b, 0.01, found);
            find_contacts(cube, a, Sphere{0.2}, b, 0.01, found);
            for (const Contact& c : found) {
                CHECK(c.point.allFinite());
                CHECK(c.normal.norm() == near(1, 1e-12));
                CHECK(std::isfinite(c.separation));
            }
        }
    }
    const auto contacts = [&](const Hull& s, const Body& of_s, const Hull& t, const Body& of_t) {
        std::vector<Contact> found;
        find_contacts(s, of_s, t, of_t, 0.01, found);
        return found;
    };
    b.position = {0.2, 0.995, 0.1};
    CHECK(contacts(cube, a, cube, b).size() == 4);  // face on face
    // the wedge stands on its ridge: two ends of an edge
    const double tip = 0.8 - wedge.body.position.y();
    Body upside = wedge.body;
    upside.orientation = quaternion_about(Vector3::UnitZ(), pi) * wedge.body.orientation;
    upside.position = {0, 0.499 + tip, 0};
    const auto ridge = contacts(cube, a, wedge.hull, upside);
    REQUIRE(ridge.size() == 2);
    for (const Contact& c : ridge) {
        CHECK((c.normal - Vector3(0, 1, 0)).norm() < 1e-12);
        CHECK(c.separation == near(-0.001, 1e-12));
        CHECK(std::abs(c.point.z()) == near(0.5, 1e-12));
    }
    // crossed ridges: one point
    Body below = wedge.body;
    below.orientation = quaternion_about(Vector3::UnitY(), pi / 2) * wedge.body.orientation;
    below.position = {0, 0, 0}, upside.position = {0, 2 * tip - 0.001, 0};
    const auto crossed = contacts(wedge.hull, below, wedge.hull, upside);
    REQUIRE(crossed.size() == 1);
    CHECK((crossed[0].point - Vector3(0, tip - 0.0005, 0)).norm() < 1e-9);
    CHECK(crossed[0].separation == near(-0.001, 1e-9));
    // eight corners of two equal faces, one turned by 45 degrees: the four outermost and the lowest
    b.position = {0, 0.995, 0}, b.orientation = quaternion_about(Vector3::UnitY(), pi / 4);
    const auto star = contacts(cube, a, cube, b);
    CHECK(star.size() >= 4);
    CHECK(star.size() <= 5);
    std::vector<Contact> none;
    CHECK_THROWS_WITH(find_contacts(Shape{Capsule{1, 1}}, a, Shape{cube}, b, 1, none),
                      ContainsSubstring("planes only"));
}
