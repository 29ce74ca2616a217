// What turning points and composing poses costs, from one to a million, and when a matrix pays.
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/rotations.hpp>
#include <nutshell/wide_turns.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

const Look matrix_look{Family::plain, Mark::square, ""},
    four_look{Family::symplectic, Mark::diamond, ""},
    unit_look{Family::symplectic, Mark::diamond, "9 4", true};
const std::vector<std::size_t> numbers{1,    3,      10,     32,      100,     316,      1000,
                                       3162, 10'000, 31'623, 100'000, 316'228, 1'000'000};
const Quaternion some_pose = quaternion_about({1, 2, 3}, 0.9);

/// The least time of several rounds for one item [ns]; the ways take turns, so that a while in
/// which the machine is busy hits all of them.
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

chart::Chart turning(lab::Report& report) {
    lab::Table data{{"points", "matrix_ns", "four_vector_ns", "floor_ns"}, {}};
    chart::Chart chart;
    chart.title = "one pose turns many points";
    chart.x = {"points", chart::Scale::logarithmic};
    chart.y = {"time per point [ns]", chart::Scale::logarithmic};
    chart::Series matrix{"matrix, made once"}, four{"4-vector"}, floor{"floor: in and out"};
    matrix.look = matrix_look, four.look = four_look, floor.draw = chart::Draw::theory;
    for (const std::size_t n : numbers) {
        Arrays arrays(6, n);
        const auto best =
            least<3>(n, {[&] {
                             const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> r =
                                 rotation_matrix(some_pose);
                             wide::turn_by_matrix(n, arrays.axes(3), arrays.axes(0), r.data());
                         },
                         [&] {
                             wide::turn_by_four_vector(n, arrays.axes(3), arrays.axes(0),
                                                       some_pose.coeffs().data());
                         },
                         [&] { wide::stream_points(n, arrays.axes(3), arrays.axes(0)); }});
        matrix.x.push_back(double(n)), four.x.push_back(double(n)), floor.x.push_back(double(n));
        matrix.y.push_back(best[0]), four.y.push_back(best[1]), floor.y.push_back(best[2]);
        data.add({std::to_string(n), lab::exact_digits(best[0]), lab::exact_digits(best[1]),
                  lab::exact_digits(best[2])});
        if (n == 1000 || n == 1'000'000) {
            const std::string key = n == 1000 ? "cost.turn_cache." : "cost.turn_memory.";
            report.number(key + "matrix", best[0], "ns");
            report.number(key + "four_vector", best[1], "ns");
            report.number(key + "floor", best[2], "ns");
            report.number(key + "ratio", best[1] / best[0]);
            report.say("turning " + std::to_string(n) + " points: matrix " +
                       lab::rounded(best[0]) + " ns, 4-vector " + lab::rounded(best[1]) +
                       " ns, floor " + lab::rounded(best[2]) + " ns a point");
        }
    }
    chart.series = {matrix, four, floor};
    report.data("cost_turning.csv", data);
    return chart;
}

chart::Chart composing(lab::Report& report) {
    lab::Table data{{"poses", "matrix_ns", "four_vector_ns", "unit_four_vector_ns"}, {}};
    chart::Chart chart;
    chart.title = "each pose is turned by its own turn";
    chart.x = {"poses", chart::Scale::logarithmic};
    chart.y = {"time per pose [ns]", chart::Scale::logarithmic};
    chart::Series matrix{"matrix"}, four{"4-vector"}, unit{"4-vector, normalised"};
    matrix.look = matrix_look, four.look = four_look, unit.look = unit_look;
    for (const std::size_t n : numbers) {
        // turns by no angle at all: the numbers stay as they are however often it is timed
        Arrays fours(8, n), matrices(18, n);
        for (int i = 0; i < 4; ++i) std::fill_n(fours[4 + i], n, i == 3 ? 1.0 : 0.0);
        for (int i = 0; i < 9; ++i) std::fill_n(matrices[9 + i], n, i % 4 == 0 ? 1.0 : 0.0);
        const auto best = least<3>(
            n, {[&] { wide::compose_matrices(n, matrices.matrices(0), matrices.matrices(9)); },
                [&] { wide::compose_four_vectors(n, fours.fours(0), fours.fours(4)); },
                [&] { wide::compose_unit_four_vectors(n, fours.fours(0), fours.fours(4)); }});
        matrix.x.push_back(double(n)), four.x.push_back(double(n)), unit.x.push_back(double(n));
        matrix.y.push_back(best[0]), four.y.push_back(best[1]), unit.y.push_back(best[2]);
        data.add({std::to_string(n), lab::exact_digits(best[0]), lab::exact_digits(best[1]),
                  lab::exact_digits(best[2])});
        if (n == 1000 || n == 1'000'000) {
            const std::string key = n == 1000 ? "cost.compose_cache." : "cost.compose_memory.";
            report.number(key + "matrix", best[0], "ns");
            report.number(key + "four_vector", best[1], "ns");
            report.number(key + "unit", best[2], "ns");
            report.number(key + "ratio", best[0] / best[1]);
            report.say("composing " + std::to_string(n) + " poses: matrix " +
                       lab::rounded(best[0]) + " ns, 4-vector " + lab::rounded(best[1]) +
                       " ns, normalised " + lab::rounded(best[2]) + " ns a pose");
        }
    }
    chart.series = {matrix, four, unit};
    report.data("cost_composing.csv", data);
    return chart;
}

/// A pose that changes every time, with k points on it: rotate each, or make a matrix first.
void when_to_convert(lab::Report& report) {
    constexpr std::size_t poses = 256;
    std::vector<Quaternion> all;
    for (std::size_t i = 0; i < poses; ++i)
        all.push_back(quaternion_about({1, 2, 3}, 0.01 * static_cast<double>(i)));
    chart::Chart chart;
    chart.title = "When does the matrix pay?";
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
        const auto best = least<2>(poses, {[&] {
                                               for (const Quaternion& q : all) {
                                                   const Matrix3 r = rotation_matrix(q);
                                                   for (std::size_t i = 0; i < k; ++i)
                                                       turned_points[i] = r * points[i];
                                                   lab::keep(turned_points[0]);
                                               }
                                           },
                                           [&] {
                                               for (const Quaternion& q : all) {
                                                   for (std::size_t i = 0; i < k; ++i)
                                                       turned_points[i] = rotate(q, points[i]);
                                                   lab::keep(turned_points[0]);
                                               }
                                           }});
        const auto x = static_cast<double>(k);
        matrix.x.push_back(x), four.x.push_back(x);
        matrix.y.push_back(best[0]), four.y.push_back(best[1]);
        table.add({std::to_string(k), lab::rounded(best[0]), lab::rounded(best[1])});
        if (best[0] > best[1]) pays_from = 0;
        if (best[0] <= best[1] && pays_from == 0) pays_from = x;
    }
    report.print(table);
    chart.series = {matrix, four};
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
