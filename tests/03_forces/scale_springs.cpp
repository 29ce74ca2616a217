// Springs: the list, the grid's wide loops and the formula agree; forces are opposite, follow the energy, and
// stay finite where ends meet; the door refuses the rest.
#include <limits>
#include <nutshell/chain_scenes.hpp>
#include <nutshell/lab/run.hpp>
#include <random>
#include "check.hpp"
#include "one_pass.hpp"

using namespace nutshell;

namespace {

/// A crumpled cloth: every particle shifted by its own reproducible amount.
SpringNet crumpled(std::size_t n, Weave weave, double by = 0.3) {
    SpringNet net = cloth(n, 1, 1, 50, weave);
    std::mt19937 random(7);
    for (auto* axis : {&net.start.position.x, &net.start.position.y, &net.start.position.z})
        for (double& value : *axis)
            value += by / static_cast<double>(n) * (static_cast<double>(random()) / 4294967296.0 - 0.5);
    return net;
}

Vector3Array spring_forces(const SpringNet& net) {
    Vector3Array forces(net.start.size());
    add_forces(net.springs, net.start, forces);
    return forces;
}

double largest_difference(const Vector3Array& a, const Vector3Array& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
    return largest;
}

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("The grid's wide loops give the forces of the list of springs, to round-off") {
    const auto weave = GENERATE(Weave::structural, Weave::with_shear, Weave::with_shear_and_bend);
    const auto n = static_cast<std::size_t>(GENERATE(2, 3, 17, 40));
    const SpringNet net = crumpled(n, weave);
    Vector3Array by_list(net.start.size());
    add_forces(list_of(net.springs), net.start, by_list);
    CHECK(largest_difference(by_list, spring_forces(net)) <
          50 * 1e-15 * 20);  // stiffness, round-off, springs at a particle
}

TEST_CASE("A chain longer than several blocks, and grids with far springs, agree with the list too") {
    for (const std::size_t n :
         std::vector<std::size_t>{2, 3, 16, 17, 255, 256, 257, 300, 511, 512, 513, 514, 1000}) {
        for (const long step : {1, 2, 5, 16}) {
            SpringNet net{"row", Particles(n), {1, n, {{0, step, {50, 0.7}}}}, {}};
            for (std::size_t i = 0; i < n; ++i) {
                const auto k = static_cast<double>(i);
                net.start.position.set(i, {k, std::sin(k), std::cos(3 * k)});
            }
            checked(net);
            Vector3Array by_list(n);
            add_forces(list_of(net.springs), net.start, by_list);
            INFO(n << " particles, springs over " << step);
            CHECK(largest_difference(by_list, spring_forces(net)) < 1e-11 * 50 / 1000);
        }
    }
}

TEST_CASE("Numbers of springs: a cloth of n x n has the springs its weave says") {
    const std::size_t n = 6;
    CHECK(list_of(cloth(n, 1, 1, 1, Weave::structural).springs).links.size() == 2 * n * (n - 1));
    CHECK(list_of(cloth(n, 1, 1, 1, Weave::with_shear).springs).links.size() ==
          2 * n * (n - 1) + 2 * (n - 1) * (n - 1));
    CHECK(list_of(cloth(n, 1, 1, 1, Weave::with_shear_and_bend).springs).links.size() ==
          2 * n * (n - 1) + 2 * (n - 1) * (n - 1) + 2 * n * (n - 2));
}

TEST_CASE(
    "Springs pull on their two ends with opposite forces: momentum and angular momentum of the whole stay") {
    const SpringNet net = crumpled(12, Weave::with_shear_and_bend);
    const Vector3Array forces = spring_forces(net);
    Vector3 sum = Vector3::Zero(), torque = Vector3::Zero();
    double size = 0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        sum += forces[i], torque += net.start.position[i].cross(forces[i]);
        size += forces[i].norm();
    }
    CHECK(size > 1);
    CHECK(sum.norm() < 1e-14 * size);
    CHECK(torque.norm() < 1e-14 * size);
}

TEST_CASE("The forces are minus the slope of the energy, and their change is minus its curvature") {
    SpringNet net = crumpled(4, Weave::with_shear_and_bend);
    net.g = 0;
    const Vector3Array forces = spring_forces(net);
    const double h = 1e-5;
    for (const std::size_t i : std::vector<std::size_t>{0, 5, 15})
        for (int axis = 0; axis < 3; ++axis) {
            SpringNet plus = net, minus = net;
            plus.start.position.set(i, net.start.position[i] + h * Vector3::Unit(axis));
            minus.start.position.set(i, net.start.position[i] - h * Vector3::Unit(axis));
            const double slope = (plus.energy(plus.start) - minus.energy(minus.start)) / (2 * h);
            CHECK(std::abs(slope + forces[i][axis]) < 1e-6);
            const Vector3 change = (spring_forces(plus)[i] - spring_forces(minus)[i]) / (2 * h);
            Vector3 formula = Vector3::Zero();
            for (const auto& [a, b, spring] : list_of(net.springs).links)
                if (a == i || b == i)
                    formula += spring_slope(spring, net.start.position[i], net.start.position[a == i ? b : a])
                                   .col(axis);
            CHECK((change - formula).norm() < 1e-5);
        }
}

TEST_CASE(
    "Where the ends of a spring meet its force is zero: in the list, in the grid, in a whole run (E08)") {
    Particles two(2);
    Vector3Array forces(2);
    add_forces(Springs{{{0, 1, {100, 1}}}, {{0, Vector3::Zero(), {100, 1}}}}, two, forces);
    CHECK(forces[0] == Vector3::Zero());
    CHECK(forces[1] == Vector3::Zero());

    SpringNet chain_of_three{"meeting", Particles(3), {1, 3, {{0, 1, {100, 1}}}}, {}};
    CHECK(spring_forces(chain_of_three)[1] == Vector3::Zero());
    SpringNet cloth_in_a_point = cloth(5, 1, 1, 50, Weave::with_shear_and_bend);
    cloth_in_a_point.start.position = Vector3Array(25);
    const Vector3Array none = spring_forces(cloth_in_a_point);
    for (std::size_t i = 0; i < 25; ++i) CHECK(none[i] == Vector3::Zero());

    // Two masses fly at each other along x and are in one point after exactly four steps, spring and all.
    SpringNet meeting{"meeting", Particles(2), {1, 2, {{0, 1, {0, 1}}}}, {}};
    meeting.g = 0, meeting.duration = 8;
    meeting.start.set(0, {1, {-4, 0, 0}, {1, 0, 0}});
    meeting.start.set(1, {1, {4, 0, 0}, {-1, 0, 0}});
    bool met = false;
    const auto look = [&](const Particles& all, double) { met = met || all.position[0] == all.position[1]; };
    lab::run(meeting, methods::verlet, 8, look);
    CHECK(met);
    // With a spring that pushes and pulls they meet where symmetry says, and whatever happens nothing is ever
    // NaN.
    meeting.springs.kinds[0].spring = {0.7, 0.0};
    each(std::tuple{methods::semi_implicit_euler, one_pass}, [&](const auto& method) {
        lab::run(meeting, method, 64, [](const Particles& all, double) {
            REQUIRE(std::isfinite(all.position[0].norm() + all.velocity[1].norm()));
            CHECK(all.position[0] == -all.position[1]);
        });
    });
}

TEST_CASE("Springs that cannot be simulated are refused at the door, with their number") {
    const Spring good{100, 1};
    const auto refuses = [](const Springs& springs, const std::string& word) {
        CHECK_THROWS_WITH(checked(springs, 3), ContainsSubstring(word));
    };
    CHECK_NOTHROW(checked(Springs{{{0, 1, good}}, {{2, Vector3::Zero(), good}}}, 3));
    refuses({{{0, 1, good}, {1, 1, good}}}, "spring 1 joins particle 1 to itself");
    refuses({{{0, 3, good}}}, "there are only 3");
    refuses({{{0, 1, {-1, 1}}}}, "stiffness");
    refuses({{{0, 1, {not_a_number, 1}}}}, "stiffness");
    refuses({{{0, 1, {1, -1}}}}, "rest length");
    refuses({{}, {{3, Vector3::Zero(), good}}}, "anchor 0");
    refuses({{}, {{0, {not_a_number, 0, 0}, good}}}, "anchor");
}

TEST_CASE("Grids, chains and cloths that cannot be simulated are refused at the door") {
    const Spring good{100, 1};
    const auto refuses = [](const GridSprings& grid, const std::string& word) {
        CHECK_THROWS_WITH(checked(grid, 12), ContainsSubstring(word));
    };
    CHECK_NOTHROW(checked(GridSprings{3, 4, {{1, -1, good}}}, 12));
    refuses({3, 5, {}}, "does not fit");
    refuses({3, 4, {{0, 0, good}}}, "itself");
    refuses({3, 4, {{0, -1, good}}}, "to the right");
    refuses({3, 4, {{0, 17, good}}}, "to the right");
    refuses({3, 4, {{1, 0, {1, -1}}}}, "rest length");
    CHECK_THROWS_AS(chain(0, 1, good, {0, 0, 0}, {1, 0, 0}), std::invalid_argument);
    CHECK_THROWS_AS(chain(3, 0, good, {0, 0, 0}, {1, 0, 0}), std::invalid_argument);
    CHECK_THROWS_AS(chain(3, 1, {-1, 1}, {0, 0, 0}, {1, 0, 0}), std::invalid_argument);
    CHECK_THROWS_AS(chain(3, 1, good, {not_a_number, 0, 0}, {1, 0, 0}), std::invalid_argument);
    CHECK_THROWS_AS(cloth(1, 1, 1, 1, Weave::structural), std::invalid_argument);
    CHECK_THROWS_AS(cloth(3, 0, 1, 1, Weave::structural), std::invalid_argument);
    CHECK_THROWS_AS(cloth(3, 1, -1, 1, Weave::structural), std::invalid_argument);
    SpringNet net = chain(3, 1, good, {0, 0, 0}, {4, 0, 0});
    net.start.velocity.set(0, {1, 0, 0});
    CHECK_THROWS_WITH(checked(net), ContainsSubstring("has a velocity"));
    net.start.velocity.set(0, {0, 0, 0});
    net.held = {4, 0};
    CHECK_THROWS_WITH(checked(net), ContainsSubstring("rising order"));
    net.held = {5};
    CHECK_THROWS_WITH(checked(net), ContainsSubstring("there are only 5"));
    net.held = {}, net.drag = -1;
    CHECK_THROWS_WITH(checked(net), ContainsSubstring("drag"));
}
