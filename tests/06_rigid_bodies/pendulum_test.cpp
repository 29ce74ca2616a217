// Chapter 6: pendulums, pinned bodies in gravity: the exact solution, the methods' orders, Verlet's limit.
#include <nutshell/lab/stability.hpp>
#include <nutshell/pendulum_scenes.hpp>
#include <nutshell/rigid_methods.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

constexpr double degree = pi / 180;
const double epsilon = std::numeric_limits<double>::epsilon();

template <class Method>
Convergence errors_of(const Pendulum& scene, const Method& method, const std::vector<long>& steps) {
    Convergence c;
    for (const long n : steps) {
        const auto m = lab::measure(scene, method, n);
        c.dt.push_back(m.dt), c.error.push_back(m.max_error);
    }
    return c;
}

}  // namespace

TEST_CASE("The period is the elliptic integral, from small swings to 179 degrees") {
    // theta = 2 asin(k sin phi) turns the period into an integral without a pole; the midpoint rule over a
    // whole period of a smooth function is exact to round-off
    for (const double angle : {1e-6, 0.1, 1.0, 2.0, 3.0, 179 * degree}) {
        const double k = std::sin(angle / 2);
        double sum = 0;
        const int n = 4000;
        for (int i = 0; i < n; ++i) {
            const double s = k * std::sin((i + 0.5) * pi / n);
            sum += 1 / std::sqrt(1 - s * s);
        }
        const double integral = sum * pi / n / 2;  // from 0 to pi/2
        CHECK(pendulum_period(2, angle) == Approx(4 * std::sqrt(2 / 9.81) * integral).epsilon(1e-12));
    }
    CHECK(pendulum_period(1, 0) == Approx(2 * pi / std::sqrt(9.81)).epsilon(1e-15));
    // Two series of other making: small angles 1 + a^2/16 + 11 a^4/3072, and near the top ln(4/k')
    CHECK(pendulum_period(1, 0.1) / pendulum_period(1, 0) ==
          Approx(1 + 0.01 / 16 + 11e-4 / 3072 + 173e-6 / 737280).epsilon(1e-11));
    CHECK_THROWS_WITH(pendulum_period(1, pi), ContainsSubstring("below pi"));
    CHECK_THROWS_WITH(pendulum_period(0, 1), ContainsSubstring("length"));
}

TEST_CASE("A compound pendulum swings as one point at I/(m r): two thirds of a thin rod") {
    CHECK(rod_pendulum(1).length() == 1);
    const double thick = (0.01 * 0.01 / 4) / 0.5;  // what the rod's 2 cm add
    CHECK(compound_pendulum(1).length() == Approx(2. / 3 + thick).epsilon(1e-15));
}

TEST_CASE(
    "The exact pendulum starts where it starts, obeys its law, keeps its energy, returns after its period") {
    for (const double angle : {0.1, 2.0, 179 * degree}) {
        const Pendulum scene = rod_pendulum(angle);
        CHECK(scene.error(scene.start, 0) < 1e-14);
        const double top = scene.energy(scene.start), h = 1e-4, period = scene.duration / 3;
        const double w = scene.omega(), inertia = scene.start.inertia.z();
        for (double t = 0.05; t < scene.duration; t += 0.37) {
            const Pinned before = scene.exact(t - h), here = scene.exact(t), after = scene.exact(t + h);
            CHECK(scene.energy(here) == Approx(top).epsilon(1e-12));
            // dL/dt = torque and dtheta/dt = L/I by central differences, off by h^2/6 of a third derivative.
            // The angle's second derivative is -w^2 sin theta and its rate squared at most
            // 2 w^2 (1 + cos theta), so its fourth is at most w^4 |sin theta (2 + 3 cos theta)| <= 3.05 w^4,
            // and its third at most 2 w^3. Round-off: values that the phase (below 8 K = 60) knows to 60
            // epsilon, over h.
            const double noise = 60 * epsilon * 2 * w / h;
            const Vector3 change = (after.angular_momentum - before.angular_momentum) / (2 * h);
            CHECK((change - scene(here, t).torque).norm() <
                  inertia * (3.05 / 6 * std::pow(w, 4) * h * h + noise));
            const double turned = logarithm(product(after.orientation, inverse(before.orientation))).z();
            CHECK(std::abs(turned / (2 * h) - here.angular_momentum.z() / inertia) <
                  w * w * w / 3 * h * h + noise);
            CHECK(scene.error(scene.exact(t + period), t) < 1e-12);
        }
    }
}

TEST_CASE(
    "Methods of chapters 1 and 3 swing a pinned body at their orders, and so does the method on the group") {
    for (const Pendulum& scene : {rod_pendulum(0.5), compound_pendulum(2)}) {
        INFO(scene.name);
        CHECK_THAT(errors_of(scene, methods::euler, {40'000, 80'000, 160'000}), HasOrder(1));
        CHECK_THAT(errors_of(scene, methods::semi_implicit_euler, {8000, 16'000, 32'000}), HasOrder(1));
        CHECK_THAT(errors_of(scene, methods::verlet_re_evaluated, {1000, 2000, 4000}), HasOrder(2));
        CHECK_THAT(errors_of(scene, methods::verlet, {1000, 2000, 4000}), HasOrder(2));
        CHECK_THAT(errors_of(scene, methods::yoshida4, {1000, 2000, 4000}), HasOrder(4));
        CHECK_THAT(errors_of(scene, methods::lie_rk4, {2000, 4000, 8000}), HasOrder(4, 0.1));
        CHECK_THAT(errors_of(scene, methods::rk4, {4000, 8000, 16'000}), HasOrder(4, 0.1));
    }
}

TEST_CASE("Kahan-Li's method swings a pinned body at order 8") {
    // At half a radian its error is a pure eighth power from 80 steps on; with 160 it is 2e-12, a
    // hundred times what 160 steps of round-off leave.
    for (const Pendulum& scene : {rod_pendulum(0.5), compound_pendulum(0.5)})
        CHECK_THAT(errors_of(scene, methods::kahan_li8, {80, 120, 160}), HasOrder(8));
}

TEST_CASE("From 179 degrees the swing is met too, at a smaller step") {
    const Pendulum scene = rod_pendulum(179 * degree);
    CHECK_THAT(errors_of(scene, methods::verlet_re_evaluated, {4000, 8000, 16'000}), HasOrder(2));
    CHECK(lab::measure(scene, methods::yoshida4, 3000).max_error < scene.need.tolerance);
}

TEST_CASE("Verlet's limit on a hanging body is 2/omega: predicted, by eigenvalue, and by running") {
    for (const Pendulum& scene : {rod_pendulum(1e-6), compound_pendulum(1e-6)}) {
        const double limit = pendulum_verlet_limit(scene.omega());
        CHECK(limit == Approx(2 * std::sqrt(scene.length() / 9.81)));
        // one step near hanging, as a matrix on (angle, angular momentum)
        const auto radius = [&](double dt) {
            return lab::spectral_radius(lab::step_matrix(
                Vector::Zero(2),
                [&](const Vector& y) {
                    Pinned body = scene.start;
                    body.orientation = exponential({0, 0, y[0]}), body.angular_momentum = {0, 0, y[1]};
                    body = verlet(body, scene, 0, dt);
                    return Vector(Eigen::Vector2d(scene.angle_of(body), body.angular_momentum.z()));
                },
                1e-4));
        };
        CHECK(radius(0.99 * limit) < 1 + 1e-6);
        CHECK(radius(1.01 * limit) > 1.1);
        const auto stable = [&](double dt) {
            return lab::stays_within(scene, methods::verlet_re_evaluated, dt, 2000, 1e-3,
                                     [&](const Pinned& body) { return std::abs(scene.angle_of(body)); });
        };
        CHECK(stable(0.99 * limit));
        CHECK_FALSE(stable(1.01 * limit));
        CHECK(lab::stability_limit(stable, limit / 2, 1.5 * limit) == Approx(limit).epsilon(0.01));
    }
    CHECK_THROWS_WITH(pendulum_verlet_limit(0), ContainsSubstring("omega"));
}
