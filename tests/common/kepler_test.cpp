#include <nutshell/kepler.hpp>
#include "check.hpp"

using namespace nutshell;

TEST_CASE("Kepler's equation is solved to round-off") {
    for (double e : {0.0, 0.1, 0.6, 0.79, 0.8, 0.95, 0.999})
        for (double M = -9; M <= 9; M += 0.0173) {
            const double E = eccentric_anomaly(M, e);
            // M and e sin E carry an error of an ulp each, at |M| <= 9 half an ulp is 9e-16
            CHECK(std::abs(E - e * std::sin(E) - M) < 4e-15);
        }
    CHECK_THROWS_WITH(eccentric_anomaly(0, 1), ContainsSubstring("ellipse"));
    CHECK_THROWS_WITH(eccentric_anomaly(std::nan(""), 0.5), ContainsSubstring("not finite"));
}

TEST_CASE("the exact orbit obeys Newton's law, by differences and by its conserved quantities") {
    const double gm = 1.7, a = 1.3, e = 0.6, h = 1e-4;
    for (double t : {0.0, 0.3, 1.0, 4.0, 20.0}) {
        const auto before = kepler_orbit(t - h, gm, a, e), here = kepler_orbit(t, gm, a, e),
                   after = kepler_orbit(t + h, gm, a, e);
        const Vector3 speed = (after.position - before.position) / (2 * h);
        const Vector3 acceleration = (after.velocity - before.velocity) / (2 * h);
        const double r = here.position.norm();
        // central differences: error h^2/6 times the third derivative, here below 60 at perihelion
        CHECK((speed - here.velocity).norm() < 60 * h * h);
        CHECK((acceleration + gm / (r * r * r) * here.position).norm() < 300 * h * h);
        CHECK(here.velocity.squaredNorm() / 2 - gm / r == Approx(-gm / (2 * a)).epsilon(1e-13));
        CHECK(here.position.cross(here.velocity).z() ==
              Approx(std::sqrt(gm * a * (1 - e * e))).epsilon(1e-13));
    }
    CHECK(kepler_orbit(0, gm, a, e).position.isApprox(Vector3(a * (1 - e), 0, 0)));
    CHECK(kepler_orbit(0.1, gm, a, e).position.y() > 0);  // counter-clockwise
}
