// Chapter 7 · Scenes of impacts without friction: two balls, a break of pool, Newton's cradle, a
// ball too fast to see. A scene here is where everything is just before; `after` what comes out.
#pragma once
#include <nutshell/impacts.hpp>
#include <nutshell/need.hpp>
#include <nutshell/time_of_impact.hpp>

namespace nutshell {

/// The sum of all momenta [kg m/s].
inline Vector3 total_momentum(const std::vector<Particle>& all) {
    Vector3 sum = Vector3::Zero();
    for (const Particle& body : all) sum += body.momentum;
    return sum;
}

/// The sum of all kinetic energies [J].
inline double kinetic_energy(const std::vector<Particle>& all) {
    double sum = 0;
    for (const Particle& body : all) sum += kinetic_energy(body);
    return sum;
}

// [two_balls]
/// Two smooth spheres of radius 0.5 m at the moment they touch (scene S11).
struct TwoBalls {
    std::string name;
    Particle a, b;
    double restitution = 1;

    /// 1 kg at 2 m/s meets 2 kg at -1 m/s, centre to centre.
    static TwoBalls head_on() {
        return {"head_on", {1, {-0.5, 0, 0}, {2, 0, 0}}, {2, {0.5, 0, 0}, {-2, 0, 0}}};
    }
    /// 1 kg at 2 m/s meets an equal ball at rest, `offset` [m] (below 1) beside its centre.
    static TwoBalls glancing(double offset = 0.5) {
        return {"glancing",
                {1, {-std::sqrt(1 - offset * offset), offset, 0}, {2, 0, 0}},
                {1, {0, 0, 0}, {0, 0, 0}}};
    }
    Vector3 normal() const { return (b.position - a.position).normalized(); }
    /// Closed form, another way than `collide`: in the frame of the common centre of mass the
    /// velocity along the normal turns round and shrinks by e.
    std::array<Vector3, 2> exact() const {
        const Vector3 n = normal(), centre = (a.momentum + b.momentum) / (a.mass + b.mass);
        const auto after = [&](const Particle& body) -> Vector3 {
            const Vector3 u = velocity(body) - centre;
            return centre + u - (1 + restitution) * n * n.dot(u);
        };
        return {after(a), after(b)};
    }
};
// [/two_balls]

// [balls]
/// Smooth balls of one radius that fly straight between impacts.
struct Balls {
    double radius = 0.5;  // [m]
    double restitution = 1;
    std::vector<Particle> all = {};
};

/// Moves the balls on by `duration` [s], from impact to impact: of all pairs, the one that meets
/// first. Pairs that touch take part when they close in. Cost: pairs times impacts.
/// @return the number of impacts    @throws std::runtime_error after a million
inline long fly_by_events(Balls& balls, double duration) {
    auto& all = balls.all;
    long impacts = 0;
    for (double left = duration;;) {
        double next = left;
        Touch pair{};
        for (std::size_t a = 0; a < all.size(); ++a)
            for (std::size_t b = a + 1; b < all.size(); ++b)
                if (const auto t =
                        time_of_impact(all[b].position - all[a].position,
                                       velocity(all[b]) - velocity(all[a]), 2 * balls.radius);
                    t && *t < next)
                    next = *t, pair = {a, b, {}};
        for (Particle& body : all) drift(body, next);
        left -= next;
        if (pair.a == pair.b) return impacts;
        const Vector3 n = (all[pair.b].position - all[pair.a].position).normalized();
        collide(all[pair.a], all[pair.b], n, balls.restitution);
        if (++impacts > 1'000'000) throw std::runtime_error("fly_by_events: impacts without end");
    }
}
// [/balls]

// [cradle]
/// Newton's cradle: five balls of 1 kg and radius 0.5 m in a row, the first comes in at 1 m/s
/// (scene S12). exact: the last leaves alone at 1 m/s.
struct Cradle {
    std::string name = "cradle";
    std::size_t balls = 5;
    double restitution = 1;

    std::vector<Particle> start() const {
        std::vector<Particle> all(balls);
        for (std::size_t i = 0; i < balls; ++i)
            all[i].position.x() = static_cast<double>(i);  // they touch
        all.front().momentum = {1, 0, 0};
        return all;
    }
    /// The same row with gaps [m], to fly from impact to impact: the exact end is the same.
    Balls with_gaps(double gap = 0.02) const {
        Balls row{0.5, restitution, start()};
        for (std::size_t i = 0; i < balls; ++i) row.all[i].position.x() *= 2 * row.radius + gap;
        return row;
    }
    std::vector<Touch> touches() const {
        std::vector<Touch> list;
        for (std::size_t i = 0; i + 1 < balls; ++i) list.push_back({i, i + 1, {1, 0, 0}});
        return list;
    }
};
// [/cradle]

// [pool_break]
/// The break of pool: fifteen balls (diameter 57.15 mm, 0.17 kg) in a triangle, `gap` [m] between
/// neighbours, and the cue ball at `speed` [m/s] towards the tip, `aside` [m] off its line.
inline Balls pool_break(double speed = 8, double gap = 1e-5, double aside = 0.005) {
    Balls balls{0.028575, 0.95, {}};
    const double step = 2 * balls.radius + gap, row = step * std::sqrt(3.0) / 2;
    balls.all.push_back({0.17, {-0.3, 0, aside}, {0.17 * speed, 0, 0}});
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j <= i; ++j)
            balls.all.push_back({0.17, {i * row, 0, (j - i / 2.0) * step}, {0, 0, 0}});
    return balls;
}
// [/pool_break]

// [too_fast]
/// A ball too fast to see: a point at `speed` [m/s] through a slab of `thickness` [m], looked at
/// every dt [s]. The part of all starts from which no look falls into the slab: 1 - h/(v dt), not
/// below 0. Eq. (7.c). @throws std::invalid_argument if a number is not greater than zero
inline double miss_probability(double thickness, double speed, double dt) {
    require_positive(thickness, "miss_probability: the thickness [m]");
    require_positive(speed, "miss_probability: the speed [m/s]");
    require_positive(dt, "miss_probability: dt [s]");
    return std::max(0.0, 1 - thickness / (speed * dt));
}

/// Whether a point that starts `before` [m] in front of the slab is seen inside it.
inline bool seen_inside(double before, double thickness, double speed, double dt) {
    const double look = std::ceil(before / (speed * dt)) * speed * dt;  // the first not before it
    return look <= before + thickness;
}

/// The swept test: whether the way from the last look before the slab to the next meets its
/// front. It always does.
inline bool swept_inside(double before, double speed, double dt) {
    const double looks = std::floor(before / (speed * dt));
    const Vector3 last_before{looks * speed * dt, 0, 0}, velocity{speed, 0, 0};
    const Plane front{{-1, 0, 0}, -before};
    const auto t = time_of_impact(Sphere{0}, last_before, velocity, Vector3::Zero(), front);
    return t && *t <= dt * (1 + 1e-12);
}
// [/too_fast]

}  // namespace nutshell
