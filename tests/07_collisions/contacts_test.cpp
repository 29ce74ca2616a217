// Contacts against what can be found without them: projections, corners, fine stepping.
#include <algorithm>
#include <nutshell/contacts.hpp>
#include <set>
#include "near.hpp"

using namespace nutshell;

namespace {

Body turned_body(Chance& chance, const Vector3& place) {
    Body body;
    body.position = place;
    body.orientation = quaternion_about(chance.direction(), chance(0, 2 * pi));
    return body;
}

/// The point of a box nearest to `point`.
Vector3 nearest(const Box& box, const Body& body, const Vector3& point) {
    const Vector3 own = rotate(inverse(body.orientation), point - body.position);
    return point_of(body, own.cwiseMax(-box.half).cwiseMin(box.half));
}

/// Distance of two boxes by projecting back and forth: slow, but nothing to get wrong.
double distance_between(const Box& s, const Body& a, const Box& t, const Body& b) {
    Vector3 on_b = b.position, on_a = a.position;
    for (int i = 0; i < 20000; ++i) {
        const Vector3 before = on_a;
        on_a = nearest(s, a, on_b), on_b = nearest(t, b, on_a);
        if (i > 0 && (on_a - before).norm() < 1e-14) break;
    }
    return (on_b - on_a).norm();
}

}  // namespace

TEST_CASE("Two boxes: apart exactly when a plane fits between them, and as deep as it takes to part them") {
    Chance chance(21);
    int apart = 0, faces_a = 0, faces_b = 0, edges = 0;
    for (int i = 0; i < 1000; ++i) {
        const Box s{{chance(0.2, 1), chance(0.2, 1), chance(0.2, 1)}},
            t{{chance(0.2, 1), chance(0.2, 1), chance(0.2, 1)}};
        const Body a = turned_body(chance, {0, 0, 0}),
                   b = turned_body(chance, chance.direction() * chance(0.5, 2.2));
        const BoxPair pair{s.half,
                           t.half,
                           a.position,
                           b.position,
                           rotation_matrix(a.orientation),
                           rotation_matrix(b.orientation)};
        const Apart found = farthest_apart(pair, 0);
        CHECK(found.normal.norm() == near(1, 1e-12));
        const double distance = distance_between(s, a, t, b);
        if (std::abs(found.gap) > 1e-3) CHECK((found.gap > 0) == (distance > 1e-6));
        if (found.gap > 0) {
            CHECK(found.gap <= distance + 1e-9);
            ++apart;
            continue;
        }
        ++(found.face >= 3 ? faces_b : found.face >= 0 ? faces_a : edges);
        Body away = b;
        away.position += (1e-3 - found.gap) * found.normal;
        CHECK(distance_between(s, a, t, away) >= 1e-3 - 1e-9);  // parted by that much, no more than needed:
        away.position -= 0.03 * found.normal;
        if (found.gap < -0.03) CHECK(distance_between(s, a, t, away) < 1e-4);
    }
    CHECK(apart > 200);
    CHECK(faces_a > 50);
    CHECK(faces_b > 50);
    CHECK(edges > 50);
}

TEST_CASE("Contacts of two boxes lie between them, and none closes in deeper than the gap says") {
    Chance chance(22);
    std::array<int, 6> points{};
    for (int i = 0; i < 3000; ++i) {
        const Box s{{chance(0.2, 1), chance(0.2, 1), chance(0.2, 1)}},
            t{{chance(0.2, 1), chance(0.2, 1), chance(0.2, 1)}};
        const Body a = turned_body(chance, {0, 0, 0}),
                   b = turned_body(chance, chance.direction() * chance(0.6, 1.6));
        std::vector<Contact> found;
        find_contacts(s, a, t, b, 0.05, found);
        REQUIRE(found.size() <= 5);
        ++points[found.size()];
        std::set<int> features;
        for (const Contact& c : found) {
            CHECK(c.normal.norm() == near(1, 1e-12));
            const Vector3 half = c.separation / 2 * c.normal;
            if (c.feature >= 0) {  // on both bodies, but for the hundredth that faces reach over
                CHECK((nearest(s, a, c.point - half) - (c.point - half)).norm() < 0.03);
                CHECK((nearest(t, b, c.point + half) - (c.point + half)).norm() < 0.03);
            }
            features.insert(c.feature);
        }
        CHECK(features.size() == found.size());  // every one has a name of its own
    }
    for (const std::size_t n : {std::size_t{0}, std::size_t{1}, std::size_t{4}}) CHECK(points[n] > 20);
    // one on the other, and a quarter over the edge
    std::vector<Contact> found;
    const Box cube{{0.5, 0.5, 0.5}};
    Body low, high;
    high.position = {0.25, 0.99, 0};
    find_contacts(cube, low, cube, high, 0.01, found);
    REQUIRE(found.size() == 4);
    for (const Contact& c : found) {
        CHECK(c.normal == Vector3(0, 1, 0));
        CHECK(c.separation == near(-0.01, 1e-15));
        CHECK(std::abs(c.point.z()) == near(0.5, 1e-12));
        CHECK((c.point.x() == near(0.505, 1e-12) || c.point.x() == near(-0.25, 1e-12)));
    }
}

TEST_CASE("Boxes with parallel edges, equal boxes in one place: no NaN") {
    const Box cube{{0.5, 0.5, 0.5}};
    Body a, b;
    for (const Vector3& place : {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(1, 1, 0), Vector3(1, 1, 1)}) {
        b.position = place;
        std::vector<Contact> found;
        find_contacts(cube, a, cube, b, 0.01, found);
        for (const Contact& c : found) {
            CHECK(c.point.allFinite());
            CHECK(c.normal.norm() == near(1, 1e-12));
            CHECK(std::isfinite(c.separation));
        }
    }
    std::vector<Contact> found;
    b.position = a.position;
    find_contacts(Sphere{1}, a, Sphere{1}, b, 0.1, found);  // coincident centres: the normal is up
    find_contacts(cube, a, Sphere{0.1}, b, 0.1, found);
    REQUIRE(found.size() == 2);
    for (const Contact& c : found) CHECK(c.normal.norm() == 1);
    CHECK(found[0].separation == -2);
    CHECK(found[1].separation == near(-0.6, 1e-15));
    CHECK_THROWS_WITH(find_contacts(Shape{Capsule{1, 1}}, a, Shape{Sphere{1}}, b, 1, found),
                      ContainsSubstring("planes only"));
}

TEST_CASE("A plane and what is in front of it: every contact in the middle of its gap, under its own point") {
    Chance chance(25);
    for (int i = 0; i < 300; ++i) {
        const Plane plane{chance.direction(), chance(-1, 1)};
        const Body body = turned_body(chance, (plane.offset + chance(-0.2, 1)) * plane.normal);
        const Sphere ball{0.4};
        const Box box{{0.3, 0.2, 0.5}};
        const Capsule rod{0.5, 0.1};
        std::vector<Vector3> lowest;  // the points that can touch: of the ball, the box, the rod
        lowest.push_back(body.position - ball.radius * plane.normal);
        for (int corner = 0; corner < 8; ++corner)
            lowest.push_back(point_of(body, corner_signs(corner).cwiseProduct(box.half)));
        for (const int end : {-1, 1})
            lowest.push_back(point_of(body, {0, end * rod.half_length, 0}) - rod.radius * plane.normal);
        std::vector<Contact> found;
        for (const Shape& shape : {Shape{ball}, Shape{box}, Shape{rod}})
            find_contacts(plane, shape, body, immovable, found);
        REQUIRE(found.size() == lowest.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
            const double gap = distance_to(plane, lowest[k]);
            CHECK(found[k].separation == near(gap, 1e-14));
            CHECK((found[k].point - (lowest[k] - gap / 2 * plane.normal)).norm() < 1e-14);
            CHECK(found[k].normal == plane.normal);
        }
        found.clear();
        const double margin = 0.3;
        find_contacts(plane, Shape{box}, body, margin, found);
        const auto near_ones = std::count_if(lowest.begin() + 1, lowest.begin() + 9, [&](const Vector3& p) {
            return distance_to(plane, p) < margin;
        });
        CHECK(found.size() == static_cast<std::size_t>(near_ones));
    }
}

TEST_CASE("A sphere and a box touch where the box is nearest, spheres on the line of their centres") {
    Chance chance(23);
    for (int i = 0; i < 1000; ++i) {
        const Box box{{chance(0.2, 1), chance(0.2, 1), chance(0.2, 1)}};
        const Sphere ball{chance(0.1, 0.5)};
        const Body a = turned_body(chance, chance.vector(1)), b = turned_body(chance, chance.vector(2));
        const Vector3 touch = nearest(box, a, b.position);
        const double distance = (b.position - touch).norm();
        std::vector<Contact> found, swapped;
        find_contacts(box, a, ball, b, 0.2, found);
        find_contacts(ball, b, box, a, 0.2, swapped);
        REQUIRE(found.size() == swapped.size());
        if (distance > 1e-9) REQUIRE(found.size() == (distance - ball.radius < 0.2 ? 1 : 0));
        if (found.empty()) continue;
        CHECK(found[0].normal == -swapped[0].normal);
        CHECK(found[0].point == swapped[0].point);
        if (distance < 1e-9) {
            CHECK(found[0].separation < -ball.radius);
            continue;
        }
        CHECK(found[0].separation == near(distance - ball.radius, 1e-12));
        CHECK((found[0].normal - (b.position - touch) / distance).norm() < 1e-9);
        CHECK((found[0].point - (touch + found[0].separation / 2 * found[0].normal)).norm() < 1e-12);
    }
}

TEST_CASE("Time of impact of a turning box or rod on a plane: not late, and early by the tolerance only") {
    Chance chance(24);
    int hits = 0;
    for (int i = 0; i < 60; ++i) {
        const int kind = i % 3;  // a cube, a rod, a plate: two equal moments, so that the motion is exact
        const bool rod = kind == 1;
        const Shape shape = rod         ? Shape{Capsule{0.5, 0.05}}
                            : kind == 0 ? Shape{Box{{0.3, 0.3, 0.3}}}
                                        : Shape{Box{{0.5, 0.01, 0.5}}};
        Body body = turned_body(chance, {0, chance(0.75, 2), 0});
        body.inertia = rod         ? Vector3(0.09, 0.00125, 0.09)
                       : kind == 0 ? Vector3::Constant(0.06)
                                   : Vector3(0.0834, 0.1667, 0.0834);
        body.momentum = chance.vector(2);
        body = spinning(body, chance.vector(rod ? 1 : kind == 0 ? 5 : 8));
        const Plane floor;
        const Vector3 fall{0, -9.81, 0};
        const double tolerance = 1e-6;
        const auto hit = time_of_impact(shape, body, fall, floor, 1, tolerance);
        // fine steps of the same motion, all from the start, so that no error collects
        const auto at = [&](double t) {
            return verlet(
                body,
                [&](const Body& b, double) {
                    return Wrench{b.mass * fall, {0, 0, 0}};
                },
                0, t);
        };
        double first = 2;
        for (int k = 0; k < 20000 && first > 1; ++k)
            if (gap_to(floor, shape, at(k * 5e-5)) <= tolerance) first = k * 5e-5;
        REQUIRE(hit.has_value() == (first < 1));
        if (!hit) continue;
        ++hits;
        CHECK(hit->time <= first + 1e-9);
        CHECK(hit->time >= first - 5.1e-5);
        CHECK(gap_to(floor, shape, hit->body) == near(tolerance / 2, tolerance / 2 + 1e-12));
        CHECK((hit->body.position - at(hit->time).position).norm() < 1e-12);
        CHECK(angle_between(hit->body.orientation, at(hit->time).orientation) < 1e-7);
    }
    CHECK(hits > 30);
    CHECK_FALSE(time_of_impact(Box{{1, 1, 1}}, Body{1, {1, 1, 1}, {0, 5, 0}}, {0, 0, 0}, Plane{}, 1e9, 1e-6));
    CHECK_THROWS_WITH(time_of_impact(Box{{1, 1, 1}}, Body{}, {0, 0, 0}, Plane{}, 1, 0),
                      ContainsSubstring("tolerance"));
}
