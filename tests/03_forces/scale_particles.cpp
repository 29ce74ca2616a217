// Particles are point masses: many at once do what each does alone, and the door refuses what cannot be
// simulated.
#include <limits>
#include <nutshell/chain_scenes.hpp>
#include <nutshell/forces_methods.hpp>
#include <nutshell/lab/run.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

/// One particle of AnchoredParticles on its own, by the plain forces of the chapter.
struct OneAnchored {
    PointMass start;
    Vector3 anchor;
    double stiffness, drag, g, duration;
    Vector3 operator()(const PointMass& body, double) const {
        return gravity_force(body.mass, g) + linear_drag_force(drag, body.velocity) +
               spring_force({stiffness, 0}, body.position, anchor);
    }
};

template <class Method>
double farthest_from_alone(AnchoredParticles scene, const Method& method, long steps) {
    for (std::size_t i = 0; i < scene.start.size(); ++i)
        scene.start.mass[i] = 0.5 + 0.1 * static_cast<double>(i);
    const Particles all = lab::run(scene, method, steps);
    double farthest = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const OneAnchored alone{scene.start[i], scene.anchors[i], scene.stiffness,
                                scene.drag,     scene.g,          scene.duration};
        farthest = std::max(farthest, (lab::run(alone, method, steps).position - all.position[i]).norm());
    }
    return farthest;
}

}  // namespace

TEST_CASE(
    "Many particles at once move as each moves alone, to round-off, with every method of drift and kick") {
    const AnchoredParticles scene = anchored_particles(37);  // not a multiple of any vector's width
    each(kick_and_drift_methods, [&](const auto& method) {
        INFO(method.name);
        CHECK(farthest_from_alone(scene, method, 400) < 1e-13);
    });
}

TEST_CASE("Verlet with the kept push gives the bits of Verlet on particles without drag") {
    AnchoredParticles scene = anchored_particles(100);
    scene.drag = 0;
    const Particles twice = lab::run(scene, methods::verlet_re_evaluated, 200);
    const Particles once = lab::run(scene, methods::verlet, 200);
    CHECK(once.position.x == twice.position.x);
    CHECK(once.position.y == twice.position.y);
    CHECK(once.velocity.z == twice.velocity.z);
}

TEST_CASE("Particles as one list of numbers: there and back, and the rate is velocity and acceleration") {
    const AnchoredParticles scene = anchored_particles(5);
    const Particles back = unflat(flat(scene.start), Particles(5));
    CHECK(back.position.x == scene.start.position.x);
    CHECK(back.velocity.z == scene.start.velocity.z);
    const Vector y = rate(scene.start, scene(scene.start, 0));
    for (int i = 0; i < 5; ++i) {
        const PointMass body = scene.start[static_cast<std::size_t>(i)];
        const OneAnchored alone{
            body, scene.anchors[static_cast<std::size_t>(i)], scene.stiffness, scene.drag, scene.g, 1};
        CHECK((y.segment<3>(3 * i) - body.velocity).norm() == 0);
        CHECK((y.segment<3>(15 + 3 * i) - alone(body, 0) / body.mass).norm() < 1e-12);
    }
}

TEST_CASE("Particles that cannot be simulated are refused at the door, with the number of the first") {
    Particles all(4);
    CHECK_NOTHROW(checked(all));
    all.mass[2] = 0;
    CHECK_THROWS_WITH(checked(all), ContainsSubstring("particle 2") && ContainsSubstring("mass"));
    all.mass[2] = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(checked(all), std::invalid_argument);
    all.mass[2] = 1;
    all.position.y[3] = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH(checked(all), ContainsSubstring("particle 3") && ContainsSubstring("position"));
    all.position.y[3] = 0;
    all.velocity.z.pop_back();
    CHECK_THROWS_WITH(checked(all), ContainsSubstring("4 masses"));
}

TEST_CASE("Anchored particles that cannot be simulated are refused at the door") {
    const AnchoredParticles good = anchored_particles(3);
    CHECK_NOTHROW(checked(good));
    const auto refuses = [&](auto&& spoil, const std::string& word) {
        AnchoredParticles scene = good;
        spoil(scene);
        CHECK_THROWS_WITH(checked(scene), ContainsSubstring(word));
    };
    refuses([](auto& s) { s.stiffness = -1; }, "stiffness");
    refuses([](auto& s) { s.drag = -1; }, "drag");
    refuses([](auto& s) { s.g = std::numeric_limits<double>::quiet_NaN(); }, "gravity");
    refuses([](auto& s) { s.anchors.resize(2); }, "one anchor");
    refuses([](auto& s) { s.anchors.x[1] = std::numeric_limits<double>::quiet_NaN(); }, "anchor");
    refuses([](auto& s) { s.start.mass[0] = -1; }, "mass");
}
