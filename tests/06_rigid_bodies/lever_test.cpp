// Chapter 6: levers and seesaws, and things that are thrown: against laws that know nothing of the code.
#include <nutshell/lab/stability.hpp>
#include <nutshell/lever_scenes.hpp>
#include <nutshell/rigid_methods.hpp>
#include <nutshell/thrown_scenes.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

const double epsilon = std::numeric_limits<double>::epsilon();

template <class Scene, class Method>
Convergence errors_of(const Scene& scene, const Method& method, const std::vector<long>& steps) {
    Convergence c;
    for (const long n : steps) {
        const auto m = lab::measure(scene, method, n);
        c.dt.push_back(m.dt), c.error.push_back(m.max_error);
    }
    return c;
}

std::vector<Lever> out_of_balance() {
    // the last one falls to the left, where its arm is the longer one
    return {seesaw(), crowbar(), light_and_far(), heavy_and_near(), {"oar", 5, -1.5, 0.5, {{10, -1.2}}, 0.3}};
}

}  // namespace

TEST_CASE("Levers: torque and inertia of the scenes as counted by hand") {
    const double g = 9.81;
    // child 25 kg at -1.8 m, grown-up 75 kg at 0.5 m, plank 20 kg of 4 m
    CHECK(seesaw()(seesaw().start, 0).torque.z() == Approx((25 * 1.8 - 75 * 0.5) * g).epsilon(8 * epsilon));
    // a thick rod adds m r^2/4 of its 5 cm
    const double plank = 20 * 16 / 12. + 20 * 0.05 * 0.05 / 4;
    CHECK(seesaw().start.inertia.z() == Approx(plank + 25 * 1.8 * 1.8 + 75 * 0.25).epsilon(8 * epsilon));
    CHECK(balanced_seesaw()(balanced_seesaw().start, 0).torque.norm() == 0);
    // crowbar: 10 kg from -0.25 to 1.75, so its middle is at 0.75
    CHECK(crowbar()(crowbar().start, 0).torque.z() ==
          Approx((200 * 0.25 - 40 * 1.75 - 10 * 0.75) * g).epsilon(8 * epsilon));
    CHECK(crowbar().start.inertia.z() ==
          Approx(10 * (4 / 12. + 0.75 * 0.75 + 0.05 * 0.05 / 4) + 200 * 0.0625 + 40 * 1.75 * 1.75)
              .epsilon(8 * epsilon));
    CHECK(light_and_far()(light_and_far().start, 0).torque ==
          heavy_and_near()(heavy_and_near().start, 0).torque);
}

TEST_CASE("A lever's exact motion obeys I tilt'' = torque, keeps its energy, ends at the ground") {
    for (const Lever& lever : out_of_balance()) {
        INFO(lever.name);
        const double omega = lever.omega(), h = 1e-3;
        for (double part = 0.1; part < 1; part += 0.2) {
            const double t = part * lever.duration;
            const double second =
                (lever.motion(t + h).angle - 2 * lever.motion(t).angle + lever.motion(t - h).angle) / (h * h);
            // h^2/12 times a fourth derivative of at most 3.05 omega^4 (pendulum_test.cpp), and round-off of
            // three angles below 2 over h^2
            const double bound = 3.05 / 12 * std::pow(omega, 4) * h * h + 16 * epsilon / (h * h);
            const Pinned body = lever.exact(t);
            CHECK(std::abs(second - lever(body, t).torque.z() / lever.start.inertia.z()) < bound);
            CHECK(std::abs(lever.energy(body)) < 32 * epsilon * lever.start.inertia.z() * omega * omega);
        }
        CHECK(lever.motion(lever.duration).angle == Approx(lever.tilt_of_touch()).epsilon(16 * epsilon));
        CHECK(std::sin(std::abs(lever.tilt_of_touch())) *
                  (lever.imbalance() > 0 ? lever.right : -lever.left) ==
              Approx(lever.height));
        CHECK(lever.error(lever.start, 0) < 4 * epsilon);
    }
    CHECK(balanced_seesaw().motion(0.7).angle == 0);
    CHECK_THROWS_WITH((Lever{"rod", -1, -1, 1, {}, 0.5}), ContainsSubstring("mass"));
}

TEST_CASE("The work of a lever's torques is the energy it turns with") {
    for (const Lever& lever : out_of_balance()) {
        // midpoint rule over the turn: h^2/24 of the second derivative of cos, times the turn
        const int pieces = 500;
        const double end = lever.tilt_of_touch();
        double work = 0;
        for (int i = 0; i < pieces; ++i) {
            Pinned body = lever.start;
            body.orientation = exponential({0, 0, end * (i + 0.5) / pieces});
            work += lever(body, 0).torque.z() * end / pieces;
        }
        const double energy = rotational_energy(lever.exact(lever.duration));
        CHECK(work == Approx(energy).epsilon(end * end / pieces / pieces / 24 + 64 * epsilon));
    }
}

TEST_CASE("Chapter 1's methods tip a seesaw at their orders, and the heavier one tips faster") {
    for (const Lever& lever : {seesaw(), crowbar()}) {
        CHECK_THAT(errors_of(lever, methods::euler, {400, 800, 1600}), HasOrder(1));
        CHECK_THAT(errors_of(lever, methods::semi_implicit_euler, {400, 800, 1600}), HasOrder(1));
        CHECK_THAT(errors_of(lever, methods::verlet, {50, 100, 200}), HasOrder(2));
    }
    CHECK(heavy_and_near().duration < 0.6 * light_and_far().duration);
}

TEST_CASE("Thrown things: the centre's parabola, a steady spin where it is one, energy and L kept") {
    for (const ThrownThing& thing :
         {thrown_dumbbell(), thrown_hammer(), thrown_t_handle(), tumbling_hammer()}) {
        INFO(thing.name);
        CHECK(thing.start.mass == Approx(by_boxes(thing.blocks).mass));
        CHECK((angular_velocity(thing.start) -
               (thing.name == "tumbling_hammer" ? Vector3(3, 2, -8) : Vector3(0, 0, -9)))
                  .norm() < 64 * epsilon * 9);
        for (double part = 0; part <= 1; part += 0.25) {
            const double t = part * thing.duration;
            const Body body = thing.exact(t);
            CHECK((body.position - Vector3(2.5 * t, 4.5 * t - 9.81 * t * t / 2, 0)).norm() < 1e-14);
            // FreeTop's pose: a few epsilon times the angle turned
            CHECK(thing.energy(body) == Approx(thing.energy(thing.start)).epsilon(1e-12));
            CHECK(body.angular_momentum == thing.start.angular_momentum);
            if (thing.name != "tumbling_hammer") {
                const Quaternion spun = product(exponential({0, 0, -9 * t}), thing.start.orientation);
                CHECK(angle_between(body.orientation, spun) < 1e-13);
            }
        }
        // a point of the blocks is where the blocks have it at the start, and at the end height 0
        CHECK((point_of(thing.start, thing.in_body(thing.tip)) - (thing.tip - thing.thing.centre)).norm() <
              16 * epsilon);
        CHECK(std::abs(thing.exact(thing.duration).position.y()) < 1e-14);
    }
    CHECK_THAT(errors_of(tumbling_hammer(), methods::verlet, {50, 100, 200}), HasOrder(2));
    const double spun = lab::measure(thrown_hammer(), methods::verlet, 10).max_error;
    CHECK(spun < 1e-12);  // a steady spin is exact at any step
}

TEST_CASE("The spin of a tensor: solves I omega = L in any axes, and refuses a rod without thickness") {
    Matrix3 inertia;
    inertia << 2.1, -0.4, 0.3, -0.4, 1.7, 0.5, 0.3, 0.5, 1.2;
    const Matrix3 turned = rotation_matrix(exponential(Vector3(0.3, -1.1, 0.7)));
    const Vector3 omega(0.7, -1.2, 0.4), L = turned * inertia * turned.transpose() * omega;
    // the condition of this tensor is below 4
    CHECK((spin_of(inertia, turned, L) - omega).norm() < 40 * epsilon);
    CHECK((inertia.inverse() * L - omega).norm() > 0.1);  // left unturned: E58
    const Vector3 moments(0.6, 1.9, 2.2);
    CHECK((spin_of(moments.asDiagonal(), turned, L) -
           turned * Vector3((turned.transpose() * L).cwiseQuotient(moments)))
              .norm() < 40 * epsilon);
    CHECK_THROWS_WITH(spin_of(rod_inertia(1, 1).asDiagonal(), turned, L), ContainsSubstring("no inverse"));
}
