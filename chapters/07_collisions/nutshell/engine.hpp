// Chapter 7 · The engine: kick, collide, drift, for any number of bodies that touch.
#pragma once
#include <nutshell/contact_memory.hpp>
#include <nutshell/contacts.hpp>
#include <nutshell/grid.hpp>
#include <nutshell/sleep.hpp>

namespace nutshell {

// [world]
/// Bodies in a room. A value: copy it, and there are two.
struct World {
    std::vector<Body> bodies = {};
    std::vector<Shape> shapes = {};  ///< one for each body
    std::vector<Plane> walls = {};
    Body earth = immovable_body();          ///< what the walls belong to; it takes their impulses
    Vector3 gravity{0, -earth_gravity, 0};  ///< [m/s^2]
    Surface surface{0, 0.5};                ///< of everything

    void add(const Body& body, const Shape& shape) {
        bodies.push_back(body), shapes.push_back(shape);
    }
};
// [/world]

// [switches]
/// What the engine does; each idea is a switch.
struct Switches {
    int sub_steps = 4;        ///< of one step
    int passes = 1;           ///< round all contacts, in each sub-step
    int relaxing = 1;         ///< passes after the drift, which take out the speed of pushing out
    int bouncing = 4;         ///< at least so many of them where something bounces
    int cold = 20;            ///< passes in a step that remembers less than half of its contacts
    bool warm_start = true;   ///< begin with the impulses of the last sub-step
    bool grid = true;         ///< look for contacts next door only; off: every pair
    bool sleep = false;       ///< what lies still for a while is left alone until it is touched
    bool manifold = true;     ///< several contacts of two bodies; off: the deepest only
    bool soft = true;         ///< what overlaps is pushed out; off: it only stops closing in
    double stiffness = 0.22;  ///< frequency of the soft contacts times the sub-step
    double damping = 10;      ///< their damping ratio
    double near = 0.05;       ///< contacts are kept from this gap on, times the smallest reach
    SleepRule rule = {};
    bool pyramid = false;  ///< friction bounded along two axes apart: wrong, see `in_pyramid`
};
// [/switches]

// [engine]
/// What is kept from step to step: the contacts with their impulses, who sleeps, and room. One
/// per run. Restitution acts in the relaxing passes.
class Engine {
  public:
    explicit Engine(const Switches& switches = {}) : on(switches) {}
    Switches on;  ///< may be changed between steps

    // [step]
    /// One step of dt [s]. Contacts are found once in it; in every sub-step if a box is so fast
    /// that the face it will hit cannot be told that early.
    [[gnu::flatten]] void step(World& world, double dt) {
        const double h = dt / on.sub_steps, g = world.gravity.norm();
        const bool hasty = boxes_are_hasty(world, dt);
        find_contacts_of(world, hasty ? h : dt);
        if (on.sleep && sleep_.wake(world.bodies, reach_, on.rule))
            find_contacts_of(world, hasty ? h : dt);
        const bool cold = on.warm_start && 2 * remembered_ < contacts_.size();
        const int passes = cold ? std::max(on.cold, on.passes) : on.passes;
        const bool bounces = world.surface.restitution > 0 && on.relaxing > 0;
        const int relaxing = bounces ? std::max(on.relaxing, on.bouncing) : on.relaxing;

        Press push{h, world.surface.friction, 0, 0};
        if (on.soft) push.soft = softness(on.stiffness / h, on.damping, h);
        Press relax{h, world.surface.friction, world.surface.restitution, 2 * g * h};
        push.pyramid = relax.pyramid = on.pyramid;

        for (int k = 0; k < on.sub_steps; ++k) {
            if (hasty && k > 0) find_contacts_of(world, h);
            for (std::size_t i = 0; i < world.bodies.size(); ++i)
                if (moves(world, i)) kick(world.bodies[i], weight(world.bodies[i], world), h);
            start_contacts(world);
            for (int pass = 0; pass < passes; ++pass) press_all(world, push, false);
            drift_all(world, h);
            for (int pass = 0; pass < relaxing; ++pass) press_all(world, relax, pass == 0);
            if (relaxing == 0) follow_all(world);
        }
        if (on.sleep) sleep_.end_step(world.bodies, reach_, on.rule, dt);
    }
    // [/step]
    bool asleep(std::size_t body) const { return on.sleep && sleep_.asleep(body); }
    /// The contacts of the last step.
    const std::vector<PressedContact>& contacts() const { return contacts_; }

  private:
    std::vector<PressedContact> contacts_;
    std::vector<Contact> found_;
    std::vector<Mobility> mobility_;            // of each body, after the earth's
    std::vector<Vector3> places_, velocities_;  // the velocities after this step's fall
    std::vector<double> reach_, speed_;
    std::size_t remembered_ = 0;  // contacts of this step that the last one had
    ContactMemory memory_;
    Sleep sleep_;
    Grid grid_;

    bool moves(const World& world, std::size_t i) const {
        return world.bodies[i].mass < immovable && !asleep(i);
    }
    /// Whether a box or hull flies half of its reach in a step.
    static bool boxes_are_hasty(const World& world, double dt) {
        for (std::size_t i = 0; i < world.bodies.size(); ++i)
            if ((std::holds_alternative<Box>(world.shapes[i]) ||
                 std::holds_alternative<Hull>(world.shapes[i])) &&
                dt * velocity(world.bodies[i]).norm() > reach(world.shapes[i]) / 2)
                return true;
        return false;
    }
    static Wrench weight(const Body& body, const World& world) {
        Wrench push;
        push.force = body.mass * world.gravity;
        return push;
    }
    static Body& body_of(World& world, int i) {
        return i < 0 ? world.earth : world.bodies[static_cast<std::size_t>(i)];
    }
    Mobility& mobility_at(int i) { return mobility_[static_cast<std::size_t>(i + 1)]; }

    /// One pass: every contact's turn, from the top of the room down to the floor, so that each
    /// layer knows what it carries when its turn comes. (The walls' contacts were found first,
    /// and the grid counts its layers from below.)
    void press_all(World& world, const Press& want, bool moved) {
        for (std::size_t i = contacts_.size(); i-- > 0;) {
            PressedContact& c = contacts_[i];
            Body &a = body_of(world, c.a), &b = body_of(world, c.b);
            if (moved) follow(c, a, b);
            press(c, a, b, mobility_at(c.a), mobility_at(c.b), want);
        }
    }
    /// Every contact begins a sub-step with the impulse of the last one, or without.
    void start_contacts(World& world) {
        if (world.surface.restitution > 0)
            for (PressedContact& c : contacts_)
                c.closing =
                    c.normal.dot(contact_velocity(c, body_of(world, c.a), body_of(world, c.b),
                                                  mobility_at(c.a), mobility_at(c.b)));
        for (PressedContact& c : contacts_) {
            if (!on.warm_start) c.normal_impulse = 0, c.friction.setZero();
            if (c.normal_impulse == 0) continue;
            apply_impulse(c, body_of(world, c.a), body_of(world, c.b),
                          c.normal_impulse * c.normal + c.friction);
        }
    }
    void follow_all(World& world) {
        for (PressedContact& c : contacts_) follow(c, body_of(world, c.a), body_of(world, c.b));
    }
    void drift_all(World& world, double h) {
        for (std::size_t i = 0; i < world.bodies.size(); ++i) {
            if (!moves(world, i)) continue;
            Body& body = world.bodies[i];
            drift(body, h);
            mobility_[i + 1] = mobility_of(body);
        }
    }

    void find_contacts_of(World& world, double dt) {
        const std::size_t n = world.bodies.size();
        if (on.warm_start) memory_.remember(contacts_);
        contacts_.clear(), remembered_ = 0;
        if (on.sleep) sleep_.start_step(n);
        mobility_.resize(n + 1), places_.resize(n), velocities_.resize(n);
        reach_.resize(n), speed_.resize(n);
        mobility_[0] = mobility_of(world.earth);
        Vector3 sum = Vector3::Zero();
        for (std::size_t i = 0; i < n; ++i) {
            const Body& body = world.bodies[i];
            mobility_[i + 1] = asleep(i) ? Mobility{} : mobility_of(body);
            places_[i] = body.position, reach_[i] = reach(world.shapes[i]);
            velocities_[i] = mobility_[i + 1].inverse_mass * body.momentum + dt * world.gravity;
            speed_[i] = velocities_[i].norm(), sum += velocities_[i];
        }
        const Vector3 mean = sum / std::max(1.0, static_cast<double>(n));
        double largest = 0, smallest = immovable, fastest = 0;
        for (std::size_t i = 0; i < n; ++i) {
            largest = std::max(largest, reach_[i]), smallest = std::min(smallest, reach_[i]);
            fastest = std::max({fastest, speed_[i], 2 * (velocities_[i] - mean).norm()});
        }
        const double slack = on.near * smallest, farthest = 2 * largest;
        // Two bodies may close in with the speeds of both; if one is stopped by a third, with one's.
        const auto look = [&](int first, int second) {
            const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
            const double touch = reach_[i] + reach_[j] + slack;
            const double square = (places_[j] - places_[i]).squaredNorm();
            const auto too_far = [&](double way) {
                return square >= (touch + way) * (touch + way);
            };
            if (too_far((speed_[i] + speed_[j]) * dt)) return;
            const double closing = (velocities_[j] - velocities_[i]).norm(),
                         fast = std::max({speed_[i], speed_[j], closing});
            const double way = std::min(farthest, fast * dt), margin = slack + way;
            if (too_far(way)) return;
            found_.clear();
            find_contacts(world.shapes[i], world.bodies[i], world.shapes[j], world.bodies[j],
                          margin, found_);
            keep(world, first, second);
        };
        for (std::size_t i = 0; i < n; ++i)
            for (const Plane& wall : world.walls) {
                const double margin = slack + speed_[i] * dt;
                if (distance_to(wall, places_[i]) >= reach_[i] + margin) continue;
                found_.clear();
                find_contacts(wall, world.shapes[i], world.bodies[i], margin, found_);
                keep(world, -1, static_cast<int>(i));
            }
        if (on.grid) {
            grid_.sort(places_, 2 * largest + slack + std::min(farthest, fastest * dt));
            visit_pairs(grid_, look);
        } else {
            for (int i = 0; i < static_cast<int>(n); ++i)
                for (int j = i + 1; j < static_cast<int>(n); ++j) look(i, j);
        }
    }

    static double skin(const Shape& shape) {
        if (const Sphere* sphere = std::get_if<Sphere>(&shape)) return sphere->radius;
        if (const Capsule* rod = std::get_if<Capsule>(&shape)) return rod->radius;
        return 0;
    }
    void keep(World& world, int a, int b) {
        const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
        const bool both =
            a >= 0 && world.bodies[i].mass < immovable && world.bodies[j].mass < immovable;
        if (on.sleep && both && !found_.empty()) sleep_.join(i, j);
        if (!moves(world, j) && (a < 0 || !moves(world, i))) return;  // neither can answer
        if (!on.manifold && found_.size() > 1) {
            const auto less = [](const Contact& c, const Contact& d) {
                return c.separation < d.separation;
            };
            found_ = {*std::min_element(found_.begin(), found_.end(), less)};
        }
        for (const Contact& found : found_) {
            PressedContact& c = contacts_.emplace_back();
            c.a = a, c.b = b;
            const Shape& shape_b = world.shapes[static_cast<std::size_t>(b)];
            c.radius_b = skin(shape_b);
            if (a >= 0) {
                const Shape& shape_a = world.shapes[static_cast<std::size_t>(a)];
                c.radius_a = skin(shape_a);
                c.balls = std::holds_alternative<Sphere>(shape_a) &&
                          std::holds_alternative<Sphere>(shape_b);
            }
            prepare(c, found, body_of(world, a), body_of(world, b), mobility_at(a),
                    mobility_at(b));
            if (on.warm_start && memory_.recall(c)) ++remembered_;
        }
    }
};
// [/engine]

}  // namespace nutshell
