// The lab is tested on things whose answers are known without it.
#include <unistd.h>
#include <fstream>
#include <nutshell/lab/need_chart.hpp>
#include <nutshell/lab/output.hpp>
#include <nutshell/lab/study.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/newton_scenes.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

/// A spring of angular frequency 1 rad/s from rest at x = 1; the lab's own test piece.
struct TestSpring {
    PointMass start{1, {1, 0, 0}, {0, 0, 0}};
    double duration = 1;
    Need need{1e-3, "m", "test"};
    Vector3 operator()(const PointMass& mass, double) const { return -mass.position; }
    double error(const PointMass& mass, double t) const { return std::abs(mass.position.x() - std::cos(t)); }
};

std::filesystem::path fresh_folder() {
    const auto folder =
        std::filesystem::temp_directory_path() / ("nutshell_lab_test_" + std::to_string(getpid()));
    std::filesystem::remove_all(folder);
    return folder;
}

std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("a run makes the steps it was asked for and shows the observer each of them") {
    std::vector<double> times;
    lab::run(TestSpring{}, methods::euler, 4, [&](const PointMass&, double t) { times.push_back(t); });
    CHECK(times == std::vector<double>{0, 0.25, 0.5, 0.75, 1});
}

TEST_CASE("a measurement counts every evaluation of the force") {
    CHECK(lab::measure(TestSpring{}, methods::euler, 10).evaluations == 10);
    CHECK(lab::measure(TestSpring{}, methods::verlet, 10).evaluations == 11);
}

TEST_CASE("a run that leaves the finite numbers has an infinite error, not a NaN") {
    struct Blast : TestSpring {
        Vector3 operator()(const PointMass& mass, double) const { return 1e200 * mass.position; }
    };
    CHECK(std::isinf(lab::measure(Blast{}, methods::euler, 10).max_error));
}

TEST_CASE("the observed order of exact powers is their exponent") {
    CHECK(lab::observed_order({0.1, 0.2, 0.4}, {0.003, 0.012, 0.048}) == Approx(2).epsilon(1e-12));
    CHECK_THROWS_WITH(lab::observed_order({0.1, 0.2}, {1, 0}), ContainsSubstring("zero error has no order"));
}

TEST_CASE("Verlet's stability limit on a spring is found at omega dt = 2") {
    const auto stable = [](double dt) {
        return lab::stays_within(TestSpring{}, methods::verlet, dt, 20000, 1e6,
                                 [](const PointMass& s) { return s.position.norm(); });
    };
    CHECK(lab::stability_limit(stable, 0.5, 4, 1e-5) ==
          Approx(2).epsilon(1e-4));  // growth at 2 + d: e^(2 sqrt d) a step
    CHECK_THROWS_WITH(lab::stability_limit(stable, 3, 4), ContainsSubstring("begin lower"));
    CHECK_THROWS_WITH(lab::stability_limit(stable, 0.5, 1), ContainsSubstring("begin higher"));
}

TEST_CASE("conservation is measured for numbers and for vectors") {
    // Euler multiplies the energy of a spring by 1 + dt^2 in every step: curriculum, chapter 3's table.
    TestSpring spring;
    const auto energy = [](const PointMass& s) {
        return s.velocity.squaredNorm() + s.position.squaredNorm();
    };
    CHECK(lab::largest_change(spring, methods::euler, 100, energy) ==
          Approx(std::pow(1 + 1e-4, 100) - 1).epsilon(1e-11));
    // A vector that only turns keeps its length; the lab must see the turn.
    const auto phase = [](const PointMass& s) { return Vector3(s.position.x(), s.velocity.x(), 0); };
    CHECK(lab::largest_change(spring, methods::verlet, 100, phase) ==
          Approx(2 * std::sin(0.5)).epsilon(1e-4));
}

TEST_CASE("the fewest steps that meet a need are the fewest") {
    const auto method = lab::entry<TestSpring>(methods::verlet);
    const auto found = lab::fewest_steps(TestSpring{}, method, 1e-5);
    REQUIRE(found);
    CHECK(found->max_error <= 1e-5);
    CHECK(lab::measure(TestSpring{}, methods::verlet, found->steps - 1).max_error > 1e-5);
    CHECK_FALSE(lab::fewest_steps(TestSpring{}, lab::entry<TestSpring>(methods::euler), 1e-12, 1, 1000));
}

TEST_CASE("the machine's floor is a time between a picosecond and a microsecond") {
    const auto floor = lab::machine_floor();
    CHECK((floor.multiply_add > 1e-12 && floor.multiply_add < 1e-6));
    CHECK(floor.square_root > floor.multiply_add);
}

TEST_CASE("a study without planned steps is refused, and one whose runs are all wrong is not drawn") {
    const lab::Plan none{.key = "none", .scene = "A spring.", .behind = "error against cost"};
    lab::Report report(fresh_folder(), "test");
    CHECK_THROWS_AS(lab::draw_study(report, none, {}, {}, TestSpring{}.need), std::invalid_argument);
    lab::Measurement wrong;
    wrong.max_error = std::numeric_limits<double>::infinity();
    lab::draw_study(report, none, {{"wrong", {}, {wrong}}}, {}, TestSpring{}.need);
    CHECK_FALSE(std::filesystem::exists(report.path("none.svg")));
}

TEST_CASE("bad steps and durations are refused in words") {
    CHECK(lab::steps_of(3, 1.0 / 60) == 180);
    CHECK_THROWS_WITH(lab::steps_of(1, 0.3), ContainsSubstring("not a whole number of steps"));
    CHECK_THROWS_WITH(lab::steps_of(1, 0), ContainsSubstring("greater than zero"));
    CHECK_THROWS_WITH(lab::steps_of(1, -1), ContainsSubstring("greater than zero"));
    CHECK_THROWS_WITH(lab::steps_of(1, std::nan("")), ContainsSubstring("finite"));
    CHECK_THROWS_WITH(lab::run(TestSpring{}, methods::euler, 0), ContainsSubstring("at least one step"));
}

TEST_CASE("a file is written whole, with provenance on top, or not at all") {
    const auto folder = fresh_folder();
    lab::Report report(folder, "test command");
    report.data("table.csv", lab::Table{{"a", "b"}, {{"1", "say \"two\", three"}}});
    const std::string text = contents(folder / "table.csv");
    CHECK_THAT(text, ContainsSubstring("# command: test command\n# machine: "));
    CHECK_THAT(text, ContainsSubstring("# compiler: "));
    CHECK_THAT(text, ContainsSubstring("a,b\n1,\"say \"\"two\"\", three\"\n"));
    long files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++files;
    CHECK(files == 1);  // no temporary file left
    CHECK_THROWS_WITH(write_file("/proc/nutshell/x.csv", "x"), ContainsSubstring("/proc/nutshell"));
    std::filesystem::create_directories(folder / "is_a_folder" / "x");
    CHECK_THROWS_WITH(write_file(folder / "is_a_folder", "x"), ContainsSubstring("is_a_folder"));
    std::filesystem::remove_all(folder);
}

TEST_CASE("a number is written so that it can be read back exactly, and only once") {
    CHECK(std::stod(lab::exact_digits(0.1 + 0.2)) == 0.1 + 0.2);
    lab::Report report(fresh_folder(), "test");
    report.number("a", 1);
    CHECK_THROWS_WITH(report.number("a", 2), ContainsSubstring("reported twice"));
}
