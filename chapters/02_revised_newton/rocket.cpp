// The rocket: from parcels to Tsiolkovsky, and the books of momentum.
#include <nutshell/lab/need_chart.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/revised_newton_scenes.hpp>
#include <nutshell/sentence.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

/// The speed a rocket gains, over its exhaust speed, when it throws all but 1/ratio of itself in
/// n parcels.
double gain_in_parcels(double ratio, long n) {
    Rocket rocket;
    rocket.duration = rocket.start.mass * (1 - 1 / ratio) / -rocket.start.flow.rate;
    return velocity(lab::run(rocket, methods::euler, n)).x() / rocket.start.flow.velocity.norm();
}

void gain_chart(lab::Report& report) {
    chart::Chart chart;
    chart.title = "Few parcels gain too much; many follow the formula";
    chart.subtitle = "Rocket without gravity. Marks: few and many parcels. Formula: u ln(m₀/m).";
    chart.x = {"mass before over mass after, m₀/m", chart::Scale::logarithmic, 1, 20};
    chart.y = {"speed gained, in exhaust speeds", chart::Scale::linear, 0, 4};
    chart::Series five{"5 parcels"}, fifty{"50 parcels"}, formula{"formula"};
    for (const double ratio :
         {1.25, 1.6, 2.0, 2.5, 3.2, 4.0, 5.0, 6.4, 8.0, 10.0, 13.0, 16.0, 20.0}) {
        five.add(ratio, gain_in_parcels(ratio, 5));
        fifty.add(ratio, gain_in_parcels(ratio, 50));
    }
    for (int i = 0; i <= 60; ++i) {
        const double ratio = std::exp(std::log(20.0) * i / 60);
        formula.add(ratio, rocket_gain(1, ratio, 1));
    }
    formula.draw = chart::Draw::theory;
    chart.levels_y = {{1, "as fast as its exhaust"}};
    chart.series = {formula, five, fifty};
    report.draw("rocket_gain", chart);
}

}  // namespace

void rocket(lab::Report& report) {
    const Rocket before, midway_rocket = Rocket::with_midway(before);
    const double u = before.start.flow.velocity.norm(), full = before.start.mass,
                 empty = before.exact(before.duration).mass, gain = rocket_gain(u, full, empty);
    report.heading("Rocket: " + lab::rounded(full) + " kg down to " + lab::rounded(empty) +
                   " kg, exhaust at " + lab::rounded(u) + " m/s, no gravity");
    lab::Table table{{"parcels",
                      {"speed [m/s]", "%.4f"},
                      {"off by [%]", "%+.4f"},
                      {"measured from the mean [m/s]", "%.4f"},
                      {"off by [%]", "%+.4f"}},
                     {}};
    report.number("rocket.gain", gain, "m/s");
    for (const long n : {1L, 3L, 15L, 150L, 1500L}) {
        const double speed = velocity(lab::run(before, methods::euler, n)).x();
        const double mean = velocity(lab::run(midway_rocket, methods::euler, n)).x();
        table.add({n, speed, 100 * (speed / gain - 1), mean, 100 * (mean / gain - 1)});
        report.number("rocket.speed_" + std::to_string(n), speed, "m/s", "printed");
        report.number("rocket.midway_" + std::to_string(n), mean, "m/s", "printed");
        report.number("rocket.off_" + std::to_string(n), speed / gain - 1, "", "printed");
        report.number("rocket.midway_off_" + std::to_string(n), mean / gain - 1, "", "printed");
    }
    report.print(table);
    report.say("Tsiolkovsky: " + lab::rounded(gain, "%.4f") + " m/s.");
    report.number("rocket.propellant_for_own_exhaust", propellant_for(u, u, 1));
    report.number("rocket.ratio_for_two", std::exp(2.0));
    report.number("rocket.ratio_for_three", std::exp(3.0));

    const std::vector ways{
        lab::entry_on<Rocket>("from the speed before", {}, methods::euler,
                              [](const Rocket& scene) { return scene; }),
        lab::entry_on<Rocket>("from the mean speed", {Family::plain, Mark::square, "9 4"},
                              methods::euler, Rocket::with_midway)};
    lab::study(
        report, before, ways,
        {.key = "rocket",
         .scene = "Rocket. Each parcel measured from the speed before it leaves, or the mean.",
         .behind = "Measured from the mean speed, the error falls twice as steeply",
         .guides = {-1, -2},
         .lead = "Measured from the mean speed, a few parcels will do",
         .work = "parcels",
         .steps = {1, 3, 10, 30, 100, 300, 1000, 3000, 10000}});
    gain_chart(report);
}

void launch(lab::Report& report) {
    const Rocket scene = water_rocket();
    const double T = scene.duration;
    report.heading("Launch: a water rocket under gravity, tilted");
    const Particle end = scene.exact(T);
    const double thrust = (scene.start.flow.rate * scene.start.flow.velocity).norm(),
                 weight = scene.start.mass * gravity.norm();
    report.say("Thrust " + lab::rounded(thrust) + " N against a weight of " +
               lab::rounded(weight) + " N. At burnout " + lab::rounded(end.position.y(), "%.2f") +
               " m up, climbing at " + lab::rounded(velocity(end).y(), "%.2f") + " m/s.");
    report.number("launch.thrust", thrust, "N");
    report.number("launch.weight", weight, "N");
    report.number("launch.height", end.position.y(), "m");
    report.number("launch.climb", velocity(end).y(), "m/s");
    report.number("launch.gravity_loss", -gravity.y() * T, "m/s");
    const Rocket in_space;
    report.number("launch.space_thrust",
                  (in_space.start.flow.rate * in_space.start.flow.velocity).norm(), "N");

    auto entries = lab::entries<Rocket>(newton_methods);
    entries.push_back(lab::entry_on<Rocket>(phrase("{}, midway parcels", methods::verlet),
                                            variant(methods::verlet.look), methods::verlet,
                                            Rocket::with_midway));
    lab::study(
        report, scene, entries,
        {.key = "launch",
         .scene = "Water rocket under gravity, " + lab::rounded(T) + " s.",
         .behind = phrase("Only {} with midway parcels falls at second order", methods::verlet),
         .guides = {-1, -2},
         .lead = sentence("{} alone gains nothing; with midway parcels it needs least",
                          methods::verlet),
         .steps = {3, 10, 30, 100, 300, 1000, 3000, 10000}});
}

namespace {

constexpr long parcels = 300;

/// Runs rocket and exhaust, keeps one component of each momentum, and draws the books.
double books_of(lab::Report& report, const Rocket& flight, Eigen::Index axis,
                const std::string& file, chart::Chart chart) {
    const RocketBooks books{flight};
    chart::Series rocket{"rocket"}, exhaust{"exhaust"}, total{"total"}, law{"P₀ + m₀ g t"};
    double worst = 0;
    lab::run(books, methods::verlet, parcels, [&](const RocketAndExhaust& all, double t) {
        const Vector3 exact = books.exact_momentum(t);
        worst = std::max(worst, (total_momentum(all) - exact).norm());
        rocket.add(t, all.rocket.momentum[axis]), exhaust.add(t, exhaust_momentum(all)[axis]);
        total.add(t, total_momentum(all)[axis]), law.add(t, exact[axis]);
    });
    rocket.draw = exhaust.draw = total.draw = chart::Draw::line;
    law.draw = chart::Draw::ghost, law.look = Look{Family::exact};
    chart.series = {law, rocket, exhaust, total};
    report.draw(file, chart);
    return worst;
}

}  // namespace

void momentum_books(lab::Report& report) {
    const std::string how =
        phrase("{}, ", methods::verlet) + std::to_string(parcels) + " parcels";
    report.heading("The books of momentum: rocket and exhaust, " + how);
    chart::Chart chart;
    chart.x = {"time [s]"};
    chart.y = {"momentum along the flight [kg m/s]"};
    chart.title = "What the rocket gains, the exhaust loses";
    chart.subtitle = "Rocket in empty space, " + how + ".";
    const double space = books_of(report, Rocket{}, 0, "books", chart);
    chart.title = "With gravity the sum falls with the whole weight";
    chart.subtitle = "Launch, " + how + ": parcels fall too.";
    chart.y.name = "momentum upwards [kg m/s]";
    const double field = books_of(report, water_rocket(), 1, "books_gravity", chart);
    const RocketAndExhaust end = lab::run(RocketBooks{}, methods::verlet, parcels);
    report.say("Largest error of the sum: " + lab::rounded(space) + " kg m/s in space, " +
               lab::rounded(field) + " kg m/s under gravity, where single entries reach " +
               lab::rounded(exhaust_momentum(end).norm()) + " kg m/s.");
    report.number("books.space", space, "kg m/s");
    report.number("books.gravity", field, "kg m/s");
    double most = 0, when = 0;
    lab::run(RocketBooks{}, methods::verlet, 3000, [&](const RocketAndExhaust& all, double t) {
        if (all.rocket.momentum.x() > most) most = all.rocket.momentum.x(), when = t;
    });
    report.number("books.rocket_most_at", when, "s");
    report.number("books.rocket_most_speed", velocity(Rocket{}.exact(when)).x(), "m/s");
}

}  // namespace nutshell
