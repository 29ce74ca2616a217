// A game of somebody else: a planet by Verlet, a thrown ball by Euler, with what the installed course offers.
#include <cmath>
#include <cstdio>
#include <nutshell/newton.hpp>
#include <nutshell/newton_scenes.hpp>

int main() {
    using namespace nutshell;

    const Planet planet;
    const double dt = 12.0 / 1500;
    PointMass body = planet.start;
    for (int i = 0; i < 1500; ++i) body = verlet(body, planet, i * dt, dt);
    std::printf("%a %a %a %a\n", body.position.x(), body.position.y(), body.velocity.x(), body.velocity.y());
    const double turning = angular_momentum(body).z() / angular_momentum(planet.start).z();
    if (!(std::abs(turning - 1) < 1e-12))
        return std::printf("Verlet changed the angular momentum by %g\n", turning - 1), 1;

    const ThrownBall ball;
    const int steps = 100;
    PointMass thrown = ball.start;
    for (int i = 0; i < steps; ++i)
        thrown = euler(thrown, ball, i * ball.duration / steps, ball.duration / steps);
    const Vector3 error = thrown.position - ball.exact(ball.duration).position;
    const Vector3 law = throw_error(Kicked::after_drift, gravity, ball.duration, ball.duration / steps);
    if (!((error - law).norm() < 1e-12 * law.norm() * steps))
        return std::printf("Euler is off by %g m, not %g m\n", error.norm(), law.norm()), 1;
}
