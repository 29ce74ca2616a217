// The same throw on machines of different speed, and the game loop that makes them agree.
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/newton_scenes.hpp>
#include <nutshell/sentence.hpp>
#include "frames.hpp"
#include "program.hpp"

namespace nutshell {

namespace {

const std::vector<int> rates{30, 60,
                             144};  // [Hz]; their common instants are the multiples of 1/6 s

/// How much farther than the exact ball Euler's flies with one step a frame, before it is down [m]:
/// where the parabola through its last three places comes to height zero.
double too_far(ThrownBall scene, int rate) {
    const double exact_landing = -2 * scene.start.velocity.y() / gravity.y(), dt = 1.0 / rate;
    std::vector<double> t, y;
    const auto steps = static_cast<long>(std::ceil(exact_landing / dt)) + 1;  // one step late
    scene.duration = static_cast<double>(steps) * dt;
    lab::run(scene, methods::euler, steps, [&](const PointMass& ball, double now) {
        t.push_back(now), y.push_back(ball.position.y());
    });
    const std::size_t n = t.size() - 2;
    const double slope = (y[n + 1] - y[n - 1]) / (2 * dt),
                 bend = (y[n + 1] - 2 * y[n] + y[n - 1]) / (dt * dt);
    const double landing = t[n] - (slope + std::sqrt(slope * slope - 2 * bend * y[n])) / bend;
    return scene.start.velocity.x() * (landing - exact_landing);
}

}  // namespace

void frame_rate(lab::Report& report) {
    const ThrownBall scene;
    report.heading(
        "Frame rate: one throw, one step a frame, height above the exact path [m] at the end");
    const double end = scene.duration;
    lab::Table table{{"rate [Hz]",
                      {methods::euler.name, "%.5f"},
                      {methods::semi_implicit_euler.name, "%.5f"},
                      {methods::verlet.name, "%.1e"}},
                     {}};
    chart::Chart chart;
    chart.title = sentence("{}'s ball flies higher on a slower machine", methods::euler);
    chart.subtitle = phrase("Thrown ball, {}, one step a frame.", methods::euler);
    chart.x = {"time [s]"};
    chart.y = {"computed minus exact height [m]"};
    for (const int rate : rates) {
        chart::Series series{std::to_string(rate) + " Hz", {}, {}, chart::Draw::line};
        const long steps = lab::steps_of(end, 1.0 / rate);
        lab::run(scene, methods::euler, steps, [&](const PointMass& ball, double t) {
            series.add(t, (ball.position - scene.exact(t).position).y());
        });
        const auto height = [&](const auto& method) {
            return (lab::run(scene, method, steps).position - scene.exact(end).position).y();
        };
        table.add({rate, series.y.back(), height(methods::semi_implicit_euler),
                   height(methods::verlet)});
        report.number("frame_rate." + methods::euler.key() + "." + std::to_string(rate),
                      series.y.back(), "m");
        report.number("frame_rate." + methods::verlet.key() + "." + std::to_string(rate),
                      height(methods::verlet), "m");
        report.number("frame_rate.landing." + std::to_string(rate), too_far(scene, rate), "m");
        chart.series.push_back(std::move(series));
    }
    report.print(table);
    chart::write_svg(chart, report.path("frame_rate.svg"));
}

void game_loop(lab::Report& report) {
    report.heading(
        phrase("Game loop: the same throw on five machines, {}, error where the ball is drawn at "
               "the end",
               methods::semi_implicit_euler));
    const ThrownBall scene;
    lab::Table table{
        {"machine", {"step follows the frame [m]", "%.4f"}, {"fixed step [m]", "%.4f"}}, {}};
    double least = 1e9, most = 0, fixed_least = 1e9, fixed_most = 0;
    for (const Machine& machine : machines()) {
        double following = 0,
               fixed = 0;  // the last frame's errors [m]; the fixed loop draws one step late
        play(machine, [&](const Shown& shown) {
            following = (shown.following - scene.exact(shown.time).position).norm();
            fixed = (shown.fixed - scene.exact(shown.time - fixed_step).position).norm();
        });
        table.add({machine.name, following, fixed});
        least = std::min(least, following), most = std::max(most, following);
        fixed_least = std::min(fixed_least, fixed), fixed_most = std::max(fixed_most, fixed);
    }
    report.print(table);
    report.number("game_loop.following_least", least, "m");
    report.number("game_loop.following_most", most, "m");
    report.number("game_loop.fixed_most", fixed_most, "m");
    report.number("game_loop.fixed_spread", fixed_most - fixed_least, "m");
    // how far the true ball flies in the one step by which the drawing is late
    const double end = scene.duration;
    report.number("game_loop.drawn_lag",
                  (scene.exact(end).position - scene.exact(end - fixed_step).position).norm(),
                  "m");

    // The source's program (section 10, erratum E72) makes one step of 0.008 s a frame, whatever
    // the frame lasts.
    report.number("game_loop.source_speed_at_60_hz", 0.008 * 60);
    report.number("game_loop.source_speed_at_144_hz", 0.008 * 144);

    // The spiral of death: a step of 1/60 s of physics that takes the machine 20 ms.
    const double slow_step = 1.0 / 60, cost = 0.020;
    chart::Chart chart;
    chart.title = "The spiral of death, and the cap that ends it";
    const std::string simulated = lab::rounded(1000 * slow_step) + " ms",
                      takes = lab::rounded(1000 * cost) + " ms";
    chart.subtitle = "Each step simulates " + simulated + " and costs the machine " + takes + ".";
    chart.x = {"frame"};
    chart.y = {"time the frame takes [s]", chart::Scale::logarithmic};
    double simulated_share = 0;
    for (const int cap : {1'000'000, 5}) {
        GameClock clock{slow_step, 0, cap};
        chart::Series series{
            cap == 5 ? "at most 5 steps a frame" : "no cap", {}, {}, chart::Draw::line};
        double frame = slow_step, played = 0, real = 0;
        for (int i = 1; i <= 40; ++i) {
            const int made = steps_due(clock, frame);
            played += made * slow_step;
            frame = std::max(slow_step, made * cost);
            real += frame;
            series.add(i, frame);
        }
        if (cap == 5) simulated_share = played / real;
        report.number(cap == 5 ? "spiral.capped_frame" : "spiral.last_frame", series.y.back(),
                      "s");
        chart.series.push_back(std::move(series));
    }
    chart::write_svg(chart, report.path("spiral_of_death.svg"));
    report.number("spiral.growth", cost / slow_step);
    report.number("spiral.capped_speed", simulated_share);
    report.say("A step that costs " + takes + " and simulates " + simulated +
               ": frame 40 takes " + lab::rounded(chart.series[0].y.back()) +
               " s without a cap, " + lab::rounded(chart.series[1].y.back()) +
               " s with one; the game then runs at " + lab::rounded(100 * simulated_share) +
               " % of real time.");
}

}  // namespace nutshell
