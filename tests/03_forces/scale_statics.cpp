// Hanging chains and cloths: the exact rest shape is at rest, a damped chain comes to it, and with ever more
// links it becomes the elastic catenary at second order.
#include <nutshell/chain_scenes.hpp>
#include <nutshell/hanging_chain.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/newton_methods.hpp>
#include "check.hpp"

using namespace nutshell;

namespace {

/// A cord of 1 kg, 3 m long at rest, cut into `links` links, between ends 2 m apart.
HangingChain cut_into(std::size_t links, const Vector2& end = {2, 0}, double cord_stiffness = 40) {
    const auto n = static_cast<double>(links);
    return {links - 1, 1 / n, {cord_stiffness * n / 3, 3 / n}, end};
}

/// The scene of that chain, its masses at `points`.
SpringNet scene_of(const HangingChain& chain, const std::vector<Vector2>& points) {
    SpringNet net =
        nutshell::chain(chain.masses, chain.mass, chain.link, {0, 0, 0}, {chain.end.x(), chain.end.y(), 0});
    for (std::size_t i = 0; i < points.size(); ++i)
        net.start.position.set(i, {points[i].x(), points[i].y(), 0});
    return net;
}

double largest_force(const SpringNet& net) {
    const Vector3Array forces = net(net.start, 0);
    double largest = 0;
    for (std::size_t i = 0; i < net.start.size(); ++i) largest = std::max(largest, forces[i].norm());
    return largest;
}

/// The horizontal tension between level ends, by halving an interval: one equation, no derivative, nothing
/// shared.
double horizontal_by_bisection(const HangingChain& chain) {
    double low = 1e-9, high = 1e9;
    for (int i = 0; i < 200; ++i) {
        const double H = std::sqrt(low * high);
        double x = 0;
        for (std::size_t link = 0; link <= chain.masses; ++link) {
            const double V =
                (static_cast<double>(chain.masses) / 2 - static_cast<double>(link)) * chain.mass * chain.g;
            x += H * (chain.link.rest_length / std::sqrt(H * H + V * V) + 1 / chain.link.stiffness);
        }
        (x < chain.end.x() ? low : high) = H;
    }
    return low;
}

}  // namespace

TEST_CASE("Between level ends half the weight hangs on each, and the tension is the root of one equation") {
    for (const std::size_t links : std::vector<std::size_t>{2, 3, 10, 101}) {
        const HangingChain chain = cut_into(links);
        const EndTension tension = end_tension(chain);
        const double weight = static_cast<double>(chain.masses) * chain.mass * chain.g;
        CHECK(std::abs(tension.vertical - weight / 2) < 1e-13 * weight);
        CHECK(std::abs(tension.horizontal / horizontal_by_bisection(chain) - 1) < 1e-12);
    }
}

TEST_CASE("In the exact rest shape no force remains: level and slanted, slack and taut, soft and stiff") {
    const Vector2 end =
        GENERATE(Vector2{2, 0}, Vector2{2, 1.5}, Vector2{2.5, -2}, Vector2{6, 1}, Vector2{1.6, 0});
    const double stiffness = GENERATE(10., 40., 1e4);
    for (const std::size_t links : std::vector<std::size_t>{2, 7, 40}) {
        const HangingChain chain = cut_into(links, end, stiffness);
        const std::vector<Vector2> points = rest_shape(chain);
        const EndTension tension = end_tension(chain);
        INFO(links << " links to (" << end.x() << ", " << end.y() << "), E A = " << stiffness
                   << " N, H = " << tension.horizontal);
        CHECK((points.back() - end).norm() < 1e-12);
        // A link's tension is its stiffness times a small difference of lengths: round-off of a length is the
        // floor.
        CHECK(largest_force(scene_of(chain, points)) < 1e-14 * chain.link.stiffness);
    }
}

TEST_CASE("A chain with one end free hangs straight down in its exact shape") {
    const Spring link{200, 0.1};
    SpringNet net = chain(20, 0.05, link, {0, 0, 0}, {0, -2, 0}, true);
    const auto heights = rest_heights_one_end_free(20, 0.05, link);
    for (std::size_t i = 0; i < heights.size(); ++i) net.start.position.y[i] = heights[i];
    CHECK(heights.size() == 21);
    CHECK(largest_force(net) < 1e-14 * link.stiffness * 2);
}

TEST_CASE("A cloth held along its upper edge hangs as a chain in every column") {
    SpringNet net = cloth(9, 1, 0.5, 60, Weave::structural);
    for (std::size_t c = 0; c < 9; ++c) net.held.push_back(c);
    checked(net);
    const auto heights = rest_heights_one_end_free(8, 0.5 / 81, {60, 1.0 / 8});
    for (std::size_t i = 0; i < 81; ++i) net.start.position.y[i] = heights[i / 9];
    CHECK(largest_force(net) < 1e-13);
}

TEST_CASE("A damped chain, let go, comes to its exact rest shape") {
    const HangingChain chain = cut_into(12, {2, 0.5});
    const std::vector<Vector2> rest = rest_shape(chain);
    SpringNet net = nutshell::chain(chain.masses, chain.mass, chain.link, {0, 0, 0}, {2, 0.5, 0});
    net.drag = 0.4, net.duration = 40;
    const Particles end = lab::run(net, methods::semi_implicit_euler, 20000);
    for (std::size_t i = 0; i < rest.size(); ++i)
        CHECK((end.position[i] - Vector3(rest[i].x(), rest[i].y(), 0)).norm() < 1e-12);
}

TEST_CASE(
    "With more links the chain becomes the elastic catenary at second order, and does not become the cosh") {
    for (const Vector2& end : {Vector2{2, 0}, Vector2{2, 1}}) {
        Convergence gap, gap_to_cosh;
        for (const std::size_t links : std::vector<std::size_t>{20, 40, 80, 160, 320}) {
            const HangingChain chain = cut_into(links, end);
            const Cord cord = cord_of(chain);
            Cord inextensible = cord;
            inextensible.stiffness = std::numeric_limits<double>::infinity();
            const EndTension tension = end_tension(cord), of_cosh = end_tension(inextensible);
            const auto points = rest_shape(chain);
            double largest = 0, from_cosh = 0;
            for (std::size_t i = 0; i < points.size(); ++i) {
                const double s = static_cast<double>(i) * chain.link.rest_length;
                largest = std::max(largest, (points[i] - cord_point(cord, tension, s)).norm());
                from_cosh = std::max(from_cosh, (points[i] - cord_point(inextensible, of_cosh, s)).norm());
            }
            CHECK((cord_point(cord, tension, cord.length) - end).norm() < 1e-12);
            gap.dt.push_back(1 / static_cast<double>(links)), gap.error.push_back(largest);
            gap_to_cosh.dt.push_back(1 / static_cast<double>(links)), gap_to_cosh.error.push_back(from_cosh);
        }
        CHECK_THAT(gap, HasOrder(2));
        CHECK_THAT(gap_to_cosh, HasOrder(0));
        CHECK(gap_to_cosh.error.back() > 0.05);  // metres: this cord is soft, and stretches under its weight
    }
}

TEST_CASE("The inextensible cord is the cosh") {
    const Cord cord{3, 2, std::numeric_limits<double>::infinity(), {2, 0}};
    const EndTension tension = end_tension(cord);
    const double a = tension.horizontal / cord.weight;
    CHECK(std::abs(2 * a * std::sinh(1 / a) - 3) < 1e-12);  // its length, by the formula for a cosh
    for (const double s : {0.3, 1.1, 1.5, 2.9}) {
        const Vector2 p = cord_point(cord, tension, s);
        CHECK(std::abs(p.y() - a * (std::cosh((p.x() - 1) / a) - std::cosh(1 / a))) < 1e-12);
    }
}

TEST_CASE("Chains that cannot hang are refused at the door") {
    const HangingChain good = cut_into(5);
    const auto refuses = [&](auto&& spoil) {
        HangingChain chain = good;
        spoil(chain);
        CHECK_THROWS_AS(rest_shape(chain), std::invalid_argument);
    };
    CHECK_NOTHROW(rest_shape(good));
    refuses([](HangingChain& c) { c.masses = 0; });
    refuses([](HangingChain& c) { c.mass = 0; });
    refuses([](HangingChain& c) { c.link.stiffness = 0; });
    refuses([](HangingChain& c) { c.link.rest_length = -1; });
    refuses([](HangingChain& c) { c.end.x() = 0; });
    refuses([](HangingChain& c) { c.end.y() = std::numeric_limits<double>::quiet_NaN(); });
    refuses([](HangingChain& c) { c.g = 0; });
    refuses([](HangingChain& c) { c.end = {0.01, -1}; });  // some link would have to push
    CHECK_THROWS_AS(end_tension(Cord{3, 2, 40, {-1, 0}}), std::invalid_argument);
}
