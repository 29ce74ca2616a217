// Chapter 6 · Scenes that turn in three dimensions: free bodies, and tops under their weight.
#pragma once
#include <nutshell/free_top.hpp>
#include <nutshell/heavy_top.hpp>
#include <nutshell/need.hpp>
#include <nutshell/newton_scenes.hpp>

namespace nutshell {

// [free_body]
/// A body that nothing pushes or twists. Its centre stays where it is, so a Pinned is all the
/// state it needs. exact: FreeTop.
struct FreeBody {
    std::string name;
    Pinned start;
    double duration;  ///< [s]
    Need need;
    FreeTop solution;

    /// @param inertia  principal moments [kg m^2]    @param omega  at the start [rad/s], body
    /// axes
    FreeBody(std::string called, const Vector3& inertia, const Vector3& omega, double seconds,
             Need what)
        : name(std::move(called)),
          start(checked(spinning(Pinned{inertia}, omega))),
          duration(seconds),
          need(std::move(what)),
          solution(inertia, start.orientation, start.angular_momentum) {}

    Wrench operator()(const Pinned&, double) const { return {}; }
    Pinned exact(double t) const {
        return {start.inertia, solution.pose(t), start.angular_momentum};
    }
    /// Angle [rad] between computed and exact orientation.
    double error(const Pinned& body, double t) const {
        return angle_between(body.orientation, solution.pose(t));
    }
    double energy(const Pinned& body) const { return rotational_energy(body); }
};

/// Scene S7: spun almost about its middle axis, it flips every 7.0 s.
inline FreeBody near_middle_axis() {
    return {"near_middle_axis",
            {1, 2, 2.5},
            {0.05, 4, 0.05},
            100,
            {1e-5, "rad", "a hundredth of a pixel: a hundred such flights add up to one"}};
}

/// The body on which the source's step never flips, and the truth does at 4.058030 s and then
/// every 6.976516 s.
inline FreeBody flip() {
    return {"flip", {1, 2, 3}, {0.1, 2, 0.1}, 30, {1.0 / 960, "rad", "one pixel at 960 pixels"}};
}

/// A handle that has the flip's moments: two thin rods, the bar along the body's x, the stem from
/// its middle along y. They are as 1 to 2 to 3 if r^3 (2 + 6/(1 + r)) = 1, r the stem's length
/// over the bar's.
struct Handle {
    double bar = 1.8;  ///< [m]
    double stem = 0.5546918369 * bar;
    /// Of the bar's middle, seen from the centre of mass, along y [m].
    double foot() const { return -stem * stem / 2 / (bar + stem); }
};

/// A thrown plate, symmetric, that wobbles: its axis goes round L.
inline FreeBody wobbling_plate() {
    return {"wobbling_plate",
            {1, 1, 2},
            {1, 0, 10},
            10,
            {1.0 / 960, "rad", "one pixel at 960 pixels"}};
}

/// Scene S6 fast: 20 turns a second about a principal axis, 1000 turns.
inline FreeBody fast_spin() {
    return {"fast_spin", {1, 2, 2.5}, {0, 0, 40 * pi}, 50, {1e-9, "rad", "round-off"}};
}

/// A throw that spins 20 times a second and wobbles: a step of 1/60 s turns it by two radians.
inline FreeBody fast_wobble() {
    return {"fast_wobble",
            {1, 2, 2.5},
            {6, 6, 40 * pi},
            2,
            {1.0 / 960, "rad", "one pixel at 960 pixels"}};
}
// [/free_body]

// [heavy_top_scene]
/// A top on a pivot, under its weight. exact: HeavyTop, unless it starts upright.
struct HeavyTopScene {
    std::string name;
    double distance;  ///< from pivot to centre of mass [m]
    Top top;
    Pinned start;
    double duration;  ///< [s]
    Need need{1e-3, "m", "one pixel of its snapshot, 1 m across 960 pixels"};
    HeavyTop solution = HeavyTop(top, start);

    Wrench operator()(const Pinned& body, double) const {
        return {Vector3::Zero(), weight_torque(top, rotate(body.orientation, {0, 0, 1}))};
    }
    Vector3 centre(const Pinned& body) const {  ///< of mass [m], from the pivot
        return rotate(body.orientation, {0, 0, distance});
    }
    Pinned exact(double t) const {  ///< its pose; its angular momentum is left at the start's
        return {start.inertia, solution.pose(t), start.angular_momentum};
    }
    /// Distance [m] between computed and exact centre.
    double error(const Pinned& body, double t) const {
        return (centre(body) - centre(exact(t))).norm();
    }
    /// Energy of rotation and height [J].
    double energy(const Pinned& body) const {
        return rotational_energy(body) + top.weight * rotate(body.orientation, {0, 0, 1}).y();
    }
    /// L about the vertical and about its own axis: both are conserved.
    double about_vertical(const Pinned& body) const { return body.angular_momentum.y(); }
    double about_axis(const Pinned& body) const {
        return body.angular_momentum.dot(rotate(body.orientation, {0, 0, 1}));
    }
};

/// A pinned symmetric body whose axis leans by `tilt` [rad] from up towards x.
inline Pinned leaning(const Top& top, double tilt) {
    const Quaternion upright = exponential({-pi / 2, 0, 0});
    return {{top.across, top.across, top.along}, product(exponential({0, 0, -tilt}), upright)};
}

/// The top of scene S8: 1 kg, moments 0.06, 0.06, 0.1 about its centre, which is 0.5 m from the
/// pivot.
inline Top standard_top() {
    return {0.06 + 0.25, 0.1, 0.5 * -gravity.y()};
}

/// Scene S8: leans by 30 degrees, spins at 30 rad/s, is let go: it falls, and nods.
inline HeavyTopScene nodding_top() {
    const Top top = standard_top();
    const Pinned at_rest = leaning(top, pi / 6);
    const Vector3 axis = rotate(at_rest.orientation, {0, 0, 1});
    return {"nodding_top", 0.5, top, spinning(at_rest, 30 * axis), 10};
}

/// The same top, started so that it goes round steadily at 30 degrees.
/// @param which  0 for the slow way round, 1 for the fast one
inline HeavyTopScene steady_top(std::size_t which) {
    const Top top = standard_top();
    const double L3 = 0.1 * 30, rate = steady_precession(top, L3, pi / 6).at(which);
    Pinned body = leaning(top, pi / 6);
    const Vector3 axis = rotate(body.orientation, {0, 0, 1}), up(0, 1, 0);
    body.angular_momentum = L3 * axis + top.across * rate * (up - axis.y() * axis);
    return {which == 0 ? "slow_precession" : "fast_precession", 0.5, top, body, 10};
}

/// The same top almost upright, spinning about its axis: it sleeps, or it falls.
struct SleepingTop {
    Top top = standard_top();
    Pinned start;

    /// @param L3  along its axis [kg m^2/s]    @param lean  from upright [rad]
    SleepingTop(double L3, double lean) : start(leaning(top, lean)) {
        start.angular_momentum = L3 * rotate(start.orientation, {0, 0, 1});
    }
    Wrench operator()(const Pinned& body, double) const {
        return {Vector3::Zero(), weight_torque(top, rotate(body.orientation, {0, 0, 1}))};
    }
};
// [/heavy_top_scene]

// [thrown_wrench]
/// A spanner thrown across the room: its centre flies a parabola while it tumbles about it.
struct ThrownSpanner {
    std::string name = "thrown_spanner";
    Body start =
        spinning(Body{0.5, {2e-4, 2.5e-3, 2.6e-3}, {0, 1.5, 0}, {1.5, 2, 0}}, {1, 12, 0.5});
    double duration = 1;  // [s]
    Need need{3.0 / 960, "m", "one pixel of its snapshot, 3 m across 960 pixels"};
    FreeTop solution{start.inertia, start.orientation, start.angular_momentum};
    Vector3 tip{0.12, 0, 0};  ///< of the spanner [m], body axes

    Wrench operator()(const Body& body, double) const {
        return {body.mass * gravity, Vector3::Zero()};
    }
    Body exact(double t) const {
        Body body = start;
        body.position += velocity(start) * t + gravity * t * t / 2;
        body.momentum += start.mass * gravity * t;
        body.orientation = solution.pose(t);
        return body;
    }
    /// Distance [m] between computed and exact tip: centre and orientation in one.
    double error(const Body& body, double t) const {
        return (point_of(body, tip) - point_of(exact(t), tip)).norm();
    }
};
// [/thrown_wrench]

}  // namespace nutshell
