// Convex pieces against boxes, against brute force, at the door, and in the engine.
#include <nutshell/hull_shapes.hpp>
#include <nutshell/mesh_shapes.hpp>
#include <nutshell/rest_scenes.hpp>
#include <set>
#include "near.hpp"

using namespace nutshell;

namespace {

constexpr double dt = 1 / 60.0;

Body turned_body(Chance& chance, const Vector3& place) {
    Body body;
    body.position = place;
    body.orientation = quaternion_about(chance.direction(), chance(0, 2 * pi));
    return body;
}

/// A tetrahedron by chance, not too flat.
Mesh tetrahedron(Chance& chance, double size) {
    for (;;) {
        Mesh mesh;
        for (int i = 0; i < 4; ++i) mesh.vertices.push_back(chance.vector(size));
        const auto& v = mesh.vertices;
        const double six = (v[1] - v[0]).dot((v[2] - v[0]).cross(v[3] - v[0]));
        if (std::abs(six) < 0.5 * size * size * size) continue;
        mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
        if (six < 0)
            for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
        return mesh;
    }
}

/// A prism over a regular polygon, its first corner moved a little outwards: no symmetry.
Mesh prism(int sides, double radius, double depth) {
    std::vector<std::array<double, 2>> polygon;
    for (int i = 0; i < sides; ++i) {
        const double r = i == 0 ? 1.1 * radius : radius, angle = 2 * pi * i / sides;
        polygon.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return prism_mesh(polygon, depth);
}

Piece any_piece(Chance& chance, double size) {
    const int kind = static_cast<int>(chance(0, 3));
    if (kind == 0) return piece_of(tetrahedron(chance, size), 1000);
    return piece_of(prism(kind == 1 ? 3 : 5, size, chance(0.5, 1.5) * size), 1000);
}

/// The gap of two convex sets by brute force: all planes through three differences of corners that have every
/// other difference on one side, and of these the one farthest from the origin. Knows no faces, no edges.
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

struct Seen {
    double drift = 0, overlap = 0, energy = 0, last_speed = 0;
};
Seen watch(World world, int steps, int sub_steps = 4) {
    checked(world);
    Engine engine({sub_steps});
    Seen seen;
    const double before = energy(world);
    for (int i = 0; i < steps; ++i) {
        engine.step(world, dt);
        for (const Body& body : world.bodies)
            seen.drift = std::max(seen.drift, std::hypot(body.position.x(), body.position.z()));
        seen.overlap = std::max(seen.overlap, deepest_overlap(world));
        seen.energy = std::max(seen.energy, energy(world) / before);
        if (i >= steps - 60) seen.last_speed = std::max(seen.last_speed, top_speed(world));
    }
    return seen;
}

/// A room of hulls, boxes and spheres by chance, none overlapping, all flying and turning.
World room_of_hulls(std::uint64_t seed) {
    Chance chance(seed);
    World world;
    world.walls = box_room(1.5);
    world.surface.friction = chance(0, 1);
    for (int tries = 0; world.bodies.size() < 10 && tries < 300; ++tries) {
        const double kind = chance(0, 1), size = chance(0.15, 0.4);
        Shape shape = Sphere{size};
        Body body = solid_ball(1, size, {0, 0, 0});
        if (kind < 0.6) {
            const Piece piece = any_piece(chance, size);
            const double mass = chance(0.5, 2);  // heavy on light is another test
            body = piece.body, shape = piece.hull;
            body.inertia *= mass / body.mass, body.mass = mass;
        } else if (kind < 0.8) {
            const Box box{{size, 0.7 * size, 0.5 * size}};
            body = solid_box(1, box, {0, 0, 0}), shape = box;
        }
        body.position = {chance(-1.2, 1.2), chance(0.4, 4), chance(-1.2, 1.2)};
        body.orientation = quaternion_about(chance.direction(), chance(0, 2 * pi));
        body.momentum = body.mass * chance.vector(3);
        body = spinning(body, chance.vector(5));
        World with = world;
        with.add(body, shape);
        if (deepest_overlap(with) == 0 && escaped(with) == 0) world = with;
    }
    return world;
}

void check_rooms_of_hulls(std::uint64_t from, std::uint64_t to, int sub_steps) {
    for (std::uint64_t seed = from; seed <= to; ++seed) {
        World world = checked(room_of_hulls(seed));
        Engine engine({sub_steps});
        const double before = energy(world);
        double highest = -immovable;
        bool finite = true;
        for (int i = 0; i < 120; ++i) {
            engine.step(world, dt);
            const double now = energy(world);
            highest = std::max(highest, now), finite = finite && std::isfinite(now);
        }
        if (finite && highest <= before && escaped(world) == 0) continue;
        FAIL_CHECK("room " << seed << ": energy " << highest << " of " << before << ", " << escaped(world)
                           << " escaped, finite: " << finite);
    }
}

}  // namespace

TEST_CASE("Boxes as hulls have the contacts of boxes: gap, normal, points") {
    // Round-off: sums of a few products of numbers around 1. Where two directions are equally good but for
    // the slack, the two codes may take different ones: then their gaps differ by no more than the slack
    // allows.
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
        REQUIRE((boxes.size() == hulls.size() || (boxes.size() == 5 && hulls.size() == 4)));
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
        // Apart, a direction across two edges may show more of the gap than the brute planes do, never less.
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
            // Within the hundredth of a face that contacts may hang over; clamped edges may be off by a gap.
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

TEST_CASE("A mesh becomes a piece: mass, centre, axes and faces of the solid it encloses") {
    const Vector3 size(0.4, 0.2, 0.7);
    const Matrix3 turn = rotation_matrix(quaternion_about(Vector3(1, 2, 3).normalized(), 0.7));
    const Piece piece = piece_of(placed(box_mesh(size), turn, {1, 2, 3}), 1000);
    CHECK(piece.body.mass == near(1000 * size.prod(), 1e-10));
    CHECK((piece.body.position - Vector3(1, 2, 3)).norm() < 1e-14);
    const Polyhedron& form = *piece.hull.form;
    CHECK(form.faces.size() == 6);
    CHECK(form.edges.size() == 12);
    CHECK(form.directions.size() == 3);
    CHECK(form.inner == near(0.1, 1e-14));
    CHECK(form.reach == near(size.norm() / 2, 1e-14));
    Vector3 moments = piece.body.inertia, by_formula = box_inertia(piece.body.mass, size);
    std::sort(moments.begin(), moments.end()), std::sort(by_formula.begin(), by_formula.end());
    CHECK((moments - by_formula).norm() < 1e-12 * by_formula.norm());
    for (const Vector3& corner : form.corners) {  // in the world they are the mesh's
        double best = 1;
        for (const Vector3& vertex : placed(box_mesh(size), turn, {1, 2, 3}).vertices)
            best = std::min(best, (point_of(piece.body, corner) - vertex).norm());
        CHECK(best < 1e-14);
    }
    const Piece barrel = piece_of(cylinder_mesh(0.5, 1, 12), 600);
    CHECK(barrel.hull.form->faces.size() == 14);
    CHECK(barrel.hull.form->directions.size() == 7);
}

TEST_CASE("Hulls at the door: open, flat, dented, off centre, inside out, without form") {
    const auto refused = [](const Mesh& mesh, const std::string& reason) {
        CHECK_THROWS_WITH(piece_of(mesh, 1000), ContainsSubstring(reason));
    };
    Mesh open = box_mesh({1, 1, 1});
    open.triangles.pop_back();
    refused(open, "open");
    Mesh flat = box_mesh({1, 1, 1});
    for (Vector3& vertex : flat.vertices) vertex.z() = 0;
    refused(flat, "no volume");
    refused(prism_mesh({{0, 0}, {1, 0}, {0.2, 0.2}, {0, 1}}, 1), "dent");
    refused(mesh_of(dumbbell()), "dent");
    Mesh inside_out = box_mesh({1, 1, 1});
    for (auto& triangle : inside_out.triangles) std::swap(triangle[0], triangle[1]);
    refused(inside_out, "inside out");

    const Polyhedron cube = *box_hull({1, 1, 1}).form;
    auto corners = cube.corners;
    for (Vector3& corner : corners) corner.x() += 0.1;
    CHECK_THROWS_WITH(hull_of(corners, cube.faces), ContainsSubstring("centre of mass"));
    for (Vector3& corner : corners) corner.x() += 2;
    CHECK_THROWS_WITH(hull_of(corners, cube.faces), ContainsSubstring("not inside"));
    auto faces = cube.faces;
    faces.pop_back();
    CHECK_THROWS_WITH(hull_of(cube.corners, faces), ContainsSubstring("open"));
    faces = cube.faces;
    faces[0] = {1, 3, 7}, faces.push_back({1, 7, 5});
    CHECK_THROWS_WITH(hull_of(cube.corners, faces), ContainsSubstring("one plane"));
    faces = cube.faces, faces[0] = {1, 3, 9};
    CHECK_THROWS_WITH(hull_of(cube.corners, faces), ContainsSubstring("corner that is none"));
    corners = cube.corners, corners[3].z() -= 0.1;
    CHECK_THROWS_AS(hull_of(corners, cube.faces), std::invalid_argument);
    corners = cube.corners, corners[3].z() = std::nan("");
    CHECK_THROWS_AS(hull_of(corners, cube.faces), std::invalid_argument);
    refused(cylinder_mesh(0.5, 1, 60), "100 corners");
    CHECK_THROWS_WITH(checked(Shape{Hull{}}), ContainsSubstring("no form"));
}

TEST_CASE("Ten cubes as hulls stand as ten boxes do, and so do ten prisms with six sides") {
    // Going round in another order ends elsewhere: measured 3.9 mm of drift as hulls, 2.1 mm as boxes.
    World world = Stack{}.start();
    const Seen boxes = watch(world, 600);
    for (Shape& shape : world.shapes) shape = box_hull({0.5, 0.5, 0.5});
    const Seen cubes = watch(world, 600);
    CHECK(cubes.drift <= 2 * boxes.drift);
    CHECK(cubes.overlap <= 0.002);  // the bounds of S14
    CHECK(cubes.last_speed <= 1e-4);
    CHECK(cubes.energy <= 1);
    CHECK(watch(world, 600, 8).drift <= 0.003);
    World tower;
    tower.walls = {Plane{}};
    const Matrix3 upright = rotation_matrix(quaternion_about(Vector3::UnitX(), -pi / 2));
    for (int i = 0; i < 10; ++i) {
        const Piece piece = piece_of(placed(prism(6, 0.5, 0.5), upright, {0, 0.25 + 0.5 * i, 0}), 1000);
        tower.add(piece.body, piece.hull);
    }
    const double off = tower.bodies[0].position.x();  // the long corner draws the centre aside
    const Seen prisms = watch(tower, 600, 8);
    CHECK(prisms.drift - off <= 0.003);
    CHECK(prisms.overlap <= 0.002);
    CHECK(prisms.last_speed <= 1e-4);
}

TEST_CASE("10^2 rooms of hulls, boxes and spheres by chance: no NaN, nobody escapes, no energy gained") {
    check_rooms_of_hulls(1, 100, 4);
}

TEST_CASE("10^4 rooms of hulls, boxes and spheres by chance", "[.million]") {
    // With four sub-steps two of these gain energy: a thin tetrahedron that spins at 28/s, thrown from the
    // floor at a wall, turns by too much in a sub-step.
    check_rooms_of_hulls(101, 10000, 8);
}
