// Two balls meet: head-on and beside the centre.
#include <nutshell/impact_scenes.hpp>
#include "program.hpp"

namespace nutshell {

void head_on(lab::Report& report) {
    report.heading("Head-on: 1 kg at 2 m/s meets 2 kg at -1 m/s");
    lab::Table table{{"restitution", "a after [m/s]", "b after [m/s]", "energy left [J]"}, {}};
    for (const double e : {1.0, 0.5, 0.0}) {
        TwoBalls scene = TwoBalls::head_on();
        scene.restitution = e;
        collide(scene.a, scene.b, scene.normal(), e);
        const double left = kinetic_energy(scene.a) + kinetic_energy(scene.b);
        table.add({lab::rounded(e), lab::rounded(velocity(scene.a).x()),
                   lab::rounded(velocity(scene.b).x()), lab::rounded(left)});
        const std::string key = "head_on." + lab::rounded(e, "%.1f");
        report.number(key + ".a", velocity(scene.a).x(), "m/s");
        report.number(key + ".b", velocity(scene.b).x(), "m/s");
        report.number(key + ".energy", left, "J");
    }
    report.print(table);
}

}  // namespace nutshell
