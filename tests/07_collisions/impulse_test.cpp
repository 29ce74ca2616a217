// Impulses with levers: conservation, restitution, friction in a cone, and who gains energy.
#include <nutshell/contacts.hpp>
#include <nutshell/spin_scenes.hpp>
#include "near.hpp"

using namespace nutshell;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A ball, a box or a rod of chance at `centre`, with chance's motion.
Body random_body(Chance& chance, const Vector3& centre, int kind) {
    Body body;
    body.mass = chance(0.1, 5);
    const double x = chance(0.1, 2), y = chance(0.1, 2), z = chance(0.1, 2), m = body.mass / 3;
    if (kind == 0) body.inertia = Vector3::Constant(0.4 * body.mass * x * x);
    if (kind == 1) body.inertia = m * Vector3(y * y + z * z, z * z + x * x, x * x + y * y);
    if (kind == 2) body.inertia = m * Vector3(y * y, 0.01 * y * y, y * y);
    body.position = centre;
    body.momentum = body.mass * chance.vector(3);
    body.orientation = quaternion_about(chance.direction(), chance(0, 2 * pi));
    return spinning(body, chance.vector(5));
}

struct Worst {
    double momentum = 0, turning = 0, restitution = 0, energy = 0, cone = 0;
};

/// Impacts of all kinds of bodies with each other and with a wall; how far each law is off.
Worst random_impacts(const ImpactLaw& law, int impacts, std::uint64_t seed) {
    Chance chance(seed);
    Worst worst;
    for (int i = 0; i < impacts; ++i) {
        const Contact at{chance.vector(1), chance.direction(), 0, 0};
        const int kind_a = i % 4, kind_b = i / 4 % 3;
        Body a = random_body(chance, at.point + chance.vector(2), kind_a % 3);
        if (kind_a == 3) a = immovable_body();
        Body b = random_body(chance, at.point + chance.vector(2), kind_b);
        const Surface surface{chance(0, 1), chance(0, 2)};
        const Vector3 u = contact_velocity(a, b, at);
        if (at.normal.dot(u) >= 0) continue;
        const Body a0 = a, b0 = b;
        collide(a, b, at, surface, law);
        const Vector3 after = contact_velocity(a, b, at), J = b.momentum - b0.momentum;
        const double size = b0.momentum.norm() + a0.momentum.norm() + J.norm();
        const double before = kinetic_energy(a0) + kinetic_energy(b0);
        const auto grow = [](double& most, double value) { most = std::max(most, value); };
        grow(worst.momentum, (a.momentum + b.momentum - a0.momentum - b0.momentum).norm() / size);
        grow(
            worst.turning,
            (angular_momentum(a) + angular_momentum(b) - angular_momentum(a0) - angular_momentum(b0)).norm() /
                (10 * size));
        const double terms = mobility(a0, b0, at).norm() * size;  // the largest that enters the velocity
        grow(worst.restitution,
             std::abs(at.normal.dot(after) + surface.restitution * at.normal.dot(u)) / terms);
        grow(worst.energy, (kinetic_energy(a) + kinetic_energy(b)) / before - 1);
        const double normal = at.normal.dot(J);
        grow(worst.cone, ((J - normal * at.normal).norm() - surface.friction * normal) / size);
    }
    return worst;
}

void check_echo(const Worst& worst) {
    CHECK(worst.momentum < 8 * epsilon);
    CHECK(worst.turning < 16 * epsilon);
    CHECK(worst.restitution < 64 * epsilon);
    // Sticking takes K^-1: on a thin rod's end K is up to 1e5 times as large one way as another, and loses
    // as many digits, 1e5 epsilon = 2e-11.
    CHECK(worst.cone < 1e-11);
    CHECK(worst.energy < 1e-11);
}

/// The most that one impact of a thin rod on the floor, moving in a plane, multiplies its energy by.
double largest_gain(double e, const ImpactLaw& law, int rods) {
    Chance chance(2);
    double gain = 0;
    for (int i = 0; i < rods; ++i) {
        const double angle = chance(0.02, pi / 2), half = 0.5;
        const Vector3 along{std::cos(angle), std::sin(angle), 0};
        Body floor = immovable_body(), rod;
        rod.inertia = half * half / 3 * Vector3(1, 1e-9, 1);
        rod.position = half * along;
        rod.orientation = quaternion_about({0, 0, 1}, angle - pi / 2);
        rod.momentum = {chance(-1, 1), chance(-1, 1), 0};
        rod.angular_momentum = {0, 0, chance(-1, 1) * rod.inertia.z() * 6};
        const double before = kinetic_energy(rod);
        collide(floor, rod, {{0, 0, 0}, {0, 1, 0}, 0, 0}, {e, chance(0, 1)}, law);
        gain = std::max(gain, kinetic_energy(rod) / before);
    }
    return gain;
}

void check_opposed(int impacts, std::uint64_t seed) {
    Chance chance(seed);
    for (int i = 0; i < impacts; ++i) {
        Body floor = immovable_body(), body = random_body(chance, {0, 0.7, 0}, i % 3);
        const Contact at{{chance(-0.5, 0.5), 0, chance(-0.5, 0.5)}, {0, 1, 0}, 0, 0};
        const Body before = body;
        collide(floor, body, at, {0, 0.3});
        const Vector3 J = body.momentum - before.momentum, u = contact_velocity(floor, body, at);
        if (J.y() == 0) continue;
        Vector3 pull(J.x(), 0, J.z()), slide(u.x(), 0, u.z());
        const double size = contact_velocity(floor, before, at).norm();
        CHECK(pull.norm() <= 0.3 * J.y() + 1e-14 * (before.momentum.norm() + 1));
        if (slide.norm() > 1e-9 * size) {
            CHECK(pull.norm() == near(0.3 * J.y(), 1e-9 * J.y()));
            CHECK(pull.normalized().dot(slide.normalized()) == near(-1, 1e-9));
        }
    }
}

}  // namespace

TEST_CASE("A sphere on the floor with spin slides or sticks (S10, the clamped law)") {
    for (const double mu : {0.0, 0.2, 0.8}) {
        const SpinningBall scene(mu);
        const Body after = scene.after(laws::clamped), exact = scene.exact();
        CHECK((velocity(after) - velocity(exact)).norm() < 1e-12 * 5);
        CHECK((angular_velocity(after) - angular_velocity(exact)).norm() < 1e-12 * 50);
    }
    // by hand: sliding takes 0.2 * 6 = 1.2 N s from the ball
    const Body slides = SpinningBall(0.2).after(laws::clamped);
    CHECK((velocity(slides) - Vector3(1.8, 2, 0)).norm() < 1e-12);
    CHECK(angular_velocity(slides).z() == near(-10, 1e-11));
    // sticking leaves no tangential velocity; the echo leaves -e of it
    const SpinningBall sticky(0.8);
    Body earth = immovable_body();
    CHECK(contact_velocity(earth, sticky.after(laws::clamped), sticky.contact()).head<1>().norm() < 1e-12);
    CHECK(contact_velocity(earth, sticky.after(laws::echo), sticky.contact()).x() == near(-0.5 * 5, 1e-12));
}

TEST_CASE("A smooth rod on its end (S10)") {
    const FallingRod scene;
    const Body after = scene.after(laws::clamped), exact = scene.exact();
    CHECK((velocity(after) - velocity(exact)).norm() < 1e-12 * 5);
    CHECK((angular_velocity(after) - angular_velocity(exact)).norm() < 1e-12 * 20);
    CHECK(kinetic_energy(after) == near(kinetic_energy(scene.rod()), 1e-12 * 12.5));
    CHECK((after.momentum - scene.after(laws::echo).momentum).norm() < 1e-14);
}

TEST_CASE("Back-spin: a ball with enough of it comes back") {
    for (const double mu : {0.1, 0.5}) {  // slides all through; ends rolling
        SpinningBall scene(mu);
        scene.velocity = {2, -4, 0}, scene.spin = {0, 0, 60};
        const Body after = scene.after(laws::clamped);
        CHECK((velocity(after) - velocity(scene.exact())).norm() < 1e-11);
        CHECK((angular_velocity(after) - angular_velocity(scene.exact())).norm() < 1e-10);
        CHECK((velocity(after).x() < 0) == (mu > 0.4));
    }
}

TEST_CASE("The law that echoes: 10^6 impacts of balls, boxes and rods without a gain") {
    check_echo(random_impacts(laws::echo, 1000000, 1));
}

TEST_CASE("The clamped law keeps momenta, restitution and cone, but gains energy on a rod") {
    const Worst worst = random_impacts(laws::clamped, 10000, 3);
    CHECK(worst.momentum < 8 * epsilon);
    CHECK(worst.turning < 16 * epsilon);
    CHECK(worst.restitution < 64 * epsilon);
    CHECK(worst.cone < 1e-11);
    CHECK(worst.energy > 0.1);
    const int rods = 100000;
    CHECK(largest_gain(0.9, laws::clamped, rods) == near(1.26, 0.01));
    CHECK(largest_gain(1, laws::clamped, rods) == near(1.56, 0.02));
    CHECK(largest_gain(0.9, laws::echo, rods) <= 1 + 1e-12);
    CHECK(largest_gain(1, laws::echo, rods) <= 1 + 1e-12);
}

TEST_CASE("Friction that remains opposes the sliding that remains, in every direction") {
    check_opposed(2000, 9);
}

TEST_CASE("Friction that remains: the other 10^5", "[.million]") {
    check_opposed(100000, 10);
}

TEST_CASE("Eq. (67*) as the errata gives it equals the smooth impulse") {
    Chance chance(4);
    for (int i = 0; i < 200; ++i) {
        const Contact at{chance.vector(1), chance.direction(), 0, 0};
        const Body a = random_body(chance, chance.vector(2), 1), b = random_body(chance, chance.vector(2), 2);
        const Vector3 u = contact_velocity(a, b, at), n = at.normal;
        if (n.dot(u) >= 0) continue;
        const Vector3 ra = at.point - a.position, rb = at.point - b.position;
        const auto turned = [&](const Body& body, const Vector3& r) {
            return n.dot((world_inertia(body).inverse() * r.cross(n)).cross(r));
        };
        const double j = -1.7 * n.dot(u) / (1 / a.mass + 1 / b.mass + turned(a, ra) + turned(b, rb));
        CHECK(n.dot(smooth_impulse(mobility(a, b, at), u, n, 0.7)) == near(j, 1e-9 * j));
    }
}

TEST_CASE("An impact law is a value: what it gives a contact is what collide applies") {
    each(impact_laws, [&](const ImpactLaw& law) {
        const SpinningBall scene(0.8);
        const Body before = scene.ball(), floor = immovable_body();
        const Vector3 u = contact_velocity(floor, before, scene.contact());
        const Matrix3 K = mobility(floor, before, scene.contact());
        const Vector3 J = law.impulse(K, u, {0, 1, 0}, 0.5, 0.8);
        CHECK((scene.after(law).momentum - before.momentum - J).norm() < 1e-14);
    });
    CHECK(laws::clamped.key() != laws::echo.key());
}

TEST_CASE("Where no direction of sliding is found there is no friction, and still no gain") {
    // Mobilities that no body of the course has: their directions differ by up to 10^16.
    Chance chance(1);
    int none = 0;
    for (int i = 0; i < 20000; ++i) {
        Matrix3 turn;
        turn = rotation_matrix(quaternion_about(chance.direction(), chance(0, 2 * pi)));
        const Vector3 answers(std::pow(10, chance(-16, 0)), std::pow(10, chance(-16, 0)), 1);
        const Matrix3 K = turn * answers.asDiagonal() * turn.transpose();
        const Vector3 u(chance(-1, 1), chance(-1, 0), chance(-1, 1)), n(0, 1, 0);
        const double mu = std::pow(10, chance(-3, 3)), e = chance(0, 1);
        const Vector3 stick = -K.inverse() * u;
        const bool sticks = n.dot(stick) > 0 && (stick - n.dot(stick) * n).norm() <= mu * n.dot(stick);
        if (sticks || sliding_impulse(K, u, n, mu)) continue;
        ++none;
        const Vector3 J = echo_impulse(K, u, n, e, mu), smooth = smooth_impulse(K, u, n, e);
        CHECK((J - smooth).norm() <= 4 * epsilon * smooth.norm());
        CHECK(n.dot(u + K * J) == near(-e * n.dot(u), 64 * epsilon * (K * J).norm()));
        const double gain = J.dot(u) + J.dot(K * J) / 2;  // of the kinetic energy
        CHECK(gain <= 64 * epsilon * std::abs(J.dot(u)));
    }
    CHECK(none > 100);
    // The bodies of the course, thin rods among them, never need it.
    for (int i = 0; i < 20000; ++i) {
        const Contact at{chance.vector(1), chance.direction(), 0, 0};
        const Body floor = immovable_body(), body = random_body(chance, at.point + chance.vector(2), i % 3);
        const Vector3 u = contact_velocity(floor, body, at);
        if (at.normal.dot(u) >= 0) continue;
        const Matrix3 K = mobility(floor, body, at);
        const double mu = chance(0, 2);
        const Vector3 stick = -K.inverse() * u;
        const double normal = at.normal.dot(stick);
        const bool sticks = normal > 0 && (stick - normal * at.normal).norm() <= mu * normal;
        CHECK((sticks || sliding_impulse(K, u, at.normal, mu)));
    }
}

TEST_CASE("What cannot collide is named at the door") {
    const Body wall = immovable_body();
    Body ball;
    const Contact at{{0, 0, 0}, {0, 1, 0}, 0, 0};
    CHECK_NOTHROW(check_contact(wall, ball, at));
    CHECK_THROWS_WITH(check_contact(wall, wall, at), ContainsSubstring("immovable"));
    CHECK_THROWS_WITH(check_contact(wall, ball, {{0, 0, 0}, {0, 0, 0}, 0, 0}), ContainsSubstring("length 0"));
    ball.mass = 0;
    CHECK_THROWS_WITH(check_contact(wall, ball, at), ContainsSubstring("mass"));
    ball.mass = 1, ball.angular_momentum.x() = std::nan("");
    CHECK_THROWS_WITH(check_contact(wall, ball, at), ContainsSubstring("angular momentum"));
    CHECK_THROWS_WITH(checked(Surface{0.5, -1}), ContainsSubstring("friction"));
    CHECK_THROWS_WITH(checked(Surface{2, 0}), ContainsSubstring("restitution"));
}
