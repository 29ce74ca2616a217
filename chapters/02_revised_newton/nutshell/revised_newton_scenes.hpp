// The scenes of chapter 2. What a scene is made of: see chapter 1's newton_scenes.hpp.
#pragma once
#include <array>
#include <nutshell/exhaust.hpp>
#include <nutshell/newton_scenes.hpp>

namespace nutshell {

/// Distance [m] between the positions of two particles.
inline double distance(const Particle& a, const Particle& b) {
    return (a.position - b.position).norm();
}

/// Chapter 1's thrown ball, its state in momentum.
/// exact: the parabola; accurate to round-off.
struct MomentumThrow {
    std::string name = "momentum_throw";
    ThrownBall ball;
    Particle start = in_momentum(ball.start);
    double duration = ball.duration;
    Need need = ball.need;

    static MomentumThrow of_mass(double mass) {
        MomentumThrow scene;
        scene.ball.start.mass = mass;
        scene.start = in_momentum(scene.ball.start);
        return scene;
    }
    Vector3 operator()(const Particle& body, double) const { return body.mass * gravity; }
    Particle exact(double t) const { return in_momentum(ball.exact(t)); }
    double error(const Particle& state, double t) const { return distance(state, exact(t)); }
};

// [cart]
/// A cart rolls over a frozen lake, without friction, and loses sand through a hole in its
/// floor. The sand has the cart's own velocity when it leaves; no force acts along the way.
/// exact: it rolls on as before; accurate to round-off.
struct LeakyCart {
    std::string name = "leaky_cart";
    VariableMass start{{2, {0, 0, 0}, {20, 0, 0}},
                       MassFlow{-0.1, Vector3::Zero(), RelativeTo::body}};
    double duration = 10;  // [s]: half the mass has left
    Need need{150.0 / 960, "m", "one pixel of its picture, 150 m across 960 pixels"};

    /// The same cart as eqs. (11)-(15) with K = m v describe it: the mass changes, the momentum
    /// does not. That is the claim that what leaves stays behind at rest in the world, whatever
    /// the cart does. Erratum E05.
    static LeakyCart as_printed() {
        LeakyCart cart;
        cart.start.flow.relative_to = RelativeTo::world;
        return cart;
    }
    /// The same process described by somebody who moves along at `frame` m/s.
    LeakyCart seen_from(const Vector3& frame) const {
        LeakyCart cart = *this;
        cart.start.momentum -= cart.start.mass * frame;
        return cart;
    }
    double mass(double t) const { return start.mass + start.flow.rate * t; }
    Vector3 operator()(const Particle&, double) const { return Vector3::Zero(); }
    Particle exact(double t) const {
        const Vector3 v = velocity(start);
        return {mass(t), start.position + v * t, mass(t) * v};
    }
    double error(const Particle& state, double t) const { return distance(state, exact(t)); }
};
// [/cart]

/// A drop falls through a cloud and picks up droplets that hang at rest. It enters with a
/// sideways speed of 3 m/s. exact: K = K0 + g (m0 t + beta t^2/2), position by one logarithm;
/// accurate to 1e-14 of the path.
struct Raindrop {
    std::string name = "raindrop";
    double m0 = 1e-5;    // [kg], 10 mg
    double beta = 1e-5;  // [kg/s]
    VariableMass start{{m0, {0, 53, 0}, {3 * m0, 0, 0}},
                       MassFlow{beta, Vector3::Zero(), RelativeTo::world}};
    double duration = 4;  // [s]
    Need need{55.0 / 800, "m", "one pixel of its picture, 55 m over 800 pixels"};

    Vector3 operator()(const Particle& drop, double) const { return drop.mass * gravity; }
    Particle exact(double t) const {
        const double m = m0 + beta * t, log = std::log1p(beta * t / m0);
        const double fall =
            (beta * t * (m + m0) / 2 - m0 * m0 * log) / (2 * beta * beta);  // [s^2]
        return {m, start.position + start.momentum * (log / beta) + gravity * fall,
                start.momentum + gravity * (m0 * t + beta * t * t / 2)};
    }
    double error(const Particle& state, double t) const { return distance(state, exact(t)); }
};

/// A rocket in empty space (scene S4 of the comparison with other engines): m = 10 - 0.5 t,
/// exhaust 100 m/s along -x. exact: Tsiolkovsky's formula and its integral, with a constant field
/// added; accurate to 1e-15 of exhaust speed x time.
struct Rocket {
    std::string name = "rocket";
    VariableMass start{{10, {0, 0, 0}, {0, 0, 0}},
                       MassFlow{-0.5, {-100, 0, 0}, RelativeTo::body}};
    Vector3 field = Vector3::Zero();  // [m/s^2]
    double duration = 15;             // [s]
    Need need{1.0 / 960, "of the gain", "one pixel of a chart 960 pixels high"};
    bool judged_by_place = false;  // error: a distance [m]; else the speed's, over the whole gain

    /// The same with its exhaust measured against the mean of the rocket's velocities before and
    /// after each parcel.
    static Rocket with_midway(Rocket scene) {
        scene.start.flow.relative_to = RelativeTo::midway;
        return scene;
    }
    double mass(double t) const { return start.mass + start.flow.rate * t; }
    Vector3 operator()(const Particle& rocket, double) const { return rocket.mass * field; }
    Particle exact(double t) const {
        const double loss = -start.flow.rate, m = mass(t);
        const double log = -std::log1p(-loss * t / start.mass);  // ln(m0/m)
        const Vector3 w = start.flow.velocity, v0 = nutshell::velocity(start);
        const Vector3 v = v0 - w * log + field * t;
        const Vector3 path = v0 * t - w * (t - m / loss * log) + field * t * t / 2;
        return {m, start.position + path, m * v};
    }
    double error(const Particle& state, double t) const {
        if (judged_by_place) return distance(state, exact(t));
        const Vector3 gain = nutshell::velocity(exact(duration)) - nutshell::velocity(start);
        return (nutshell::velocity(state) - nutshell::velocity(exact(t))).norm() / gain.norm();
    }
};

/// A water rocket takes off, a little tilted: 10 kg, 5 kg/s of water at 40 m/s for 1.5 s, under
/// gravity.
inline Rocket water_rocket() {
    Rocket scene;
    scene.name = "launch";
    scene.start.flow = MassFlow{-5, Vector3{-0.2, -1, 0}.normalized() * 40, RelativeTo::body};
    scene.field = gravity;
    scene.duration = 1.5;
    scene.need = Need{25.0 / 760, "m", "one pixel of its picture, 25 m over 760 pixels"};
    scene.judged_by_place = true;
    return scene;
}

/// A rocket scene with its exhaust: the whole system, for the books of momentum.
struct RocketBooks {
    Rocket flight;
    std::string name = flight.name + "_and_exhaust";
    RocketAndExhaust start{flight.start, {}};
    double duration = flight.duration;

    Weights operator()(const RocketAndExhaust& all, double t) const {
        return {flight(all.rocket, t), flight.field, all.exhaust.size()};
    }
    /// What the books must say at time t [kg m/s]: P0 + m0 g t.
    Vector3 exact_momentum(double t) const {
        return start.rocket.momentum + start.rocket.mass * t * flight.field;
    }
};

/// A ring on level ice, pulled by four ropes and pushed by a machine that shakes it. The forces
/// depend on time only, so not only they add: the motions they would cause one by one add too.
/// exact: the sum of those motions; accurate to round-off.
struct ManyForces {
    std::string name = "many_forces";
    std::array<Vector3, 4> ropes{Vector3{300, 0, 40}, Vector3{-120, 0, 250},
                                 Vector3{-210, 0, -160}, Vector3{31, 0, -131}};  // [N]
    Vector3 shake{0, 0, 30};                                                     // [N]
    double shake_rate = 2 * pi;                                                  // [rad/s]
    Particle start{4, {0, 0, 0}, {0, 0, 0}};
    double duration = 6;  // [s]
    Need need{8.0 / 960, "m", "one pixel of a picture 8 m across 960 pixels"};
    std::array<std::size_t, 5> order{0, 1, 2, 3, 4};  // in which the five are added

    Vector3 force(std::size_t i, double t) const {
        return i < 4 ? ropes[i] : Vector3(shake * std::cos(shake_rate * t));
    }
    Vector3 operator()(const Particle&, double t) const {
        std::array<Vector3, 5> forces;
        for (std::size_t i = 0; i < 5; ++i) forces[i] = force(order[i], t);
        return total_force(forces);
    }
    /// The motion that force number i alone would cause.
    Particle exact_alone(std::size_t i, double t) const {
        const double m = start.mass, w = shake_rate;
        if (i < 4) return {m, ropes[i] * t * t / (2 * m), ropes[i] * t};
        const double half = std::sin(w * t / 2);
        return {m, shake * (2 * half * half / (m * w * w)), shake * (std::sin(w * t) / w)};
    }
    Particle exact(double t) const {
        Particle sum{start.mass, start.position + velocity(start) * t, start.momentum};
        for (std::size_t i = 0; i < 5; ++i) {
            const Particle alone = exact_alone(i, t);
            sum.position += alone.position;
            sum.momentum += alone.momentum;
        }
        return sum;
    }
    double error(const Particle& state, double t) const { return distance(state, exact(t)); }
};

}  // namespace nutshell
