// The model ladder: when a ball needs no orientation, and when a stick does; and what each costs.
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/rigid_methods.hpp>
#include <nutshell/spinning.hpp>
#include <nutshell/thrown_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

/// The tip if the model knows the centre only, and the thing keeps the pose in which it was
/// thrown.
Vector3 as_a_point(const ThrownThing& scene, double t) {
    Body body = scene.start;
    body.position = scene.exact(t).position;
    return point_of(body, scene.in_body(scene.tip));
}

/// The tip if it goes on spinning as it was thrown: chapter 5's exponential, no inertia.
Vector3 as_a_steady_spin(const ThrownThing& scene, double t) {
    Body body = scene.start;
    body.position = scene.exact(t).position;
    body.orientation =
        product(exponential(angular_velocity(scene.start) * t), scene.start.orientation);
    return point_of(body, scene.in_body(scene.tip));
}

Vector3 truth(const ThrownThing& scene, double t) {
    return point_of(scene.exact(t), scene.in_body(scene.tip));
}

template <class Model>
double largest(const ThrownThing& scene, const Model& model) {
    double most = 0;
    for (int i = 1; i <= 200; ++i) {
        const double t = scene.duration * i / 200;
        most = std::max(most, (model(scene, t) - truth(scene, t)).norm());
    }
    return most;
}

/// A stick of this length, thrown end over end; a ball of this diameter.
ThrownThing stick(double length) {
    return {"stick",
            {{{0.02, length, 0.02}, {0, 0, 0}}},
            {0, length / 2, 0},
            {2.5, 4.5, 0},
            {0, 0, -9}};
}

template <class State>
double nanoseconds(const State& start, const auto& forces, const auto& step) {
    const int steps = 1000;
    return 1e9 / steps * lab::time_of([&] {
               State state = start;
               for (int n = 0; n < steps; ++n) state = step(state, forces, n / 60.0, 1 / 60.0);
               lab::keep(state);
           });
}

void errors(lab::Report& report) {
    lab::Table table{{"thing", "as a point [m]", "as a steady spin [m]", "as a body, 60 Hz [m]"},
                     {}};
    const auto row = [&](const ThrownThing& scene) {
        const double point = largest(scene, as_a_point), spin = largest(scene, as_a_steady_spin);
        const long steps = std::lround(scene.duration * 60);
        const double body = lab::measure(scene, methods::verlet, steps).max_error;
        table.add({scene.name, lab::rounded(point), lab::rounded(spin), lab::rounded(body)});
        const std::string key = "ladder." + scene.name;
        report.number(key + ".point", point, "m");
        report.number(key + ".spin", spin, "m");
        report.number(key + ".body", body, "m");
    };
    row(stick(0.6)), row(thrown_hammer()), row(tumbling_hammer());
    report.print(table);
    report.number("ladder.need", tumbling_hammer().need.tolerance, "m");

    double low = 1e-4, high = 1;  // the longest stick that may be a point
    for (int halving = 0; halving < 40; ++halving) {
        const double middle = std::sqrt(low * high);
        const ThrownThing scene = stick(middle);
        (largest(scene, as_a_point) < scene.need.tolerance ? low : high) = middle;
    }
    report.number("ladder.stick.good_to", low, "m");
}

void picture_of_errors(lab::Report& report) {
    const ThrownThing scene = tumbling_hammer();
    chart::Chart chart;
    chart.title = "A tumbling hammer needs all of a body";
    chart.subtitle = "Distance of its grip from the truth.";
    chart.x = {"time [s]", chart::Scale::linear, 0};
    chart.y = {"distance [m]", chart::Scale::logarithmic};
    chart.tolerance = {scene.need.tolerance, "a pixel"};
    chart::Series point{"a point"}, spin{"a steady spin"}, body{"a body, 60 Hz"};
    body.look = methods::verlet.look;
    for (chart::Series* s : {&point, &spin, &body}) s->draw = chart::Draw::line;
    lab::run(scene, methods::verlet, std::lround(scene.duration * 60),
             [&](const Body& state, double t) {
                 if (t == 0) return;
                 const auto add = [&](chart::Series& series, const Vector3& tip) {
                     series.x.push_back(t);
                     series.y.push_back((tip - truth(scene, t)).norm());
                 };
                 add(point, as_a_point(scene, t)), add(spin, as_a_steady_spin(scene, t));
                 add(body, point_of(state, scene.in_body(scene.tip)));
             });
    chart.series = {point, spin, body};
    chart::write_svg(chart, report.path("ladder.svg"));
}

void costs(lab::Report& report) {
    const ThrownThing scene = tumbling_hammer();
    struct Gravity {
        Vector3 operator()(const PointMass& s, double) const { return s.mass * gravity; }
        Wrench operator()(const Body& s, double) const {
            return {s.mass * gravity, Vector3::Zero()};
        }
    };
    const auto one_verlet = [](const auto& state, const auto& forces, double t, double dt) {
        return verlet(state, forces, t, dt);
    };
    const PointMass point{scene.start.mass, scene.start.position, velocity(scene.start)};
    Body ball = scene.start, lopsided = scene.start;
    ball.inertia = ball_inertia(1, 0.1);
    struct Spinning {
        PointMass centre;
        Quaternion pose;
    };
    const Vector3 omega = angular_velocity(scene.start);
    const auto spin_on = [&](const Spinning& s, const Gravity& forces, double t, double dt) {
        return Spinning{verlet(s.centre, forces, t, dt),
                        product(exponential(omega * dt), s.pose)};
    };
    const double as_point = nanoseconds(point, Gravity{}, one_verlet),
                 as_spin =
                     nanoseconds(Spinning{point, scene.start.orientation}, Gravity{}, spin_on),
                 as_ball = nanoseconds(ball, Gravity{}, one_verlet),
                 as_body = nanoseconds(lopsided, Gravity{}, one_verlet);
    lab::Table table{{"model", "ns a step", "numbers"}, {}};
    const auto row = [&](const char* name, const char* key, double ns, int numbers) {
        table.add({name, lab::rounded(ns, "%.0f"), std::to_string(numbers)});
        report.number(std::string("ladder.cost.") + key, ns, "ns");
    };
    row("a point", "point", as_point, 6);
    row("a point with a steady spin", "spin", as_spin, 13);
    row("a body with two equal moments", "ball", as_ball, 13);
    row("a body with three moments", "body", as_body, 13);
    report.print(table);
    report.number("ladder.cost.ratio", as_body / as_point);
}

}  // namespace

void ladder(lab::Report& report) {
    report.heading("Model ladder: things thrown for " + lab::rounded(tumbling_hammer().duration) +
                   " s");
    errors(report);
    picture_of_errors(report);
    costs(report);
}

}  // namespace nutshell
