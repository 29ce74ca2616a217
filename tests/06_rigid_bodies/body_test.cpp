// Chapter 6: bodies, their verbs, and what they are made of.
#include <nutshell/joined.hpp>
#include <nutshell/newton_scenes.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

const double epsilon = std::numeric_limits<double>::epsilon();
const Quaternion tilted = exponential(Vector3(0.3, -1.1, 0.7));

/// The free rotation by another way: R' = [omega]x R with omega = R I0^-1 R^T L, by RK4 in `steps` steps, on
/// nine numbers that know nothing of rotations.
Matrix3 turned_finely(const Vector3& inertia, const Matrix3& start, const Vector3& L, double time,
                      int steps) {
    const auto rate = [&](const Matrix3& r) -> Matrix3 {
        const Vector3 w = r * Vector3((r.transpose() * L).cwiseQuotient(inertia));
        Matrix3 cross;
        cross << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
        return cross * r;
    };
    Matrix3 r = start;
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
        const Matrix3 a = rate(r), b = rate(r + h / 2 * a), c = rate(r + h / 2 * b), d = rate(r + h * c);
        r += h / 6 * (a + 2 * b + 2 * c + d);
    }
    return r;
}

Body some_body(const Vector3& inertia) {
    Body body{2, inertia, {1, 2, 3}, {0.5, -1, 2}, tilted};
    return spinning(body, {0.7, -1.2, 0.4});
}

}  // namespace

TEST_CASE(
    "A lever: torque is force times arm at right angles, and a seesaw balances where they add to nothing") {
    CHECK(force_at({0, -10, 0}, {2, 0, 0}).torque == Vector3(0, 0, -20));
    CHECK(force_at({5, 0, 0}, {2, 0, 0}).torque == Vector3::Zero());  // along the arm: no torque
    const Wrench seesaw = force_at({0, -300, 0}, {-2, 0, 0}) + force_at({0, -400, 0}, {1.5, 0, 0});
    CHECK(seesaw.torque == Vector3::Zero());
    CHECK(seesaw.force == Vector3(0, -700, 0));
}

TEST_CASE("Forces at points of a body: about the centre and at it, their torque about the origin") {
    // Which point a body's L is taken about may move as it likes, if it is the centre of mass: the sum of the
    // torque about the centre and of the force at the centre is the torque about a point that stands still.
    const Body before = some_body({1, 2, 2.5});
    const double dt = 0.1;
    Wrench push;
    Vector3 about_origin = Vector3::Zero();
    for (const auto& [force, r] : {std::pair{Vector3(3, -1, 2), Vector3(0.4, 0.1, -0.9)},
                                   {Vector3(-2, 5, 1), Vector3(-0.3, 0.8, 0.2)},
                                   {Vector3(1, 1, -4), Vector3(0, 0, 0)}}) {
        push = push + force_at(force, rotate(before.orientation, r));
        about_origin += point_of(before, r).cross(force);
    }
    Body body = before;
    kick(body, push, dt);
    const double bound = 32 * epsilon * angular_momentum(before).norm();
    CHECK((angular_momentum(body) - angular_momentum(before) - about_origin * dt).norm() < bound);
    // and no torque comes from the centre's motion, which is along its momentum
    const Vector3 kicked = angular_momentum(body);
    drift(body, dt);
    CHECK((body.position - before.position).norm() > 0.1);
    CHECK((angular_momentum(body) - kicked).norm() < bound);
}

TEST_CASE("L = I omega in world axes, and half omega L is the energy") {
    for (const Vector3& inertia : {Vector3(1, 2, 2.5), Vector3(1, 1, 0.4), Vector3(2, 2, 2)}) {
        const Body body = some_body(inertia);
        const Vector3 omega(0.7, -1.2, 0.4);
        const double bound = 16 * epsilon * body.angular_momentum.norm();
        CHECK((angular_velocity(body) - omega).norm() < bound);
        CHECK((world_inertia(body) * omega - body.angular_momentum).norm() < bound);
        CHECK((world_inverse_inertia(body) * body.angular_momentum - omega).norm() < bound);
        CHECK(rotational_energy(body) == Approx(omega.dot(world_inertia(body) * omega) / 2));
        CHECK(kinetic_energy(body) == Approx(rotational_energy(body) + 2 * velocity(body).squaredNorm() / 2));
    }
    // the inverse left unrotated, as the source has it, is wrong by half
    const Body body = some_body({1, 2, 3});
    CHECK((body.angular_momentum.cwiseQuotient(body.inertia) - angular_velocity(body)).norm() >
          0.3 * angular_velocity(body).norm());
}

TEST_CASE("Points of a body: where they are, and how fast they move, by finite differences") {
    const Body body = some_body({1, 2, 2.5});
    const Vector3 r(0.3, -0.4, 1.2);
    const double h = 1e-4;
    Body before = body, after = body;
    drift(before, -h), drift(after, h);
    const Vector3 difference = (point_of(after, r) - point_of(before, r)) / (2 * h);
    CHECK((difference - velocity_of(body, r)).norm() < 10 * h * h);  // h^2/6 omega^3 |r|
    // the source's (59), with r left in body axes
    CHECK((angular_velocity(body).cross(r) + velocity(body) - difference).norm() > 0.5);
    CHECK((point_of(body, {0, 0, 0}) - body.position).norm() == 0);
}

TEST_CASE("The drift of a symmetric body is exact at any step, about whichever axis it is symmetric") {
    for (const Vector3& inertia :
         {Vector3(1, 1, 0.4), Vector3(1, 1, 1.9), Vector3(0.3, 1, 1), Vector3(1, 1.5, 1), Vector3(2, 2, 2)}) {
        Body body = some_body(inertia);
        const Matrix3 start = rotation_matrix(body.orientation);
        const Vector3 L = body.angular_momentum;
        drift(body, 3.7);
        const Matrix3 fine = turned_finely(inertia, start, L, 3.7, 20'000);
        // RK4: (omega h)^5/120 a step, omega at most 5 rad/s: 1e-12; round-off of 20 000 steps
        CHECK((rotation_matrix(body.orientation) - fine).norm() < 2e-11);
        CHECK(body.angular_momentum == L);
        Body twice = some_body(inertia);
        drift(twice, 1.3), drift(twice, 2.4);
        CHECK(angle_between(twice.orientation, body.orientation) < 100 * epsilon);
    }
}

TEST_CASE("A 4-vector that is a little too long is trimmed to one, but for the square of what it was off") {
    for (const double off : {1e-6, -1e-6}) {
        Quaternion q = tilted;
        q.coeffs() *= 1 + off;
        // Newton's step for 1/length: 3/2 off^2 is left
        CHECK(std::abs(trimmed(q).norm() - 1) < 1.6 * off * off);
    }
}

TEST_CASE("The drift of any other body is second order, symmetric in time, and keeps L to the bit") {
    const Vector3 inertia(1, 2, 2.5);
    const Body start = some_body(inertia);
    const Matrix3 fine =
        turned_finely(inertia, rotation_matrix(start.orientation), start.angular_momentum, 2, 20'000);
    Convergence c;
    for (const int steps : {50, 100, 200, 400}) {
        Body body = start;
        for (int i = 0; i < steps; ++i) drift(body, 2.0 / steps);
        CHECK(body.angular_momentum == start.angular_momentum);
        CHECK(body.orientation.norm() == Approx(1).epsilon(4 * epsilon));
        c.dt.push_back(2.0 / steps), c.error.push_back((rotation_matrix(body.orientation) - fine).norm());
    }
    CHECK_THAT(c, HasOrder(2));
    Body there_and_back = start;
    drift(there_and_back, 0.8), drift(there_and_back, -0.8);
    CHECK(angle_between(there_and_back.orientation, start.orientation) < 100 * epsilon);
}

TEST_CASE("Chapter 1's methods move a body unchanged: its centre is a particle, its turning is free") {
    struct Thrown {
        Wrench operator()(const Body& body, double) const { return {body.mass * gravity, Vector3::Zero()}; }
    };
    Body body = some_body({1, 1, 0.4});
    Particle centre{body.mass, body.position, body.momentum};
    Body alone = body;
    KeptVerlet<Wrench> fsal;
    Body kept = body;
    const double dt = 1. / 60;
    for (int i = 0; i < 120; ++i) {
        body = verlet(body, Thrown{}, i * dt, dt);
        kept = fsal(kept, Thrown{}, i * dt, dt);
        centre = verlet(
            centre, [](const Particle& p, double) { return Vector3(p.mass * gravity); }, i * dt, dt);
        drift(alone, dt);
    }
    CHECK(body.position == centre.position);
    CHECK(body.momentum == centre.momentum);
    CHECK(body.orientation.coeffs() == alone.orientation.coeffs());
    CHECK(kept.position == body.position);
}

TEST_CASE("A pinned body turns as a free one does, takes torques, and leaves forces to its pivot") {
    const Body body = some_body({1, 2, 2.5});
    Pinned pinned{body.inertia, body.orientation, body.angular_momentum};
    Body free = body;
    const Wrench push{{1, 2, 3}, {0.3, -0.2, 0.9}};
    kick(pinned, push, 0.1), kick(free, push, 0.1);
    drift(pinned, 0.1), drift(free, 0.1);
    CHECK(pinned.orientation.coeffs() == free.orientation.coeffs());
    CHECK(pinned.angular_momentum == body.angular_momentum + 0.1 * push.torque);
    CHECK((free.momentum - body.momentum - 0.1 * push.force).norm() < 4 * epsilon);
}

TEST_CASE("Bodies stuck together: momentum, angular momentum and inertia of the whole") {
    // Two spinless bodies that pass each other: L = 2, where the source's sum has 0 (E33).
    const Body left{1, {1, 1, 1}, {0, 0, 0}, {0, -1, 0}, Quaternion::Identity()};
    const Body right{1, {1, 1, 1}, {2, 0, 0}, {0, 1, 0}, Quaternion::Identity()};
    const Body pair = joined(std::array{left, right});
    CHECK((pair.angular_momentum - Vector3(0, 0, 2)).norm() < 4 * epsilon);
    CHECK(pair.position == Vector3(1, 0, 0));
    CHECK((world_inertia(pair).diagonal() - Vector3(2, 4, 4)).norm() < 8 * epsilon);

    const Body a = some_body({1, 2, 2.5});
    Body b = some_body({0.3, 1, 1.1});
    b.position = {-1, 0.5, 4}, b.orientation = exponential(Vector3(-2, 0.1, 1)), b.mass = 5;
    const Body whole = joined(std::array{a, b});
    CHECK((angular_momentum(whole) - angular_momentum(a) - angular_momentum(b)).norm() < 100 * epsilon);
    CHECK((whole.momentum - a.momentum - b.momentum).norm() < 8 * epsilon);
    CHECK((world_inertia(whole) - world_inertia(a) - world_inertia(b) -
           point_inertia(a.mass, a.position - whole.position) -
           point_inertia(b.mass, b.position - whole.position))
              .norm() < 1e-13 * world_inertia(whole).norm());
}

TEST_CASE("Bodies that cannot be are refused with the reason") {
    const auto refuse = [](const auto& change, const std::string& reason) {
        Body body = some_body({1, 2, 2.5});
        change(body);
        CHECK_THROWS_WITH(checked(body), ContainsSubstring(reason));
    };
    refuse([](Body& b) { b.mass = 0; }, "mass");
    refuse([](Body& b) { b.inertia = {1, 1, 3}; }, "larger than the two others");
    refuse([](Body& b) { b.inertia = rod_inertia(1, 1); }, "cylinder");
    refuse([](Body& b) { b.inertia = {1, -1, 1}; }, "principal moment");
    refuse([](Body& b) { b.orientation.coeffs() *= 1.1; }, "normalised");
    refuse([](Body& b) { b.angular_momentum.x() = std::nan(""); }, "angular momentum");
    refuse([](Body& b) { b.position.x() = std::nan(""); }, "position");
    CHECK_NOTHROW(checked(some_body({1, 2, 2.5})));
    CHECK_THROWS_WITH(checked(Pinned{{1, 1, 3}, tilted}), ContainsSubstring("two others"));
}
