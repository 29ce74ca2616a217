// The throw of chapter 1 in momentum, and many forces at once.
#include <algorithm>
#include <nutshell/lab/need_chart.hpp>
#include <nutshell/newton_methods.hpp>
#include <nutshell/revised_newton_scenes.hpp>
#include "program.hpp"

namespace nutshell {

void momentum_throw(lab::Report& report) {
    const long rate = 60;  // [steps/s]
    const double duration = ThrownBall{}.duration;
    const long steps = lab::steps_of(duration, 1.0 / rate);
    report.heading("The same throw in momentum: " + lab::rounded(duration) + " s in steps of 1/" +
                   std::to_string(rate) + " s");
    lab::Table table{
        {"mass [kg]", "method", "position, difference [m]", "velocity, difference [m/s]"}, {}};
    double same_bits = 0, any_mass = 0;
    const auto compare = [&](double mass, const auto& method) {
        const MomentumThrow scene = MomentumThrow::of_mass(mass);
        const PointMass one = lab::run(scene.ball, method, steps);
        const Particle other = lab::run(scene, method, steps);
        const double place = (one.position - other.position).norm(),
                     speed = (one.velocity - velocity(other)).norm();
        table.add({mass, method.name, place, speed});
        double& most = mass == 2 ? same_bits : any_mass;
        most = std::max({most, place, speed});
    };
    for (const double mass : {2.0, 7.0})
        each(newton_methods, [&](const auto& method) { compare(mass, method); });
    report.print(table);
    report.number("throw.steps", steps);
    report.number("throw.difference_2kg", same_bits, "m");
    report.number("throw.difference_7kg", any_mass, "m");
}

void many_forces(lab::Report& report) {
    ManyForces scene;
    report.heading("Many forces: a ring on ice, four ropes and a shaker");
    double sizes = scene.shake.norm();
    Vector3 net = Vector3::Zero();
    for (const Vector3& rope : scene.ropes) sizes += rope.norm(), net += rope;
    const long steps = 240;
    const Particle first = lab::run(scene, methods::verlet, steps);
    double spread = 0;
    int orders = 0;
    do {
        ++orders;
        spread = std::max(spread, distance(lab::run(scene, methods::verlet, steps), first));
    } while (std::next_permutation(scene.order.begin(), scene.order.end()));
    report.say("The forces' sizes add up to " + lab::rounded(sizes, "%.0f") +
               " N; the ropes' sum is " + lab::rounded(net.norm()) + " N. In " +
               std::to_string(orders) + " orders of the list the ring ends within " +
               lab::rounded(spread) + " m of the same place.");
    report.number("forces.sum_of_sizes", sizes, "N");
    report.number("forces.net_of_ropes", net.norm(), "N");
    report.number("forces.orders", orders);
    report.number("forces.spread", spread, "m");
    lab::report_least(report, "forces",
                      lab::least_of_each(ManyForces{}, lab::entries<ManyForces>(newton_methods)),
                      scene.need);
}

}  // namespace nutshell
