// What turning points and composing poses costs, from one to a million, and when a matrix pays.
#include <memory>
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/rotations.hpp>
#include <nutshell/wide_turns.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

const Look matrix_look{Family::runge_kutta, Mark::square, ""},
    four_look{Family::symplectic, Mark::diamond, ""},
    unit_look{Family::symplectic, Mark::diamond, "9 4", true};
const std::vector<std::size_t> numbers{1,    3,      10,     32,      100,     316,      1000,
                                       3162, 10'000, 31'623, 100'000, 316'228, 1'000'000};
const Quaternion some_pose = quaternion_about({1, 2, 3}, 0.9);

using Loops = std::vector<std::function<void()>>;

/// The least time of several rounds for one item [ns]; the ways take turns, so that a while in
/// which the machine is busy hits all of them.
std::vector<double> least(std::size_t items, const Loops& ways) {
    std::vector<double> best(ways.size(), 1e300);
    for (int round = 0; round < 5; ++round)
        for (std::size_t i = 0; i < ways.size(); ++i)
            best[i] = std::min(best[i],
                               1e9 / static_cast<double>(items) * lab::time_of(ways[i], 1, 5e-4));
    return best;
}

struct Arrays {
    std::vector<std::vector<double>> all;
    Arrays(int count, std::size_t n) {
        for (int i = 0; i < count; ++i) all.emplace_back(n, 0.3 + 0.1 * i);
    }
    double* operator[](int i) { return all[static_cast<std::size_t>(i)].data(); }
    wide::Axes axes(int i) { return {(*this)[i], (*this)[i + 1], (*this)[i + 2]}; }
    wide::FourVectors fours(int i) {
        return {(*this)[i], (*this)[i + 1], (*this)[i + 2], (*this)[i + 3]};
    }
    wide::Matrices matrices(int i) {
        wide::Matrices m;
        for (int k = 0; k < 9; ++k) m[static_cast<std::size_t>(k)] = (*this)[i + k];
        return m;
    }
};

/// One way to do it: its key among the numbers, its line on the chart.
struct Way {
    const char* key;
    chart::Series line;
    Way(const char* its_key, const char* name, const Look& look) : key(its_key), line{name} {
        line.look = look;
    }
    /// What no way can beat.
    explicit Way(const char* floor) : key("floor"), line{floor} {
        line.draw = chart::Draw::theory;
    }
};

/// The time of one `item` by several ways, from one item to a million: a panel, a CSV file, and the
/// numbers in the cache and from memory. `on(n)` makes n items and hands over the loops.
template <class On>
chart::Chart panel(lab::Report& report, const std::string& key, const std::string& item,
                   std::vector<Way> ways, const On& on) {
    lab::Table data{{item + "s"}, {}};
    for (const Way& way : ways) data.columns.push_back(std::string(way.key) + "_ns");
    for (const std::size_t n : numbers) {
        const std::vector<double> best = least(n, on(n));
        std::vector<std::string> row{std::to_string(n)};
        for (std::size_t i = 0; i < ways.size(); ++i) {
            ways[i].line.x.push_back(static_cast<double>(n)), ways[i].line.y.push_back(best[i]);
            row.push_back(lab::exact_digits(best[i]));
        }
        data.add(row);
        if (n != 1000 && n != 1'000'000) continue;
        const std::string at = "cost." + key + (n == 1000 ? "_cache." : "_memory.");
        std::string words = std::to_string(n) + " " + item + "s:";
        for (std::size_t i = 0; i < ways.size(); ++i) {
            report.number(at + ways[i].key, best[i], "ns");
            words += " " + ways[i].line.name + " " + lab::rounded(best[i]) + " ns";
        }
        report.number(at + "ratio", std::max(best[0], best[1]) / std::min(best[0], best[1]));
        report.say(words);
    }
    report.data("cost_" + key + ".csv", data);
    chart::Chart chart;
    chart.x = {item + "s", chart::Scale::logarithmic};
    chart.y = {"time per " + item + " [ns]", chart::Scale::logarithmic};
    for (const Way& way : ways) chart.series.push_back(way.line);
    return chart;
}

chart::Chart turning(lab::Report& report) {
    const auto on = [](std::size_t n) -> Loops {
        const auto points = std::make_shared<Arrays>(6, n);
        return {[=] {
                    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> r =
                        rotation_matrix(some_pose);
                    wide::turn_by_matrix(n, points->axes(3), points->axes(0), r.data());
                },
                [=] {
                    wide::turn_by_four_vector(n, points->axes(3), points->axes(0),
                                              some_pose.coeffs().data());
                },
                [=] { wide::stream_points(n, points->axes(3), points->axes(0)); }};
    };
    chart::Chart chart = panel(report, "turn", "point",
                               {{"matrix", "matrix, made once", matrix_look},
                                {"four_vector", "4-vector", four_look},
                                Way("floor: in and out")},
                               on);
    chart.title = "one pose turns many points";
    return chart;
}

chart::Chart composing(lab::Report& report) {
    const auto on = [](std::size_t n) -> Loops {
        // turns by no angle at all: the numbers stay as they are however often it is timed
        const auto fours = std::make_shared<Arrays>(8, n),
                   matrices = std::make_shared<Arrays>(18, n),
                   eight = std::make_shared<Arrays>(8, n);
        for (int i = 0; i < 4; ++i) std::fill_n((*fours)[4 + i], n, i == 3 ? 1.0 : 0.0);
        for (int i = 0; i < 9; ++i) std::fill_n((*matrices)[9 + i], n, i % 4 == 0 ? 1.0 : 0.0);
        return {[=] { wide::compose_matrices(n, matrices->matrices(0), matrices->matrices(9)); },
                [=] { wide::compose_four_vectors(n, fours->fours(0), fours->fours(4)); },
                [=] { wide::compose_unit_four_vectors(n, fours->fours(0), fours->fours(4)); },
                [=] { wide::stream_four_vectors(n, eight->fours(0), eight->fours(4)); }};
    };
    chart::Chart chart = panel(report, "compose", "pose",
                               {{"matrix", "matrix", matrix_look},
                                {"four_vector", "4-vector", four_look},
                                {"unit", "4-vector, normalised", unit_look},
                                Way("floor: in and out")},
                               on);
    chart.title = "each pose is turned by its own turn";
    return chart;
}

/// Turns all points by each pose in turn: by its matrix, made first, or as they are.
void turn_by_matrices(const std::vector<Quaternion>& poses, const std::vector<Vector3>& points,
                      std::vector<Vector3>& turned_points) {
    for (const Quaternion& q : poses) {
        const Matrix3 r = rotation_matrix(q);
        for (std::size_t i = 0; i < points.size(); ++i) turned_points[i] = r * points[i];
        lab::keep(turned_points[0]);
    }
}
void turn_by_four_vectors(const std::vector<Quaternion>& poses,
                          const std::vector<Vector3>& points,
                          std::vector<Vector3>& turned_points) {
    for (const Quaternion& q : poses) {
        for (std::size_t i = 0; i < points.size(); ++i) turned_points[i] = rotate(q, points[i]);
        lab::keep(turned_points[0]);
    }
}

/// A pose that changes every time, with k points on it: rotate each, or make a matrix first.
void when_to_convert(lab::Report& report) {
    constexpr std::size_t poses = 256;
    std::vector<Quaternion> all;
    for (std::size_t i = 0; i < poses; ++i)
        all.push_back(quaternion_about({1, 2, 3}, 0.01 * static_cast<double>(i)));
    chart::Chart chart;
    chart.subtitle = "A new pose each time, k points on it, plain code. Down is better.";
    chart.x = {"points turned by one pose", chart::Scale::logarithmic};
    chart.y = {"time per pose [ns]", chart::Scale::logarithmic};
    chart::Series matrix{"matrix first"}, four{"4-vector"};
    matrix.look = matrix_look, four.look = four_look;
    double pays_from = 0;
    lab::Table table{{"points", "matrix first [ns]", "4-vector [ns]"}, {}};
    for (const std::size_t k : std::vector<std::size_t>{1, 2, 3, 4, 5, 6, 8, 12, 16, 32, 64}) {
        const std::vector<Vector3> points(k, Vector3(0.3, -1.1, 0.7));
        std::vector<Vector3> turned_points(k);
        const auto best =
            least(poses, {[&] { turn_by_matrices(all, points, turned_points); },
                          [&] { turn_by_four_vectors(all, points, turned_points); }});
        const auto x = static_cast<double>(k);
        matrix.x.push_back(x), four.x.push_back(x);
        matrix.y.push_back(best[0]), four.y.push_back(best[1]);
        table.add({std::to_string(k), lab::rounded(best[0]), lab::rounded(best[1])});
        if (best[0] > best[1]) pays_from = 0;
        if (best[0] <= best[1] && pays_from == 0) pays_from = x;
    }
    report.print(table);
    chart.series = {matrix, four};
    chart.title = "From " + lab::rounded(pays_from) + " points a pose on the matrix pays";
    report.number("cost.pays_from", pays_from);
    report.number("cost.one_by_matrix", matrix.y.front(), "ns");
    report.number("cost.one_by_four_vector", four.y.front(), "ns");
    chart::write_svg(chart, report.path("cost_convert.svg"));
    report.say("the matrix pays from " + lab::rounded(pays_from) + " points a pose");
}

}  // namespace

void cost(lab::Report& report) {
    report.heading("What it costs");
    chart::Figure figure;
    figure.title = "A matrix for points, a 4-vector for poses";
    figure.subtitle =
        "Arrays, one core; what memory costs is on the right of each. Down is better.";
    figure.panels = {turning(report), composing(report)};
    chart::write_svg(figure, report.path("cost.svg"));
    when_to_convert(report);
}

}  // namespace nutshell
