// Chapter 6: inertia, against sums over the same mass cut into small pieces, and what no body can have.
#include <Eigen/Eigenvalues>
#include <nutshell/assembly.hpp>
#include <nutshell/mesh_shapes.hpp>
#include <nutshell/rotations.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

const double epsilon = std::numeric_limits<double>::epsilon();
const Matrix3 tilted = rotation_matrix(exponential(Vector3(0.3, -1.1, 0.7)));

/// A slice across z, one kilogram a square metre: its area, and the integrals of x^2 and y^2 over it.
struct Slice {
    double area, xx, yy;
};
Slice ellipse(double a, double b) {
    return {pi * a * b, pi * a * b * a * a / 4, pi * a * b * b * b / 4};
}
Slice rectangle(double a, double b) {  // of half edges a and b
    return {4 * a * b, 4 * a * b * a * a / 3, 4 * a * b * b * b / 3};
}

/// Principal moments of 1 kg made of slices from -top to top, which may have corners at +-corner:
/// Gauss-Legendre with three points, exact for polynomials of fifth degree in z, on each of the three parts.
template <class At>
Vector3 by_slices(const At& at, double top, double corner) {
    const std::array<double, 4> ends{-top, -corner, corner, top};
    double mass = 0, xx = 0, yy = 0, zz = 0;
    for (std::size_t part = 0; part < 3; ++part) {
        const double middle = (ends[part] + ends[part + 1]) / 2, half = (ends[part + 1] - ends[part]) / 2;
        for (const auto& [place, weight] :
             {std::pair{-std::sqrt(0.6), 5. / 9}, {0., 8. / 9}, {std::sqrt(0.6), 5. / 9}}) {
            const double z = middle + half * place, w = half * weight;
            const Slice s = at(z);
            mass += w * s.area, xx += w * s.xx, yy += w * s.yy, zz += w * s.area * z * z;
        }
    }
    return Vector3(yy + zz, zz + xx, xx + yy) / mass;
}

void check_close(const Matrix3& a, const Matrix3& b, double within) {
    INFO(a << "\n  against\n" << b);
    CHECK((a - b).cwiseAbs().maxCoeff() <= within);
}

}  // namespace

TEST_CASE("The inertia of uniform solids is the sum over their slices") {
    // the slices' areas and moments are polynomials of z up to the fourth degree, with z^2 of those up to the
    // second: the sums are exact but for round-off
    const auto check = [](const Vector3& moments, const Vector3& slices) {
        INFO(moments.transpose() << "  against  " << slices.transpose());
        CHECK((moments - slices).cwiseAbs().maxCoeff() < 16 * epsilon * slices.maxCoeff());
    };
    const auto bulge = [](double z, double c) { return std::sqrt(1 - z * z / (c * c)); };
    check(ball_inertia(1, 0.9),
          by_slices([&](double z) { return ellipse(0.9 * bulge(z, 0.9), 0.9 * bulge(z, 0.9)); }, 0.9, 0.3));
    check(box_inertia(1, {1.5, 1, 0.5}), by_slices([](double) { return rectangle(0.75, 0.5); }, 0.25, 0.1));
    check(cylinder_inertia(1, 0.6, 1.5), by_slices([](double) { return ellipse(0.6, 0.6); }, 0.75, 0.5));
    check(ellipsoid_inertia(1, {0.9, 0.7, 0.4}),
          by_slices([&](double z) { return ellipse(0.9 * bulge(z, 0.4), 0.7 * bulge(z, 0.4)); }, 0.4, 0.2));
    const auto capsule = [](double z) {
        const double beyond = std::max(0., std::abs(z) - 0.5), r = std::sqrt(0.16 - beyond * beyond);
        return ellipse(r, r);
    };
    check(capsule_inertia(1, 0.4, 0.5), by_slices(capsule, 0.9, 0.5));
    // a rod: the cylinder that gets thin
    CHECK((rod_inertia(2, 3) - cylinder_inertia(2, 1e-9, 3)).norm() < 1e-15);
    CHECK_THROWS_WITH(ball_inertia(-1, 1), ContainsSubstring("mass"));
    CHECK_THROWS_WITH(box_inertia(1, {1, 0, 1}), ContainsSubstring("edge"));
    CHECK_THROWS_WITH(cylinder_inertia(1, 1, std::nan("")), ContainsSubstring("height"));
}

TEST_CASE("L = I omega is the sum of r x m v, and the energy half omega L, for particles in disorder") {
    const std::vector<Particle> cloud = {
        {1, {0.3, 1.2, -0.4}}, {2.5, {-1, 0.2, 0.8}}, {0.7, {0.1, -0.9, 1.5}}, {1.1, {2, 0, -1}}};
    const MassProperties body = mass_properties(cloud);
    const Vector3 omega(0.4, -1.3, 2.1);
    Vector3 sum = Vector3::Zero();
    double energy = 0;
    for (const Particle& p : cloud) {
        const Vector3 r = p.position - body.centre, v = omega.cross(r);
        sum += p.mass * r.cross(v);
        energy += p.mass * v.squaredNorm() / 2;
    }
    CHECK((body.inertia * omega - sum).norm() < 20 * epsilon * sum.norm());
    CHECK(omega.dot(body.inertia * omega) / 2 == Approx(energy).epsilon(20 * epsilon));
    CHECK_THROWS_WITH(mass_properties(std::span<const Particle>{}), ContainsSubstring("without particles"));
}

TEST_CASE("World inertia turns with the body: the inertia of the turned particles, eq. 53") {
    std::vector<Particle> cloud = {{1, {0.3, 1.2, -0.4}}, {2, {-1, 0.2, 0.8}}, {3, {0.1, -0.9, 1.5}}};
    const Matrix3 own = mass_properties(cloud).inertia;
    for (Particle& p : cloud) p.position = tilted * p.position;
    check_close(in_world(own, tilted), mass_properties(cloud).inertia, 20 * epsilon * own.norm());
    CHECK((in_world(own, tilted.transpose()) - mass_properties(cloud).inertia).norm() > 0.1 * own.norm());
    CHECK((own - mass_properties(cloud).inertia).norm() > 0.1 * own.norm());  // left unrotated: E27
}

TEST_CASE("Parallel axes: adding gives the inertia about any point, subtracting a body that cannot exist") {
    const Vector3 size(1, 0.2, 0.3);
    const MassProperties bar{2, Vector3::Zero(), box_inertia(2, size).asDiagonal()};
    // a rod about its end: m l^2/3
    const MassProperties rod{2, Vector3::Zero(), rod_inertia(2, 3).asDiagonal()};
    CHECK(inertia_about(rod, {0, 0, 1.5})(0, 0) == Approx(2 * 9 / 3.0).epsilon(4 * epsilon));
    const Matrix3 wrong_sign = bar.inertia - parallel_axis(2, {1, 0, 0});
    CHECK_THROWS_WITH(principal_axes(wrong_sign), ContainsSubstring("negative"));
    // a smaller slip, with moments that are all positive still
    const Matrix3 small = bar.inertia - parallel_axis(2, {0.29, 0, 0});
    CHECK_THROWS_WITH(principal_axes(small), ContainsSubstring("larger than the two others"));
    CHECK_NOTHROW(principal_axes(bar.inertia + parallel_axis(2, {1, 0, 0})));
}

TEST_CASE(
    "Principal axes: the moments and axes a body was made with, right-handed, in order if it has them") {
    const Vector3 moments(3, 1, 2.5);
    const PrincipalAxes kept = principal_axes(moments.asDiagonal());
    CHECK(kept.moments == moments);
    CHECK(kept.axes == Matrix3::Identity());
    const Matrix3 turned = in_world(moments.asDiagonal(), tilted);
    const PrincipalAxes found = principal_axes((turned + turned.transpose()) / 2);
    CHECK((found.moments - Vector3(1, 2.5, 3)).norm() < 20 * epsilon);
    CHECK(found.axes.determinant() == Approx(1));
    check_close(in_world(found.moments.asDiagonal(), found.axes), turned, 20 * epsilon);
    Matrix3 skew = turned;
    skew(2, 1) += 0.01;  // the slip of the source's inverse, E54
    CHECK_THROWS_WITH(principal_axes(skew), ContainsSubstring("symmetric"));
    skew(0, 0) = std::nan("");
    CHECK_THROWS_WITH(principal_axes(skew), ContainsSubstring("finite"));
    // Against Eigen's solver, which works in another way: tridiagonal, then QR. Both are good to a few
    // epsilon.
    Matrix3 mixed;
    for (int seed = 1; seed <= 1000; ++seed) {
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j <= i; ++j) mixed(i, j) = mixed(j, i) = std::sin(seed * (3 * i + j + 1.7));
        if (seed % 5 == 0) mixed(0, 1) = mixed(1, 0) = 1e-12 * mixed(0, 1);
        if (seed % 7 == 0) mixed(2, 2) = mixed(1, 1);
        const PrincipalAxes ours = symmetric_axes(mixed);
        const Eigen::SelfAdjointEigenSolver<Matrix3> theirs(mixed);
        REQUIRE((ours.moments - theirs.eigenvalues()).norm() < 40 * epsilon);
        REQUIRE((in_world(ours.moments.asDiagonal(), ours.axes) - mixed).norm() < 40 * epsilon);
        REQUIRE((ours.axes.transpose() * ours.axes - Matrix3::Identity()).norm() < 20 * epsilon);
        REQUIRE(ours.axes.determinant() > 0);
    }
    CHECK(why_impossible({1, 1, 2}).empty());  // flat: on the border
    CHECK_THAT(why_impossible({1, 1, 2.01}), ContainsSubstring("2.01"));
    CHECK_THAT(why_impossible({-1, 1, 1}), ContainsSubstring("negative"));
}

TEST_CASE("Assembly three ways: boxes and mesh integrals agree to round-off, particles at order two") {
    for (const auto& blocks : {dumbbell(), hammer(), t_handle()}) {
        std::vector<Block> turned = blocks;
        for (Block& b : turned) b.place = tilted * b.place, b.rotation = tilted * b.rotation;
        for (const auto& list : {blocks, turned}) {
            const MassProperties boxes = by_boxes(list), meshes = by_meshes(list);
            CHECK(meshes.mass == Approx(boxes.mass).epsilon(8 * epsilon));
            CHECK((meshes.centre - boxes.centre).norm() < 20 * epsilon);
            check_close(meshes.inertia, boxes.inertia, 40 * epsilon * boxes.inertia.norm());
            CHECK_NOTHROW(principal_axes((boxes.inertia + boxes.inertia.transpose()) / 2));
        }
        const MassProperties exact = by_boxes(blocks);
        Convergence c;
        for (const double cell : {0.01, 0.005, 0.0025}) {  // divide every edge
            const MassProperties cloud = by_particles(blocks, cell);
            CHECK(cloud.mass == Approx(exact.mass).epsilon(1e-10));  // a sum of 400 000 terms
            CHECK((cloud.centre - exact.centre).norm() < 1e-12);
            // what is missing is exactly the cells' own inertia: cubes of this edge, all of the mass
            const Matrix3 missing = exact.mass * cell * cell / 6 * Matrix3::Identity();
            check_close(exact.inertia - cloud.inertia, missing, 1e-10 * exact.inertia.norm());
            c.dt.push_back(cell), c.error.push_back((cloud.inertia - exact.inertia).norm());
        }
        CHECK_THAT(c, HasOrder(2, 1e-3));
    }
}

TEST_CASE(
    "The hammer as counted by hand: an iron head on a wooden shaft, about its centre and about its grip") {
    // shaft 0.03 x 0.3 x 0.03 m of 700 kg/m^3 about the origin; head 0.12 x 0.04 x 0.04 m of 7800 about
    // (0.01, 0.17, 0)
    const double shaft = 0.189, head = 1.4976, x = head * 0.01 / (shaft + head),
                 y = head * 0.17 / (shaft + head);
    const MassProperties hammer_of_boxes = by_boxes(hammer());
    CHECK(hammer_of_boxes.mass == Approx(shaft + head).epsilon(8 * epsilon));
    CHECK((hammer_of_boxes.centre - Vector3(x, y, 0)).norm() < 4 * epsilon);
    const double about_z = shaft * (0.03 * 0.03 + 0.3 * 0.3) / 12 + shaft * (x * x + y * y) +
                           head * (0.12 * 0.12 + 0.04 * 0.04) / 12 +
                           head * ((0.01 - x) * (0.01 - x) + (0.17 - y) * (0.17 - y));
    CHECK(hammer_of_boxes.inertia(2, 2) == Approx(about_z).epsilon(32 * epsilon));
    CHECK(inertia_about(hammer_of_boxes, {0, -0.15, 0})(2, 2) ==
          Approx(about_z + (shaft + head) * (x * x + (y + 0.15) * (y + 0.15))).epsilon(32 * epsilon));
}

TEST_CASE("One mesh of several solids gives what the assembly of each gives, wherever it lies") {
    Mesh mesh;
    const Vector3 far(100, -50, 30);
    for (const Block& b : t_handle())
        mesh = merged(mesh, placed(box_mesh(b.size), b.rotation, b.place + far));
    const MassProperties whole = mass_properties(mesh, 1000), parts = by_boxes(t_handle());
    CHECK((whole.centre - far - parts.centre).norm() < 4 * epsilon * far.norm());
    // vertices at 100 m are known to 1e-14 m, the handle is 0.1 m: 1e-13 of everything
    check_close(whole.inertia, parts.inertia, 1e-12 * parts.inertia.norm());
}

TEST_CASE("Assembly by hand: what the source's sum of two bodies gets wrong") {
    const MassProperties a{1, Vector3::Zero(), Vector3(1, 2, 2.5).asDiagonal()};
    const std::vector<Part> parts = {{a, {1, 2, 3}, Matrix3::Identity()},
                                     {{2, {0.5, 0, 0}, a.inertia}, {5, 4, 9}, rotation_z(pi / 2)}};
    const MassProperties whole = assemble(parts);
    CHECK(whole.mass == 3);
    // the second part's centre, turned a quarter about z: (5, 4.5, 9)
    CHECK((whole.centre - Vector3(11, 11, 21) / 3).norm() < 4 * epsilon);
    const Vector3 da = Vector3(1, 2, 3) - whole.centre, db = Vector3(5, 4.5, 9) - whole.centre;
    const Matrix3 by_hand = Matrix3(Vector3(1, 2, 2.5).asDiagonal()) +
                            Matrix3(Vector3(2, 1, 2.5).asDiagonal()) + point_inertia(1, da) +
                            point_inertia(2, db);
    check_close(whole.inertia, by_hand, 20 * epsilon * by_hand.norm());
    CHECK(point_inertia(1, {1, 2, 3}).diagonal() == Vector3(13, 10, 5));  // E65 gives 14 three times
    CHECK_THROWS_WITH(assemble(std::span<const Part>{}), ContainsSubstring("nothing"));
    CHECK_THROWS_WITH(assemble(std::vector<Part>(1)), ContainsSubstring("mass of a part"));
}
