// Ways between two poses, and what three angles do near the zenith.
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/rotation_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

constexpr double degrees = 180 / pi;
const Look slerp_look{Family::exponential, Mark::triangle, ""};

/// Nanoseconds of one call of way(from, to, part), in a row of many that do not wait for each
/// other.
template <class Way>
double nanoseconds(const Way& way) {
    std::vector<Quaternion> from, to, result(256);
    for (int i = 0; i < 256; ++i) {
        from.push_back(quaternion_about({1, 2, 3}, 0.01 * i));
        to.push_back(quaternion_about({3, -1, 2}, 2 - 0.005 * i));
    }
    return 1e9 / 256 * lab::time_of([&] {
               for (std::size_t i = 0; i < 256; ++i) result[i] = way(from[i], to[i], 0.3);
               lab::keep(result[0]);
           });
}

/// How fast a way turns at `part` [rad for the whole way].
template <class Way>
double speed(const Way& way, double part) {
    const double h = 1e-4;
    return angle_between(way(part - h), way(part + h)) / (2 * h);
}

}  // namespace

void between_poses(lab::Report& report) {
    report.heading("Between two poses: slerp, nlerp, and three angles by themselves");
    const TwoPoses scene;
    const double whole = angle_between(scene.from, scene.to);
    const auto by_nlerp = [&](double part) { return nlerp(scene.from, scene.to, part); };
    const auto by_angles = [&](double part) { return scene.by_angles(part); };
    report.number("way.angle", whole * degrees, "degrees");

    double detour = 0;
    for (int i = 0; i < 100; ++i)
        detour += angle_between(by_angles(i / 100.0), by_angles((i + 1) / 100.0));

    const double ratio = speed(by_nlerp, 0.5) / speed(by_nlerp, 0);
    report.number("way.nlerp_ratio", ratio);
    report.number("way.nlerp_law", nlerp_speed_ratio(whole));
    report.number("way.nlerp_half_turn", nlerp_speed_ratio(pi));
    report.number("way.detour", detour / whole);
    report.number("way.slerp_ns", nanoseconds(slerp), "ns");
    report.number("way.nlerp_ns", nanoseconds(nlerp), "ns");
    double low = 0.01, high = pi - 0.01;
    while (high - low > 1e-4) {
        const double middle = (low + high) / 2;
        (TwoPoses::apart(middle).largest_lead() <= scene.need.tolerance ? low : high) = middle;
    }
    report.number("way.need", scene.need.tolerance, "rad");
    report.number("way.nlerp_enough", low * degrees, "degrees");
    report.say("nlerp is " + lab::rounded(ratio, "%.2f") + " times as fast in the middle (law: " +
               lab::rounded(nlerp_speed_ratio(whole), "%.2f") + "); it meets " +
               scene.need.reason + " up to " + lab::rounded(low * degrees, "%.0f") +
               " degrees. Three angles by themselves go " + lab::rounded(detour / whole, "%.2f") +
               " times as far.");
}

void three_angles(lab::Report& report) {
    report.heading("Three angles: a camera follows a bird over the zenith");
    lab::Table table{{"passes beside the zenith [m]", "line of sight turns [degrees/s]",
                      "yaw must turn [degrees/s]"},
                     {}};
    chart::Chart chart;
    chart.title = "The nearer to the zenith, the faster the yaw must turn";
    chart.subtitle = "A bird at 10 m/s, 20 m above the camera; turning speeds on its way.";
    chart.x = {"time [s]"};
    chart.y = {"turning speed [degrees/s]", chart::Scale::logarithmic};
    chart.tolerance = {Overhead{}.need.tolerance * degrees, "the motor's most"};
    for (const double aside : {5.0, 2.0, 0.5}) {
        Overhead scene;
        scene.aside = aside;
        chart::Series series{"yaw, " + lab::rounded(aside) + " m aside"};
        series.draw = chart::Draw::line;
        for (int i = -200; i <= 200; ++i) {
            const double t = i / 100.0, h = 1e-5;
            series.x.push_back(t);
            series.y.push_back(degrees * (scene.angles(t + h).yaw - scene.angles(t - h).yaw) /
                               (2 * h));
        }
        chart.series.push_back(series);
        table.add({lab::rounded(aside), lab::rounded(scene.sight_rate() * degrees),
                   lab::rounded(scene.yaw_rate() * degrees)});
        const std::string key = "overhead." + lab::rounded(aside);
        report.number(key + ".sight", scene.sight_rate() * degrees, "degrees/s");
        report.number(key + ".yaw", scene.yaw_rate() * degrees, "degrees/s");
    }
    chart::Series sight{"line of sight, 0.5 m aside"};
    sight.look = slerp_look, sight.draw = chart::Draw::line;
    Overhead near;
    near.aside = 0.5;
    for (int i = -200; i <= 200; ++i) {
        const double t = i / 100.0, h = 1e-5;
        const Vector3 before = near.bird(t - h).normalized(),
                      after = near.bird(t + h).normalized();
        sight.x.push_back(t), sight.y.push_back(degrees * before.cross(after).norm() / (2 * h));
    }
    chart.series.push_back(sight);
    chart::write_svg(chart, report.path("overhead.svg"));
    report.print(table);
    report.number("overhead.need", near.need.tolerance * degrees, "degrees/s");
    report.number("overhead.nearest", near.speed / near.need.tolerance, "m");
    report.say("A motor of " + lab::rounded(near.need.tolerance * degrees) +
               " degrees a second can follow birds that pass at least " +
               lab::rounded(near.speed / near.need.tolerance) + " m beside the zenith.");
}

}  // namespace nutshell
