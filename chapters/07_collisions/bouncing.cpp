// The bouncing ball: by events, by steps, and by floors that do it wrong.
#include <algorithm>
#include <nutshell/bouncing_methods.hpp>
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/sentence.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

/// Root of the mean square of the height's error [m] over the first three seconds, at all steps.
template <class Method>
double rms(BouncingBall scene, const Method& method, long steps) {
    scene.duration = 3;
    double sum = 0;
    lab::run(scene, method, steps, [&](const Particle& body, double t) {
        const double error = scene.error(body, t);
        sum += error * error;
    });
    return std::sqrt(sum / static_cast<double>(steps));
}

/// Its mean over `near` runs with about so many steps: a single one meets the floor by chance early
/// or late in a step.
template <class Method>
double mean_rms(const BouncingBall& scene, const Method& method, long steps, int near = 20) {
    double sum = 0;
    for (int i = 0; i < near; ++i)
        sum +=
            rms(scene, method, std::lround(static_cast<double>(steps) * (0.8 + 0.4 * i / near)));
    return sum / near;
}

/// When the ball has come to rest [s]: the last time that it is more than a millimetre up.
template <class Method>
double rests_after(const BouncingBall& scene, const Method& method, long steps) {
    double last = 0;
    lab::run(scene, method, steps, [&](const Particle& body, double t) {
        if (distance_to(scene.floor, body.position) - scene.ball.radius > 0.001) last = t;
    });
    return last;
}

/// Bounces until the clock stands still: until a flight is shorter than its last digit.
long bounces_until_clock_stops(const BouncingBall& scene) {
    double now = std::sqrt(2 * scene.drop() / scene.g), up = scene.restitution * scene.g * now;
    long bounces = 1;
    for (; now + 2 * up / scene.g > now; ++bounces)
        now += 2 * up / scene.g, up *= scene.restitution;
    return bounces;
}

void zeno_numbers(lab::Report& report, const BouncingBall& scene) {
    std::vector<double> at;
    bounce_by_events(scene, scene.start, 12, [&](double t, const Particle&) { at.push_back(t); });
    report.number("bounce.bounces", static_cast<double>(at.size()));
    const std::vector<std::pair<std::string, double>> stretches{
        {"second", 1}, {"millisecond", 1e-3}, {"microsecond", 1e-6}};
    for (const auto& [name, left] : stretches) {
        const auto later = std::lower_bound(at.begin(), at.end(), scene.rest_time() - left);
        const auto n = static_cast<double>(later - at.begin());
        report.number("bounce.before." + name, n);
        require(std::abs(n - scene.bounces_until(left)) <= 1,
                "the row of bounces does not follow its law");
    }
    report.number("bounce.clock_stops", static_cast<double>(bounces_until_clock_stops(scene)));
    report.number("bounce.last_off", std::abs(at.back() - scene.rest_time()), "s");
}

}  // namespace

void bouncing(lab::Report& report) {
    const BouncingBall scene;
    report.heading("Bouncing ball: from 1 m, restitution 0.9");
    report.number("bounce.rest", scene.rest_time(), "s");
    report.number("bounce.path", scene.path(), "m");
    BouncingBall half;
    half.restitution = 0.5;
    report.number("bounce.half.rest", half.rest_time(), "s");
    report.number("bounce.need", scene.need.tolerance, "m");
    zeno_numbers(report, scene);

    chart::Ranking ranking;
    ranking.subtitle = "Height within 5 mm (rms) over the first 3 s.";
    ranking.columns = {"steps a second", "processor time [µs]"};
    chart::Chart chart;
    chart.title = "Smaller steps mend one of them";
    chart.subtitle =
        "Error of the height over the first 3 s; mean of 20 runs with about so many steps.";
    chart.x = {"steps a second", chart::Scale::logarithmic};
    chart.y = {"rms error [m]", chart::Scale::logarithmic, 1e-3, 1};
    chart.tolerance = {scene.need.tolerance, "half a pixel of 5 m"};
    chart.guides = {-1};
    std::vector<double> needs;  // steps a second of those that get there
    lab::Table table{{"method", "rms at 60/s [m]", "order", "at rest after [s]"}, {}};
    each(bouncing_methods, [&](const auto& method) {
        chart::Series series{method.name};
        series.look = method.look;
        std::vector<double> dts, errors;
        for (const long rate : {30, 60, 120, 240, 480, 960}) {
            const double error = mean_rms(scene, method, 3 * rate);
            dts.push_back(1.0 / static_cast<double>(rate)), errors.push_back(error);
            series.x.push_back(static_cast<double>(rate)), series.y.push_back(error);
        }
        chart.series.push_back(series);
        const std::string key = "bounce." + method.key();
        const double order = lab::observed_order(dts, errors);
        const double rest = rests_after(scene, method, 720);
        report.number(key + ".rms", errors[1], "m");
        report.number(key + ".rms_960", errors.back(), "m");
        report.number(key + ".order", order);
        report.number(key + ".rest", rest, "s");
        table.add({method.name, lab::rounded(errors[1]), lab::rounded(order, "%.2f"),
                   rest > 11.9 ? "never" : lab::rounded(rest, "%.2f")});
        const auto meets = [&](long rate) {
            return mean_rms(scene, method, 3 * rate) <= scene.need.tolerance;
        };
        long need = 60;  // steps a second: a picture each
        if (meets(4000))
            while (!meets(need)) need += 20;
        else {
            ranking.rows.push_back(
                {method.name,
                 method.look,
                 {},
                 "does not get there: " + lab::rounded(100 * errors.back(), "%.0f") +
                     " cm off with 960",
                 ""});
            return;
        }
        BouncingBall three = scene;
        three.duration = 3;
        const double us =
            1e6 * lab::time_of([&] { lab::keep(lab::run(three, method, 3 * need)); });
        ranking.rows.push_back(
            {method.name, method.look, {static_cast<double>(need), us}, "", ""});
        report.number(key + ".need", static_cast<double>(need));
        needs.push_back(static_cast<double>(need));
        report.number(key + ".us", us, "us");
        report.number(key + ".rest_at_need", rests_after(scene, method, 12 * need), "s");
    });
    report.print(table);
    ranking.title = "Step by step takes " + lab::rounded(needs.at(1) / needs.at(0), "%.0f") +
                    " times the steps of going from impact to impact";
    chart::write_svg(ranking, report.path("bounce_need.svg"));
    report.draw("bounce_order", chart);
}

void bad_floors(lab::Report& report) {
    report.heading("Floors that never rest, and floors that kick");
    // the printed floor, its ball started at rest on it
    BouncingBall rest;
    rest.g = 9.8;
    const double dt = 0.008;
    chart::Series jitter{methods::bounce_printed.name};
    jitter.look = methods::bounce_printed.look, jitter.draw = chart::Draw::line;
    Particle body{1};
    double highest = 0;
    long sent = 0, steps = 21000;
    for (long i = 0; i < steps; ++i) {
        body = euler(body, rest, 0, dt);
        const double before = body.momentum.y();
        bounce_as_printed(body);
        if (i >= 1000) {
            highest = std::max(highest, body.position.y());
            sent += body.momentum.y() != before;
        }
        if (i >= 20000 && i < 20125) {
            jitter.x.push_back(static_cast<double>(i - 20000) * dt);
            jitter.y.push_back(1000 * body.position.y());
        }
    }
    report.number("jitter.height", 1000 * highest, "mm");
    report.number("jitter.every", static_cast<double>(steps - 1000) / static_cast<double>(sent),
                  "steps");
    report.say(sentence("{} a ball at rest on the floor jumps ", methods::bounce_printed) +
               lab::rounded(1000 * highest, "%.1f") + " mm high for ever (dt = 0.008 s)");

    BouncingBall elastic;
    elastic.restitution = 1, elastic.duration = 20;
    std::vector<chart::Series> energies;
    const double start = elastic.drop() * elastic.g;
    const auto energy = [&](const auto& method, const std::string& key) {
        chart::Series series{method.name};
        series.look = method.look, series.draw = chart::Draw::line;
        double most = 0;
        lab::run(elastic, method, 1200, [&](const Particle& ball, double t) {
            const double now =
                elastic.g * (ball.position.y() - elastic.ball.radius) + kinetic_energy(ball);
            series.x.push_back(t), series.y.push_back(now / start);
            most = std::max(most, now / start);
        });
        report.number("elastic." + key, most);
        report.say(phrase("{}: ", method) + lab::rounded(most) + " times the energy after 20 s");
        energies.push_back(series);
    };
    energy(methods::bounce_pushed, "pushed");
    energy(methods::bounce_steps, "steps");
    energy(methods::bounce_events, "events");

    chart::Figure figure;
    figure.title = "The printed floor throws a resting ball up; pushing out makes energy";
    figure.subtitle =
        "Left: the printed rule, at rest on the floor since 160 s. Right: an elastic ball.";
    chart::Chart left, right;
    left.title = "printed, dt = 0.008 s", right.title = "elastic, dt = 1/60 s";
    left.x = {"time [s]"}, left.y = {"height [mm]", chart::Scale::linear, 0};
    right.x = {"time [s]"}, right.y = {"energy / energy at the start", chart::Scale::linear, 0};
    left.series = {jitter}, right.series = energies;
    figure.panels = {left, right};
    chart::write_svg(figure, report.path("bad_floors.svg"));
}

}  // namespace nutshell
