// Chapter 6's scene S7 in Bullet: a free body that flips for 100 s from within a degree of its middle axis,
// with each of Bullet's ways with the gyroscopic term. The largest error of the orientation, ours beside it.
//   peers_06_free_bodies [--check]    --check: fail if a way of Bullet's keeps the phase, or ours does not
#include <btBulletDynamicsCommon.h>
#include <cstdio>
#include <cstring>
#include <nutshell/lab/run.hpp>
#include <nutshell/rigid_methods.hpp>
#include <nutshell/top_scenes.hpp>

using namespace nutshell;

namespace {

constexpr double lost = 1;  // [rad]: who is so far off does not know which way the body points

btVector3 bullet(const Vector3& v) {
    return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

/// The largest error [rad] of Bullet's orientation. @param flags  of btRigidBody: how it takes the term
double bullets_error(const FreeBody& scene, int flags, int steps_a_second) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broad_phase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broad_phase, &solver, &configuration);
    world.setGravity({0, 0, 0});
    btSphereShape shape(static_cast<btScalar>(0.5));
    btRigidBody body(1, nullptr, &shape, bullet(scene.start.inertia));
    body.setActivationState(DISABLE_DEACTIVATION);
    body.setDamping(0, 0);
    body.setFlags(flags);
    body.setAngularVelocity(bullet(angular_velocity(scene.start)));
    world.addRigidBody(&body);
    double most = 0;
    const double dt = 1. / steps_a_second;
    for (long n = 1; n <= std::lround(scene.duration * steps_a_second); ++n) {
        world.stepSimulation(static_cast<btScalar>(dt), 0);
        const btQuaternion q = body.getOrientation();
        Pinned now = scene.start;
        now.orientation = Quaternion(q.w(), q.x(), q.y(), q.z()).normalized();
        most = std::max(most, scene.error(now, static_cast<double>(n) * dt));
    }
    world.removeRigidBody(&body);
    return most;
}

}  // namespace

int main(int argc, char** argv) {
    const bool check = argc > 1 && std::strcmp(argv[1], "--check") == 0;
    const FreeBody scene = near_middle_axis();
    bool good = true;
    std::printf("Scene S7, 100 s: the largest error of the orientation [rad]\n");
    const struct {
        const char* name;
        int flags;
    } ways[] = {{"Bullet, as it comes (implicit, body)", BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY},
                {"Bullet, implicit, world", BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD},
                {"Bullet, explicit", BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT},
                {"Bullet, without", 0}};
    for (const int rate : {60, 240, 960}) {
        for (const auto& way : ways) {
            const double error = bullets_error(scene, way.flags, rate);
            std::printf("  1/%-4d %-40s %.3g\n", rate, way.name, error);
            good = good && error > lost;
        }
        const double ours =
            lab::measure(scene, methods::kick_magnus_kick, std::lround(scene.duration) * rate).max_error;
        std::printf("  1/%-4d %-40s %.3g\n", rate, "ours, Magnus' step", ours);
        good = good && ours <= 1e-6;
    }
    if (check && !good)
        std::printf("A way of Bullet's keeps the phase, or ours does not: the page says otherwise.\n");
    return check && !good ? 1 : 0;
}
