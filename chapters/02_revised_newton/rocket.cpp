// The rocket: from parcels to Tsiolkovsky, and the books of momentum.
#include <nutshell/lab/need_chart.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/revised_newton_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

/// The speed a rocket gains, over its exhaust speed, when it throws all but 1/ratio of itself in
/// n parcels.
double gain_in_parcels(double ratio, long n, bool midway_parcels) {
    Rocket rocket;
    rocket.duration = rocket.start.mass * (1 - 1 / ratio) / -rocket.start.flow.rate;
    if (midway_parcels) rocket = Rocket::with_midway(rocket);
    return velocity(lab::run(rocket, methods::euler, n)).x() / rocket.start.flow.velocity.norm();
}

void gain_chart(lab::Report& report) {
    chart::Chart chart;
    chart.title = "Few parcels gain too much; many follow the formula";
    chart.subtitle = "Rocket without gravity. Marks: few and many parcels. Formula: u ln(m₀/m).";
    chart.x = {"mass before over mass after, m₀/m", chart::Scale::logarithmic, 1, 20};
    chart.y = {"speed gained, in exhaust speeds", chart::Scale::linear, 0, 4};
    chart::Series five{"5 parcels"}, fifty{"50 parcels"}, formula{"formula"};
    lab::Table data{{"mass_ratio", "parcels_5", "parcels_50", "formula"}, {}};
    for (const double ratio :
         {1.25, 1.6, 2.0, 2.5, 3.2, 4.0, 5.0, 6.4, 8.0, 10.0, 13.0, 16.0, 20.0}) {
        five.x.push_back(ratio), five.y.push_back(gain_in_parcels(ratio, 5, false));
        fifty.x.push_back(ratio), fifty.y.push_back(gain_in_parcels(ratio, 50, false));
        data.add({lab::exact_digits(ratio), lab::exact_digits(five.y.back()),
                  lab::exact_digits(fifty.y.back()),
                  lab::exact_digits(rocket_gain(1, ratio, 1))});
    }
    for (int i = 0; i <= 60; ++i) {
        const double ratio = std::exp(std::log(20.0) * i / 60);
        formula.x.push_back(ratio), formula.y.push_back(rocket_gain(1, ratio, 1));
    }
    formula.draw = chart::Draw::theory;
    chart.levels_y = {{1, "as fast as its exhaust"}};
    chart.series = {formula, five, fifty};
    chart::write_svg(chart, report.path("rocket_gain.svg"));
    report.data("rocket_gain.csv", data);
}

}  // namespace

void rocket(lab::Report& report) {
    const Rocket before, midway_rocket = Rocket::with_midway(before);
    const double u = before.start.flow.velocity.norm(), gain = rocket_gain(u, 10, 2.5);
    report.heading("Rocket: 10 kg down to 2.5 kg, exhaust at 100 m/s, no gravity");
    lab::Table table{
        {"parcels", "speed [m/s]", "off by", "measured from the mean [m/s]", "off by"}, {}};
    report.number("rocket.gain", gain, "m/s");
    for (const long n : {1L, 3L, 15L, 150L, 1500L}) {
        const double speed = velocity(lab::run(before, methods::euler, n)).x();
        const double mean = velocity(lab::run(midway_rocket, methods::euler, n)).x();
        table.add({std::to_string(n), lab::rounded(speed, "%.4f"),
                   lab::rounded(100 * (speed / gain - 1), "%+.4f %%"), lab::rounded(mean, "%.4f"),
                   lab::rounded(100 * (mean / gain - 1), "%+.4f %%")});
        report.number("rocket.speed_" + std::to_string(n), speed, "m/s");
        report.number("rocket.midway_" + std::to_string(n), mean, "m/s");
        report.number("rocket.off_" + std::to_string(n), speed / gain - 1);
        report.number("rocket.midway_off_" + std::to_string(n), mean / gain - 1);
    }
    report.print(table);
    report.say("Tsiolkovsky: " + lab::rounded(gain, "%.4f") + " m/s.");
    report.number("rocket.ratio_for_own_exhaust", std::exp(1.0));
    report.number("rocket.propellant_for_own_exhaust", propellant_for(u, u, 1));
    report.number("rocket.ratio_for_two", std::exp(2.0));
    report.number("rocket.ratio_for_three", std::exp(3.0));

    const std::vector<lab::Entry<Rocket>> ways{
        {"from the speed before",
         {},
         lab::entry<Rocket>(methods::euler).measure,
         lab::entry<Rocket>(methods::euler).seconds},
        {"from the mean speed",
         {Family::plain, Mark::square, "9 4"},
         [](const Rocket& scene, long steps) {
             return lab::measure(Rocket::with_midway(scene), methods::euler, steps);
         },
         [](const Rocket& scene, long steps) {
             const Rocket other = Rocket::with_midway(scene);
             return lab::time_of([&] { lab::keep(lab::run(other, methods::euler, steps)); });
         }}};
    const auto least = lab::least_of_each(before, ways);
    lab::report_least(report, "rocket", least, before.need);
    const auto curves =
        lab::work_precision(before, ways, {1, 3, 10, 30, 100, 300, 1000, 3000, 10000});
    lab::draw_study(report,
                    {"rocket",
                     "Rocket. Each parcel measured from the speed before it leaves, or the mean.",
                     "Measured from the mean speed, the error falls twice as steeply",
                     {-1, -2},
                     "Measured from the mean speed, a few parcels will do",
                     "parcels"},
                    curves, least, before.need);
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
    entries.push_back({"Verlet, midway parcels", variant(methods::verlet.look),
                       [](const Rocket& s, long n) {
                           return lab::measure(Rocket::with_midway(s), methods::verlet, n);
                       },
                       [](const Rocket& s, long n) {
                           const Rocket other = Rocket::with_midway(s);
                           return lab::time_of(
                               [&] { lab::keep(lab::run(other, methods::verlet, n)); });
                       }});
    const auto least = lab::least_of_each(scene, entries);
    lab::report_least(report, "launch", least, scene.need);
    const auto curves =
        lab::work_precision(scene, entries, {3, 10, 30, 100, 300, 1000, 3000, 10000});
    lab::draw_study(report,
                    {"launch",
                     "Water rocket under gravity, 1.5 s.",
                     "Only Verlet with midway parcels falls at second order",
                     {-1, -2},
                     "A chain is as good as its worst link: Verlet alone gains nothing"},
                    curves, least, scene.need);
}

namespace {

/// Runs rocket and exhaust, keeps one component of each momentum, and draws the books.
double books_of(lab::Report& report, const Rocket& flight, Eigen::Index axis,
                const std::string& file, chart::Chart chart) {
    const RocketBooks books{flight};
    chart::Series rocket{"rocket"}, exhaust{"exhaust"}, total{"total"}, law{"P₀ + m₀ g t"};
    lab::Table data{{"t", "rocket", "exhaust", "total", "law"}, {}};
    double worst = 0;
    lab::run(books, methods::verlet, 300, [&](const RocketAndExhaust& all, double t) {
        const Vector3 exact = books.exact_momentum(t);
        worst = std::max(worst, (total_momentum(all) - exact).norm());
        for (auto* series : {&rocket, &exhaust, &total, &law}) series->x.push_back(t);
        rocket.y.push_back(all.rocket.momentum[axis]),
            exhaust.y.push_back(exhaust_momentum(all)[axis]);
        total.y.push_back(total_momentum(all)[axis]), law.y.push_back(exact[axis]);
        data.add({lab::exact_digits(t), lab::exact_digits(rocket.y.back()),
                  lab::exact_digits(exhaust.y.back()), lab::exact_digits(total.y.back()),
                  lab::exact_digits(law.y.back())});
    });
    law.draw = chart::Draw::ghost, law.look = Look{Family::exact};
    rocket.draw = exhaust.draw = total.draw = chart::Draw::line;
    chart.series = {law, rocket, exhaust, total};
    report.data(file + ".csv", data);
    chart::write_svg(chart, report.path(file + ".svg"));
    return worst;
}

}  // namespace

void momentum_books(lab::Report& report) {
    report.heading("The books of momentum: rocket and exhaust, 300 parcels");
    chart::Chart chart;
    chart.x = {"time [s]"};
    chart.y = {"momentum along the flight [kg m/s]"};
    chart.title = "What the rocket gains, the exhaust loses";
    chart.subtitle = "Rocket in empty space, Verlet, 300 parcels.";
    const double space = books_of(report, Rocket{}, 0, "books", chart);
    chart.title = "With gravity the sum falls with the whole weight";
    chart.subtitle = "Launch, Verlet, 300 parcels: parcels fall too.";
    chart.y.name = "momentum upwards [kg m/s]";
    const double field = books_of(report, water_rocket(), 1, "books_gravity", chart);
    const RocketAndExhaust end = lab::run(RocketBooks{}, methods::verlet, 300);
    report.say("Largest error of the sum: " + lab::rounded(space) + " kg m/s in space, " +
               lab::rounded(field) + " kg m/s under gravity, where single entries reach " +
               lab::rounded(exhaust_momentum(end).norm()) + " kg m/s.");
    report.number("books.space", space, "kg m/s");
    report.number("books.gravity", field, "kg m/s");
    report.number("books.rocket", end.rocket.momentum.x(), "kg m/s");
    report.number("books.exhaust", exhaust_momentum(end).x(), "kg m/s");
    double most = 0, when = 0;
    lab::run(RocketBooks{}, methods::verlet, 3000, [&](const RocketAndExhaust& all, double t) {
        if (all.rocket.momentum.x() > most) most = all.rocket.momentum.x(), when = t;
    });
    report.number("books.rocket_most", most, "kg m/s");
    report.number("books.rocket_most_at", when, "s");
    report.number("books.rocket_most_speed", velocity(Rocket{}.exact(when)).x(), "m/s");
}

}  // namespace nutshell
