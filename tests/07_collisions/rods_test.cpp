// Chapter 7: rods, on which friction turns the sliding round: against what is found by hand.
#include <nutshell/contacts.hpp>
#include <nutshell/spin_scenes.hpp>
#include "near.hpp"

using namespace nutshell;

TEST_CASE("Rods that move in a plane: friction forwards, backwards or at rest, found by hand") {
    Chance chance(6);
    int forwards = 0, backwards = 0, stuck = 0;
    for (int i = 0; i < 20000; ++i) {
        FallingRod rod;
        rod.slope = chance(0.02, 1.5), rod.speed = chance(0, 1), rod.sideways = chance(-1, 1);
        rod.spin = chance(-6, 6);
        const double mu = chance(0, 1);
        const Body body = rod.rod(), floor = immovable_body();
        const Contact at{body.position - Vector3(0.5 * std::cos(rod.slope), body.position.y(), 0), {0, 1, 0}};
        const Vector3 u = contact_velocity(floor, body, at), r = at.point - body.position;
        if (!(u.y() < -1e-3)) continue;
        // K in the plane, written out; then sticking, and sliding towards +x or -x
        const double I = 0.09, xx = 1 + r.y() * r.y() / I, yy = 1 + r.x() * r.x() / I,
                     xy = -r.x() * r.y() / I;
        Eigen::Matrix2d K;
        K << xx, xy, xy, yy;
        const Eigen::Vector2d stick = -K.inverse() * Eigen::Vector2d(u.x(), u.y());
        Eigen::Vector2d J = stick;
        if (!(stick.y() > 0 && std::abs(stick.x()) <= mu * stick.y())) {
            int found = 0;
            for (const double d : {1.0, -1.0}) {
                const double j = -u.y() / (yy - mu * d * xy), left = u.x() + j * (xy - mu * d * xx);
                if (!(yy - mu * d * xy > 0) || left * d < 0) continue;
                J = {-mu * d * j, j}, ++found;
                ++(d * u.x() > 0 ? forwards : backwards);
            }
            REQUIRE(found == 1);
        } else {
            ++stuck;
        }
        const Vector3 ours = plastic_impulse(mobility(floor, body, at), u, at.normal, mu);
        CHECK((ours - Vector3(J.x(), J.y(), 0)).norm() < 1e-11 * J.norm());
    }
    CHECK(forwards > 500);
    CHECK(backwards > 500);
    CHECK(stuck > 500);
}

TEST_CASE("A rough rod on its end: the clamped law makes energy, the echo does not") {
    const FallingRod scene = FallingRod::rough();
    const double before = kinetic_energy(scene.rod());
    CHECK(kinetic_energy(scene.after(laws::clamped)) / before == near(1.2955, 1e-4));
    CHECK(kinetic_energy(scene.after(laws::echo)) / before == near(0.8101, 1e-4));
    // another way: in the plane, the impulse that sticks, and friction at its limit if it may not
    const Body rod = scene.rod(), after = scene.after(laws::clamped);
    const double c = scene.shape.half_length * std::cos(scene.slope),
                 s = scene.shape.half_length * std::sin(scene.slope) + scene.shape.radius;
    const Vector3 lever(-c, -s, 0), J = after.momentum - rod.momentum;
    CHECK(std::abs(J.x()) <= 0.4 * J.y() * (1 + 1e-12));
    const Vector3 spin = angular_velocity(rod) + Vector3(0, 0, lever.cross(J).z() / 0.09);
    CHECK(angular_velocity(after).z() == near(spin.z(), 1e-12 * 40));
    const Vector3 end = velocity(after) + spin.cross(lever),
                  came = velocity(rod) + angular_velocity(rod).cross(lever);
    CHECK(end.y() == near(-0.9 * came.y(), 1e-12 * 10));
    CHECK(end.x() == near(0, 1e-12 * 10));  // it sticks
}
