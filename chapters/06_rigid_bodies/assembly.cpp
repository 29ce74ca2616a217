// Assembling: one body out of several, three ways, and what the slips of the source make of it.
#include <nutshell/chart/chart.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/obj.hpp>
#include <nutshell/thrown_scenes.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

double apart(const Matrix3& a, const Matrix3& b) {
    return (a - b).norm() / b.norm();
}

struct Thing {
    std::string name;
    std::vector<Block> blocks;
};

void three_ways(lab::Report& report) {
    report.heading("Assembly three ways: boxes, meshes, clouds of particles");
    lab::Table table{
        {"thing", "mass [kg]", "largest moment [kg m^2]", "meshes off by", "1 cm cells off by"},
        {}};
    chart::Chart chart;
    chart.title = "A cloud of particles has too little inertia";
    chart.subtitle = "Cut into cubes, each taken for a point. Dashed: m h²/6 is missing.";
    chart.x = {"edge of a cell, h [m]", chart::Scale::logarithmic};
    chart.y = {"inertia missing, part of the whole", chart::Scale::logarithmic};
    chart.guides = {2};
    lab::Table data{{"thing", "cell", "missing"}, {}};
    double worst_mesh = 0, worst_law = 0;
    for (const Thing& thing :
         {Thing{"dumbbell", dumbbell()}, {"hammer", hammer()}, {"T-handle", t_handle()}}) {
        const MassProperties exact = by_boxes(thing.blocks), skin = by_meshes(thing.blocks);
        worst_mesh = std::max(worst_mesh, apart(skin.inertia, exact.inertia));
        chart::Series found{thing.name}, law{""};
        law.draw = chart::Draw::theory;
        double at_1_cm = 0;
        for (const double cell : {0.01, 0.005, 0.0025}) {
            const MassProperties cloud = by_particles(thing.blocks, cell);
            const double off = apart(cloud.inertia, exact.inertia);
            const double predicted = std::sqrt(3.0) * exact.mass * cell * cell / 6 /
                                     exact.inertia.norm();  // of three moments alike
            worst_law = std::max(worst_law, std::abs(off / predicted - 1));
            if (cell == 0.01) at_1_cm = off;
            found.x.push_back(cell), found.y.push_back(off);
            law.x.push_back(cell), law.y.push_back(predicted);
            data.add({thing.name, lab::exact_digits(cell), lab::exact_digits(off)});
        }
        chart.series.push_back(found), chart.series.push_back(law);
        const PrincipalAxes axes =
            principal_axes((exact.inertia + exact.inertia.transpose()) / 2);
        table.add({thing.name, lab::rounded(exact.mass), lab::rounded(axes.moments.maxCoeff()),
                   lab::rounded(apart(skin.inertia, exact.inertia)), lab::rounded(at_1_cm)});
        const std::string key = "assembly." + key_of(thing.name);
        report.number(key + ".mass", exact.mass, "kg");
        report.number(key + ".cell_1_cm", at_1_cm);
    }
    report.print(table);
    report.number("assembly.meshes_off", worst_mesh);
    report.number("assembly.law_off", worst_law);
    report.data("assembly.csv", data);
    chart::write_svg(chart, report.path("cloud.svg"));

    // what each way costs, for the hammer
    const auto blocks = hammer();
    report.number("assembly.boxes.ns", 1e9 * lab::time_of([&] { lab::keep(by_boxes(blocks)); }),
                  "ns");
    report.number("assembly.meshes.ns", 1e9 * lab::time_of([&] { lab::keep(by_meshes(blocks)); }),
                  "ns");
    report.number("assembly.cloud.ns",
                  1e9 * lab::time_of([&] { lab::keep(by_particles(blocks, 0.005)); }), "ns");
}

void the_hammer(lab::Report& report) {
    report.heading("The hammer");
    const MassProperties thing = by_boxes(hammer());
    const Vector3 grip(0, -0.15, 0);
    const Matrix3 at_grip = inertia_about(thing, grip);
    report.number("hammer.mass", thing.mass, "kg");
    report.number("hammer.shaft", hammer()[0].mass(), "kg");
    report.number("hammer.head", hammer()[1].mass(), "kg");
    report.number("hammer.centre", (thing.centre - grip).norm(), "m");
    report.number("hammer.inertia", thing.inertia(2, 2), "kg m^2");
    report.number("hammer.at_grip", at_grip(2, 2), "kg m^2");
    report.number("hammer.ratio", at_grip(2, 2) / thing.inertia(2, 2));
    const Matrix3 wrong = thing.inertia - parallel_axis(thing.mass, grip - thing.centre);
    report.number("hammer.wrong_sign", wrong(2, 2), "kg m^2");
    report.say("About its centre " + lab::rounded(thing.inertia(2, 2)) +
               " kg m^2, about the end of its shaft " + lab::rounded(at_grip(2, 2)) +
               "; with the sign wrong " + lab::rounded(wrong(2, 2)) + ": " +
               why_impossible(wrong.diagonal()) + ".");
    const Mesh head = course_meshes().at(1).second;
    report.number("hammer.head_corners", static_cast<double>(head.vertices.size()));
    report.number("hammer.head_triangles", static_cast<double>(head.triangles.size()));
}

/// The source's sum of two bodies, one slip at a time.
void slips(lab::Report& report) {
    report.heading("What slips cost");
    // two equal bars crossed: one along x, one a quarter turn about z
    const Vector3 bar = box_inertia(1, {1, 0.1, 0.1});
    const std::vector<Part> cross = {solid(1, bar, {0, 0, 0}),
                                     solid(1, bar, {0, 0, 0}, rotation_z(pi / 2))};
    const Matrix3 right = assemble(cross).inertia, unturned = 2 * Matrix3(bar.asDiagonal());
    report.number("slips.cross.right", right(0, 0), "kg m^2");
    report.number("slips.cross.unturned", unturned(0, 0), "kg m^2");
    // two bodies that pass each other and are caught by a rope: only the orbits have L
    const Body left{1, {1, 1, 1}, {0, 0, 0}, {0, -1, 0}, Quaternion::Identity(), Vector3::Zero()};
    const Body other{1, {1, 1, 1}, {2, 0, 0}, {0, 1, 0}, Quaternion::Identity(), Vector3::Zero()};
    const Body pair = joined(std::array{left, other});
    report.number("slips.pair.L", pair.angular_momentum.z(), "kg m^2/s");
    report.number("slips.pair.printed", (left.angular_momentum + other.angular_momentum).z(),
                  "kg m^2/s");
    // the centre with a plus for a times
    report.number("slips.centre.right", (1 * 1.0 + 2 * 5.0) / 3, "m");
    report.number("slips.centre.printed", (1 * 1.0 + 2 + 5.0) / 3, "m");
    report.say("Two bars crossed: " + lab::rounded(right(0, 0)) +
               " kg m^2 about one of them; with neither turned " + lab::rounded(unturned(0, 0)) +
               ".");
}

}  // namespace

void assembly(lab::Report& report) {
    three_ways(report);
    the_hammer(report);
    slips(report);
}

}  // namespace nutshell
