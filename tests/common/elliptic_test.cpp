// The special functions of pendulums and tops, against the standard library's, their own definitions as
// integrals, and each other.
#include <nutshell/elliptic.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

const double epsilon = std::numeric_limits<double>::epsilon();

/// Integral from a to b by Gauss-Legendre with five points on each of `pieces` pieces.
template <class F>
double integral(const F& f, double a, double b, int pieces = 400) {
    constexpr double x[3] = {0, 0.538469310105683091, 0.906179845938663993};
    constexpr double w[3] = {128. / 225, 0.478628670499366468, 0.236926885056189088};
    double sum = 0;
    const double h = (b - a) / pieces;
    for (int i = 0; i < pieces; ++i) {
        const double middle = a + (i + 0.5) * h;
        sum += w[0] * f(middle);
        for (int j = 1; j < 3; ++j) sum += w[j] * (f(middle - h / 2 * x[j]) + f(middle + h / 2 * x[j]));
    }
    return sum * h / 2;
}

}  // namespace

TEST_CASE("The complete elliptic integral by Gauss' mean: the standard library's, and its limits") {
    CHECK(arithmetic_geometric_mean(1, std::sqrt(2.0)) == Approx(1.1981402347355922).epsilon(2 * epsilon));
    for (const double k : {0.0, 0.1, 0.5, 0.9, 0.99}) {
        const double complementary = std::sqrt((1 - k) * (1 + k));
        // the standard library takes k, whose rounding moves K by epsilon k^2/k'^2 of itself at most
        CHECK(complete_elliptic_k(complementary) ==
              Approx(std::comp_ellint_1(k)).epsilon(4 * epsilon / (complementary * complementary)));
    }
    // K = ln(4/k') + (ln(4/k') - 1) k'^2/4 + ...
    for (const double c : {1e-5, 1e-9, 1e-100})
        CHECK(complete_elliptic_k(c) ==
              Approx(std::log(4 / c) + (std::log(4 / c) - 1) * c * c / 4).epsilon(1e-15));
    CHECK_THROWS_WITH(complete_elliptic_k(0), ContainsSubstring("greater than zero"));
    CHECK_THROWS_WITH(arithmetic_geometric_mean(-1, 1), ContainsSubstring("first number"));
}

TEST_CASE(
    "Jacobi's functions: their squares, their derivatives, their quarter periods, near the separatrix too") {
    for (const double c : {1.0, 0.9, 0.5, 0.1, 1e-2, 1e-4, 1e-8}) {
        const double quarter = complete_elliptic_k(c), k2 = (1 - c) * (1 + c);
        INFO("k' = " << c);
        for (double part = -2.97; part < 3; part += 0.0831) {
            const double u = part * quarter, h = 1e-5;
            const Jacobi f = jacobi(u, c), before = jacobi(u - h, c), after = jacobi(u + h, c);
            // at most 7 Landen steps of 4 roundings by half an epsilon each; twice that in a square
            const double bound = 28 * epsilon * (1 + std::abs(u));
            CHECK(std::abs(f.sn * f.sn + f.cn * f.cn - 1) < bound);
            CHECK(std::abs(f.dn * f.dn + k2 * f.sn * f.sn - 1) < bound);
            // central differences: h^2/6 times a third derivative of at most 5, and round-off over h
            CHECK(std::abs((after.sn - before.sn) / (2 * h) - f.cn * f.dn) < 1e-10 + 2 * bound / h);
            CHECK(std::abs((after.dn - before.dn) / (2 * h) + k2 * f.sn * f.cn) < 1e-10 + 2 * bound / h);
        }
        CHECK(jacobi(quarter, c).sn == Approx(1).epsilon(4 * epsilon));
        CHECK(jacobi(quarter, c).dn == Approx(c).epsilon(1e-12));  // dn(K) = k', to its own digits
        CHECK(jacobi(quarter / 2, c).sn == Approx(1 / std::sqrt(1 + c)).epsilon(1e-14));
        CHECK(jacobi(quarter / 2, c).cn == Approx(std::sqrt(c / (1 + c))).epsilon(1e-13));
    }
    CHECK(jacobi(0.7, 1).sn == Approx(std::sin(0.7)).epsilon(2 * epsilon));
    CHECK(jacobi(0.7, 1e-9).sn == Approx(std::tanh(0.7)).epsilon(1e-14));
    CHECK_THROWS_WITH(jacobi(std::nan(""), 0.5), ContainsSubstring("finite"));
    CHECK_THROWS_WITH(jacobi(1, 0), ContainsSubstring("complementary"));
}

TEST_CASE("The first integral is the inverse of sn and cn, and the standard library's") {
    for (const double c : {1.0, 0.7, 0.1, 1e-3, 1e-7}) {
        const double quarter = complete_elliptic_k(c);
        for (double part = -1.98; part < 2; part += 0.0731) {
            const Jacobi f = jacobi(part * quarter, c);
            CHECK(std::abs(elliptic_f(f.cn, f.sn, c) - part * quarter) < 8 * epsilon * (1 + quarter));
        }
    }
    for (const double phi : {0.1, 0.5, 1.0, 1.5})
        for (const double k : {0.2, 0.8}) {
            const double c = std::sqrt(1 - k * k);
            CHECK(elliptic_f(std::cos(phi), std::sin(phi), c) ==
                  Approx(std::ellint_1(k, phi)).epsilon(1e-14));
        }
}

TEST_CASE("The third integral is the integral it says, over several periods and both signs of n") {
    for (const double c : {1.0, 0.6, 0.1})
        for (const double n : {-0.9, -0.3, 0.0, 0.7, 50.0})
            for (const double u : {-7.3, -0.4, 0.0, 0.9, 5.1, 14.2}) {
                const double expected = integral(
                    [&](double x) {
                        const double s = jacobi(x, c).sn;
                        return s * s / (1 + n * s * s);
                    },
                    0, u);
                INFO("k' " << c << ", n " << n << ", u " << u);
                CHECK(std::abs(elliptic_third(u, n, c) - expected) < 1e-12 * (1 + std::abs(u)));
            }
    // the standard library's Pi(k, nu, phi) = F - nu times ours, with n = nu
    const double k = 0.6, phi = 1.1, c = 0.8, u = elliptic_f(std::cos(phi), std::sin(phi), c);
    for (const double nu : {-0.4, 0.5, 3.0})
        CHECK(u - nu * elliptic_third(u, nu, c) == Approx(std::ellint_3(k, -nu, phi)).epsilon(1e-13));
    CHECK_THROWS_WITH(elliptic_third(1, -1, 0.5), ContainsSubstring("greater than -1"));
}
