// From one free body to a million: time for a step of one body, against what this machine can.
#include <nutshell/bodies.hpp>
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/rigid_methods.hpp>
#include <nutshell/top_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

constexpr double dt = 1. / 60;

/// The least time for one item [ns]; the ways take turns, so that a while in which the machine is
/// busy hits all of them.
template <std::size_t N>
std::array<double, N> least(std::size_t items, const std::array<std::function<void()>, N>& ways) {
    std::array<double, N> best;
    best.fill(1e300);
    for (int round = 0; round < 5; ++round)
        for (std::size_t i = 0; i < N; ++i)
            best[i] = std::min(best[i],
                               1e9 / static_cast<double>(items) * lab::time_of(ways[i], 1, 5e-4));
    return best;
}

/// One body after the other, each a struct of its own.
template <auto Rotation>
void drift_each(std::vector<Body>& all) {
    for (Body& body : all) drift_by<Rotation>(body, dt);
}

struct Row {
    std::size_t bodies;
    double wide, streaming, arithmetic;    ///< [ns] a body-step
    double magnus, split, explicit_euler;  ///< one struct after the other
    double floor() const { return std::max(streaming, arithmetic); }
};

Row time_bodies(std::size_t n) {
    Bodies all = free_boxes(n), streamed = free_boxes(n);
    std::vector<Body> a, b, c;
    for (std::size_t i = 0; i < n; ++i) a.push_back(all[i]);
    b = c = a;
    const std::vector<double> in(256, 1.5);
    std::vector<double> out(256);
    const auto best = least<6>(
        n, {[&] { drift(all, dt); }, [&] { wide::stream_bodies(n, streamed.arrays()); },
            [&] {
                for (std::size_t done = 0; done < n; done += 256)
                    wide::arithmetic_bodies(std::min<std::size_t>(256, n - done), in.data(),
                                            out.data(), dt);
                lab::keep(out[0]);
            },
            [&] { drift_each<magnus_rotation>(a); }, [&] { drift_each<split_rotation>(b); },
            [&] { drift_each<explicit_rotation>(c); }});
    return {n, best[0], best[1], best[2], best[3], best[4], best[5]};
}

void draw(lab::Report& report, const std::vector<Row>& rows) {
    chart::Chart chart;
    chart.title = "What a step of one free body costs";
    chart.subtitle = "One core, steps of 1/60 s; down is better.";
    chart.x = {"bodies", chart::Scale::logarithmic};
    chart.y = {"time for a body-step [ns]", chart::Scale::logarithmic};
    chart::Series wide{"Magnus, arrays"}, floor{"the machine's floor"},
        magnus{"Magnus, one by one"}, split{"split turns, one by one"},
        euler{"constant ω, one by one"};
    wide.look = methods::kick_magnus_kick.look;
    magnus.look = variant(methods::kick_magnus_kick.look);
    split.look = methods::kick_split_kick.look;
    euler.look = methods::corrected_step.look;
    floor.draw = chart::Draw::theory;
    for (const Row& row : rows) {
        const auto n = static_cast<double>(row.bodies);
        for (chart::Series* one : {&wide, &floor, &magnus, &split, &euler}) one->x.push_back(n);
        wide.y.push_back(row.wide), floor.y.push_back(row.floor());
        magnus.y.push_back(row.magnus), split.y.push_back(row.split);
        euler.y.push_back(row.explicit_euler);
    }
    chart.series = {euler, split, magnus, wide, floor};
    chart::write_svg(chart, report.path("many_bodies.svg"));
}

/// How far off [rad] each way of turning is on the chips of an explosion: boxes that wobble for
/// two seconds, the worst of a hundred.
void chips(lab::Report& report) {
    const Bodies boxes = free_boxes(100);
    const auto worst = [&](auto rotation) {
        double most = 0;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const Body box = boxes[i];
            const FreeTop exact(box.inertia, box.orientation, box.angular_momentum);
            Quaternion q = box.orientation;
            for (int n = 1; n <= 120; ++n) {
                rotation(box.inertia, q, box.angular_momentum, dt);
                most = std::max(most, angle_between(q, exact.pose(n * dt)));
            }
        }
        return most;
    };
    report.number("chips.explicit", worst(explicit_rotation), "rad");
    report.number("chips.split", worst(split_rotation), "rad");
    report.number("chips.magnus",
                  worst([](const Vector3& I, Quaternion& q, const Vector3& L, double h) {
                      magnus_rotation(I, q, L, h);
                  }),
                  "rad");
}

}  // namespace

void many_bodies(lab::Report& report) {
    report.heading("Many free bodies: time for a body-step [ns]");
    std::vector<Row> rows;
    for (const std::size_t n :
         std::vector<std::size_t>{1, 10, 100, 1000, 10'000, 100'000, 1'000'000})
        rows.push_back(time_bodies(n));
    lab::Table data{{"bodies", "magnus_arrays_ns", "streaming_ns", "arithmetic_ns", "magnus_ns",
                     "split_ns", "explicit_ns"},
                    {}};
    lab::Table shown{
        {"bodies", "Magnus, arrays", "floor", "times", "Magnus", "split", "constant"}, {}};
    for (const Row& row : rows) {
        data.add({std::to_string(row.bodies), lab::exact_digits(row.wide),
                  lab::exact_digits(row.streaming), lab::exact_digits(row.arithmetic),
                  lab::exact_digits(row.magnus), lab::exact_digits(row.split),
                  lab::exact_digits(row.explicit_euler)});
        shown.add({std::to_string(row.bodies), lab::rounded(row.wide), lab::rounded(row.floor()),
                   lab::rounded(row.wide / row.floor(), "%.2f"), lab::rounded(row.magnus),
                   lab::rounded(row.split), lab::rounded(row.explicit_euler)});
        const std::string key = "many." + std::to_string(row.bodies);
        report.number(key + ".magnus_arrays", row.wide, "ns");
        report.number(key + ".floor", row.floor(), "ns");
        report.number(key + ".over_floor", row.wide / row.floor());
        report.number(key + ".magnus", row.magnus, "ns");
        report.number(key + ".split", row.split, "ns");
        report.number(key + ".explicit", row.explicit_euler, "ns");
    }
    report.print(shown);
    report.data("many_bodies.csv", data);
    draw(report, rows);
    chips(report);
}

}  // namespace nutshell
