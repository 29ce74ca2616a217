// How long one step of one particle takes, from ten particles to a million, and how far that is
// from what the machine can.
#include "scale.hpp"
#include <nutshell/chart/chart.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/spring_limits.hpp>
#include "step_times.hpp"

namespace nutshell {

namespace {

struct Kind {
    std::string name, plural, word;  ///< on charts; in names of numbers
    std::vector<Times> times;
};

void draw_time_against_number(lab::Report& report, const std::vector<Kind>& kinds) {
    chart::Chart chart;
    chart.title = "What one step of one particle costs";
    chart.subtitle = "One core, one pass of " + std::string(methods::semi_implicit_euler.name) +
                     ". Dashed: the machine's reference. Down is better.";
    chart.x = {"particles", chart::Scale::logarithmic};
    chart.y = {"time per particle-step [ns]", chart::Scale::logarithmic};
    for (const Kind& kind : kinds) {
        chart::Series one{kind.name}, floor{"", {}, {}, chart::Draw::theory};
        floor.like_last = true;
        for (const Times& t : kind.times) {
            const auto n = static_cast<double>(t.particles);
            one.add(n, t.one_pass), floor.add(n, t.floor());
            one.notes.push_back(lab::rounded(t.one_pass / t.floor(), "%.2f times the reference"));
        }
        chart.series.push_back(one), chart.series.push_back(floor);
    }
    chart::write_svg(chart, report.path("scale.svg"));
}

void draw_against_floor(lab::Report& report, const std::vector<Kind>& kinds) {
    chart::Chart chart;
    chart.title = "One pass over memory instead of three: the same bits, sooner";
    chart.subtitle =
        "One core, " + std::string(methods::semi_implicit_euler.name) +
        ": force, kick and drift one after the other, or all in one pass over memory.";
    chart.x = {"time per particle-step [ns]", chart::Scale::linear, 0};
    for (const Kind& kind : kinds)
        for (const std::size_t n : {std::size_t{1000}, std::size_t{1'000'000}}) {
            const auto near = std::min_element(
                kind.times.begin(), kind.times.end(), [&](const Times& a, const Times& b) {
                    return std::abs(std::log(double(a.particles) / double(n))) <
                           std::abs(std::log(double(b.particles) / double(n)));
                });
            const std::string of = (n == 1000 ? "10³ " : "10⁶ ") + kind.plural;
            const auto bar = [&](const std::string& way, double time, const Look& look) {
                chart::Bar one{of + way, time, near->floor()};
                one.text = lab::rounded(time, "%.2g ns, ") +
                           lab::rounded(time / near->floor(), "%.1f× the reference");
                one.look = look;
                chart.bars.push_back(one);
            };
            bar(", verbs", near->verbs, variant(methods::semi_implicit_euler.look));
            bar(", one pass", near->one_pass, methods::semi_implicit_euler.look);
            const std::string key = "scale." + kind.word + (n == 1000 ? "_cache" : "_memory");
            const std::string shown = "scale_floor.svg";
            report.number(key + ".verbs", near->verbs, "ns", shown);
            report.number(key + ".one_pass", near->one_pass, "ns", shown);
            report.number(key + ".floor", near->floor(), "ns", shown);
            if (kind.word == std::string("anchored"))
                report.number(key + ".floor_spread", near->slowest_floor / near->floor());
            report.number(key + ".verbs_over_floor", near->verbs / near->floor(), "", shown);
            report.number(key + ".one_pass_over_floor", near->one_pass / near->floor(), "",
                          shown);
        }
    chart::write_svg(chart, report.path("scale_floor.svg"));
}

/// A cloth of one size and mass, finer and finer: more points, and smaller steps.
void finer_cloth(lab::Report& report, const std::vector<Times>& times) {
    constexpr double side = 2, mass = 0.4, stiffness = 100,
                     part_of_limit = 0.9;  // [m], [kg], [N/m]
    chart::Chart chart;
    chart.title = "Half the mesh, eight times the work";
    chart.subtitle = lab::rounded(side) + " m × " + lab::rounded(side) + " m, " +
                     methods::semi_implicit_euler.name + " at " + lab::rounded(part_of_limit) +
                     " of its limit: more points, and smaller steps.";
    chart.x = {"points along a side", chart::Scale::logarithmic};
    chart.y = {"processor time per simulated second [s/s]", chart::Scale::logarithmic};
    chart.tolerance = {1, "as fast as the clock, on one core"};
    chart::Series cost{"", {}, {}, chart::Draw::line_and_marks};
    cost.look = methods::semi_implicit_euler.look;
    double finest_in_time = 0;
    for (const Times& t : times) {
        const double n = std::sqrt(static_cast<double>(t.particles)),
                     each = mass / static_cast<double>(t.particles);
        const SpringNet net = cloth(4, side, 16 * each, stiffness, Weave::with_shear_and_bend);
        const double step = part_of_limit * 2 / cloth_frequency(net.springs.kinds, each, 180);
        const double seconds = 1e-9 * t.one_pass * static_cast<double>(t.particles) / step;
        if (n < 6) continue;  // too few points for the limit of an endless cloth
        cost.add(n, seconds);
        cost.notes.push_back(lab::rounded(1 / step, "%.0f steps a second"));
        if (seconds > 1 && finest_in_time == 0 &&
            cost.y.size() > 1) {  // where the line crosses one second, log-log
            const std::size_t now = cost.y.size() - 1;
            const double part =
                std::log(1 / cost.y[now - 1]) / std::log(cost.y[now] / cost.y[now - 1]);
            finest_in_time = cost.x[now - 1] * std::pow(cost.x[now] / cost.x[now - 1], part);
        }
    }
    const std::size_t last = cost.x.size() - 1;
    chart.series.push_back(cost);
    chart.guides = {2, 3};
    chart.guide_name = "slope";
    const double slope = std::log(cost.y[last] / cost.y[1]) / std::log(cost.x[last] / cost.x[1]);
    report.number("cloth.finer.slope", slope);
    report.number("cloth.finer.in_time", finest_in_time);
    report.number("cloth.finer.million", cost.y[last], "s");
    report.draw("finer_cloth", chart);
    report.say("cost of a finer cloth grows as (points along a side)^" +
               lab::rounded(slope, "%.2f") + "; " + lab::rounded(finest_in_time, "%.0f") +
               " along a side still run as fast as the clock");
}

}  // namespace

void scale(lab::Report& report) {
    report.heading(
        "Many particles: time per particle-step [ns], and how many times the machine's floor");
    std::vector<Kind> kinds{{"anchored springs", "anchored", "anchored", {}},
                            {"chain", "in a chain", "chain", {}},
                            {"cloth", "in a cloth", "cloth", {}}};
    for (const std::size_t n : std::initializer_list<std::size_t>{
             10, 32, 100, 316, 1000, 3162, 10'000, 31'623, 100'000, 316'228, 1'000'000}) {
        kinds[0].times.push_back(time_anchored(n));
        kinds[1].times.push_back(time_net(timed_chain(n)));
        kinds[2].times.push_back(time_net(timed_cloth(n)));
    }
    lab::Table table{{"scene",
                      "particles",
                      "three verbs",
                      "one pass",
                      "floor of memory",
                      "floor of arithmetic",
                      {"times the floor", "%.2f"}},
                     {}};
    for (const Kind& kind : kinds)
        for (const Times& t : kind.times)
            table.add({kind.name, t.particles, t.verbs, t.one_pass, t.streaming, t.arithmetic,
                       t.one_pass / t.floor()});
    report.print(table);
    report.data("scale.csv", table);
    draw_time_against_number(report, kinds);
    draw_against_floor(report, kinds);
    finer_cloth(report, kinds[2].times);
}

}  // namespace nutshell
