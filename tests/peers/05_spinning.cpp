// Chapter 5's scenes S6 and S6 fast in Bullet: a ball that spins steadily for a thousand turns, steps of
// 1/60 s. How many turns it makes; what a clamp of 45 degrees a step, made by halves, says; ours beside it.
//   peers_05_spinning [--check]    --check: fail if Bullet does not make the turns that the page says
#include <btBulletDynamicsCommon.h>
#include <cstdio>
#include <cstring>
#include <nutshell/lab/run.hpp>
#include <nutshell/spinning_limits.hpp>
#include <nutshell/spinning_scenes.hpp>

using namespace nutshell;

namespace {

constexpr double dt = 1. / 60;

/// Turns made from one pose to the next, each less than half a turn, about the wheel's axis.
struct Turns {
    Vector3 axis;
    Quaternion before = four_vector({0, 0, 0}, 1);
    double made = 0;
    void look(const Quaternion& now) {
        made += logarithm(product(now, inverse(before))).dot(axis) / (2 * pi);
        before = now;
    }
};

double bullets_turns(const SpinningWheel& wheel, long steps) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broad_phase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broad_phase, &solver, &configuration);
    world.setGravity({0, 0, 0});
    btSphereShape shape(static_cast<btScalar>(0.5));
    btRigidBody body(1, nullptr, &shape, {1, 1, 1});
    body.setActivationState(DISABLE_DEACTIVATION);
    body.setDamping(0, 0);
    const Vector3 omega = wheel.omega();
    body.setAngularVelocity({static_cast<btScalar>(omega.x()), static_cast<btScalar>(omega.y()),
                             static_cast<btScalar>(omega.z())});
    world.addRigidBody(&body);
    Turns turns{direction_of(wheel.axis)};
    for (long n = 0; n < steps; ++n) {
        world.stepSimulation(static_cast<btScalar>(dt), 0);
        const btQuaternion q = body.getOrientation();
        turns.look(Quaternion(q.w(), q.x(), q.y(), q.z()).normalized());
    }
    world.removeRigidBody(&body);
    return turns.made;
}

double our_turns(const SpinningWheel& wheel, long steps) {
    Turns turns{direction_of(wheel.axis)};
    for (long n = 0; n < steps; ++n)
        turns.look(exponential_map(turns.before, wheel, static_cast<double>(n) * dt, dt));
    return turns.made;
}

}  // namespace

int main(int argc, char** argv) {
    const bool check = argc > 1 && std::strcmp(argv[1], "--check") == 0;
    bool good = true;
    std::printf("A thousand turns, steps of 1/60 s: turns made\n");
    std::printf("  turns/s   Bullet   clamped by halves        ours\n");
    for (const SpinningWheel& wheel : {SpinningWheel::s6(), SpinningWheel::s6_fast()}) {
        const long steps = lab::steps_of(wheel.duration, dt);
        const double bullet = bullets_turns(wheel, steps), ours = our_turns(wheel, steps);
        const double turn = wheel.rate * dt, law = 1000 * clamped_by_halves(turn, pi / 4) / turn;
        std::printf("  %7.0f %8.2f %19.2f %11.6f\n", wheel.rate / (2 * pi), bullet, law, ours);
        // Bullet is built in float: a step of 60 000 that errs by 2e-5 rad, always one way, makes 0.2 turns
        good = good && std::abs(bullet - law) <= 0.2 && std::abs(ours - 1000) <= 1e-9;
    }
    if (check && !good) std::printf("Bullet does not clamp as the page says, or we lose turns.\n");
    return check && !good ? 1 : 0;
}
