// The arch: how thick it must be by statics and by the engine, what its joints pass on, and when it
// slides.
#include <nutshell/chart/chart.hpp>
#include <nutshell/chart/diagram.hpp>
#include <nutshell/lab/run.hpp>
#include <nutshell/picture/picture.hpp>
#include "arch_drawings.hpp"
#include "program.hpp"

namespace nutshell {

namespace {

constexpr double dt = 1 / 60.0;

/// Whether an arch stands for its duration: its keystone stays above three quarters of its height.
/// One that lies still (nothing faster than 10 um/s) goes on standing.
bool stands(const Arch& arch) {
    World world = checked(arch.start());
    Engine engine(arch.switches);
    for (long i = 0; i < lab::steps_of(arch.duration, dt); ++i) {
        engine.step(world, dt);
        if (arch.sunk(world) > arch.radius / 4) return false;
        if (i > 60 && i % 10 == 0 && top_speed(world) < 1e-5) return true;
    }
    return true;
}

/// The least of a number with which the arch stands, between one with which it falls and one with
/// which it stands, to `part` of their distance.
template <class Change>
double least(Arch arch, double falls, double holds, double part, const Change& change) {
    const double enough = part * (holds - falls);
    while (holds - falls > enough) {
        const double middle = (falls + holds) / 2;
        change(arch, middle);
        (stands(arch) ? holds : falls) = middle;
    }
    return holds;
}
double thickness_by_engine(const Arch& arch) {
    const double statics = least_thickness(arch);
    return least(arch, 0.9 * statics, 1.5 * statics, 1 / 256.0,
                 [](Arch& one, double thickness) { one.thickness = thickness; });
}

/// Two halves of the truth: the thickness that statics asks for and the engine.
void thicknesses(lab::Report& report) {
    lab::Table table{{"stones", "statics, t/r", "4 sub-steps", "16 sub-steps"}, {}};
    chart::Series statics{"statics"}, four{"4 sub-steps"}, sixteen{"16 sub-steps"};
    statics.look = Look{Family::exact, Mark::circle};
    four.look = Look{Family::symplectic, Mark::square};
    sixteen.look = Look{Family::symplectic, Mark::triangle};
    for (const int stones : {5, 7, 9, 11, 13, 15, 19}) {
        Arch arch;
        arch.stones = stones;
        const double by_statics = least_thickness(arch) / arch.radius;
        const double by_four = thickness_by_engine(arch) / arch.radius;
        arch.switches.sub_steps = 16;
        const double by_sixteen = thickness_by_engine(arch) / arch.radius;
        statics.add(stones, by_statics), four.add(stones, by_four);
        sixteen.add(stones, by_sixteen);
        table.add({std::to_string(stones), lab::rounded(by_statics), lab::rounded(by_four),
                   lab::rounded(by_sixteen)});
        const std::string key = "arch." + std::to_string(stones);
        report.number(key + ".statics", by_statics, "", "arch_stones.svg");
        report.number(key + ".four", by_four, "", "arch_stones.svg");
        report.number(key + ".four_more", by_four / by_statics - 1, "", "arch_stones.svg");
        report.number(key + ".sixteen", by_sixteen, "", "arch_stones.svg");
        report.number(key + ".sixteen_more", by_sixteen / by_statics - 1, "", "arch_stones.svg");
    }
    report.print(table);
    Arch many;
    many.stones = 2001;
    report.number("arch.many", least_thickness(many) / many.radius);

    chart::Chart chart;
    chart.title = "How thick an arch must be";
    chart.subtitle =
        "Half a circle of equal stones; 10 s, steps of 1/60 s. Below its line an arch falls.";
    chart.x = {"stones"};
    chart.y = {"least thickness, of the middle radius"};
    chart.levels_y = {{0.1075, "Milankovitch, 1907"}};
    chart.series = {four, sixteen, statics};
    chart::write_svg(chart, report.path("arch_stones.svg"));
}

/// What the joints of standing arches pass on, beside what statics allows.
void thrust(lab::Report& report) {
    lab::Table table{{"t/r", "thrust / half weight", "from", "to", "crown sunk [mm]"}, {}};
    for (const int hundredths : {12, 20, 30}) {
        Arch arch;
        arch.thickness = arch.radius * hundredths / 100;
        World world = checked(arch.start());
        Engine engine(arch.switches);
        const long steps = lab::steps_of(arch.duration, dt);
        const double begin = lab::processor_seconds();
        for (long i = 0; i < steps; ++i) engine.step(world, dt);
        const double took = lab::processor_seconds() - begin;
        double force = 0;
        for (const Passed& joint : passed_on(arch, world, engine, dt / arch.switches.sub_steps))
            force += joint.force.x() / (arch.stones + 1);
        const double half = joints_of(arch).back().weight;
        const Range allowed = thrusts(arch).value();
        table.add({lab::rounded(hundredths / 100.0), lab::rounded(force / half),
                   lab::rounded(allowed.low / half), lab::rounded(allowed.high / half),
                   lab::rounded(1000 * arch.sunk(world))});
        const std::string key = "arch.thrust." + std::to_string(hundredths);
        report.number(key, force / half);
        report.number(key + ".least", allowed.low / half);
        report.number(key + ".most", allowed.high / half);
        report.number(key + ".share", (force - allowed.low) / (allowed.high - allowed.low));
        report.number(key + ".sunk", arch.sunk(world), "m");
        if (hundredths == 20)
            report.number("arch.us", 1e6 * took / static_cast<double>(steps) / arch.stones, "us");
    }
    report.print(table);
}

/// The friction below which an arch slides apart, and what a hull costs.
void sliding(lab::Report& report) {
    Arch arch;
    arch.thickness = 0.3 * arch.radius, arch.switches.sub_steps = 16;
    const double statics = least_friction(arch);
    report.number("arch.friction.statics", statics);
    report.number("arch.friction.thickness", arch.thickness / arch.radius);
    report.number("arch.friction.engine",
                  least(arch, 0.93 * statics, 1.1 * statics, 1 / 64.0,
                        [](Arch& one, double friction) { one.friction = friction; }));
    const Box box{{0.5, 0.4, 0.3}};
    const Hull hull = box_hull(box.half);
    Body low, high;
    high.position = {0.1, 0.79, 0.1}, high.orientation = quaternion_about(Vector3::UnitY(), 0.3);
    const auto us = [&](const auto& shape) {
        std::vector<Contact> found;
        const double begin = lab::processor_seconds();
        for (int i = 0; i < 20000; ++i)
            found.clear(), find_contacts(shape, low, shape, high, 0.01, found);
        return (lab::processor_seconds() - begin) / 20000 * 1e6;
    };
    report.number("arch.box_us", us(box), "us");
    report.number("arch.hull_us", us(hull), "us");
}

/// The right half, cut free: its weight, the thrust at the crown and what the foot answers.
void half_arch(lab::Report& report) {
    Arch arch;
    arch.thickness = 0.16 * arch.radius;
    const std::vector<Joint> joints = joints_of(arch);
    const Range allowed = thrusts(arch).value();
    const double force = (allowed.low + allowed.high) / 2, weight = joints.back().weight;
    const Range moments = window(arch, joints, force);
    const double moment = (moments.low + moments.high) / 2, long_as = 1.2 / weight;  // [m/N]
    chart::Diagram half;
    half.title = "Half an arch, cut free";
    const double a = arch.wedge() / 2;
    const auto at = [](double r, double angle) {
        return chart::Place{r * std::sin(angle), r * std::cos(angle)};
    };
    half.polygon({{0, arch.inside() * std::cos(a)},
                  at(arch.inside(), a),
                  at(arch.outside(), a),
                  {0, arch.outside() * std::cos(a)}});
    for (std::size_t k = 1; k < joints.size(); ++k)
        half.polygon({at(arch.inside(), joints[k - 1].angle), at(arch.inside(), joints[k].angle),
                      at(arch.outside(), joints[k].angle),
                      at(arch.outside(), joints[k - 1].angle)});
    std::vector<chart::Place> line{{0, moment / force}};
    for (const Joint& joint : joints)
        line.push_back(at(crossing(joint, force, moment), joint.angle));
    half.dashed(line);
    const chart::Place crown = line.front(), foot = line.back();
    half.arrow({crown.x - long_as * force, crown.y}, {long_as * force, 0}, chart::Quantity::force,
               "H");
    const double x = joints.back().moment / weight;
    const chart::Place middle{x, 0.62 * arch.radius};
    half.arrow(middle, {0, -long_as * weight}, chart::Quantity::force, "W");
    half.arrow({foot.x + long_as * force, foot.y - long_as * weight},
               {-long_as * force, long_as * weight}, chart::Quantity::force, "F");
    half.wall({arch.inside() - 0.3, 0}, {arch.outside() + 0.5, 0});
    chart::write_svg(half, report.path("arch_half.svg"));
}

/// Three arches, before and after.
void pictures_of(lab::Report& report, const std::string& file, double time) {
    const pic::Note note{report.command(),
                         "three arches of eleven stones",
                         "our engine",
                         "1/60 s",
                         {{"at", time, "s"}}};
    pic::save(report.path(file + ".png"), note, [&]() -> pic::Sheet {
        pic::Sheet sheet;
        for (const int hundredths : {8, 10, 12}) {
            Arch arch;
            arch.thickness = arch.radius * hundredths / 100;
            World world = arch.start();
            Engine engine(arch.switches);
            for (long i = 0; i < std::lround(time / dt); ++i) engine.step(world, dt);
            pic::Drawing drawing;
            add_arch(drawing, arch, world, world.bodies.size());
            drawing.title(std::to_string(hundredths) + " % of the radius");
            const pic::Size size{480, 300};
            sheet.shots.push_back({drawing, arch_camera(arch, size), size});
        }
        return sheet;
    });
}

/// One that is too thin, while it falls.
void falling(lab::Report& report) {
    Arch arch;
    arch.thickness = 0.1 * arch.radius, arch.switches.sub_steps = 16;
    const pic::Note note{report.command(),
                         "an arch of eleven stones that is too thin",
                         "our engine, 16 sub-steps",
                         "1/60 s",
                         {{"thickness / radius", 0.1, ""}}};
    pic::save(report.path("arch_falls.png"), note, [&]() -> pic::Sheet {
        pic::Sheet sheet;
        sheet.columns = 3;
        World world = arch.start();
        Engine engine(arch.switches);
        long steps = 0;
        for (const double at : {0.2, 0.6, 0.75, 0.85, 0.95, 1.15}) {
            for (; steps < std::lround(at / dt); ++steps) engine.step(world, dt);
            pic::Drawing drawing;
            add_arch(drawing, arch, world, world.bodies.size());
            const auto joints = passed_on(arch, world, engine, dt / arch.switches.sub_steps);
            add_hinges(drawing, arch, world, joints);
            drawing.title(lab::rounded(at) + " s");
            const pic::Size size{480, 270};
            sheet.shots.push_back({drawing, arch_camera(arch, size), size});
        }
        return sheet;
    });
}

}  // namespace

void arch(lab::Report& report) {
    report.heading("An arch of stones without mortar, by statics and by the engine");
    thicknesses(report);
    thrust(report);
    sliding(report);
    half_arch(report);
    pictures_of(report, "arch_question", 0);
    pictures_of(report, "arch_answer", 0.65);
    falling(report);
}

}  // namespace nutshell
