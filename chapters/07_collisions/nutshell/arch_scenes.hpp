// Chapter 7 · An arch: stones without mortar that hold each other up, and the forces between them.
#pragma once
#include <nutshell/hull_shapes.hpp>
#include <nutshell/rest_scenes.hpp>

namespace nutshell {

// [arch]
/// Equal wedges in a half circle in the x-y plane, its centre in the origin, its feet on the floor.
struct Arch {
    std::string name = "arch";
    int stones = 11;
    double radius = 2;       // of the middle of the ring [m]
    double thickness = 0.4;  // [m]
    double depth = 0.5;      // along z [m]
    double density = 2400;   // [kg/m^3]
    double friction = 0.7;   // stone on stone
    double duration = 10;    // [s]
    Switches switches = {4};
    Need need{0.1, "", "least thickness to 10 %: a builder takes twice as much"};

    double wedge() const { return pi / stones; }  // the angle of a stone [rad]
    double inside() const { return radius - thickness / 2; }
    double outside() const { return radius + thickness / 2; }

    /// @throws std::invalid_argument if there are fewer than three stones, the ring is thicker than
    /// a disc, or a number is not positive (friction: negative)
    World start() const {
        require(stones >= 3, "an arch has three stones at least");
        require_positive(thickness, "the thickness of an arch [m]");
        require_positive(inside(), "the inner radius of an arch [m]");
        const double x = std::sin(wedge() / 2), y = std::cos(wedge() / 2);
        const double r = inside(), R = outside();
        const Piece keystone = piece_of(
            prism_mesh({{-r * x, r * y}, {r * x, r * y}, {R * x, R * y}, {-R * x, R * y}}, depth),
            density);
        World world;
        world.walls = {Plane{}};
        world.surface = checked(Surface{0, friction});
        for (int i = 0; i < stones; ++i) {  // from the left foot to the right one
            const Quaternion turn =
                quaternion_about(Vector3::UnitZ(), pi / 2 - (i + 0.5) * wedge());
            Body stone = keystone.body;
            stone.position = rotate(turn, stone.position);
            stone.orientation = turn * stone.orientation;
            world.add(stone, keystone.hull);
        }
        return world;
    }
    /// How far the crown has come down since the start [m].
    double sunk(const World& world) const {
        const auto middle = static_cast<std::size_t>(stones / 2);
        return start().bodies[middle].position.y() - world.bodies[middle].position.y();
    }
};
// [/arch]

// [passed]
/// What a joint passes on.
struct Passed {
    Vector3 force = Vector3::Zero();  ///< on the stone to its right [N], world axes
    Vector3 at = Vector3::Zero();  ///< where it acts [m]: the contacts, weighed by their forces
};

/// Of all joints of an arch, from the left foot to the right one, what the contacts of an engine's
/// last sub-step of h [s] have passed on.
inline std::vector<Passed> passed_on(const Arch& arch, const World& world, const Engine& engine,
                                     double h) {
    std::vector<Passed> joints(static_cast<std::size_t>(arch.stones) + 1);
    std::vector<double> pressed(joints.size(), 0);
    for (const PressedContact& c : engine.contacts()) {
        const int left = std::min(c.a, c.b), right = std::max(c.a, c.b);
        const bool right_foot = left < 0 && right == arch.stones - 1;
        if (right_foot ? false : right != left + 1 || right >= arch.stones) continue;
        const auto joint = static_cast<std::size_t>(right_foot ? arch.stones : right);
        const double sign = right_foot || c.b < c.a ? -1 : 1;
        const Vector3 point = world.bodies[static_cast<std::size_t>(c.b)].position + c.lever_b;
        joints[joint].force += sign / h * (c.normal_impulse * c.normal + c.friction);
        joints[joint].at += c.normal_impulse * point, pressed[joint] += c.normal_impulse;
    }
    for (std::size_t k = 0; k < joints.size(); ++k)
        if (pressed[k] > 0) joints[k].at /= pressed[k];
    return joints;
}
// [/passed]

}  // namespace nutshell
