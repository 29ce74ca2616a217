// Chapter 7 · Scenes of rest: a stack, a pile, rooms of chance. Each gives the world it starts
// from; what may go wrong is measured on a world.
#pragma once
#include <cstdint>
#include <nutshell/engine.hpp>
#include <nutshell/forces.hpp>
#include <nutshell/need.hpp>

namespace nutshell {

// [solids]
/// A solid ball [kg, m] with its centre at `place`, at rest.
inline Body solid_ball(double mass, double radius, const Vector3& place) {
    Body body;
    body.mass = mass, body.inertia = ball_inertia(mass, radius), body.position = place;
    return body;
}

/// A solid box, its shape's half edges in m.
inline Body solid_box(double mass, const Box& box, const Vector3& place) {
    Body body;
    body.mass = mass, body.inertia = box_inertia(mass, 2 * box.half), body.position = place;
    return body;
}
// [/solids]

// [measures]
/// Kinetic energy and that of height, of all bodies [J].
inline double energy(const World& world) {
    double sum = 0;
    for (const Body& body : world.bodies)
        if (body.mass < immovable)
            sum += kinetic_energy(body) - body.mass * world.gravity.dot(body.position);
    return sum;
}

/// The fastest point of any body [m/s], at most: its centre's speed and its turning at its reach.
inline double top_speed(const World& world) {
    double fastest = 0;
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
        fastest = std::max(fastest,
                           velocity(world.bodies[i]).norm() +
                               angular_velocity(world.bodies[i]).norm() * reach(world.shapes[i]));
    return fastest;
}

/// How deep any two bodies, or a body and a wall, overlap [m]: every pair is looked at.
inline double deepest_overlap(const World& world) {
    double deepest = 0;
    std::vector<Contact> found;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        for (const Plane& wall : world.walls)
            find_contacts(wall, world.shapes[i], world.bodies[i], 0, found);
        for (std::size_t j = i + 1; j < world.bodies.size(); ++j) {
            const double near = reach(world.shapes[i]) + reach(world.shapes[j]);
            const Vector3 between = world.bodies[j].position - world.bodies[i].position;
            if (between.squaredNorm() < near * near)
                find_contacts(world.shapes[i], world.bodies[i], world.shapes[j], world.bodies[j],
                              0, found);
        }
    }
    for (const Contact& contact : found) deepest = std::max(deepest, -contact.separation);
    return deepest;
}

/// How many bodies have their centre outside a wall.
inline int escaped(const World& world) {
    int count = 0;
    for (const Body& body : world.bodies)
        for (const Plane& wall : world.walls)
            if (!(distance_to(wall, body.position) >= 0)) {
                ++count;
                break;
            }
    return count;
}
// [/measures]

/// Numbers by chance that are the same from every compiler. Source: splitmix64, S. Vigna.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}
    double operator()(double from, double to) {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return from + (to - from) * static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }

  private:
    std::uint64_t state_;
};

/// An orientation by chance.
inline Quaternion any_orientation(Dice& dice) {
    const double x = dice(-1, 1), y = dice(-1, 1), z = dice(-1, 1), w = dice(-1, 1);
    return four_vector({x, y, z}, w).normalized();
}

/// A floor and four walls, each `half_width` [m] from the y axis.
inline std::vector<Plane> box_room(double half_width) {
    return {{{0, 1, 0}, 0},
            {{1, 0, 0}, -half_width},
            {{-1, 0, 0}, -half_width},
            {{0, 0, 1}, -half_width},
            {{0, 0, -1}, -half_width}};
}

// [stack]
/// Ten unit boxes of 1 kg on each other, touching (scene S14). None may move.
struct Stack {
    std::string name = "stack";
    int boxes = 10;
    double duration = 10;  // [s]
    Switches switches = {4};
    Need need{0.003, "m", "drift of any box: one pixel of a picture 3 m across"};

    World start() const {
        World world;
        world.walls = {Plane{}};
        const Box cube{{0.5, 0.5, 0.5}};
        for (int i = 0; i < boxes; ++i) world.add(solid_box(1, cube, {0, 0.5 + i, 0}), cube);
        return world;
    }
    /// The farthest any box has come from the axis [m].
    double drift(const World& world) const {
        double farthest = 0;
        for (const Body& box : world.bodies)
            farthest = std::max(farthest, std::hypot(box.position.x(), box.position.z()));
        return farthest;
    }
};
// [/stack]

// [pile]
/// Spheres of radius 0.1 m and 1 kg fall into a box (scene S15): ten layers of wide x wide, 0.215
/// m apart, the lowest 0.5 m up, each shifted by chance by up to 5 mm in x and z. Or cubes with
/// edges of 11.6 cm in their places, each turned by chance.
struct Pile {
    std::string name = "pile";
    int wide = 10;        // bodies along a side of a layer; the box grows with them
    double duration = 5;  // [s]
    Switches switches = {4};
    std::uint64_t seed = 1;
    bool cubes = false;
    Need need{0.01, "m", "overlap: a tenth of the radius cannot be seen"};

    double half_width() const { return 0.12 * wide; }
    World start() const {
        World world;
        world.walls = box_room(half_width());
        Dice dice(seed);
        const Sphere ball{0.1};
        const Box cube{{0.058, 0.058, 0.058}};  // its corners reach just as far
        for (int y = 0; y < 10; ++y)
            for (int z = 0; z < wide; ++z)
                for (int x = 0; x < wide; ++x) {
                    const double middle = (wide - 1) / 2.0, shift_x = dice(-0.005, 0.005),
                                 shift_z = dice(-0.005, 0.005);
                    const Vector3 place((x - middle) * 0.215 + shift_x, 0.5 + y * 0.215,
                                        (z - middle) * 0.215 + shift_z);
                    if (cubes)
                        world.add(solid_box(1, cube, place), cube),
                            world.bodies.back().orientation = any_orientation(dice);
                    else
                        world.add(solid_ball(1, ball.radius, place), ball);
                }
        return world;
    }
};
// [/pile]

// [random_room]
/// Boxes and spheres of chance in a room, none overlapping, all flying and turning by chance.
struct RandomRoom {
    std::string name = "random_room";
    std::uint64_t seed = 1;
    int bodies = 12;
    double duration = 2;  // [s]

    World start() const {
        Dice dice(seed);
        World world;
        world.walls = box_room(1.5);
        world.surface.friction = dice(0, 1);
        for (int tries = 0; static_cast<int>(world.bodies.size()) < bodies && tries < 1000;
             ++tries) {
            const bool round = dice(0, 1) < 0.5;
            const Sphere ball{dice(0.1, 0.4)};
            const double hx = dice(0.1, 0.4), hy = dice(0.1, 0.4), hz = dice(0.1, 0.4);
            const Box box{{hx, hy, hz}};
            const double mass = dice(0.5, 2), px = dice(-1.2, 1.2), py = dice(0.3, 4),
                         pz = dice(-1.2, 1.2);
            Body body = round ? solid_ball(mass, ball.radius, {px, py, pz})
                              : solid_box(mass, box, {px, py, pz});
            body.orientation = any_orientation(dice);
            const double vx = dice(-3, 3), vy = dice(-3, 3), vz = dice(-3, 3);
            body.momentum = mass * Vector3(vx, vy, vz);
            const double wx = dice(-5, 5), wy = dice(-5, 5), wz = dice(-5, 5);
            body = spinning(body, {wx, wy, wz});
            World with = world;
            with.add(body, round ? Shape{ball} : Shape{box});
            if (deepest_overlap(with) == 0 && escaped(with) == 0) world = with;
        }
        return world;
    }
};
// [/random_room]

/// Gives the world back if it can be simulated. @throws std::invalid_argument if a body, a shape,
/// a wall or the surface cannot be, there is not one shape for each body, or a rod is not alone
inline World checked(World world) {
    require(world.bodies.size() == world.shapes.size(),
            "a world needs one shape for each body, but has " +
                std::to_string(world.shapes.size()) + " for " +
                std::to_string(world.bodies.size()));
    for (const Body& body : world.bodies)
        if (body.mass < immovable) checked(body);
    for (const Shape& shape : world.shapes) {
        checked(shape);
        require(!std::holds_alternative<Capsule>(shape) || world.bodies.size() == 1,
                "rods (capsules) touch planes only: a rod must be alone in its world");
    }
    for (const Plane& wall : world.walls) checked(wall);
    checked(world.surface);
    require_finite(world.gravity, "the gravity of a world [m/s^2]");
    return world;
}

}  // namespace nutshell
