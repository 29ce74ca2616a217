// Chapter 6: meshes and OBJ files: exact integrals, and everything wrong refused with line and reason.
#include <cstdio>
#include <nutshell/mesh_shapes.hpp>
#include <nutshell/obj.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

const double epsilon = std::numeric_limits<double>::epsilon();

const std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const auto at = text.find(what);
    REQUIRE(at != text.npos);
    return text.replace(at, what.size(), by);
}

void check_refused(const std::string& text, const std::string& where, const std::string& reason) {
    INFO(text.substr(0, 200));
    CHECK_THROWS_WITH(parse_obj(text, "a.obj"), ContainsSubstring(where) && ContainsSubstring(reason));
    CHECK_THROWS_AS(parse_obj(text), std::runtime_error);
}

}  // namespace

TEST_CASE("A tetrahedron, a box and a prism by the integrals over their skins: exact") {
    const MassProperties t = mass_properties(parse_obj(tetrahedron), 6);
    CHECK(t.mass == Approx(1).epsilon(8 * epsilon));
    CHECK((t.centre - Vector3::Constant(0.25)).norm() < 4 * epsilon);
    // about the centre: integral of x^2 is V (1/10 - 1/16), of x y it is V (1/20 - 1/16), and V density = 1
    const double own = 2 * (1. / 10 - 1. / 16), mixed = -(1. / 20 - 1. / 16);
    CHECK((t.inertia.diagonal() - Vector3::Constant(own)).norm() < 4 * epsilon);
    CHECK(t.inertia(0, 1) == Approx(mixed).epsilon(8 * epsilon));

    const Vector3 size(2, 3, 5);
    const MassProperties box = mass_properties(box_mesh(size), 1);
    CHECK(box.mass == Approx(30).epsilon(4 * epsilon));
    CHECK((box.inertia.diagonal() - box_inertia(30, size)).norm() < 200 * epsilon);

    // A prism of n sides: area n/2 r^2 sin a, a = 2 pi/n; about its axis m r^2 (2 + cos a)/6.
    const int sides = 7;
    const double a = 2 * pi / sides;
    const MassProperties prism = mass_properties(cylinder_mesh(0.5, 2, sides), 1);
    CHECK(prism.mass == Approx(2 * sides / 2. * 0.25 * std::sin(a)).epsilon(16 * epsilon));
    CHECK(prism.inertia(2, 2) == Approx(prism.mass * 0.25 * (2 + std::cos(a)) / 6).epsilon(16 * epsilon));
}

TEST_CASE("A ball of more and more faces becomes a ball at order two") {
    Convergence volume, inertia;
    for (const int rings : {16, 32, 64, 128}) {
        const MassProperties ball = mass_properties(ball_mesh(1, rings), 1);
        volume.dt.push_back(1. / rings), volume.error.push_back(4 * pi / 3 - ball.mass);
        inertia.dt.push_back(1. / rings);
        inertia.error.push_back((ball.inertia.diagonal() - ball_inertia(ball.mass, 1)).norm());
    }
    CHECK_THAT(volume, HasOrder(2));
    CHECK_THAT(inertia, HasOrder(2));
}

TEST_CASE("OBJ: polygons, negative indices, v/vt/vn, comments, CRLF, tabs, plus signs, no last newline") {
    const Mesh plain = parse_obj(tetrahedron);
    std::string dos = tetrahedron;
    for (std::size_t at = 0; (at = dos.find('\n', at)) != dos.npos; at += 2) dos.replace(at, 1, "\r\n");
    for (const std::string& text :
         {dos, tetrahedron.substr(0, tetrahedron.size() - 1), "# a comment\n\n  \t\n" + tetrahedron,
          replaced(tetrahedron, "v 1 0 0", "\tv\t+1e0 0 0 1 # weight"),
          replaced(tetrahedron, "f 2 3 4", "f -3 -2 -1"),
          "o thing\ng part\ns off\nusemtl x\nmtllib y.mtl\n" + tetrahedron,
          "vt 0 0\nvn 0 0 1\n" + replaced(tetrahedron, "f 1 3 2", "f 1/1/1 3/-1/-1 2//1"),
          "vt 0 0\n" + replaced(tetrahedron, "f 1 3 2", "f 1/1 3/1 2/1"),
          replaced(tetrahedron, "v 0 0 1", "v 0 0 1 0.5 0.25 1")}) {
        const Mesh mesh = parse_obj(text);
        CHECK(mesh.vertices == plain.vertices);
        CHECK(mesh.triangles == plain.triangles);
    }
    const std::string box =
        "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nv 0 0 5\nv 2 0 5\nv 2 3 5\nv 0 3 5\n"
        "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    CHECK(parse_obj(box).triangles.size() == 12);
    CHECK(mass_properties(parse_obj(box), 2).mass == Approx(60).epsilon(4 * epsilon));
    // seams: every face with vertices of its own, as programs for painting write them
    std::string seams;
    for (const auto& triangle : plain.triangles) {
        std::ostringstream text;
        for (const int i : triangle)
            text << "v " << plain.vertices[static_cast<std::size_t>(i)].transpose() << '\n';
        seams += text.str() + "f -3 -2 -1\n";
    }
    CHECK(mass_properties(parse_obj(seams), 6).mass == Approx(1).epsilon(8 * epsilon));
}

TEST_CASE("OBJ: everything wrong ends in an error with file, line and reason") {
    check_refused("", "a.obj", "no faces");
    check_refused("v 0 0 0\nv 1 0 0\n", "a.obj", "no faces");
    check_refused("v 1 2\n", "a.obj:1", "missing");
    check_refused("v 1 2 x\n", "a.obj:1", "'x' is not a number");
    check_refused("v 1 2 3,5\n", "a.obj:1", "not a number");
    check_refused("v 1 2 nan\n", "a.obj:1", "not finite");
    check_refused("v 1 2 inf\n", "a.obj:1", "not finite");
    check_refused("v 1 2 1e999\n", "a.obj:1", "fits");
    check_refused("v 1 2 1e200\n", "a.obj:1", "1e30");
    check_refused("v 1 2 3 4 5 6 7 8\n", "a.obj:1", "more than seven");
    check_refused(replaced(tetrahedron, "f 1 3 2", "f 1 3"), "a.obj:5", "three corners");
    check_refused(replaced(tetrahedron, "f 1 3 2", "f 1 3 9"), "a.obj:5", "no vertex 9; the file has 4");
    check_refused(replaced(tetrahedron, "f 1 3 2", "f 1 3 -5"), "a.obj:5", "no vertex -5");
    check_refused(replaced(tetrahedron, "f 1 3 2", "f 0 3 2"), "a.obj:5", "no vertex 0");
    check_refused(replaced(tetrahedron, "f 1 3 2", "f 1.5 3 2"), "a.obj:5", "'1.5' is not the index");
    check_refused(replaced(tetrahedron, "f 1 3 2", "f 99999999999999999999 3 2"), "a.obj:5", "not the index");
    check_refused(replaced(tetrahedron, "f 1 3 2", "f 1/1 3 2"), "a.obj:5", "no texture 1");
    check_refused(replaced(tetrahedron, "f 1 3 2", "f 1//7 3 2"), "a.obj:5", "no normal 7");
    check_refused(replaced(tetrahedron, "f 1 3 2", "f 1/ 3 2"), "a.obj:5", "texture");
    check_refused(replaced(tetrahedron, "f 1 3 2", "f 1/1/1/1 3 2"), "a.obj:5", "texture");
    check_refused("vt 0 0\nvn 0 0 1\n" + replaced(tetrahedron, "f 1 3 2", "f 1/1/1/1 3 2"), "a.obj:7",
                  "normal");
    check_refused("solid of another format\n", "a.obj:1", "'solid' begins no statement");
    check_refused("f 1 2 3\n" + tetrahedron, "a.obj:1", "has 0 so far");
    std::string hostile("v 0 0 0\n\0\x01\xff\x7f", 12);
    check_refused(hostile, "a.obj:2", "begins no statement");
    CHECK_THROWS_WITH(load_obj("no/such/file.obj"), ContainsSubstring("no/such/file.obj"));
    CHECK_THROWS_WITH(load_obj("."), ContainsSubstring("."));
}

TEST_CASE("Meshes that enclose nothing are refused with the reason and the line of a face at fault") {
    const auto refuse = [](const std::string& text, const std::string& reason) {
        CHECK_THROWS_WITH(mass_properties(parse_obj(text), 1), ContainsSubstring(reason));
        CHECK_THROWS_AS(mass_properties(parse_obj(text), 1), std::invalid_argument);
    };
    // a file that ends too early, between two lines
    refuse(tetrahedron.substr(0, tetrahedron.size() - 8), "open");
    refuse(tetrahedron.substr(0, tetrahedron.size() - 8), "line 5");
    refuse(replaced(tetrahedron, "f 1 3 2", "f 1 2 3"), "inside out");
    std::string inside_out = tetrahedron;
    for (const auto& [a, b] : {std::pair{"f 1 3 2", "f 1 2 3"},
                               {"f 1 2 4", "f 1 4 2"},
                               {"f 1 4 3", "f 1 3 4"},
                               {"f 2 3 4", "f 2 4 3"}})
        inside_out = replaced(inside_out, a, b);
    refuse(inside_out, "volume is negative");
    refuse(tetrahedron + "f 2 3 4\n", "3 faces");
    refuse(replaced(tetrahedron, "v 0 0 1", "v 1 1 0"), "encloses no volume");  // flat
    refuse("v 0 0 0\nf 1 1 1\n", "encloses no volume");
    CHECK_THROWS_WITH(mass_properties(Mesh{}, 1), ContainsSubstring("no faces"));
    CHECK_THROWS_WITH(mass_properties(box_mesh({1, 1, 1}), -1), ContainsSubstring("density"));
    CHECK_THROWS_WITH(mass_properties(Mesh{{Vector3::Zero()}, {{0, 1, 2}}, {}}, 1),
                      ContainsSubstring("no vertex"));
    // A skin that passes through itself: a box, and a smaller one of the wrong way round that sticks out of
    // it.
    Mesh box = box_mesh({1, 1, 1}), hole = placed(box_mesh({0.1, 0.1, 10}), Matrix3::Identity(), {0, 0, 0});
    for (auto& t : hole.triangles) std::swap(t[1], t[2]);
    CHECK_THROWS_WITH(mass_properties(merged(box, hole), 1), ContainsSubstring("passes through itself"));
    CHECK_THROWS_WITH(mass_properties(merged(box, box), 1), ContainsSubstring("more than its bounding box"));
    // what it encloses twice it counts twice, and nothing tells: 1 and 1/8, of which 0.35/4 is shared
    const Mesh bump = placed(box_mesh({0.5, 0.5, 0.5}), Matrix3::Identity(), {0.4, 0, 0});
    CHECK(mass_properties(merged(box, bump), 1).mass == Approx(1.125).epsilon(8 * epsilon));
    // a hollow ball has a skin of that kind and is in order
    Mesh cavity = ball_mesh(0.5, 32);
    for (auto& t : cavity.triangles) std::swap(t[1], t[2]);
    const MassProperties shell = mass_properties(merged(ball_mesh(1, 32), cavity), 1);
    CHECK(shell.inertia(0, 0) / shell.mass ==
          Approx(0.4 * (1 - std::pow(0.5, 5)) / (1 - std::pow(0.5, 3))).epsilon(0.01));
}

TEST_CASE("The text of a mesh reads back as the mesh, and a mesh far from the origin keeps its inertia") {
    const Mesh ball = ball_mesh(0.3, 9);
    const Mesh again = parse_obj(obj_text(ball, "a ball"));
    CHECK(again.vertices == ball.vertices);
    CHECK(again.triangles == ball.triangles);
    const MassProperties here = mass_properties(ball, 1),
                         there = mass_properties(placed(ball, Matrix3::Identity(), {10, 0, 0}), 1);
    CHECK((there.centre - here.centre - Vector3(10, 0, 0)).norm() < 20 * epsilon);
    CHECK((there.inertia - here.inertia).norm() <
          200 * epsilon * here.inertia.norm());  // vertices are 10/0.3 coarser
}

TEST_CASE(
    "The meshes in assets/ are what the project's program writes, and bodies with the mass of their boxes") {
    for (const auto& [name, mesh] : course_meshes()) {
        const std::string path = std::string(PROJECT_DIR) + "/assets/" + name + ".obj";
        INFO(path << ": cmake --build build/default --target meshes");
        std::ifstream file(path, std::ios::binary);
        const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
        CHECK(text == obj_text(mesh, mesh_comment(name)));
    }
    const auto read = [](const char* name, double density) {
        return mass_properties(load_obj(std::string(PROJECT_DIR) + "/assets/" + name + ".obj"), density);
    };
    CHECK(read("t_handle", 1000).mass == Approx(by_boxes(t_handle()).mass).epsilon(1e-14));
    CHECK(read("dumbbell", 1000).inertia.isApprox(by_boxes(dumbbell()).inertia, 1e-14));
    const MassProperties both =
        assemble(std::vector<Part>{{read("hammer_shaft", 700)}, {read("hammer_head", 7800)}});
    CHECK(both.inertia.isApprox(by_boxes(hammer()).inertia, 1e-14));
}
