// The planet again: step control, high order, and a clock that runs with the planet.
#include "entries.hpp"
#include "program.hpp"

namespace nutshell {

namespace {

constexpr double orbits = 10;

std::vector<long> times_orbits(std::vector<long> steps) {
    for (long& n : steps) n *= static_cast<long>(orbits);
    return steps;
}

/// A method, measured with so many steps an orbit.
template <class Method>
lab::Entry<Planet> tried(const Method& method, const std::vector<long>& steps_an_orbit) {
    auto entry = lab::entry<Planet>(method);
    entry.steps = times_orbits(steps_an_orbit);
    return entry;
}

}  // namespace

void planet_again(lab::Report& report) {
    const Planet scene = Planet::for_orbits(orbits);
    report.heading("Planet: e = " + lab::rounded(scene.eccentricity) + ", " +
                   lab::rounded(orbits) + " orbits");
    const std::vector list{
        tried(methods::verlet, {100, 200, 500, 1000, 2000, 5000}),
        tried(methods::yoshida4, {50, 100, 200, 500, 1000, 2000}),
        tried(methods::kahan_li8, {25, 40, 60, 100, 150, 200, 300}),
        tried(methods::rk4, {50, 100, 200, 500, 1000, 2000}),
        clock_entry(methods::logarithmic_leapfrog,
                    times_orbits({10, 20, 50, 100, 500, 2000, 5000})),
        clock_entry(methods::logarithmic_leapfrog8, times_orbits({4, 6, 8, 12, 16, 20, 30}))};
    const lab::Plan plan{
        .key = "planet",
        .scene = "Planet, ε = " + lab::rounded(scene.eccentricity) + ", " + lab::rounded(orbits) +
                 " orbits.",
        .behind = "A clock that runs with the planet wins; its order decides by how much",
        .guides = {-2, -4, -8},
        .fewest = 50,
        .most = 500'000};
    auto [least, curves] = lab::measured(scene, list, plan);
    lab::report_least(report, plan.key, least, scene.need);
    curves.push_back(
        controlled(scene, {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12}));
    // The loosest tolerance that meets the need, searched, so that it is not charged for decades.
    double loose = 1e-3, tight = 1e-9;
    for (int halving = 0; halving < 24; ++halving) {
        const double middle = std::sqrt(loose * tight);
        const bool meets =
            controlled(scene, {middle}, false).runs.front().max_error <= scene.need.tolerance;
        (meets ? tight : loose) = middle;
    }
    const lab::Measurement searched = controlled(scene, {tight}).runs.front();
    report.number("planet.controlled.evaluations", searched.evaluations);
    least.push_back({curves.back().name, curves.back().look, searched});
    lab::draw_study(report, plan, curves, least, scene.need);
    // The steps that control chooses: longest over shortest.
    double shortest = 1e9, longest = 0, last = 0;
    adaptive(flat(scene.start), right_hand_side(scene.start, scene), 0, scene.duration,
             {1e-8, 1e-8}, 0.01, [&](const FlatPoint&, double t) {
                 if (last > 0 && t < scene.duration)
                     shortest = std::min(shortest, t - last),
                     longest = std::max(longest, t - last);
                 last = t;
             });
    report.number("planet.controlled.longest_over_shortest", longest / shortest);
    // What ten orbits do to the energy, as a share of it: positive is a gain.
    for (const double tolerance : {1e-6, 1e-8, 1e-9, 1e-10}) {
        const PointMass end = unflat(
            adaptive(flat(scene.start), right_hand_side(scene.start, scene), 0, scene.duration,
                     {tolerance, tolerance}, 0.01, [](const FlatPoint&, double) {}),
            scene.start);
        const double start = scene.energy(scene.start);
        report.number("planet.controlled.energy_" + lab::rounded(tolerance, "%.0e"),
                      (scene.energy(end) - start) / std::abs(start));
    }
    // Two hundred steps of 2 pi/20: on the ellipse all the way, but not ten orbits.
    TimedPlanet planet{scene.start};
    const LogHamiltonian leapfrog(scene.gm, scene.start);
    double off = 0;
    const double h2 = angular_momentum(scene.start).squaredNorm();
    const double e = scene.eccentricity;
    const auto anomaly = [e](const PointMass& at) {  // eccentric, of the place, in units a = 1
        return std::atan2(at.position.y() / std::sqrt(1 - e * e), at.position.x() + e);
    };
    double turned = 0;
    for (int n = 0; n < 20 * static_cast<int>(orbits); ++n) {
        const double before = anomaly(planet.body);
        planet = leapfrog(planet, scene, 0.0, 2 * pi / 20);
        turned += std::remainder(anomaly(planet.body) - before, 2 * pi);
        off = std::max(off, std::abs(planet.body.position.norm() -
                                     (h2 - scene.eccentricity * planet.body.position.x())));
    }
    report.number("planet.clock.off_the_ellipse", off, "a");
    report.number("planet.clock.orbits", turned / (2 * pi));
    // Kepler's equation says when the true planet is at this place
    report.number("planet.clock.off_there", planet.time - (turned - e * std::sin(turned)));
}

}  // namespace nutshell
