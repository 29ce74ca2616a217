// A million turns: what is left of a rotation, for every way to keep it and several axes.
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/many_turns.hpp>
#include <nutshell/need.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

const std::vector<Vector3> stated_axes{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 2, 3}, {0.1, 1, 0.2}};
const Need pixel{1.0 / 300, "", "one pixel at the end of an arm of 300 pixels"};

Look look_of(Keeper keeper) {
    switch (keeper) {
        case Keeper::printed_matrix:
            return {Family::explicit_one_step, Mark::triangle_down, "8 3"};
        case Keeper::float_matrix:
            return {Family::runge_kutta, Mark::square, "9 4", true};
        case Keeper::double_matrix:
            return {Family::runge_kutta, Mark::square, ""};
        case Keeper::float_four_vector:
            return {Family::peer, Mark::circle, "9 4", true};
        case Keeper::double_four_vector:
            return {Family::peer, Mark::circle, ""};
        case Keeper::float_four_vector_unit:
            return {Family::symplectic, Mark::diamond, "9 4", true};
        default:
            return {Family::symplectic, Mark::diamond, ""};
    }
}

std::string key_of(Keeper keeper) {
    constexpr std::array keys{"printed",       "float_matrix", "float_4",      "float_4_unit",
                              "double_matrix", "double_4",     "double_4_unit"};
    return keys[static_cast<std::size_t>(keeper)];
}

/// The least and the most of a number over the stated axes.
struct Spread {
    double least = 1e300, most = 0;
    void add(double x) { least = std::min(least, x), most = std::max(most, x); }
    std::string text() const {
        return lab::rounded(least, "%.1e") + " - " + lab::rounded(most, "%.1e");
    }
};

/// Nanoseconds of one turn, each waiting for the one before, as in a game.
double nanoseconds(Keeper keeper) {
    const ManyTurns scene{{1, 2, 3}, 0.008, 2000};
    double least = 1e300;
    for (int i = 0; i < 3; ++i)
        least = std::min(least, lab::time_of([&] { lab::keep(wear(scene, keeper)); }, 1));
    return 1e9 * least / static_cast<double>(scene.turns);
}

/// How many turns a float 4-vector that is divided each time stays within the need, about the worst
/// of the stated axes; looked at every hundred thousand.
long float_is_enough() {
    struct Kept {
        ManyTurns scene;
        Eigen::Quaternionf step, pose{1, 0, 0, 0};
    };
    std::vector<Kept> all;
    for (const Vector3& axis : stated_axes)
        all.push_back({{axis}, quaternion_about(axis, ManyTurns{}.angle).cast<float>()});
    constexpr long block = 100'000, most = 100'000'000;
    for (long turns = block; turns <= most; turns += block)
        for (Kept& kept : all) {
            for (long i = 0; i < block; ++i)
                kept.pose = kept.step * kept.pose, kept.pose.normalize();
            if (wear_of(kept.pose.cast<double>(), kept.scene.exact(turns)).angle >
                pixel.tolerance)
                return turns - block;
        }
    return most;
}

void by_number_of_turns(lab::Report& report) {
    chart::Figure figure;
    figure.title = "Only dividing keeps the stretch away";
    figure.subtitle = "Turns of 0.008 rad about (1, 2, 3). Down is better.";
    chart::Chart stretch, angle;
    stretch.title = "stretch: RᵀR is not 1", angle.title = "turned too far or too little";
    stretch.y = {"|RᵀR − 1|", chart::Scale::logarithmic};
    angle.y = {"angle off [rad]", chart::Scale::logarithmic};
    lab::Table data{{"turns", "keeper", "stretch", "angle"}, {}};
    for (const Keeper keeper : keepers) {
        if (keeper == Keeper::double_matrix || keeper == Keeper::double_four_vector_unit)
            continue;
        chart::Series s{name_of(keeper)}, a{name_of(keeper)};
        s.look = a.look = look_of(keeper);
        for (const long turns : {100L, 1000L, 10'000L, 100'000L, 1'000'000L}) {
            const Wear worn = wear({{1, 2, 3}, 0.008, turns}, keeper);
            s.x.push_back(static_cast<double>(turns)), a.x.push_back(static_cast<double>(turns));
            s.y.push_back(worn.stretch), a.y.push_back(worn.angle);
            data.add({std::to_string(turns), name_of(keeper), lab::exact_digits(worn.stretch),
                      lab::exact_digits(worn.angle)});
        }
        stretch.series.push_back(s), angle.series.push_back(a);
    }
    for (chart::Chart* one : {&stretch, &angle}) {
        one->x = {"turns", chart::Scale::logarithmic};
        one->tolerance = {pixel.tolerance, "one pixel, arm of 300"};
    }
    figure.panels = {stretch, angle};
    report.data("million.csv", data);
    chart::write_svg(figure, report.path("million.svg"));
}

}  // namespace

void million_turns(lab::Report& report) {
    report.heading("A million turns of 0.008 rad about five axes: least and most");
    lab::Table table{{"kept as", "|R^T R - 1|", "angle off [rad]", "ns a turn"}, {}};
    lab::Table data{{"kept_as", "stretch_least", "stretch_most", "angle_most"}, {}};
    chart::Ranking ranking;
    ranking.subtitle =
        "Stretch and angle, worst of five axes; processor time, one after another.";
    ranking.columns = {"time of one turn [ns]"};
    double cheapest = 1e300;
    for (const Keeper keeper : keepers) {
        Spread stretch, angle;
        for (const Vector3& axis : stated_axes) {
            const Wear worn = wear({axis}, keeper);
            stretch.add(worn.stretch), angle.add(worn.angle);
        }
        const double time = nanoseconds(keeper);
        table.add({name_of(keeper), stretch.text(), angle.text(), lab::rounded(time)});
        data.add({name_of(keeper), lab::exact_digits(stretch.least),
                  lab::exact_digits(stretch.most), lab::exact_digits(angle.most)});
        const std::string key = "million." + key_of(keeper);
        report.number(key + ".stretch_least", stretch.least);
        report.number(key + ".stretch_most", stretch.most);
        report.number(key + ".ns", time, "ns");
        chart::Ranking::Row row{name_of(keeper), look_of(keeper)};
        if (std::max(stretch.most, angle.most) <= pixel.tolerance)
            row.values = {time};
        else
            row.instead = "no: stretched by " + lab::rounded(stretch.most, "%.2g");
        ranking.rows.push_back(row);
        if (!row.values.empty() && row.values.front() < cheapest)
            cheapest = row.values.front(),
            ranking.title = "A rotation for a million turns costs least as a " + row.name;
    }
    report.print(table);
    report.data("million_spread.csv", data);
    // where the stretch comes from: the same with the step rounded to float and its turns in double
    double rest = 0;
    for (const Vector3& axis : stated_axes)
        for (const Keeper keeper :
             {Keeper::printed_matrix, Keeper::float_matrix, Keeper::float_four_vector})
            rest = std::max(rest, std::abs(wear_by_step_alone({axis}, keeper).stretch /
                                               wear({axis}, keeper).stretch -
                                           1));
    report.number("million.not_the_step", rest);
    report.number("million.float_enough", static_cast<double>(float_is_enough()), "turns");
    const Wear source = wear({{1, 2, 3}}, Keeper::printed_matrix);
    report.number("million.source.stretch", source.stretch);
    report.number("million.need", pixel.tolerance);
    report.say(
        "The source's own: printed Rotation in float about (1, 2, 3) ends with |R^T R - 1| = " +
        lab::rounded(source.stretch) + " and det R = " + lab::rounded(source.volume) + ".");
    chart::write_svg(ranking, report.path("million_cost.svg"));
    by_number_of_turns(report);
}

}  // namespace nutshell
