// Single turns: two in either order, the printed matrices, and how small a small turn must be.
#include <nutshell/chart/chart.hpp>
#include <nutshell/rotation_scenes.hpp>
#include "printed.hpp"
#include "program.hpp"

namespace nutshell {

namespace {

constexpr double degrees = 180 / pi;

double unrotated(const Matrix3& r) {
    return (r.transpose() * r - Matrix3::Identity()).norm();
}

}  // namespace

void order(lab::Report& report) {
    report.heading("Order: a quarter turn about x and one about z");
    const TwoQuarterTurns turns;
    report.number("order.apart", turns.apart() * degrees, "degrees");
    lab::Table table{{"first", "then", "axis", "angle [degrees]"}, {}};
    const auto row = [&](const char* first, const char* then, const char* key,
                         const Quaternion& q) {
        const Vector3 a = logarithm(q), n = a.normalized();
        table.add({first, then,
                   "(" + lab::rounded(n.x()) + ", " + lab::rounded(n.y()) + ", " +
                       lab::rounded(n.z()) + ")",
                   lab::rounded(a.norm() * degrees)});
        report.number(std::string("order.") + key + ".angle", a.norm() * degrees, "degrees");
    };
    row("x", "z", "x_first", turns.one_first());
    row("z", "x", "z_first", turns.other_first());
    report.print(table);
    report.say("The two ends are " + lab::rounded(turns.apart() * degrees) + " degrees apart.");
    // small turns nearly commute: the ends differ by the product of the two angles
    for (const double angle : {0.1, 0.01}) {
        const TwoQuarterTurns small{quaternion_about(Vector3::UnitX(), angle),
                                    quaternion_about(Vector3::UnitZ(), angle)};
        report.number("order.small." + lab::rounded(angle), small.apart(), "rad");
    }
}

void printed_matrices(lab::Report& report) {
    report.heading("The printed matrices: a turn by 60 degrees about (1, 2, 3)");
    const Vector3 n = direction_of({1, 2, 3});
    const double angle = pi / 3;
    const Quaternion q = quaternion_about(n, angle);
    lab::Table table{{"matrix", "|R^T R - 1|", "det R"}, {}};
    const auto row = [&](const char* name, const char* key, const Matrix3& r) {
        table.add({name, lab::rounded(unrotated(r)), lab::rounded(r.determinant(), "%.3f")});
        report.number(std::string(key) + ".stretch", unrotated(r));
        report.number(std::string(key) + ".volume", r.determinant());
    };
    row("(26) as printed", "printed.26", printed::rotation_about(n, angle));
    row("(26*)", "corrected.26", rotation_about(n, angle));
    row("(28) as printed", "printed.28", printed::rotation_matrix(q));
    row("(28*)", "corrected.28", rotation_matrix(q));
    report.print(table);
    const Matrix3 keeps_volume = Vector3(2, 0.5, 1).asDiagonal();
    report.number("volume_only.volume", keeps_volume.determinant());
    report.number("volume_only.length", (keeps_volume * Vector3::UnitX()).norm());
    report.number("long.stretch", unrotated(rotation_matrix(Quaternion(1.1 * q.coeffs()))));
}

void small_turns(lab::Report& report) {
    const FullTurn scene;
    report.heading("How small is small: one full turn of many small ones");
    lab::Table table{
        {"steps", "one step [degrees]", "length of q, nobody divides", "off [rad], divided"}, {}};
    chart::Figure figure;
    figure.title = "Nobody divides: it grows. Divided: it lags";
    figure.subtitle = "One full turn in equal steps by (30*): too long, and too late.";
    chart::Chart longer, late;
    longer.title = "too long, if nobody divides";
    late.title = "too late, divided each time";
    chart::Series length{"length"}, lag{"lag"}, length_theory{"theory"}, lag_theory{"theory"};
    length.look = Look{Family::explicit_one_step, Mark::circle};
    lag.look = Look{Family::explicit_one_step, Mark::square};
    length_theory.draw = lag_theory.draw = chart::Draw::theory;
    for (const long steps : {6L, 12L, 25L, 50L, 100L, 200L, 400L, 800L}) {
        const double beta = 2 * pi / static_cast<double>(steps), n = static_cast<double>(steps);
        length.x.push_back(n), length.y.push_back(scene.length(steps) - 1);
        length_theory.x.push_back(n);
        length_theory.y.push_back(std::pow(1 + beta * beta / 4, n / 2) - 1);
        lag.x.push_back(n), lag.y.push_back(scene.error(steps));
        lag_theory.x.push_back(n), lag_theory.y.push_back(n * (beta - 2 * std::atan(beta / 2)));
        table.add({std::to_string(steps), lab::rounded(beta * degrees),
                   lab::rounded(scene.length(steps), "%.4f"), lab::rounded(scene.error(steps))});
        report.number("full_turn.length." + std::to_string(steps), scene.length(steps));
        report.number("full_turn.lag." + std::to_string(steps), scene.error(steps) * degrees,
                      "degrees");
    }
    report.print(table);
    long enough = 6;
    while (scene.error(enough) > scene.need.tolerance) ++enough;
    report.number("full_turn.need", scene.need.tolerance, "rad");
    report.number("full_turn.enough", static_cast<double>(enough));
    report.number("full_turn.enough_step", 360.0 / static_cast<double>(enough), "degrees");
    report.say("Needs " + scene.need.reason + ": " + std::to_string(enough) +
               " steps a turn, if each is made as long as one.");
    for (chart::Chart* one : {&longer, &late}) {
        one->x = {"steps in a full turn", chart::Scale::logarithmic};
        one->y = {"", chart::Scale::logarithmic};
    }
    longer.y.name = "length − 1", late.y.name = "angle missing [rad]";
    longer.guides = {-1}, late.guides = {-2};
    late.tolerance = {scene.need.tolerance, "one pixel, arm of 300"};
    longer.series = {length, length_theory}, late.series = {lag, lag_theory};
    figure.panels = {longer, late};
    chart::write_svg(figure, report.path("small_turns.svg"));
}

}  // namespace nutshell
