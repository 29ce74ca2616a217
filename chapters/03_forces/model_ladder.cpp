// The model ladder: a throw without drag, with linear drag and with quadratic drag. What does the
// simpler model get wrong, what does it save, and when does nobody notice?
#include <nutshell/sentence.hpp>
#include "entries.hpp"
#include "program.hpp"

namespace nutshell {

namespace {

/// The ball thrown at `speed` [m/s] in the direction of chapter 1's throw; in air, it lands after
/// `flight` seconds.
struct Case {
    ThrowInAir air;
    double flight = 0;
};

ThrowInAir thrown(double speed, double linear, double air) {
    ThrowInAir scene;
    scene.start.velocity = speed * scene.start.velocity.normalized();
    scene.drag = linear, scene.air = air;
    return scene;
}

Case in_air(double speed) {
    Case c{thrown(speed, 0, ThrowInAir{}.air)};
    double low = 0.1 * speed / earth_gravity, high = 3 * speed / earth_gravity;
    for (int halving = 0; halving < 50; ++halving) {
        const double middle = (low + high) / 2;
        (c.air.exact(middle).position.y() > 0 ? low : high) = middle;
    }
    c.flight = low;
    return c;
}

/// The largest distance from the truth over the flight [m].
double off_the_truth(const ThrowInAir& model, const Case& truth) {
    double largest = 0;
    for (int n = 1; n <= 10; ++n) {
        const double t = truth.flight * n / 10;
        largest = std::max(largest, distance(model.exact(t), truth.air.exact(t)));
    }
    return largest;
}

ThrowInAir without(double speed) {
    return thrown(speed, 0, 0);
}
/// Linear drag that is as strong as the air's at the start.
ThrowInAir linear(double speed) {
    return thrown(speed, ThrowInAir{}.air * speed, 0);
}

constexpr double ball_radius = 0.1;  // [m]: who would see less?

}  // namespace

void model_ladder(lab::Report& report) {
    report.heading("Model ladder: a ball of " + lab::rounded(ThrowInAir{}.start.mass) +
                   " kg and " + lab::rounded(100 * ball_radius) + " cm radius, thrown");
    chart::Chart chart;
    chart.title = "How much model does a throw need?";
    chart.subtitle = "Largest distance from the throw with quadratic drag, over the flight.";
    chart.x = {"speed of the throw [m/s]", chart::Scale::logarithmic};
    chart.y = {"distance from the truth [m]", chart::Scale::logarithmic};
    chart.tolerance = chart::Level{ball_radius, "the ball's own radius"};
    chart::Series none{"no drag"}, fitted{"linear drag"};
    for (const double speed : {1.0, 2.0, 3.0, 5.0, 7.0, 10.0, 14.0, 20.0, 30.0, 40.0}) {
        const Case truth = in_air(speed);
        none.add(speed, off_the_truth(without(speed), truth));
        fitted.add(speed, off_the_truth(linear(speed), truth));
    }
    chart.series = {none, fitted};
    report.draw("ladder", chart);

    const double full = ThrowInAir{}.start.velocity.norm();
    const Case truth = in_air(full);
    report.number("ladder.speed", full, "m/s");
    report.number("ladder.flight", truth.flight, "s");
    report.number("ladder.range", truth.air.exact(truth.flight).position.x(), "m");
    const double none_off = off_the_truth(without(full), truth),
                 linear_off = off_the_truth(linear(full), truth);
    report.number("ladder.no_drag.off", none_off, "m");
    report.number("ladder.linear.off", linear_off, "m");
    report.number("ladder.drag_over_weight", truth.air.air * full * full / earth_gravity);
    const auto limit =
        [&](const auto& model) {  // the speed at which the model is off by the ball's radius
            double low = 1, high = 40;
            for (int halving = 0; halving < 20; ++halving) {
                const double middle = std::sqrt(low * high);
                (off_the_truth(model(middle), in_air(middle)) < ball_radius ? low : high) =
                    middle;
            }
            return low;
        };
    const double none_limit = limit(without), linear_limit = limit(linear);
    report.number("ladder.no_drag.good_to", none_limit, "m/s");
    report.number("ladder.linear.good_to", linear_limit, "m/s");

    // What the simpler model saves: steps for a pixel, and time for the whole throw.
    ThrowInAir nothing, viscous, air;
    nothing.air = 0;
    viscous.air = 0, viscous.drag = ThrowInAir{}.air * full;
    const auto cheapest =
        lab::fewest_steps(air, lab::entry<ThrowInAir>(methods::rk4), air.need.tolerance);
    require(cheapest.has_value(), phrase("model_ladder: {} did not reach a pixel", methods::rk4));
    const double time_none =
        lab::time_of([&] { lab::keep(lab::run(nothing, methods::verlet, 1)); });
    const double time_linear =
        lab::time_of([&] { lab::keep(lab::run(viscous, methods::exponential_kick, 1)); });
    const double time_air =
        lab::time_of([&] { lab::keep(lab::run(air, methods::rk4, cheapest->steps)); });
    report.number("ladder.no_drag.nanoseconds", 1e9 * time_none, "ns");
    report.number("ladder.linear.nanoseconds", 1e9 * time_linear, "ns");
    report.number("ladder.air.nanoseconds", 1e9 * time_air, "ns");
    report.number("ladder.air.steps", cheapest->steps);
    lab::Table table{{"model", "off the truth [m]", "steps for a pixel",
                      "time for the throw [ns]", "good to [m/s]"},
                     {}};
    table.add({"no drag", none_off, 1, 1e9 * time_none, none_limit});
    table.add({"linear drag", linear_off, 1, 1e9 * time_linear, linear_limit});
    table.add({"quadratic drag", 0, cheapest->steps, 1e9 * time_air, "-"});
    report.print(table);
}

}  // namespace nutshell
