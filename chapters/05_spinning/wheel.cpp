// Steady spins: how fast points are, what each method loses, what engines lose, what eyes lose.
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/need_chart.hpp>
#include <nutshell/sentence.hpp>
#include <nutshell/spinning_limits.hpp>
#include <nutshell/spinning_methods.hpp>
#include <nutshell/spinning_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

constexpr double degrees = 180 / pi;

/// How much of theta one step leaves out [rad], measured: the mean of many steps.
template <class Method>
double measured_lag(const Method& method, double theta, int steps = 50) {
    SpinningWheel wheel;
    wheel.rate = theta;  // steps of a second
    Quaternion q = wheel.start;
    auto step = method.start(wheel);
    double turned_by = 0;
    for (int n = 0; n < steps; ++n) {
        const Quaternion next = step(q, wheel, n, 1);
        turned_by += logarithm(product(normalised(next), inverse(normalised(q)))).z();
        q = next;
    }
    return theta - turned_by / steps;
}

}  // namespace

void velocity(lab::Report& report) {
    report.heading("Velocity of points");
    // the printed (37) half a turn later
    const Vector3 p(1, 0, 0);
    const Quaternion half = exponential({0, 0, pi});
    report.number("velocity.true", point_velocity({0, 0, 1}, half, p).y(), "m/s");
    report.number("velocity.printed", Vector3(0, 0, 1).cross(p).y(), "m/s");
    // the difference of eqs. (35)-(36)
    const SpinningWheel wheel = SpinningWheel::s6();
    for (const double dt : {1e-3, 1e-5}) {
        const Vector3 now = rotate(wheel.exact(0.3), p), later = rotate(wheel.exact(0.3 + dt), p);
        const double off =
            ((later - now) / dt - point_velocity(wheel.omega(), wheel.exact(0.3), p)).norm();
        report.number("velocity.difference." + lab::rounded(dt), off, "m/s");
    }
    const RollingWheel rolling;
    const Quaternion q = rolling.exact(0.4);
    const Vector3 lowest = rotate(inverse(q), Vector3(0, -rolling.radius, 0));
    report.number("rolling.speed", rolling.speed, "m/s");
    report.number("rolling.contact", rolling.velocity(q, lowest).norm(), "m/s");
    report.number("rolling.top", rolling.velocity(q, -lowest).norm(), "m/s");
    long steps = 1;
    while (lab::measure(rolling, methods::first_order_unit, steps).max_error >
           rolling.need.tolerance)
        ++steps;
    report.number("rolling.need", rolling.need.tolerance, "m");
    report.number("rolling.first_order_steps", static_cast<double>(steps));
    require(lab::measure(rolling, methods::exponential_map, 1).max_error < rolling.need.tolerance,
            phrase("one step of the {} does not meet the rolling wheel's need",
                   methods::exponential_map));
    report.say("A wheel rolls at " + lab::rounded(rolling.speed) +
               " m/s: its lowest point moves at " +
               lab::rounded(rolling.velocity(q, lowest).norm()) + ", its highest at " +
               lab::rounded(rolling.velocity(q, -lowest).norm()) + " m/s.");
}

void steady_spin(lab::Report& report) {
    report.heading("Spinning wheel: 1000 turns about (1, 2, 3), steps of 1/60 s");
    lab::Table table{{"turns a second", "method", "off at the end [rad]", "turns lost",
                      "length of q", "ns a step"},
                     {}};
    for (const bool fast : {false, true}) {
        const SpinningWheel wheel = fast ? SpinningWheel::s6_fast() : SpinningWheel::s6();
        const long steps = lab::steps_of(wheel.duration, 1.0 / 60);
        const double theta = wheel.rate / 60;
        const std::string word = fast ? "fast." : "slow.";
        report.number("wheel." + word + "step", theta * degrees, "degrees");
        each(spinning_methods, [&](const auto& method) {
            const auto m = lab::measure(wheel, method, steps);
            const double length = lab::run(wheel, method, steps).norm();
            const double time = lab::time_of([&] { lab::keep(lab::run(wheel, method, steps)); }) /
                                static_cast<double>(steps) * 1e9;
            const double lost =
                static_cast<double>(steps) * measured_lag(method, theta) / (2 * pi);
            table.add({fast ? "20" : "1", method.name, lab::rounded(m.final_error),
                       lab::rounded(lost), lab::rounded(length), lab::rounded(time)});
            const std::string key = "wheel." + word + method.key();
            report.number(key + ".error", m.final_error, "rad");
            report.number(key + ".largest", m.max_error, "rad");
            report.number(key + ".lost", lost, "turns");
            report.number(key + ".length", length);
            report.number(key + ".ns", time, "ns");
        });
        report.number("wheel." + word + "law",
                      static_cast<double>(steps) * first_order_lag(theta) / (2 * pi), "turns");
        report.number("wheel." + word + "growth", first_order_growth(theta));
        report.number("wheel." + word + "lag", first_order_lag(theta) * degrees, "degrees");
        report.number("wheel." + word + "small_law",
                      static_cast<double>(steps) * theta * theta * theta / 12, "rad");
    }
    report.print(table);
    // how long q is after ten seconds at one turn a second if nobody divides
    const SpinningWheel wheel = SpinningWheel::at({1, 2, 3}, 1, 10);
    const auto undivided = [](const Quaternion& q, const auto& spin, double t, double dt) {
        return first_order(q, spin, t, dt);
    };
    report.number("wheel.undivided", lab::run(wheel, undivided, 600).norm());
    report.number("wheel.undivided_law", std::pow(first_order_growth(2 * pi / 60), 600));

    chart::Chart chart;
    chart.title = "What a step of a steady spin leaves out";
    chart.subtitle = phrase("Marks: measured; dashed: the laws. The {} leaves out nothing.",
                            methods::exponential_map);
    chart.x = {"angle of one step, ω dt [rad]", chart::Scale::logarithmic};
    chart.y = {"angle missing each step [rad]", chart::Scale::logarithmic, 1e-13};
    chart.cut = true;
    chart::Series first = chart::series_of(methods::first_order_unit), first_law{"the laws"},
                  rk4 = chart::series_of(methods::rk4_pose), rk4_law{""};
    first_law.draw = rk4_law.draw = chart::Draw::theory;
    double worst = 0;
    for (double theta = 0.01; theta < 5.6; theta *= 1.4) {
        const double a = measured_lag(methods::first_order_unit, theta),
                     b = measured_lag(methods::rk4_pose, theta);
        first.x.push_back(theta), first.y.push_back(a);
        first_law.x.push_back(theta), first_law.y.push_back(first_order_lag(theta));
        worst = std::max(worst, std::abs(a / first_order_lag(theta) - 1));
        if (theta > 0.05 && theta < 3) {
            rk4.x.push_back(theta), rk4.y.push_back(b);
            rk4_law.x.push_back(theta), rk4_law.y.push_back(rk4_pose_lag(theta));
        }
    }
    chart.series = {first, first_law, rk4, rk4_law};
    chart.guides = {3, 5};
    chart.levels_x = {{2 * pi / 60, "1 turn/s"}, {2 * pi / 3, "20 turns/s"}};
    chart::write_svg(chart, report.path("lag.svg"));
    report.number("lag.off_the_law", worst);

    const auto stable = [](double theta) {
        SpinningWheel one;
        one.rate = theta;
        return lab::stays_within(
            one,
            [](const Quaternion& q, const auto& spin, double t, double dt) {
                return rk4_pose(q, spin, t, dt);
            },
            1, 20000, 1.01, [](const Quaternion& q) { return q.norm(); });
    };
    const double limit = lab::stability_limit(stable, 4, 7);
    report.number(methods::rk4_pose.key() + ".limit", limit, "rad");
    report.number(methods::rk4_pose.key() + ".limit_law", rk4_pose_limit, "rad");
    report.say(sentence("{} is stable up to omega dt = ", methods::rk4_pose) +
               lab::rounded(limit, "%.4f") +
               "; 4 sqrt 2 = " + lab::rounded(rk4_pose_limit, "%.4f"));
}

/// What ten turns within a pixel cost each method.
void ten_turns(lab::Report& report) {
    const SpinningWheel wheel;
    report.heading("Spinning wheel: what ten turns need");
    const auto least =
        lab::least_of_each(wheel, lab::entries<SpinningWheel>(spinning_methods), 1, 100'000);
    lab::report_least(report, "wheel.ten", least, wheel.need);
    chart::Ranking lead = lab::need_chart(least, wheel.need, "Ten turns at a steady speed.",
                                          "A steady spin needs one step, if the step turns");
    lead.columns.front() = "times ω is asked for";
    chart::write_svg(lead, report.path("wheel_need.svg"));
}

void engines(lab::Report& report) {
    report.heading("What engines do: 20 turns a second for 1000 turns, steps of 1/60 s");
    const SpinningWheel wheel = SpinningWheel::s6_fast();
    const double dt = 1.0 / 60, theta = wheel.rate * dt;
    lab::Table table{{"rule", "turns made of 1000"}, {}};
    chart::Chart chart;
    chart.title = "How many of 1000 turns are made";
    chart.subtitle = "20 turns a second, steps of 1/60 s, by the rules that engines use.";
    chart.x = {"turns made", chart::Scale::linear, 0};
    const auto rule = [&](const std::string& name, const std::string& key, Look look,
                          double made) {
        chart::Bar bar{name, made};
        bar.look = look, bar.text = lab::rounded(made, "%.0f");
        chart.bars.push_back(bar);
        table.add({name, lab::rounded(made, "%.1f")});
        report.number("engines." + key, made, "turns");
    };
    const auto part = [&](const Vector3& omega) { return 1000 * omega.norm() / wheel.rate; };
    rule(phrase("{}, no clamp", methods::exponential_map), methods::exponential_map.key(),
         methods::exponential_map.look, 1000);
    rule(methods::first_order_unit.name, "first_order", methods::first_order_unit.look,
         1000 * 2 * std::atan(theta / 2) / theta);
    rule("clamped by halves", "by_halves", Look{Family::peer, Mark::triangle_down},
         1000 * clamped_by_halves(theta, pi / 4) / theta);
    rule("clamped to 45° a step", "clamp_step", Look{Family::peer, Mark::square},
         part(clamped(wheel.omega(), dt, pi / 4)));
    rule("clamped to 47.1 rad/s", "clamp_speed", Look{Family::peer, Mark::diamond},
         part(clamped(wheel.omega(), 1, 47.1)));
    report.print(table);
    chart::write_svg(chart, report.path("engines.svg"));
}

void wagon(lab::Report& report) {
    report.heading("Wagon wheel: eight spokes, 24 pictures a second");
    const int spokes = 8;
    const double pictures_a_second = 24;
    chart::Chart chart;
    chart.title = "What the film shows of a wheel's speed";
    chart.subtitle = "Eight equal spokes, 24 pictures a second; dashed: the wheel itself.";
    chart.x = {"wheel [turns/s]"};
    chart.y = {"seen [turns/s]"};
    chart.cut = true;  // a gap is no point that is missing
    chart::Series seen{"seen"};
    seen.look = Look{Family::implicit, Mark::circle}, seen.draw = chart::Draw::line;
    double before = 0;
    for (int i = 0; i <= 1200; ++i) {
        const double rate = i / 200.0, turn = 2 * pi * rate / pictures_a_second;
        const double shown = seen_turn(turn, spokes) * pictures_a_second / (2 * pi);
        if (shown < before - 1)  // from half a spoke forwards to half a spoke backwards: a gap
            seen.x.push_back(rate), seen.y.push_back(std::nan(""));
        seen.x.push_back(rate), seen.y.push_back(shown);
        before = shown;
    }
    chart.series.push_back(seen);
    chart.series.push_back({"", {0, 6}, {0, 6}, chart::Draw::theory});
    chart::write_svg(chart, report.path("wagon_speed.svg"));
    report.number("wagon.backwards_from", pictures_a_second / spokes / 2, "turns/s");
    report.number("wagon.still_at", pictures_a_second / spokes, "turns/s");
    report.number("wagon.pictures", 2 * spokes * 6.0);  // two a spoke, at 6 turns a second
    const double rate = 2.75;
    report.number("wagon.example", rate, "turns/s");
    report.number(
        "wagon.example_seen",
        seen_turn(2 * pi * rate / pictures_a_second, spokes) * pictures_a_second / (2 * pi),
        "turns/s");
    report.say("It turns backwards from " + lab::rounded(pictures_a_second / spokes / 2) +
               " turns a second on and stands still at " +
               lab::rounded(pictures_a_second / spokes) + ".");
}

}  // namespace nutshell
