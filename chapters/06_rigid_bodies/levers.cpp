// Levers and seesaws: torques in balance and out of it, and what inertia does to the same torque.
#include <nutshell/lab/study.hpp>
#include <nutshell/lever_scenes.hpp>
#include <nutshell/rigid_methods.hpp>
#include "program.hpp"

namespace nutshell {

namespace {

void one(lab::Report& report, lab::Table& table, const Lever& lever) {
    const double torque = lever(lever.start, 0).torque.z(), inertia = lever.start.inertia.z();
    const std::string key = "lever." + lever.name;
    table.add({lever.name, lab::rounded(torque), lab::rounded(inertia),
               lab::rounded(torque / inertia),
               lever.imbalance() == 0 ? "-" : lab::rounded(lever.duration)});
    report.number(key + ".imbalance", lever.imbalance(), "kg m");
    report.number(key + ".torque", torque, "N m");
    report.number(key + ".inertia", inertia, "kg m^2");
    report.number(key + ".acceleration", torque / inertia, "rad/s^2");
    double mass = lever.bar;
    for (const Load& load : lever.loads) mass += load.mass;
    report.number(key + ".mass", mass, "kg");
    if (lever.imbalance() != 0) report.number(key + ".falls", lever.duration, "s");
}

/// The work of the torque of the weights, summed over small turns, against the energy of
/// rotation.
void work(lab::Report& report, const Lever& lever) {
    const int pieces = 1000;
    double sum = 0;
    for (int i = 0; i < pieces; ++i) {  // torque in the middle of each small turn
        const double dt = lever.duration / pieces;
        const double turn = lever.motion((i + 1) * dt).angle - lever.motion(i * dt).angle;
        sum += lever(lever.exact((i + 0.5) * dt), 0).torque.z() * turn;
    }
    const double energy = rotational_energy(lever.exact(lever.duration));
    report.number("lever.work", sum, "J");
    report.number("lever.energy", energy, "J");
    report.number("lever.speed", std::abs(lever.motion(lever.duration).rate) * lever.reach(),
                  "m/s");
    report.say("The torques do " + lab::rounded(sum, "%.2f") + " J of work on " + lever.name +
               ", and its energy of rotation at the ground is " + lab::rounded(energy, "%.2f") +
               " J.");
}

}  // namespace

void levers(lab::Report& report) {
    report.heading("Levers, let go level");
    lab::Table table{
        {"lever", "torque [N m]", "inertia [kg m^2]", "rad/s^2", "touches after [s]"}, {}};
    for (const Lever& lever :
         {balanced_seesaw(), seesaw(), crowbar(), light_and_far(), heavy_and_near()})
        one(report, table, lever);
    report.print(table);
    work(report, seesaw());

    const Lever bar = crowbar();
    const double stone = bar.loads[0].mass * -gravity.y();
    const double needed =
        (bar.loads[0].mass * -bar.loads[0].place - bar.bar * (bar.left + bar.right) / 2) *
        -gravity.y() / bar.right;
    report.number("lever.stone", stone, "N");
    report.number("lever.needed", needed, "N");
    report.number("lever.gain", stone / needed);

    // What a seesaw needs: the fewest steps by the three methods of chapter 1.
    const Lever scene = seesaw();
    report.number("lever.need", scene.need.tolerance * scene.reach(), "m");
    each(std::tuple{methods::euler, methods::semi_implicit_euler, methods::verlet},
         [&](const auto& method) {
             const auto least =
                 lab::fewest_steps(scene, lab::entry<Lever>(method), scene.need.tolerance);
             require(least.has_value(), "levers: a method does not meet the seesaw's need");
             report.number("lever." + method.key() + ".steps", static_cast<double>(least->steps));
         });
}

}  // namespace nutshell
