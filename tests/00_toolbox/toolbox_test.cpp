// The toolbox against references of its own: Eigen's solver, std::pow and std::polar, known integrals.
#include <Eigen/Eigenvalues>
#include <nutshell/toolbox.hpp>
#include <random>

#include "check.hpp"

using namespace nutshell;

namespace {

double number(std::mt19937& source) {
    return std::uniform_real_distribution<double>(-2, 2)(source);
}
Vector3 vector(std::mt19937& source) {
    return {number(source), number(source), number(source)};
}

}  // namespace

TEST_CASE("toolbox: a direction has length 1 and leads from one place to the other") {
    std::mt19937 source(1);
    for (int i = 0; i < 100; ++i) {
        const Vector3 from = vector(source), to = vector(source);
        const Vector3 n = direction(from, to);
        CHECK(std::abs(n.norm() - 1) < 1e-15);
        CHECK((from + (to - from).norm() * n - to).norm() < 4e-15);
    }
    CHECK_THROWS_AS(direction({1, 2, 3}, {1, 2, 3}), std::invalid_argument);
}

TEST_CASE("toolbox: part along and rest make the vector, area is base times height over two") {
    std::mt19937 source(2);
    for (int i = 0; i < 100; ++i) {
        const Vector3 a = vector(source), b = vector(source), n = b.normalized();
        const Vector3 rest = a - part_along(a, n) * n;
        CHECK(std::abs(rest.x() * n.x() + rest.y() * n.y() + rest.z() * n.z()) < 4e-15);
        CHECK(std::abs(triangle_area(a, b) - b.norm() * rest.norm() / 2) < 1e-14);
    }
}

TEST_CASE("toolbox: slope and area are of second order") {
    const auto f = [](double x) { return std::exp(x); };
    const double h = 1e-2;  // leading error h^2/6 f'''; the next term is smaller by h^2/20
    CHECK(std::abs((slope(f, 0.7, h) - f(0.7)) / (h * h / 6 * f(0.7)) - 1) < 1e-5);
    CHECK(std::abs((slope(f, 0.7, h) - f(0.7)) / (slope(f, 0.7, h / 2) - f(0.7)) - 4) < 1e-3);
    const double exact = f(2) - f(0.5);
    CHECK(std::abs((area_under(f, 0.5, 2, 50) - exact) / (area_under(f, 0.5, 2, 100) - exact) - 4) < 1e-3);
    CHECK(std::abs(area_under([](double x) { return 3 * x + 1; }, -1, 2, 1) - 7.5) < 1e-15);
    CHECK_THROWS_AS(slope(f, 1, 0), std::invalid_argument);
    CHECK_THROWS_AS(area_under(f, 0, 1, 0), std::invalid_argument);
}

TEST_CASE(
    "toolbox: growth in many small steps comes to grown at first order, and doubles in ln 2 over the rate") {
    const double rate = -0.8, t = 2.5;
    const auto in_steps = [&](int n) { return 3 * std::pow(1 + rate * t / n, n); };
    const double coarse = in_steps(1000) - grown(3, rate, t), fine = in_steps(2000) - grown(3, rate, t);
    CHECK(std::abs(coarse / fine - 2) < 5e-3);
    CHECK(std::abs(grown(5, 0.3, std::log(2) / 0.3) - 10) < 1e-14);
}

TEST_CASE("toolbox: turns keep the size and add angles, spirals change both at their rates") {
    std::mt19937 source(3);
    for (int i = 0; i < 100; ++i) {
        const Complex z{number(source), number(source)};
        const double a = number(source), b = number(source);
        CHECK(std::abs(turned(z, a) - z * std::polar(1.0, a)) < 4e-15);
        CHECK(std::abs(turned(turned(z, a), b) - turned(z, a + b)) < 4e-15);
        CHECK(std::abs(spiralled(z, {a, b}, 1.5) - z * std::exp(Complex{a, b} * 1.5)) < 2e-13);
    }
    CHECK(std::abs(turned({3, 1}, pi / 2) - Complex{-1, 3}) < 1e-15);
}

TEST_CASE("toolbox: a matrix times a vector, and its larger eigenvalue, as Eigen finds them") {
    std::mt19937 source(4);
    int pairs = 0;
    for (int i = 0; i < 400; ++i) {
        Matrix2 A;
        A << number(source), number(source), number(source), number(source);
        const Vector2 v{number(source), number(source)};
        CHECK((mapped(A, v) - A * v).norm() < 1e-15);
        const auto values = Eigen::EigenSolver<Matrix2>(A, false).eigenvalues();
        pairs += values[0].imag() != 0;
        CHECK(std::abs(largest_factor(A) - values.cwiseAbs().maxCoeff()) <
              1e-7);  // near-double ones: sqrt(eps)
    }
    CHECK(pairs > 40);
    CHECK(pairs < 360);
}

TEST_CASE("toolbox: Newton's method squares the error in every turn") {
    const auto f = [](double x) { return x * x - 2; };
    const auto df = [](double x) { return 2 * x; };
    const double root = std::sqrt(2);
    for (int turns = 1; turns <= 3; ++turns) {
        const double before = newton_root(f, df, 3, turns) - root,
                     after = newton_root(f, df, 3, turns + 1) - root;
        // exactly before^2 / (2 x), x the place before
        CHECK(std::abs(after - before * before / (2 * (root + before))) < 4e-15);
    }
    CHECK(newton_root(f, df, 3, 0) == 3);
}
